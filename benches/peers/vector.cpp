// Hand-written column: lanes over modes with compiler vector types. Compile with -DMODES=<modes>: 1, 2, 4 or a multiple of 8.
// Per pair of modes eight components of T_νμ are multiplied by q and three by q̇; everything else is sums over lanes.
#include <cstring>
#define M MODES
#define INLINE static inline __attribute__((always_inline))
constexpr int W = M < 8 ? M : 8, G = M / W, N = 6 + M;
template <int K> struct vector_of { typedef double type __attribute__((vector_size(8 * K))); };
template <> struct vector_of<1> { typedef double type; };
typedef vector_of<W>::type V;

INLINE V load(const double *p) { V v; memcpy(&v, p, sizeof v); return v; }
INLINE void store(double *p, V v) { memcpy(p, &v, sizeof v); }
INLINE V all(double x) { return V{} + x; }

// Sums over the lanes of K vectors: halves are folded pairwise, so that eight vectors become one.
template <int K> INLINE void sums(const V *v, double *out) {
#if M >= 8
  for (int first = 0; first < K; first += 8) {
    V a[8];
    for (int k = 0; k < 8; k++) a[k] = first + k < K ? v[first + k] : V{};
#define MIX __builtin_shufflevector
    for (int k = 0; k < 4; k++)
      a[k] = MIX(a[2 * k], a[2 * k + 1], 0, 8, 2, 10, 4, 12, 6, 14) + MIX(a[2 * k], a[2 * k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    for (int k = 0; k < 2; k++)
      a[k] = MIX(a[2 * k], a[2 * k + 1], 0, 1, 8, 9, 4, 5, 12, 13) + MIX(a[2 * k], a[2 * k + 1], 2, 3, 10, 11, 6, 7, 14, 15);
    double r[8];
    store(r, MIX(a[0], a[1], 0, 1, 2, 3, 8, 9, 10, 11) + MIX(a[0], a[1], 4, 5, 6, 7, 12, 13, 14, 15));
    for (int k = 0; k < 8 && first + k < K; k++) out[first + k] = r[k];
  }
#else
  for (int k = 0; k < K; k++) {
    double r[W], s = 0;
    store(r, v[k]);
    for (int i = 0; i < W; i++) s += r[i];
    out[k] = s;
  }
#endif
}

struct S3 { double xx, yy, zz, xy, xz, yz; };
struct R3 { double x, y, z; };
INLINE R3 operator+(R3 a, R3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
INLINE R3 operator-(R3 a, R3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
INLINE R3 operator*(double s, R3 a) { return {s * a.x, s * a.y, s * a.z}; }
INLINE R3 cross(R3 a, R3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
INLINE double dot(R3 a, R3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
INLINE R3 times(const S3 &s, R3 v) { return {dot({s.xx, s.xy, s.xz}, v), dot({s.xy, s.yy, s.yz}, v), dot({s.xz, s.yz, s.zz}, v)}; }
INLINE S3 inverse(const S3 &s) {
  double a = s.yy * s.zz - s.yz * s.yz, b = s.xz * s.yz - s.xy * s.zz, c = s.xy * s.yz - s.xz * s.yy;
  double f = 1 / (s.xx * a + s.xy * b + s.xz * c);
  return {a * f, (s.xx * s.zz - s.xz * s.xz) * f, (s.xx * s.yy - s.xy * s.xy) * f, b * f, c * f, (s.xy * s.xz - s.xx * s.yz) * f};
}

static struct alignas(64) {
  V pair[G][M][8], position[G][9], first[G][3], stiffness[G];
  double mass;
  R3 moment;
  S3 inertia, compliance;
} body;
struct State { R3 moment, translation, rotation; S3 inertia; V coupling[G][3], modal[G]; };

INLINE void evaluate(const double *q, const double *rates, R3 w, State &s) {
  const V weight[6] = {all(-w.y * w.y - w.z * w.z), all(w.y * w.y - w.x * w.x), all(w.z * w.z - w.x * w.x),
                       all(w.x * w.y), all(w.x * w.z), all(w.y * w.z)};
  V sum[21] = {};
#pragma GCC unroll 1
  for (int g = 0; g < G; g++) {
    const V *base = body.position[g];
    V d[8], u[3] = {};
    for (int c = 0; c < 8; c++) d[c] = base[c + 1];
#pragma GCC unroll 4
    for (int nu = 0; nu < M; nu++) {
      const V *t = body.pair[g][nu], x = all(q[nu]), y = all(rates[nu]);
      for (int c = 0; c < 8; c++) d[c] += t[c] * x;
      for (int c = 0; c < 3; c++) u[c] += t[5 + c] * y;
    }
    V x = load(q + g * W), y = load(rates + g * W), trace = base[0] + x;
    s.modal[g] = trace * weight[0] + d[0] * weight[1] + d[1] * weight[2] + d[2] * weight[3] + d[3] * weight[4] + d[4] * weight[5] +
                 u[0] * all(2 * w.x) + u[1] * all(2 * w.y) + u[2] * all(2 * w.z);
    sum[0] += (base[0] + trace) * x, sum[6] += trace * y;
    for (int c = 0; c < 5; c++) sum[1 + c] += (base[1 + c] + d[c]) * x, sum[7 + c] += d[c] * y;
    for (int c = 0; c < 3; c++) {
      s.coupling[g][c] = d[5 + c];
      sum[12 + c] += d[5 + c] * y, sum[15 + c] += body.first[g][c] * x, sum[18 + c] += body.first[g][c] * y;
    }
  }
  double h[21];
  sums<21>(sum, h);
  s.moment = body.moment + R3{h[15], h[16], h[17]};
  const S3 &i = body.inertia;
  s.inertia = {i.xx + h[1] + h[2], i.yy + h[0] - h[1], i.zz + h[0] - h[2], i.xy - h[3] / 2, i.xz - h[4] / 2, i.yz - h[5] / 2};
  S3 growth = {2 * (h[7] + h[8]), 2 * (h[6] - h[7]), 2 * (h[6] - h[8]), -h[9], -h[10], -h[11]};
  s.translation = cross(w, cross(w, s.moment) + 2 * R3{h[18], h[19], h[20]});
  s.rotation = cross(w, times(s.inertia, w) + R3{h[12], h[13], h[14]}) + times(growth, w);
}

INLINE void write_mass(const State &s, double *m) {
  const R3 r = s.moment;
  const S3 &i = s.inertia;
  const double a = body.mass, rigid[6][6] = {{a, 0, 0, 0, r.z, -r.y}, {0, a, 0, -r.z, 0, r.x}, {0, 0, a, r.y, -r.x, 0},
    {0, -r.z, r.y, i.xx, i.xy, i.xz}, {r.z, 0, -r.x, i.xy, i.yy, i.yz}, {-r.y, r.x, 0, i.xz, i.yz, i.zz}};
  for (int row = 0; row < 6; row++) {
    memcpy(m + row * N, rigid[row], sizeof rigid[row]);
    for (int g = 0; g < G; g++) store(m + row * N + 6 + g * W, row < 3 ? body.first[g][row] : s.coupling[g][row - 3]);
  }
  for (int mu = 0; mu < M; mu++) {
    double *row = m + (6 + mu) * N;
    const double *b = (const double *)body.first[mu / W] + mu % W, *v = (const double *)s.coupling[mu / W] + mu % W;
    for (int c = 0; c < 3; c++) row[c] = b[c * W], row[3 + c] = v[c * W];
    for (int nu = 0; nu < M; nu++) row[6 + nu] = 0;
    row[6 + mu] = 1;
  }
}

INLINE void write_quadratic(const State &s, double *out) {
  memcpy(out, &s.translation, 24), memcpy(out + 3, &s.rotation, 24);
  for (int g = 0; g < G; g++) store(out + 6 + g * W, s.modal[g]);
}

INLINE void solve(const State &s, const double *q, const double *force, double *out) {
  V sum[21] = {}, rest[G];
  for (int g = 0; g < G; g++) {
    const V *v = s.coupling[g], *b = body.first[g];
    V f = rest[g] = load(force + 6 + g * W) - s.modal[g] - body.stiffness[g] * load(q + g * W);
    for (int c = 0; c < 9; c++) sum[c] += b[c / 3] * v[c % 3];
    sum[9] += v[0] * v[0], sum[10] += v[1] * v[1], sum[11] += v[2] * v[2], sum[12] += v[0] * v[1], sum[13] += v[0] * v[2], sum[14] += v[1] * v[2];
    for (int c = 0; c < 3; c++) sum[15 + c] += b[c] * f, sum[18 + c] += v[c] * f;
  }
  double h[21];
  sums<21>(sum, h);
  const R3 r = s.moment;
  const R3 c[3] = {{-h[0], -r.z - h[3], r.y - h[6]}, {r.z - h[1], -h[4], -r.x - h[7]}, {-r.y - h[2], r.x - h[5], -h[8]}};
  R3 t = times(body.compliance, R3{force[0], force[1], force[2]} - s.translation - R3{h[15], h[16], h[17]});
  R3 k = R3{force[3], force[4], force[5]} - s.rotation - R3{h[18], h[19], h[20]} - R3{dot(c[0], t), dot(c[1], t), dot(c[2], t)};
  R3 p[3] = {times(body.compliance, c[0]), times(body.compliance, c[1]), times(body.compliance, c[2])};
  const S3 &i = s.inertia;
  S3 left = {i.xx - h[9] - dot(c[0], p[0]), i.yy - h[10] - dot(c[1], p[1]), i.zz - h[11] - dot(c[2], p[2]),
             i.xy - h[12] - dot(c[0], p[1]), i.xz - h[13] - dot(c[0], p[2]), i.yz - h[14] - dot(c[1], p[2])};
  R3 a = times(inverse(left), k);
  t = t - (a.x * p[0] + a.y * p[1] + a.z * p[2]);
  memcpy(out, &t, 24), memcpy(out + 3, &a, 24);
  for (int g = 0; g < G; g++) {
    const V *v = s.coupling[g], *b = body.first[g];
    store(out + 6 + g * W, rest[g] - b[0] * all(t.x) - b[1] * all(t.y) - b[2] * all(t.z) - v[0] * all(a.x) - v[1] * all(a.y) - v[2] * all(a.z));
  }
}

extern "C" {
int ffrf_prepare(int modes, const double *p) {
  if (modes != M) return 1;
  auto put = [](V &v, int k, double x) { double l[W]; store(l, v); l[k] = x; v = load(l); };
  auto parts = [](const double *t, double *c) {
    const double o[9] = {t[0] + t[4] + t[8], t[4], t[8], t[1] + t[3], t[2] + t[6], t[5] + t[7], t[5] - t[7], t[6] - t[2], t[1] - t[3]};
    memcpy(c, o, sizeof o);
  };
  body.mass = p[0], body.moment = p[0] * R3{p[1], p[2], p[3]}, body.inertia = {p[4], p[8], p[12], p[5], p[6], p[9]};
  S3 left = {p[0], p[0], p[0], 0, 0, 0};
  const double *position = p + 13 + 3 * M, *pair = position + 9 * M;
  for (int mu = 0; mu < M; mu++) {
    int g = mu / W, l = mu % W;
    double c[9], b[3];
    for (int i = 0; i < 3; i++) put(body.first[g][i], l, b[i] = p[0] * p[13 + 3 * mu + i]);
    left = {left.xx - b[0] * b[0], left.yy - b[1] * b[1], left.zz - b[2] * b[2], left.xy - b[0] * b[1], left.xz - b[0] * b[2], left.yz - b[1] * b[2]};
    put(body.stiffness[g], l, pair[9 * M * M + mu]);
    parts(position + 9 * mu, c);
    for (int i = 0; i < 9; i++) put(body.position[g][i], l, c[i]);
    for (int nu = 0; nu < M; nu++) {
      parts(pair + 9 * (M * nu + mu), c);
      for (int i = 0; i < 8; i++) put(body.pair[g][nu][i], l, c[i + 1]);
    }
  }
  body.compliance = inverse(left);
  return 0;
}
void ffrf_equations(const double *q, const double *rates, const double *w, const double *force, double *mass, double *quadratic, double *acceleration) {
  State s;
  evaluate(q, rates, {w[0], w[1], w[2]}, s);
  solve(s, q, force, acceleration);
  write_quadratic(s, quadratic);
  write_mass(s, mass);
}
void ffrf_accelerations(const double *q, const double *rates, const double *w, const double *force, double *acceleration) {
  State s;
  evaluate(q, rates, {w[0], w[1], w[2]}, s);
  solve(s, q, force, acceleration);
}
}
