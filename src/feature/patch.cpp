#include "feature/patch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace arris {
namespace {

constexpr std::size_t most_members = 28;
constexpr std::size_t quadric_members = 8;
constexpr std::size_t large_members = 9;
// Patches end at this distance from their centre, in units of spacing.
constexpr double reach = 3.5;
// Weight of a member falls off as a Gaussian of this width, in units of spacing.
constexpr double fit_width = 1.5;
// Ridge on second derivatives: small against what well spread members say.
constexpr double ridge = 1e-3;
// A facet thinner than this share of its longest side has no normal to judge by.
constexpr double sliver = 0.15;
// Least angle of the star of the centre, radians, that a patch must cover.
constexpr int polish_steps = 6;
constexpr double residual_floor = 1e-4;
constexpr double plane_share = 0.6;
constexpr double least_fan = 50 * std::numbers::pi / 180;

bool contains(const std::vector<Index>& list, Index i) {
  return std::find(list.begin(), list.end(), i) != list.end();
}

}  // namespace

PatchGrower::PatchGrower(const std::vector<Vec3>& points, const FacetMesh& mesh,
                         const std::vector<double>& spacing)
    : points_(points), mesh_(mesh), spacing_(spacing) {}

Vec3 PatchGrower::facet_normal(Index f) const {
  const Triangle& t = mesh_.facets[f];
  return cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]);
}

void PatchGrower::fit(Patch& patch, bool quadric, const std::vector<double>& trust) const {
  const double h = spacing_[patch.members[0]];
  Eigen::Matrix<double, 6, 6> a = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
  LocalSurface& s = patch.surface;
  double all = 0;
  for (std::size_t k = 0; k < patch.members.size(); ++k) {
    const Vec3 d = (1 / h) * (points_[patch.members[k]] - s.origin);
    const double x = dot(d, s.u), y = dot(d, s.v), z = dot(d, s.n);
    double w = std::exp(-squared_length(d) / (2 * fit_width * fit_width));
    if (!trust.empty()) w *= trust[k];
    all += w;
    const Eigen::Matrix<double, 6, 1> t{1, x, y, x * x, x * y, y * y};
    a.noalias() += w * t * t.transpose();
    b.noalias() += w * z * t;
  }
  s.c = {};
  if (!quadric) {
    const Eigen::Vector3d c = a.topLeftCorner<3, 3>().ldlt().solve(b.head<3>());
    s.c = {c[0] * h, c[1], c[2], 0, 0, 0};
  } else {
    for (int k = 3; k < 6; ++k) a(k, k) += ridge * all;
    const Eigen::Matrix<double, 6, 1> c = a.ldlt().solve(b);
    s.c = {c[0] * h, c[1], c[2], c[3] / h, c[4] / h, c[5] / h};
  }
}

// Iteratively reweighted: members that the others do not bear out lose their say. Returns the share
// that lies on the surface to `residual_floor`.
double PatchGrower::polish(Patch& patch, bool quadric) const {
  const double h = spacing_[patch.members[0]];
  std::vector<double> residual(patch.members.size()), sorted, trust(patch.members.size());
  for (int step = 0; step <= polish_steps; ++step) {
    for (std::size_t k = 0; k < residual.size(); ++k)
      residual[k] = std::abs(patch.surface.distance(points_[patch.members[k]])) / h;
    if (step == polish_steps) break;
    sorted = residual;
    std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
    const double scale = std::max(1.5 * sorted[sorted.size() / 2], residual_floor);
    for (std::size_t k = 0; k < residual.size(); ++k)
      trust[k] = 1e-9 + std::exp(-std::pow(residual[k] / scale, 2) / 2);
    fit(patch, quadric, trust);
  }
  const auto on = std::count_if(residual.begin(), residual.end(), [](double r) { return r < 10 * residual_floor; });
  return static_cast<double>(on) / static_cast<double>(residual.size());
}

bool PatchGrower::accepts_facet(const Patch& patch, Index f, double angle) const {
  const double h = spacing_[patch.members[0]];
  const bool quadric = patch.members.size() >= quadric_members;
  const Triangle& t = mesh_.facets[f];
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 p = points_[t[i]];
    longest = std::max(longest, distance(p, points_[t[(i + 1) % 3]]));
    if (distance(p, patch.surface.origin) > reach * h) return false;
    const double far = quadric ? h / 4 : std::max(h, distance(p, patch.surface.origin)) / 2;
    if (std::abs(patch.surface.distance(p)) > std::tan(angle) * far) return false;
  }
  const Vec3 n = facet_normal(f);
  const double area = length(n);
  if (area < sliver * longest * longest) return true;
  const Vec3 c = 1.0 / 3 * (points_[t[0]] + points_[t[1]] + points_[t[2]]);
  const double lean = quadric ? angle : 2 * angle;
  return dot(n, patch.surface.normal(c)) >= std::cos(lean) * area;
}

void PatchGrower::add_facet(Patch& patch, Index f) const {
  patch.facets.push_back(f);
  for (Index v : mesh_.facets[f])
    if (!contains(patch.members, v)) patch.members.push_back(v);
}

Patch PatchGrower::grow(Index centre, Index seed, double angle) const {
  Patch patch;
  patch.members.push_back(centre);
  const Vec3 n = facet_normal(seed);
  const double area = length(n);
  if (!(area > 0)) return patch;
  patch.surface = tangent_plane(points_[centre], (1 / area) * n);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> frontier;
  std::vector<Index> seen{seed};
  const auto add = [&](Index f) {
    const std::size_t before = patch.members.size();
    add_facet(patch, f);
    const std::size_t now = patch.members.size();
    if (now > before && (now < 12 || now % 4 == 0)) fit(patch, now >= quadric_members, {});
    for (Index g : mesh_.neighbours[f]) {
      if (contains(seen, g)) continue;
      seen.push_back(g);
      const Triangle& t = mesh_.facets[g];
      const Vec3 c = 1.0 / 3 * (points_[t[0]] + points_[t[1]] + points_[t[2]]);
      frontier.emplace(distance(c, points_[centre]), g);
    }
  };
  add(seed);
  std::vector<Index> refused;
  while (!frontier.empty() && patch.members.size() < most_members) {
    const Index f = frontier.top().second;
    frontier.pop();
    if (accepts_facet(patch, f, angle)) add(f);
    else refused.push_back(f);
  }
  if (patch.members.size() < quadric_members) return patch;
  fit(patch, false, {});
  if (polish(patch, false) >= plane_share) return patch;
  fit(patch, true, {});
  polish(patch, true);
  return patch;
}

bool PatchGrower::is_large(const Patch& patch, Index centre) const {
  if (patch.members.size() < large_members) return false;
  double fan = 0;
  for (Index f : patch.facets) {
    const Triangle& t = mesh_.facets[f];
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] != centre) continue;
      const Vec3 a = points_[t[(i + 1) % 3]] - points_[centre];
      const Vec3 b = points_[t[(i + 2) % 3]] - points_[centre];
      fan += std::atan2(length(cross(a, b)), dot(a, b));
    }
  }
  return fan >= least_fan;
}

}  // namespace arris
