#include "feature/normal_filter.h"

#include <algorithm>
#include <cmath>

#include "base/distinct.h"
#include "base/parallel.h"
#include "base/vec.h"
#include "feature/small_set.h"

namespace arris {
namespace {

// The likeness, as a chord of the unit sphere, follows the usual turn between facets: that is
// noise or curvature, and a smaller one leaves single facets as they are or makes flat strips of
// what is round. On flat faces even an edge of 20 degrees is three times the least.
constexpr double likeness_in_turns = 5;
constexpr double least_likeness = 0.12, most_likeness = 0.35;
// More flatten faces better, and cut small holes to polygons.
constexpr int passes = 15;
constexpr std::size_t grain = 1024;  // facets a chunk

// The facets that share a point with each, itself among them, but for slivers; at a point of very
// many those near it. In compressed rows.
struct Links {
  std::vector<std::size_t> first{0};
  std::vector<Index> facet;
  std::vector<double> weight;  // by area and nearness
};

struct Middle {
  Vec3 at;
  double area;
};

std::vector<Middle> middles(const std::vector<Vec3>& points, const FacetMesh& mesh) {
  std::vector<Middle> result;
  for (const Triangle& t : mesh.facets) {
    const Vec3 a = points[t[0]], b = points[t[1]], c = points[t[2]];
    result.push_back({1.0 / 3 * (a + b + c), length(cross(b - a, c - a)) / 2});
  }
  return result;
}

Links link_facets(const std::vector<Vec3>& points, const FacetMesh& mesh) {
  const std::vector<Middle> all = middles(points, mesh);
  Links links;
  std::vector<Index> near, buffer;
  for (std::size_t f = 0; f < all.size(); ++f) {
    near.clear();
    for (Index v : mesh.facets[f]) {
      const auto star = mesh.star_near(v, static_cast<Index>(f), buffer);
      near.insert(near.end(), star.begin(), star.end());
    }
    keep_distinct(near);
    double variance = 0;
    for (Index g : near) variance += squared_length(all[g].at - all[f].at);
    variance /= static_cast<double>(near.size());
    for (Index g : near) {
      if (mesh.normal[g] == Vec3{}) continue;
      const double far = squared_length(all[g].at - all[f].at) / variance;
      links.facet.push_back(g);
      links.weight.push_back(all[g].area * std::exp(-far / 2));
    }
    links.first.push_back(links.facet.size());
  }
  return links;
}

// The median turn, as a chord, at the sides of the facets linked to those linked to f.
double usual_turn(const Links& links, const FacetMesh& mesh, std::size_t f, SmallSet& seen,
                  std::vector<double>& turns) {
  seen.clear();
  turns.clear();
  for (std::size_t k = links.first[f]; k < links.first[f + 1]; ++k) {
    const Index l = links.facet[k];
    for (std::size_t j = links.first[l]; j < links.first[l + 1]; ++j) {
      const Index g = links.facet[j];
      if (!seen.insert(g)) continue;
      for (Index o : mesh.neighbours[g])
        if (!(mesh.normal[o] == Vec3{})) turns.push_back(length(mesh.normal[o] - mesh.normal[g]));
    }
  }
  if (turns.empty()) return 0;
  const auto middle = turns.begin() + static_cast<std::ptrdiff_t>(turns.size() / 2);
  std::nth_element(turns.begin(), middle, turns.end());
  return *middle;
}

std::vector<double> choose_likeness(const Links& links, const FacetMesh& mesh, unsigned threads) {
  std::vector<double> result(mesh.facets.size());
  parallel_chunks(result.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
    SmallSet seen;
    std::vector<double> turns;
    for (std::size_t f = begin; f < end; ++f)
      result[f] = std::clamp(likeness_in_turns * usual_turn(links, mesh, f, seen, turns),
                             least_likeness, most_likeness);
  });
  return result;
}

// What is compared to tell pieces apart: of all neighbourhoods that hold a facet the mean normal of
// the one that varies least, which lies on its side of an edge.
class Guidance {
 public:
  Guidance(const Links& links, std::size_t facets)
      : links_(links), mean_(facets), variation_(facets), normal_(facets) {}

  const std::vector<Vec3>& follow(const std::vector<Vec3>& normal, unsigned threads) {
    parallel_for(normal.size(), threads, [&](std::size_t f) { average(normal, f); });
    parallel_for(normal.size(), threads, [&](std::size_t f) {
      std::size_t best = f;
      for (std::size_t k = links_.first[f]; k < links_.first[f + 1]; ++k)
        if (variation_[links_.facet[k]] < variation_[best]) best = links_.facet[k];
      normal_[f] = mean_[best];
    });
    return normal_;
  }

 private:
  void average(const std::vector<Vec3>& normal, std::size_t f) {
    Vec3 sum{};
    double all = 0;
    for (std::size_t k = links_.first[f]; k < links_.first[f + 1]; ++k) {
      sum = sum + links_.weight[k] * normal[links_.facet[k]];
      all += links_.weight[k];
    }
    variation_[f] = all > 0 ? 1 - length(sum) / all : 1;
    mean_[f] = normalized(sum);
  }

  const Links& links_;
  std::vector<Vec3> mean_;
  std::vector<double> variation_;  // 0: all alike, 1: nothing in common
  std::vector<Vec3> normal_;
};

}  // namespace

FilteredNormals filter_normals(const std::vector<Vec3>& points, const FacetMesh& mesh,
                               unsigned threads) {
  const Links links = link_facets(points, mesh);
  FilteredNormals result{mesh.normal, choose_likeness(links, mesh, threads)};
  Guidance guidance(links, mesh.facets.size());
  std::vector<Vec3> next(mesh.facets.size());
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Vec3>& guide = guidance.follow(result.normal, threads);
    parallel_for(next.size(), threads, [&](std::size_t f) {
      const double width = 2 * result.likeness[f] * result.likeness[f];
      Vec3 sum{};
      for (std::size_t k = links.first[f]; k < links.first[f + 1]; ++k) {
        const Index g = links.facet[k];
        const double like = std::exp(-squared_length(guide[g] - guide[f]) / width);
        sum = sum + links.weight[k] * like * result.normal[g];
      }
      next[f] = normalized(sum);
    });
    result.normal.swap(next);
  }
  return result;
}

}  // namespace arris
