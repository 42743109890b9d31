#include <libhair/guides/literal.h>

namespace hair::literal {

namespace {

using Matrix = std::vector<std::vector<double>>;

Matrix zeros(std::size_t rows, std::size_t columns) {
  return Matrix(rows, std::vector<double>(columns));
}

// The solution of a b' = b, by elimination. Diagonally dominant systems need no pivoting.
template <class Value>
std::vector<Value> solve(Matrix a, std::vector<Value> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return b;
}

glm::dvec3 fromWorld(const Frame& f, glm::dvec3 v) {
  return {glm::dot(v, f.normal), glm::dot(v, glm::cross(f.tangent, f.normal)),
          glm::dot(v, f.tangent)};
}

glm::dvec3 toWorld(const Frame& f, glm::dvec3 v) {
  return v.x * f.normal + v.y * glm::cross(f.tangent, f.normal) + v.z * f.tangent;
}

// Parallel transport: the frame, turned by the shortest rotation of its tangent to `to`.
Frame transported(const Frame& f, glm::dvec3 to) {
  const glm::dvec3 h = f.tangent + to;
  return {to, f.normal - 2 * glm::dot(f.normal, to) / glm::dot(h, h) * h};
}

// Q, [joints][points]: q_i = d_i - d_(i-1) with d_i = (x_(i+1) - x_i) / l_i. The root's direction,
// d_(-1), is a constant.
Matrix bendOfPoints(const Guide& guide) {
  Matrix q = zeros(guide.links(), guide.points());
  for (std::size_t i = 0; i < guide.links(); ++i) {
    q[i][i + 1] += 1 / guide.length[i];
    q[i][i] -= 1 / guide.length[i];
    if (i == 0) continue;
    q[i][i] -= 1 / guide.length[i - 1];
    q[i][i - 1] += 1 / guide.length[i - 1];
  }
  return q;
}

// W, [points].
std::vector<glm::dmat3> inverseMasses(const Guide& guide, std::span<const Contact> contacts) {
  constexpr double kSlide = 0.98;
  std::vector<glm::dmat3> w(guide.points(), glm::dmat3(0));
  for (std::size_t i = 1; i < guide.points(); ++i) {
    const glm::dvec3 n = contacts[i].normal;
    w[i] = glm::dmat3(1);
    if (contacts[i].touching) w[i] -= kSlide * glm::outerProduct(n, n);
    w[i] /= guide.mass[i];
  }
  return w;
}

}  // namespace

Guide::Guide(const GuideStrands& guides, std::size_t guide) {
  const std::size_t n = guides.pointsPerGuide(), group = guide / kLanes, l = guide % kLanes;
  for (std::size_t at = group * n; at < (group + 1) * n; ++at)
    mass.push_back(guides.pointMass[at][l]);
  for (std::size_t at = group * (n - 1); at < (group + 1) * (n - 1); ++at) {
    length.push_back(guides.linkLength[at][l]);
    tension.push_back(guides.restTension[at][l]);
    stiffness.push_back(guides.jointStiffness[at][l]);
    curvature.emplace_back(lane(guides.curvature[at], l));
  }
}

std::vector<glm::dvec3> bend(const Guide& guide, const Frame& root, const Frame& rootBefore,
                             std::span<const glm::dvec3> before, std::span<const glm::dvec3> force,
                             double h, double bendDamping, std::span<const glm::dvec3> x) {
  const std::size_t points = guide.points(), links = guide.links();
  const double damping = bendDamping / h;
  const Matrix q = bendOfPoints(guide);
  Matrix a = zeros(points, points);
  std::vector<glm::dvec3> b(force.begin(), force.end());

  // The right-hand side: f - Qᵀ g.
  Frame now = root, then = rootBefore;
  glm::dvec3 d = root.tangent, dThen = rootBefore.tangent;
  for (std::size_t i = 0; i < links; ++i) {
    const glm::dvec3 next = (x[i + 1] - x[i]) / guide.length[i];
    const glm::dvec3 bent = fromWorld(now, next - d), bentThen = fromWorld(then, before[i] - dThen);
    const glm::dvec3 g =
        guide.stiffness[i] * toWorld(now, bent - guide.curvature[i] + damping * (bent - bentThen));
    for (std::size_t j = 0; j < points; ++j) b[j] -= q[i][j] * g;
    now = transported(now, glm::normalize(next)), then = transported(then, before[i]);
    d = next, dThen = before[i];
  }

  // The matrix: M / h² + (1 + D) Qᵀ kappa Q + S.
  for (std::size_t j = 0; j < points; ++j) a[j][j] += guide.mass[j] / (h * h);
  for (std::size_t i = 0; i < links; ++i)
    for (std::size_t j = 0; j < points; ++j)
      for (std::size_t k = 0; k < points; ++k)
        a[j][k] += (1 + damping) * guide.stiffness[i] * q[i][j] * q[i][k];
  for (std::size_t i = 0; i < links; ++i) {
    const double perLength = guide.tension[i] / guide.length[i];
    if (guide.tension[i] <= guide.mass[i + 1] * guide.length[i] / (4 * h * h)) continue;
    a[i][i] += perLength, a[i + 1][i + 1] += perLength;
    a[i][i + 1] -= perLength, a[i + 1][i] -= perLength;
  }

  // The root does not move: its row reads y_0 - x_0 = 0.
  a[0].assign(points, 0);
  a[0][0] = 1, b[0] = glm::dvec3(0);
  std::vector<glm::dvec3> y = solve(a, b);
  for (std::size_t i = 0; i < points; ++i) y[i] += x[i];
  return y;
}

LinkStep correctLinks(const Guide& guide, std::span<const Contact> contacts,
                      std::span<const glm::dvec3> x) {
  const std::size_t points = guide.points(), links = guide.links();
  const std::vector<glm::dmat3> w = inverseMasses(guide, contacts);
  // Row i of J: -d_i at point i, d_i at point i + 1.
  std::vector<std::vector<glm::dvec3>> j(links, std::vector<glm::dvec3>(points, glm::dvec3(0)));
  std::vector<double> minusC(links);
  for (std::size_t i = 0; i < links; ++i) {
    const glm::dvec3 e = x[i + 1] - x[i];
    j[i][i + 1] = glm::normalize(e), j[i][i] = -j[i][i + 1];
    minusC[i] = guide.length[i] - glm::length(e);
  }
  Matrix a = zeros(links, links);
  for (std::size_t r = 0; r < links; ++r)
    for (std::size_t s = 0; s < links; ++s)
      for (std::size_t p = 0; p < points; ++p) a[r][s] += glm::dot(j[r][p], w[p] * j[s][p]);

  LinkStep step{solve(a, minusC), {x.begin(), x.end()}};
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t r = 0; r < links; ++r) step.x[p] += step.lambda[r] * (w[p] * j[r][p]);
  return step;
}

LinkStep relaxLinks(const Guide& guide, std::span<const Contact> contacts,
                    std::span<const glm::dvec3> x) {
  const std::vector<glm::dmat3> w = inverseMasses(guide, contacts);
  LinkStep step{std::vector<double>(guide.links()), {x.begin(), x.end()}};
  for (std::size_t i = 0; i < guide.links(); ++i) {
    const glm::dvec3 e = step.x[i + 1] - step.x[i], d = glm::normalize(e);
    const double lambda = (guide.length[i] - glm::length(e)) / glm::dot(d, (w[i] + w[i + 1]) * d);
    step.x[i] -= lambda * (w[i] * d);
    step.x[i + 1] += lambda * (w[i + 1] * d);
    step.lambda[i] = lambda;
  }
  return step;
}

}  // namespace hair::literal
