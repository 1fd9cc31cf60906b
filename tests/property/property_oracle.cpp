// Random mechanisms against the augmented index-1 system in absolute coordinates (oracle.hpp):
// accelerations, reactions, multipliers, drives, degrees of freedom, reduced mass matrix, energies
// and sensors, at the start, 50 steps later, and for the smaller ones after a second, when
// independent coordinates have changed.
//
//   property_oracle [--seed N] [--from N] [--count N] [--verbose]
#include <cmath>
#include <cstdio>
#include <memory>

#include "oracle.hpp"
#include "report.h"
#include "subject.h"

using namespace oracle;

namespace {

// relative to the largest number of its kind in the problem; both sides are double precision
const double limit = 1e-9;

double norm(const VectorXd &x)
{
  return x.size() > 0 ? x.lpNorm<Eigen::Infinity>() : 0.0;
}

double norm(const std::vector<Vector6d> &list)
{
  double y = 0.0;

  for (const Vector6d &w : list)
    y = std::max(y, w.lpNorm<Eigen::Infinity>());
  return y;
}

struct Got {
  double q[MECH_COORDINATES], v[MECH_COORDINATES], a[MECH_COORDINATES];
  std::vector<Vector6d> reaction, loop;
  std::vector<double> rod;
  VectorXd drive;
};

void read(subject &s, Got &got)
{
  maggi_model_info info;

  subject_get(&s, got.q, got.v, got.a);
  maggi_model_get_info(s.model, &info);
  std::vector<double> wrench(6 * static_cast<size_t>(info.bodies)), drive(info.coordinates + 1);
  maggi_get_reactions(s.data, wrench.data());
  maggi_get_drives(s.data, drive.data());
  for (int i = 0; i < s.m.nbody; ++i)
    got.reaction.push_back(Eigen::Map<Vector6d>(&wrench[6 * static_cast<size_t>(s.body[i])]));
  for (int i = 0; i < s.m.nloop + s.m.nrod; ++i) {
    Vector6d w;
    subject_loop_wrench(&s, i, w.data());
    if (i < s.m.nloop)
      got.loop.push_back(w);
    else
      got.rod.push_back(w[0]);
  }
  got.drive = VectorXd::Zero(s.m.nq);
  for (int i = 0; i < s.m.nq; ++i)
    got.drive[i] = drive[s.q[i]];
}

void check_forces(const subject &s, const Oracle &o, const Solution &x, const Got &got)
{
  uint64_t seed = s.m.seed;
  double scale = std::max({1.0, norm(x.reaction), norm(got.reaction), norm(got.loop)});
  double worst = 0.0, cut = 0.0, rod = 0.0, drive = 0.0;

  for (int i = 0; i < s.m.nbody; ++i) {
    if (x.reaction_unique[i])
      worst = std::max(worst, norm(x.reaction[i] - got.reaction[i]));
    report_count(x.reaction_unique[i] ? "joint wrenches that are unique"
                                      : "joint wrenches that are not");
  }
  for (int i = 0; i < s.m.nloop; ++i) {
    if (x.loop_unique[i])
      cut = std::max(cut, norm(x.loop[i] - got.loop[i]));
    report_count(x.loop_unique[i] ? "loop wrenches that are unique" : "loop wrenches that are not");
  }
  for (int i = 0; i < s.m.nrod; ++i) {
    if (x.rod_unique[i])
      rod = std::max(rod, std::fabs(x.rod[i] - got.rod[i]));
    report_count(x.rod_unique[i] ? "rod forces that are unique" : "rod forces that are not");
  }
  for (int i = 0; i < s.m.nq; ++i)
    if (x.drive_unique[i])
      drive = std::max(drive, std::fabs(x.drive[i] - got.drive[i]));
  report_near(seed, "joint reactions", worst / scale, limit);
  if (s.m.nloop > 0)
    report_near(seed, "loop multipliers as wrenches", cut / scale, limit);
  if (s.m.nrod > 0)
    report_near(seed, "rod multipliers", rod / scale, limit);
  report_near(seed, "drives of guides", drive / scale, limit);
  // unique or not, reactions and multipliers must balance each body and work on no coordinate
  report_near(seed, "balance of forces on every body",
              norm(o.imbalance(x.x, got.reaction, got.loop, got.rod)) / scale, limit);
  report_near(seed, "joint wrenches do no work on free coordinates",
              norm(o.effort(got.reaction) - got.drive) / scale, limit);
}

void check_accelerations(const subject &s, const Solution &x, const Got &got)
{
  uint64_t seed = s.m.seed;
  std::vector<mech_pose> pose(static_cast<size_t>(s.m.nbody));
  Eigen::Map<const VectorXd> a(got.a, s.m.nq);
  double worst = 0.0;

  report_near(seed, "joint accelerations", norm(x.a - a) / std::max(1.0, norm(x.a)), limit);
  mech_motion(&s.m, got.q, got.v, got.a, pose.data());
  for (int i = 0; i < s.m.nbody; ++i) {
    Inertia in = inertia(s.m, i);
    double r[3], v[3], g[3];
    mech_point(&s.m, pose.data(), i, in.cog.data(), r, v, g);
    for (int k = 0; k < 3; ++k) {
      worst = std::max(worst, std::fabs(g[k] - x.x[6 * i + k]));
      worst = std::max(worst, std::fabs(pose[i].dw[k] - x.x[6 * i + 3 + k]));
    }
  }
  report_near(seed, "body accelerations", worst / std::max(1.0, norm(x.x)), limit);
  report_near(seed, "velocities satisfy all constraints", x.velocity, 1e-10);
  report_near(seed, "oracle: redundant rows agree", x.redundant / std::max(1.0, norm(x.x)), limit);
}

// R_z moves bodies as the constraints allow; V^T M V is the reduced mass matrix
void check_mass(const subject &s, const Oracle &o)
{
  int n = subject_columns(&s), nq = s.m.nq;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> R(nq, n), Mr(n, n);
  MatrixXd V(o.mass().rows(), n);

  subject_velocity_columns(&s, R.data());
  subject_reduced_mass(&s, Mr.data());
  for (int c = 0; c < n; ++c) {
    VectorXd column = R.col(c);
    V.col(c) = o.velocities(column.data());
  }
  MatrixXd expected = V.transpose() * o.mass() * V;
  double worst = (expected - Mr).lpNorm<Eigen::Infinity>();
  report_near(s.m.seed, "reduced mass matrix", worst / expected.lpNorm<Eigen::Infinity>(), 1e-12);
}

// rates of the angles of R = Rz(yaw) Ry(pitch) Rx(roll) by R' = w x R
Vector3d angle_rates(const mech_pose &pose)
{
  const double *A = pose.A;
  Eigen::Matrix3d R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(A), S;
  for (int k = 0; k < 3; ++k)
    S.col(k) = Eigen::Map<const Vector3d>(pose.w).cross(R.col(k));

  return {(A[8] * S(2, 1) - A[7] * S(2, 2)) / (A[7] * A[7] + A[8] * A[8]),
          -S(2, 0) / std::sqrt(1.0 - A[6] * A[6]),
          (A[0] * S(1, 0) - A[3] * S(0, 0)) / (A[0] * A[0] + A[3] * A[3])};
}

// length and rate from the ends, force as it is judged by check_forces
Vector3d rod_columns(const subject &s, const mech_pose *pose, const Got &got, int i)
{
  const mech_rod &rod = s.m.rod[i];
  double a[3][3], b[3][3];
  mech_point(&s.m, pose, rod.a, rod.def.point_a, a[0], a[1], a[2]);
  mech_point(&s.m, pose, rod.b, rod.def.point_b, b[0], b[1], b[2]);
  Vector3d e = Eigen::Map<Vector3d>(a[0]) - Eigen::Map<Vector3d>(b[0]);
  Vector3d ev = Eigen::Map<Vector3d>(a[1]) - Eigen::Map<Vector3d>(b[1]);

  return {e.norm(), e.dot(ev) / e.norm(), got.rod[static_cast<size_t>(i)]};
}

// `cog` of the definition, to which point masses do not add
void sensor_point(const subject &s, const mech_sensor &x, double point[3])
{
  const maggi_body_def &body = s.m.body[x.body].def;

  for (int k = 0; k < 3; ++k)
    point[k] = !x.def.at_cog  ? x.def.point[k]
               : body.is_bar ? 0.5 * (body.bar_from[k] + body.bar_to[k])
                             : body.cog[k];
}

Vector3d sensor_columns(const subject &s, const Oracle &o, const mech_pose *pose, const Got &got,
                        const mech_sensor &x)
{
  const double *A = pose[x.body].A;
  double point[3], y[3][3];

  sensor_point(s, x, point);
  mech_point(&s.m, pose, x.body, point, y[0], y[1], y[2]);
  switch (x.def.type) {
  case MAGGI_SENSOR_ANGLES:
    return {std::atan2(A[7], A[8]), std::asin(std::max(-1.0, std::min(1.0, -A[6]))),
            std::atan2(A[3], A[0])};
  case MAGGI_SENSOR_ANGLE_RATES:
    return angle_rates(pose[x.body]);
  case MAGGI_SENSOR_ANGULAR_VELOCITY:
    return Eigen::Map<const Vector3d>(pose[x.body].w);
  case MAGGI_SENSOR_ANGULAR_ACCELERATION:
    return Eigen::Map<const Vector3d>(pose[x.body].dw);
  case MAGGI_SENSOR_SPRING:
    return o.spring(x.element);
  case MAGGI_SENSOR_JOINT_SPRING:
    return o.joint_spring(x.element);
  case MAGGI_SENSOR_ROD:
    return rod_columns(s, pose, got, x.element);
  default:
    return Eigen::Map<const Vector3d>(y[x.def.type]);
  }
}

void check_sensors(const subject &s, const Oracle &o, const Got &got)
{
  std::vector<mech_pose> pose(static_cast<size_t>(s.m.nbody));
  std::vector<double> column(3 * static_cast<size_t>(s.m.nsensor) + 1);
  double worst = 0.0, size = 1.0;

  mech_motion(&s.m, got.q, got.v, got.a, pose.data());
  maggi_get_sensors(s.data, column.data());
  for (int i = 0; i < s.m.nsensor; ++i) {
    const mech_sensor &x = s.m.sensor[i];
    // roll and yaw are lost where pitch is a right angle
    if ((x.def.type == MAGGI_SENSOR_ANGLES || x.def.type == MAGGI_SENSOR_ANGLE_RATES) &&
        std::fabs(pose[x.body].A[6]) > 0.999)
      continue;
    Vector3d y = sensor_columns(s, o, pose.data(), got, x);
    for (int k = 0; k < 3; ++k) {
      worst = std::max(worst, std::fabs(y[k] - column[3 * i + k]));
      size = std::max(size, std::fabs(y[k]));
    }
  }
  report_near(s.m.seed, "sensors", worst / size, 1e-12);
}

void check_state(subject &s)
{
  auto got = std::make_unique<Got>();
  maggi_loop_state loops;
  maggi_energy energy;

  read(s, *got);
  Oracle o(s.m, maggi_get_time(s.data), got->q, got->v);
  Solution x = o.solve();
  maggi_get_loop_state(s.data, &loops);
  report_true(s.m.seed, "degrees of freedom = 6 bodies - rank of all constraints",
              loops.dof == x.dof);
  if (loops.dof != x.dof)
    std::fprintf(stderr, "seed %llu: dof %d, oracle %d; smallest pivot %.3g, gap %.3g\n",
                 static_cast<unsigned long long>(s.m.seed), loops.dof, x.dof, x.smallest, x.gap);
  report_true(s.m.seed, "coordinates = dof + rank + guides",
              s.m.nq == loops.rank + subject_columns(&s));
  check_accelerations(s, x, *got);
  check_forces(s, o, x, *got);
  check_mass(s, o);
  check_sensors(s, o, *got);
  maggi_get_energy(s.data, &energy);
  report_near(s.m.seed, "kinetic energy",
              std::fabs(energy.kinetic - o.kinetic()) / std::max(1.0, o.kinetic()), 1e-12);
  report_near(s.m.seed, "potential energy",
              std::fabs(energy.potential - o.potential()) /
                  std::max(1.0, std::fabs(o.potential())), 1e-11);
}

// coordinates in threes about global axes have singular positions of their own
bool is_small(const mechanism &m)
{
  for (int i = 0; i < m.nbody; ++i)
    if (m.body[i].def.joint == MAGGI_JOINT_SPHERICAL || m.body[i].def.joint == MAGGI_JOINT_FREE)
      return false;
  return m.nbody <= 15;
}

bool is_guided(const mechanism &m)
{
  for (int i = 0; i < m.nbody; ++i)
    for (int k = 0; k < m.body[i].dof; ++k)
      if (m.body[i].motion[k] >= 0)
        return true;
  return false;
}

// A guide may drive loops against a dead point: that is said and ends the run.  Singular positions
// are passed at the default tolerance, round-off cannot be reached there.
void check_later(subject &s)
{
  maggi_loop_state loops;

  maggi_data_set_tolerance(s.data, 1e-10);
  for (int i = 0; i < 500; ++i) {
    if (i == 490)
      maggi_data_set_tolerance(s.data, SUBJECT_TOLERANCE);
    maggi_status status = maggi_step(s.data, 2e-3);
    if (status == MAGGI_E_LOCKUP && s.m.nloop + s.m.nrod > 0 && is_guided(s.m)) {
      report_count("after 1 s: locked up by a guide");
      return;
    }
    if (!report_true(s.m.seed, "every step succeeds", status == MAGGI_OK)) {
      std::fprintf(stderr, "seed %llu: %s\n", static_cast<unsigned long long>(s.m.seed),
                   maggi_data_message(s.data));
      return;
    }
  }
  maggi_get_loop_state(s.data, &loops);
  report_count(loops.changes > 0 ? "after 1 s: independent coordinates have changed"
                                 : "after 1 s: independent coordinates are the same");
  check_state(s);
}

void check_seed(uint64_t seed, bool verbose)
{
  auto s = std::make_unique<subject>();
  maggi_loop_state loops;

  if (!subject_create(seed, s.get()))
    return;
  maggi_get_loop_state(s->data, &loops);
  report_count(mech_kind_text(s->m.kind));
  if (verbose)
    std::printf("seed %llu: %s: %d bodies, %d coordinates, dof %d, rank %d, %d loops, %d rods\n",
                static_cast<unsigned long long>(seed), mech_kind_text(s->m.kind), s->m.nbody,
                s->m.nq, loops.dof, loops.rank, s->m.nloop, s->m.nrod);
  check_state(*s);
  if (subject_steps(s.get(), 50, 1e-3)) {
    check_state(*s);
    if (is_small(s->m))
      check_later(*s);
  }
  subject_free(s.get());
}

} // namespace

int main(int argc, char **argv)
{
  report_options options = {1, 700, 0};

  if (!report_parse(argc, argv, &options))
    return 2;
  for (long i = 0; i < options.count; ++i)
    check_seed(options.from + static_cast<uint64_t>(i), options.verbose != 0);
  return report_done("property_oracle");
}
