#include "oracle.hpp"

#include <cmath>
#include <limits>

namespace oracle {

namespace {

Vector3d vec(const double x[3])
{
  return Vector3d(x[0], x[1], x[2]);
}

Matrix3d matrix(const double A[9])
{
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(A);
}

// thin rod along e
Matrix3d rod_tensor(double mass, const Vector3d &e)
{
  return mass / 12.0 * (e.squaredNorm() * Matrix3d::Identity() - e * e.transpose());
}

Matrix3d steiner(double mass, const Vector3d &r)
{
  return mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
}

// two unit vectors that make a right-handed frame with u
void frame(const Vector3d &u, Vector3d &a, Vector3d &b)
{
  a = u.unitOrthogonal();
  b = u.cross(a);
}

double four_slopes(const maggi_spring_def &d, double v)
{
  if (v >= 0.0)
    return d.c[0] * std::min(v, d.v11) + d.c[1] * std::max(v - d.v11, 0.0);
  return d.c[2] * std::max(v, d.v22) + d.c[3] * std::min(v - d.v22, 0.0);
}

} // namespace

Inertia inertia(const mechanism &m, int i)
{
  const maggi_body_def &d = m.body[i].def;
  std::vector<double> mass;
  std::vector<Vector3d> centre;
  std::vector<Matrix3d> tensor;
  Inertia total;

  mass.push_back(d.mass);
  if (d.is_bar) {
    centre.push_back(0.5 * (vec(d.bar_from) + vec(d.bar_to)));
    tensor.push_back(rod_tensor(d.mass, vec(d.bar_to) - vec(d.bar_from)));
  } else {
    Matrix3d J;
    J << d.inertia[0], d.inertia[3], d.inertia[4], d.inertia[3], d.inertia[1], d.inertia[5],
        d.inertia[4], d.inertia[5], d.inertia[2];
    centre.push_back(vec(d.cog));
    tensor.push_back(J);
  }
  for (int k = 0; k < m.npoint_mass; ++k) {
    if (m.point_mass[k].body == i) {
      mass.push_back(m.point_mass[k].def.mass);
      centre.push_back(vec(m.point_mass[k].def.point));
      tensor.push_back(Matrix3d::Zero());
    }
  }
  for (size_t k = 0; k < mass.size(); ++k) {
    total.mass += mass[k];
    total.cog += mass[k] * centre[k];
  }
  total.cog /= total.mass;
  for (size_t k = 0; k < mass.size(); ++k)
    total.J += tensor[k] + steiner(mass[k], centre[k] - total.cog);
  return total;
}

Oracle::Oracle(const mechanism &mech, double time, const double *position, const double *velocity)
    : m(mech), t(time), q(position), v(velocity), pose(static_cast<size_t>(mech.nbody))
{
  mech_motion(&m, q, v, nullptr, pose.data());
  add_bodies();
  M = MatrixXd::Zero(size(), size());
  Q = VectorXd::Zero(size());
  for (int i = 0; i < m.nbody; ++i) {
    add_joint(i);
    add_guides(i);
  }
  for (int i = 0; i < m.nloop; ++i)
    add_loop(i);
  for (int i = 0; i < m.nrod; ++i)
    add_rod(i);
  add_mass();
  add_weights();
  add_springs();
  add_loads();
  add_actuation();
}

// ------------------------------------------------------------------------------------ kinematics

Vector3d Oracle::direction(int b, const double u[3]) const
{
  return b < 0 ? vec(u).normalized() : (matrix(pose[b].A) * vec(u)).normalized().eval();
}

Vector3d Oracle::omega(int b) const
{
  return b < 0 ? Vector3d::Zero().eval() : body[b].w;
}

// body-fixed point now at r; `on` when the body is not the ground
Oracle::Point Oracle::on(int b, const Vector3d &r) const
{
  Vector3d c = body[b].w.cross(r - body[b].g);

  return {b, r, body[b].v + c, body[b].w.cross(c)};
}

Oracle::Point Oracle::at(int b, const Vector3d &r) const
{
  return b < 0 ? Point{b, r, Vector3d::Zero(), Vector3d::Zero()} : on(b, r);
}

Oracle::Point Oracle::drawn(int b, const double x[3]) const
{
  if (b < 0)
    return at(b, vec(x));
  return at(b, vec(pose[b].o) + matrix(pose[b].A) * (vec(x) - vec(m.body[b].def.point)));
}

Vector3d Oracle::acceleration(const Point &p, const VectorXd &x) const
{
  if (p.body < 0)
    return Vector3d::Zero();
  return x.segment<3>(6 * p.body) + x.segment<3>(6 * p.body + 3).cross(p.r - body[p.body].g) + p.c;
}

VectorXd Oracle::velocities(const double *rates) const
{
  std::vector<mech_pose> moved(static_cast<size_t>(m.nbody));
  VectorXd y = VectorXd::Zero(size());

  mech_motion(&m, q, rates, nullptr, moved.data());
  for (int i = 0; i < m.nbody; ++i) {
    y.segment<3>(6 * i + 3) = vec(moved[i].w);
    y.segment<3>(6 * i) = vec(moved[i].v) + vec(moved[i].w).cross(body[i].g - vec(moved[i].o));
  }
  for (int i = 0; i < m.nrod; ++i) {
    if (rod_body[i] < 0)
      continue;
    Vector3d end[2], speed[2];
    for (int k = 0; k < 2; ++k) {
      int b = k ? m.rod[i].b : m.rod[i].a;
      end[k] = drawn(b, k ? m.rod[i].def.point_b : m.rod[i].def.point_a).r;
      speed[k] = Vector3d::Zero();
      if (b >= 0)
        speed[k] = vec(moved[b].v) + vec(moved[b].w).cross(end[k] - vec(moved[b].o));
    }
    Vector3d e = end[0] - end[1];
    y.segment<3>(6 * rod_body[i]) = 0.5 * (speed[0] + speed[1]);
    y.segment<3>(6 * rod_body[i] + 3) = e.cross(speed[0] - speed[1]) / e.squaredNorm();
  }
  return y;
}

void Oracle::add_bodies()
{
  for (int i = 0; i < m.nbody; ++i) {
    Inertia in = inertia(m, i);
    Matrix3d A = matrix(pose[i].A);
    State s;

    s.g = vec(pose[i].o) + A * (in.cog - vec(m.body[i].def.point));
    s.w = vec(pose[i].w);
    s.v = vec(pose[i].v) + s.w.cross(s.g - vec(pose[i].o));
    s.mass = in.mass;
    s.J = A * in.J * A.transpose();
    body.push_back(s);
  }
  for (int i = 0; i < m.nrod; ++i)
    add_rod_body(i);
}

// no spin about itself
void Oracle::add_rod_body(int i)
{
  const mech_rod &rod = m.rod[i];
  Point a = drawn(rod.a, rod.def.point_a), b = drawn(rod.b, rod.def.point_b);
  Vector3d e = a.r - b.r;
  State s;

  rod_body.push_back(-1);
  if (rod.def.mass == 0.0)
    return;
  rod_body[i] = static_cast<int>(body.size());
  s.g = 0.5 * (a.r + b.r);
  s.v = 0.5 * (a.v + b.v);
  s.w = e.cross(a.v - b.v) / e.squaredNorm();
  s.mass = rod.def.mass;
  s.J = rod_tensor(rod.def.mass, e);
  body.push_back(s);
}

// ------------------------------------------------------------------------------------ constraints

void Oracle::push(const VectorXd &p, double right, Row::Owner owner, int id, double first)
{
  coefficients.push_back(p.transpose());
  gamma.push_back(right);
  rate.push_back(first);
  row.push_back({owner, id});
}

namespace {

// n . (acceleration of a point at r)
void add(VectorXd &p, int b, const Vector3d &g, const Vector3d &r, const Vector3d &n, double sign)
{
  if (b < 0)
    return;
  p.segment<3>(6 * b) += sign * n;
  p.segment<3>(6 * b + 3) += sign * (r - g).cross(n);
}

void add_turn(VectorXd &p, int b, const Vector3d &n, double sign)
{
  if (b >= 0)
    p.segment<3>(6 * b + 3) += sign * n;
}

} // namespace

// r_a - r_b = 0
void Oracle::coincide(const Point &a, const Point &b, Row::Owner owner, int id)
{
  for (int k = 0; k < 3; ++k) {
    VectorXd p = VectorXd::Zero(size());
    Vector3d e = Vector3d::Unit(k);

    add(p, a.body, a.body < 0 ? e : body[a.body].g, a.r, e, 1.0);
    add(p, b.body, b.body < 0 ? e : body[b.body].g, b.r, e, -1.0);
    push(p, -(a.c - b.c)[k], owner, id);
  }
}

// (r_a - r_b).n = constant, n fixed in body `fixed`:
//   (a_a - a_b).n + 2 (v_a - v_b).n' + d.(w' × n + w × n') = 0
void Oracle::across(const Point &a, const Point &b, int fixed, const Vector3d &n, Row::Owner owner,
                    int id)
{
  VectorXd p = VectorXd::Zero(size());
  Vector3d d = a.r - b.r, w = omega(fixed), n1 = w.cross(n);

  add(p, a.body, a.body < 0 ? n : body[a.body].g, a.r, n, 1.0);
  add(p, b.body, b.body < 0 ? n : body[b.body].g, b.r, n, -1.0);
  add_turn(p, fixed, n.cross(d), 1.0);
  push(p, -((a.c - b.c).dot(n) + 2.0 * (a.v - b.v).dot(n1) + d.dot(w.cross(n1))), owner, id);
}

// e.f = constant, e fixed in a and f in b
void Oracle::angle(int a, const Vector3d &e, int b, const Vector3d &f, Row::Owner owner, int id)
{
  VectorXd p = VectorXd::Zero(size());
  Vector3d e1 = omega(a).cross(e), f1 = omega(b).cross(f);

  add_turn(p, a, e.cross(f), 1.0);
  add_turn(p, b, e.cross(f), -1.0);
  push(p, -(omega(a).cross(e1).dot(f) + 2.0 * e1.dot(f1) + e.dot(omega(b).cross(f1))), owner, id);
}

void Oracle::add_joint(int i)
{
  const maggi_body_def &d = m.body[i].def;
  int up = m.body[i].parent;
  Point own = on(i, vec(pose[i].o)), there = drawn(up, d.point);
  Vector3d u, s, c;

  if (d.joint == MAGGI_JOINT_FREE)
    return;
  if (d.joint == MAGGI_JOINT_SPHERICAL || d.joint == MAGGI_JOINT_FIXED ||
      d.joint == MAGGI_JOINT_REVOLUTE || d.joint == MAGGI_JOINT_UNIVERSAL)
    coincide(own, there, Row::joint, i);
  if (d.joint == MAGGI_JOINT_SPHERICAL)
    return;
  if (d.joint == MAGGI_JOINT_UNIVERSAL) {
    angle(i, direction(i, d.axis2), up, direction(up, d.axis), Row::joint, i);
    return;
  }
  u = d.joint == MAGGI_JOINT_FIXED ? Vector3d::UnitX().eval() : direction(up, d.axis);
  frame(u, s, c);
  if (d.joint == MAGGI_JOINT_PRISMATIC || d.joint == MAGGI_JOINT_CYLINDRICAL) {
    across(own, there, up, s, Row::joint, i);
    across(own, there, up, c, Row::joint, i);
  }
  if (d.joint == MAGGI_JOINT_PLANAR)
    across(own, there, up, u, Row::joint, i);
  angle(i, u, up, s, Row::joint, i);
  angle(i, u, up, c, Row::joint, i);
  if (d.joint == MAGGI_JOINT_PRISMATIC || d.joint == MAGGI_JOINT_FIXED)
    angle(i, s, up, c, Row::joint, i);
}

// relative acceleration at the joint point = sum screw z'' + bias; the dual wrench of a coordinate
// picks its z''
void Oracle::add_guides(int i)
{
  const mech_body &b = m.body[i];
  Eigen::Map<const MatrixXd> S(pose[i].screw[0], 6, b.dof);
  double y[3];

  dual.push_back(S * (S.transpose() * S).inverse());
  for (int k = 0; k < b.dof; ++k) {
    if (b.motion[k] < 0)
      continue;
    VectorXd p = VectorXd::Zero(size());
    Vector6d c = dual[i].col(k);
    Vector3d f = c.head<3>(), n = c.tail<3>();
    Point own = on(i, vec(pose[i].o)), there = at(b.parent, own.r);
    Vector6d bias;

    mech_function_value(&m.function[b.motion[k]], t, y);
    p.segment<3>(6 * i) = f;
    p.segment<3>(6 * i + 3) = n + (own.r - body[i].g).cross(f);
    if (b.parent >= 0) {
      p.segment<3>(6 * b.parent) = -f;
      p.segment<3>(6 * b.parent + 3) = -n - (own.r - body[b.parent].g).cross(f);
    }
    // own.c - there.c are the accelerations of both points without those of the bodies
    bias = Eigen::Map<const Vector6d>(pose[i].bias);
    bias.head<3>() -= own.c - there.c;
    push(p, y[2] + c.dot(bias), Row::guide, b.q + k, y[1]);
  }
}

Oracle::Point Oracle::cut_point(int i) const
{
  return drawn(m.loop[i].a, m.loop[i].def.point_a);
}

void Oracle::add_loop(int i)
{
  const mech_loop &l = m.loop[i];
  const maggi_loop_def &d = l.def;
  Point a = cut_point(i), b = drawn(l.b, d.has_b ? d.point_b : d.point_a);
  Vector3d u, s, c;

  if (d.type <= MAGGI_LOOP_UNIVERSAL)
    coincide(a, b, Row::cut, i);
  if (d.type == MAGGI_LOOP_SPHERICAL)
    return;
  if (d.type == MAGGI_LOOP_UNIVERSAL) {
    angle(l.a, direction(l.a, d.axis_a), l.b, direction(l.b, d.axis_b), Row::cut, i);
    return;
  }
  u = direction(l.b, d.has_b ? d.axis_b : d.axis_a);
  frame(u, s, c);
  if (d.type >= MAGGI_LOOP_CYLINDRICAL) {
    across(a, b, l.b, s, Row::cut, i);
    across(a, b, l.b, c, Row::cut, i);
  }
  angle(l.a, u, l.b, s, Row::cut, i);
  angle(l.a, u, l.b, c, Row::cut, i);
  if (d.type == MAGGI_LOOP_PRISMATIC)
    angle(l.a, s, l.b, c, Row::cut, i);
}

void Oracle::add_rod(int i)
{
  const mech_rod &rod = m.rod[i];
  Point a = drawn(rod.a, rod.def.point_a), b = drawn(rod.b, rod.def.point_b);
  Vector3d e = a.r - b.r;
  double l = e.norm();
  VectorXd p = VectorXd::Zero(size());

  e /= l;
  if (rod_body[i] >= 0) {
    coincide(a, at(rod_body[i], a.r), Row::rod_a, i);
    coincide(b, at(rod_body[i], b.r), Row::rod_b, i);
    add_turn(p, rod_body[i], e, 1.0);
    push(p, 0.0, Row::spin, i);
    return;
  }
  add(p, rod.a, rod.a < 0 ? e : body[rod.a].g, a.r, e, 1.0);
  add(p, rod.b, rod.b < 0 ? e : body[rod.b].g, b.r, e, -1.0);
  push(p, -((a.c - b.c).dot(e) + (a.v - b.v).squaredNorm() / l), Row::rod, i);
}

// ------------------------------------------------------------------------------------ forces

void Oracle::add_mass()
{
  for (size_t i = 0; i < body.size(); ++i) {
    int k = 6 * static_cast<int>(i);
    M.block<3, 3>(k, k) = body[i].mass * Matrix3d::Identity();
    M.block<3, 3>(k + 3, k + 3) = body[i].J;
    Q.segment<3>(k + 3) -= body[i].w.cross(body[i].J * body[i].w);
  }
}

void Oracle::force(const Point &p, const Vector3d &f)
{
  if (p.body < 0)
    return;
  Q.segment<3>(6 * p.body) += f;
  Q.segment<3>(6 * p.body + 3) += (p.r - body[p.body].g).cross(f);
}

void Oracle::moment(int b, const Vector3d &n)
{
  if (b >= 0)
    Q.segment<3>(6 * b + 3) += n;
}

void Oracle::add_weights()
{
  for (size_t i = 0; i < body.size(); ++i)
    Q.segment<3>(6 * static_cast<int>(i)) += body[i].mass * vec(m.gravity);
}

Vector3d Oracle::spring(int i) const
{
  const maggi_spring_def &d = m.spring[i].def;
  Point a = drawn(m.spring[i].a, d.point_a), b = drawn(m.spring[i].b, d.point_b);
  double l = (b.r - a.r).norm(), file = (vec(d.point_b) - vec(d.point_a)).norm(), f;
  double speed = (b.v - a.v).dot(b.r - a.r) / l;

  f = std::isnan(d.free_length) ? d.preload + d.stiffness * (l - file)
                                : d.stiffness * (l - d.free_length);
  f += d.damping * speed;
  if (d.has_slopes)
    f += four_slopes(d, speed);
  return {l, speed, f};
}

void Oracle::add_springs()
{
  for (int i = 0; i < m.nspring; ++i) {
    const maggi_spring_def &d = m.spring[i].def;
    Point a = drawn(m.spring[i].a, d.point_a), b = drawn(m.spring[i].b, d.point_b);
    Vector3d f = (b.r - a.r).normalized() * spring(i)[2];

    force(a, f);
    force(b, -f);
  }
}

void Oracle::add_loads()
{
  for (int i = 0; i < m.nforce; ++i) {
    const mech_force &d = m.force[i];
    double y[3] = {1.0, 0.0, 0.0};
    Vector3d f = vec(d.def.value);

    if (d.def.type == MAGGI_FORCE_JOINT || d.def.type >= MAGGI_FORCE_SPEED)
      continue;
    if (d.function >= 0)
      mech_function_value(&m.function[d.function], t, y);
    f *= y[0];
    if (d.def.type == MAGGI_FORCE_BODY || d.def.type == MAGGI_TORQUE_BODY)
      f = matrix(pose[d.body].A) * f;
    if (d.def.type == MAGGI_TORQUE_BODY || d.def.type == MAGGI_TORQUE_GLOBAL) {
      moment(d.body, f);
      moment(d.reaction, -f);
    } else {
      Point p = drawn(d.body, d.def.point);
      if (d.def.type == MAGGI_FORCE_DRAG) {
        Vector3d u = p.v - vec(d.def.wind);
        f = -0.5 * y[0] * d.def.density * d.def.coefficient * d.def.area *
            std::hypot(u.norm(), d.def.low_speed) * u;
      }
      force(p, f);
      force(at(d.reaction, p.r), -f);
    }
  }
}

Vector3d Oracle::joint_spring(int i) const
{
  const mech_joint_spring &s = m.joint_spring[i];
  double z = q[s.q] - (s.q2 < 0 ? 0.0 : q[s.q2]), speed = v[s.q] - (s.q2 < 0 ? 0.0 : v[s.q2]);

  return {z, speed, -s.def.stiffness * (z - s.def.rest) - s.def.damping * speed - s.def.preload};
}

void Oracle::add_actuation()
{
  VectorXd tau = VectorXd::Zero(m.nq);

  for (int i = 0; i < m.njoint_spring; ++i) {
    const mech_joint_spring &s = m.joint_spring[i];
    double f = joint_spring(i)[2];

    tau[s.q] += f;
    if (s.q2 >= 0)
      tau[s.q2] -= f;
  }
  for (int i = 0; i < m.nforce; ++i) {
    const mech_force &d = m.force[i];
    double y[3] = {1.0, 0.0, 0.0};

    if (d.def.type != MAGGI_FORCE_JOINT && d.def.type < MAGGI_FORCE_SPEED)
      continue;
    if (d.function >= 0)
      mech_function_value(&m.function[d.function], t, y);
    if (d.def.type == MAGGI_FORCE_JOINT) {
      tau[d.q] += d.def.value[0] * y[0];
      continue;
    }
    double e = d.def.speed * y[0] -
               std::hypot(drawn(d.body, d.def.point).v.norm(), d.def.low_speed);
    double f = d.def.gain * d.def.torque * (d.def.type == MAGGI_FORCE_SPEED ? e * std::abs(e) : e);
    tau[d.q] += f;
    if (d.q2 >= 0)
      tau[d.q2] += f;
  }
  for (int i = 0; i < m.nbody; ++i) {
    Vector6d w = dual[i] * tau.segment(m.body[i].q, m.body[i].dof);
    Vector3d r = vec(pose[i].o), f = w.head<3>(), n = w.tail<3>();

    actuation.push_back(w);
    force(on(i, r), f);
    moment(i, n);
    force(at(m.body[i].parent, r), -f);
    moment(m.body[i].parent, -n);
  }
}

// ------------------------------------------------------------------------------------ energies

double Oracle::kinetic() const
{
  double T = 0.0;

  for (const State &s : body)
    T += 0.5 * s.mass * s.v.squaredNorm() + 0.5 * s.w.dot(s.J * s.w);
  return T;
}

double Oracle::potential() const
{
  double V = 0.0;

  for (const State &s : body)
    V -= s.mass * vec(m.gravity).dot(s.g);
  for (int i = 0; i < m.nspring; ++i) {
    const maggi_spring_def &d = m.spring[i].def;
    Point a = drawn(m.spring[i].a, d.point_a), b = drawn(m.spring[i].b, d.point_b);
    double l = (b.r - a.r).norm(), file = (vec(d.point_b) - vec(d.point_a)).norm();
    double x = l - (std::isnan(d.free_length) ? file : d.free_length);

    V += 0.5 * d.stiffness * x * x + (std::isnan(d.free_length) ? d.preload * x : 0.0);
  }
  for (int i = 0; i < m.njoint_spring; ++i) {
    const mech_joint_spring &s = m.joint_spring[i];
    double z = q[s.q] - (s.q2 < 0 ? 0.0 : q[s.q2]), x = z - s.def.rest;

    V += 0.5 * s.def.stiffness * x * x + s.def.preload * z;
  }
  return V;
}

// ------------------------------------------------------------------------------------ solution

// generalised force on a body (force, moment about its centre of gravity) as a wrench at r
Vector6d Oracle::wrench(const VectorXd &generalised, int b, const Vector3d &r) const
{
  Vector6d w = Vector6d::Zero();

  if (b >= 0) {
    w = generalised.segment<6>(6 * b);
    w.tail<3>() += (body[b].g - r).cross(w.head<3>().eval());
  }
  return w;
}

std::vector<int> Oracle::rows_of(Row::Owner owner, int id) const
{
  std::vector<int> list;

  for (size_t i = 0; i < row.size(); ++i)
    if (row[i].owner == owner && row[i].id == id)
      list.push_back(static_cast<int>(i));
  return list;
}

Solution Oracle::solve() const
{
  const int n = size(), rows = static_cast<int>(row.size());
  MatrixXd J(rows, n);
  VectorXd g(rows), speed(rows), lambda = VectorXd::Zero(rows);
  Solution s;

  for (int i = 0; i < rows; ++i) {
    J.row(i) = coefficients[i];
    g[i] = gamma[i];
    speed[i] = rate[i];
  }
  if (rows > 0)
    s.velocity = (J * velocities(v) - speed).lpNorm<Eigen::Infinity>();

  // independent rows and what is left of the others
  int rank = 0;
  MatrixXd kernel;
  std::vector<int> chosen;
  if (rows > 0) {
    Eigen::FullPivLU<MatrixXd> lu(J.transpose());
    VectorXd pivots = lu.matrixLU().diagonal().cwiseAbs();
    lu.setThreshold(1e-9);
    rank = static_cast<int>(lu.rank());
    s.smallest = pivots[rank - 1] / pivots[0];
    if (rank < pivots.size())
      s.gap = pivots[rank - 1] / std::max(pivots[rank], std::numeric_limits<double>::min());
    else
      s.gap = std::numeric_limits<double>::infinity();
    for (int i = 0; i < rank; ++i)
      chosen.push_back(lu.permutationQ().indices()[i]);
    if (rank < rows) {
      Eigen::HouseholderQR<MatrixXd> qr(lu.kernel());
      kernel = qr.householderQ() * MatrixXd::Identity(rows, rows - rank);
    }
  }
  s.dof = n - rank;

  MatrixXd K = MatrixXd::Zero(n + rank, n + rank);
  VectorXd right(n + rank), y;
  K.topLeftCorner(n, n) = M;
  right.head(n) = Q;
  for (int i = 0; i < rank; ++i) {
    K.row(n + i).head(n) = J.row(chosen[i]);
    K.col(n + i).head(n) = J.row(chosen[i]).transpose();
    right[n + i] = g[chosen[i]];
  }
  Eigen::FullPivLU<MatrixXd> solver(K);
  y = solver.solve(right);
  y += solver.solve(right - K * y);
  s.x = y.head(n);
  for (int i = 0; i < rank; ++i)
    lambda[chosen[i]] = y[n + i];
  if (rows > 0)
    s.redundant = (J * s.x - g).lpNorm<Eigen::Infinity>();

  // z'' of each coordinate by the dual of its screw
  s.a = VectorXd::Zero(m.nq);
  for (int i = 0; i < m.nbody; ++i) {
    Point own = on(i, vec(pose[i].o)), there = at(m.body[i].parent, own.r);
    Vector6d d;

    d.head<3>() = acceleration(own, s.x) - acceleration(there, s.x);
    d.tail<3>() = s.x.segment<3>(6 * i + 3);
    if (m.body[i].parent >= 0)
      d.tail<3>() -= s.x.segment<3>(6 * m.body[i].parent + 3);
    d -= Eigen::Map<const Vector6d>(pose[i].bias);
    s.a.segment(m.body[i].q, m.body[i].dof) = dual[i].transpose() * d;
  }

  // forces of groups of rows on one body, and whether those of redundant rows can change them
  auto exerted = [&](const std::vector<int> &list, int b, const Vector3d &r, bool &unique) {
    VectorXd f = VectorXd::Zero(n);
    MatrixXd change = MatrixXd::Zero(n, kernel.cols());

    for (int i : list) {
      f -= lambda[i] * J.row(i).transpose();
      if (kernel.cols() > 0)
        change += J.row(i).transpose() * kernel.row(i);
    }
    unique = kernel.cols() == 0 || b < 0 ||
             change.middleRows(6 * b, 6).lpNorm<Eigen::Infinity>() < 1e-8;
    return wrench(f, b, r);
  };
  bool unique;
  s.drive = VectorXd::Zero(m.nq);
  s.drive_unique.assign(m.nq, true);
  for (int i = 0; i < m.nbody; ++i) {
    std::vector<int> list = rows_of(Row::joint, i);
    for (int k = 0; k < m.body[i].dof; ++k) {
      std::vector<int> one = rows_of(Row::guide, m.body[i].q + k);
      for (int j : one) {
        list.push_back(j);
        s.drive[m.body[i].q + k] = -lambda[j];
        s.drive_unique[m.body[i].q + k] =
            kernel.cols() == 0 || kernel.row(j).lpNorm<Eigen::Infinity>() < 1e-8;
      }
    }
    s.reaction.push_back(exerted(list, i, vec(pose[i].o), unique) + actuation[i]);
    s.reaction_unique.push_back(unique);
  }
  for (int i = 0; i < m.nloop; ++i) {
    Point p = cut_point(i);
    // seen from b when a is the ground
    if (m.loop[i].a >= 0)
      s.loop.push_back(exerted(rows_of(Row::cut, i), m.loop[i].a, p.r, unique));
    else
      s.loop.push_back(-exerted(rows_of(Row::cut, i), m.loop[i].b, p.r, unique));
    s.loop_unique.push_back(unique);
  }
  for (int i = 0; i < m.nrod; ++i) {
    Point a = drawn(m.rod[i].a, m.rod[i].def.point_a), b = drawn(m.rod[i].b, m.rod[i].def.point_b);
    Vector3d e = (a.r - b.r).normalized(), f;
    double mass = m.rod[i].def.mass;

    if (rod_body[i] < 0) {
      int j = rows_of(Row::rod, i)[0];
      s.rod.push_back(lambda[j]);
      unique = kernel.cols() == 0 || kernel.row(j).lpNorm<Eigen::Infinity>() < 1e-8;
    } else {
      // on a: - lambda e - m (a_a / 3 + a_b / 6) + m g / 2; what the rod's body feels, reversed
      f = -wrench(VectorXd::Zero(n), -1, e).head<3>();
      for (int j : rows_of(Row::rod_a, i)) {
        f += lambda[j] * J.row(j).segment<3>(6 * rod_body[i]).transpose();
      }
      f += mass * (acceleration(a, s.x) / 3.0 + acceleration(b, s.x) / 6.0 - 0.5 * vec(m.gravity));
      s.rod.push_back(-e.dot(f));
      exerted(rows_of(Row::rod_a, i), rod_body[i], a.r, unique);
    }
    s.rod_unique.push_back(unique);
  }
  return s;
}

VectorXd Oracle::imbalance(const VectorXd &x, const std::vector<Vector6d> &reaction,
                           const std::vector<Vector6d> &loop, const std::vector<double> &rod) const
{
  // weights, springs and loads are in Q together with the actuation of the joints, which is a part
  // of the reactions: taken out
  VectorXd f = Q - M * x;

  auto apply = [&](int b, const Vector3d &r, const Vector6d &w, double sign) {
    if (b < 0)
      return;
    f.segment<3>(6 * b) += sign * w.head<3>();
    f.segment<3>(6 * b + 3) += sign * (w.tail<3>() + (r - body[b].g).cross(w.head<3>().eval()));
  };
  for (int i = 0; i < m.nbody; ++i) {
    Vector6d w = reaction[i] - actuation[i];
    apply(i, vec(pose[i].o), w, 1.0);
    apply(m.body[i].parent, vec(pose[i].o), w, -1.0);
  }
  for (int i = 0; i < m.nloop; ++i) {
    apply(m.loop[i].a, cut_point(i).r, loop[i], 1.0);
    apply(m.loop[i].b, cut_point(i).r, loop[i], -1.0);
  }
  for (int i = 0; i < m.nrod; ++i) {
    Point a = drawn(m.rod[i].a, m.rod[i].def.point_a), b = drawn(m.rod[i].b, m.rod[i].def.point_b);
    Vector3d e = (a.r - b.r).normalized(), g = vec(m.gravity);
    Vector3d aa = acceleration(a, x), ab = acceleration(b, x);
    double mass = m.rod[i].def.mass;
    Vector6d w = Vector6d::Zero();

    w.head<3>() = -rod[i] * e - mass * (aa / 3.0 + ab / 6.0 - 0.5 * g);
    apply(m.rod[i].a, a.r, w, 1.0);
    w.head<3>() = rod[i] * e - mass * (ab / 3.0 + aa / 6.0 - 0.5 * g);
    apply(m.rod[i].b, b.r, w, 1.0);
  }
  return f.head(6 * m.nbody);
}

VectorXd Oracle::effort(const std::vector<Vector6d> &reaction) const
{
  VectorXd tau(m.nq);

  for (int i = 0; i < m.nbody; ++i) {
    Eigen::Map<const MatrixXd> S(pose[i].screw[0], 6, m.body[i].dof);
    tau.segment(m.body[i].q, m.body[i].dof) = S.transpose() * (reaction[i] - actuation[i]);
  }
  return tau;
}

} // namespace oracle
