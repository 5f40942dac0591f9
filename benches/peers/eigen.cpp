// Plain Eigen: the equations as they stand, fixed sizes, Cholesky factorisation of the whole mass matrix. -DMODES=<modes>
#include <Eigen/Dense>
#include <array>
using namespace Eigen;
constexpr int M = MODES, N = 6 + M;
using Modal = Matrix<double, M, 1>;
using Coupling = Matrix<double, 3, M>;
using Mass = Matrix<double, N, N>;
using Force = Matrix<double, N, 1>;

static struct {
  double mass;
  Vector3d centre;
  Matrix3d inertia;
  Coupling shift, spin;                              // B, Ξ
  std::array<Matrix3d, M> modal;                     // Θ_μ
  std::array<std::array<Matrix3d, M>, M> pair;       // Θ_μν
  std::array<Coupling, M> whirl;                     // ϑ_μν, columns ν
  Modal stiffness;
} body;

static Matrix3d tilde(const Vector3d &v) {
  Matrix3d s;
  s << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return s;
}

static void evaluate(const Modal &q, const Modal &rates, const Vector3d &w, Map<Mass> &mass, Map<Force> &quadratic) {
  Vector3d moment = body.mass * (body.centre + body.shift * q);
  Matrix3d inertia = body.inertia;
  Coupling coupling = body.spin, forces;
  Matrix3d rate = Matrix3d::Zero();
  Modal turned;
  for (int mu = 0; mu < M; mu++) {
    Matrix3d deformed = body.modal[mu];
    for (int nu = 0; nu < M; nu++) deformed += q(nu) * body.pair[nu][mu];
    inertia += q(mu) * (body.modal[mu].transpose() + deformed);
    rate += rates(mu) * deformed;
    coupling += q(mu) * body.whirl[mu];
    turned(mu) = -w.dot(deformed * w) - 2 * w.dot(body.whirl[mu] * rates);
  }
  mass.setZero();
  mass.topLeftCorner<3, 3>() = body.mass * Matrix3d::Identity();
  mass.block<3, 3>(0, 3) = -tilde(moment), mass.block<3, 3>(3, 0) = tilde(moment);
  mass.block<3, 3>(3, 3) = inertia;
  mass.block<3, M>(0, 6) = body.mass * body.shift, mass.block<M, 3>(6, 0) = body.mass * body.shift.transpose();
  mass.block<3, M>(3, 6) = coupling, mass.block<M, 3>(6, 3) = coupling.transpose();
  mass.block<M, M>(6, 6).setIdentity();
  quadratic.head<3>() = w.cross(w.cross(moment) + 2 * body.mass * (body.shift * rates));
  quadratic.segment<3>(3) = w.cross(inertia * w) + 2 * (rate * w);
  quadratic.tail<M>() = turned;
}

extern "C" {
int ffrf_prepare(int modes, const double *p) {
  if (modes != M) return 1;
  typedef Map<const Matrix<double, 3, 3, RowMajor>> Rows;
  auto tensor = [](const double *t) -> Matrix3d { return Rows(t).trace() * Matrix3d::Identity() - Rows(t).transpose(); };
  auto axial = [](const double *t) { return Vector3d(t[5] - t[7], t[6] - t[2], t[1] - t[3]); };
  body.mass = p[0], body.centre = Map<const Vector3d>(p + 1), body.inertia = Rows(p + 4), body.shift = Map<const Coupling>(p + 13);
  const double *position = p + 13 + 3 * M, *pair = position + 9 * M;
  for (int mu = 0; mu < M; mu++) {
    body.modal[mu] = tensor(position + 9 * mu), body.spin.col(mu) = axial(position + 9 * mu);
    for (int nu = 0; nu < M; nu++) {
      body.pair[mu][nu] = tensor(pair + 9 * (M * mu + nu)), body.whirl[mu].col(nu) = axial(pair + 9 * (M * mu + nu));
    }
  }
  body.stiffness = Map<const Modal>(pair + 9 * M * M);
  return 0;
}
void ffrf_equations(const double *q, const double *rates, const double *w, const double *force, double *m, double *g, double *a) {
  Map<Mass> mass(m);
  Map<Force> quadratic(g), acceleration(a);
  evaluate(Map<const Modal>(q), Map<const Modal>(rates), Map<const Vector3d>(w), mass, quadratic);
  Force right = Map<const Force>(force) - quadratic;
  right.tail<M>() -= body.stiffness.cwiseProduct(Map<const Modal>(q));
  acceleration = Mass(mass).llt().solve(right);
}
}
