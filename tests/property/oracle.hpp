// The equations of motion once more: absolute coordinates, index 1, nothing of core/.
//
//   [ M  J^T ] [ x      ]   [ Q     ]      x: acceleration of the centre of gravity and angular
//   [ J  0   ] [ lambda ] = [ gamma ]         acceleration of each body, 6 numbers in global axes
//
// Every joint, compound ones at once, and every loop is written as scalar equations between its two
// real bodies; a rod with mass is a body of its own between two spherical joints; a guided
// coordinate is one more equation.  Redundant rows are found by LU with full pivoting and left out.
#ifndef MAGGI_TESTS_ORACLE_HPP
#define MAGGI_TESTS_ORACLE_HPP

#include <Eigen/Dense>
#include <vector>

#include "mechanism.h"

namespace oracle {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
typedef Eigen::Matrix<double, 6, 1> Vector6d;

// mass, centre of gravity in the drawing and tensor about it, body axes
struct Inertia {
  double mass = 0.0;
  Vector3d cog = Vector3d::Zero();
  Matrix3d J = Matrix3d::Zero();
};

// a body at an instant; bodies of rods follow those of the description
struct State {
  Vector3d g, v, w; // centre of gravity, its velocity, angular velocity
  double mass;
  Matrix3d J; // global axes
};

struct Solution {
  int dof = 0;               // 6 bodies - rank J
  double gap = 1.0;          // smallest pivot of J that counts over the largest that does not
  double smallest = 1.0;     // smallest pivot of J that counts over the largest
  VectorXd x;                // accelerations
  VectorXd a;                // of the joint coordinates
  double velocity = 0.0;     // |J (velocities) - rates of guides|
  double redundant = 0.0;    // |J x - gamma| of the rows left out
  std::vector<Vector6d> reaction, loop; // joints: on the body at its joint point; loops: on a
  std::vector<bool> reaction_unique, loop_unique, drive_unique;
  VectorXd drive;            // by coordinate, 0 where not guided
  std::vector<double> rod;   // axial force, tension positive
  std::vector<bool> rod_unique;
};

class Oracle {
public:
  Oracle(const mechanism &m, double t, const double *q, const double *v);

  Solution solve() const;
  // length, rate, force of a spring; value, rate, torque of a spring on coordinates
  Vector3d spring(int i) const;
  Vector3d joint_spring(int i) const;
  double kinetic() const;
  double potential() const;
  // 6 bodies of absolute velocities, as joint velocities make them
  VectorXd velocities(const double *v) const;
  const MatrixXd &mass() const { return M; }
  // |G - (what Newton and Euler ask)| of all bodies for given accelerations, joint wrenches and
  // loop wrenches: whether some reactions are in balance, unique or not
  VectorXd imbalance(const VectorXd &x, const std::vector<Vector6d> &reaction,
                     const std::vector<Vector6d> &loop, const std::vector<double> &rod) const;
  // efforts that joint wrenches do on the coordinates, less those of springs and loads
  VectorXd effort(const std::vector<Vector6d> &reaction) const;

private:
  struct Row {
    enum Owner { joint, guide, cut, rod_a, rod_b, rod, spin } owner;
    int id;
  };

  struct Point {
    int body; // or -1
    Vector3d r, v, c; // position, velocity, acceleration when that of the bodies is zero
  };

  const mechanism &m;
  double t;
  const double *q, *v;
  std::vector<mech_pose> pose;
  std::vector<State> body;
  MatrixXd M;
  VectorXd Q;
  std::vector<Row> row;
  std::vector<Eigen::RowVectorXd> coefficients;
  std::vector<double> gamma, rate;
  std::vector<Vector6d> actuation;     // wrench of springs and loads on the joint, at its point
  std::vector<MatrixXd> dual;          // 6 x dof: wrenches that work on one coordinate alone
  std::vector<int> rod_body;           // -1 for a massless rod

  int size() const { return 6 * static_cast<int>(body.size()); }
  Vector3d direction(int b, const double u[3]) const;
  Vector3d omega(int b) const;
  Point on(int b, const Vector3d &r) const;
  Point at(int b, const Vector3d &r) const;
  Point drawn(int b, const double x[3]) const;
  Vector3d acceleration(const Point &p, const VectorXd &x) const;
  void add_bodies();
  void add_rod_body(int i);
  void add_joint(int i);
  void add_guides(int i);
  void add_loop(int i);
  void add_rod(int i);
  void add_mass();
  void add_weights();
  void add_springs();
  void add_loads();
  void add_actuation();
  void push(const VectorXd &p, double right, Row::Owner owner, int id, double first = 0.0);
  void coincide(const Point &a, const Point &b, Row::Owner owner, int id);
  void across(const Point &a, const Point &b, int fixed, const Vector3d &n, Row::Owner owner,
              int id);
  void angle(int a, const Vector3d &e, int b, const Vector3d &f, Row::Owner owner, int id);
  void force(const Point &p, const Vector3d &f);
  void moment(int b, const Vector3d &n);
  Vector6d wrench(const VectorXd &generalised, int b, const Vector3d &r) const;
  std::vector<int> rows_of(Row::Owner owner, int id) const;
  Point cut_point(int loop) const;
};

Inertia inertia(const mechanism &m, int body);

} // namespace oracle

#endif
