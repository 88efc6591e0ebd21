#include "compare/compare.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/failure.h"
#include "base/job.h"
#include "compare/distances.h"
#include "compare/ndc.h"
#include "compare/sharp_edges.h"
#include "compare/surface.h"
#include "compare/volume.h"
#include "surface/certify.h"

namespace arris::compare {
namespace {

void require_options(const CompareOptions& o) {
  const auto refuse = [](const char* message, const char* remedy) {
    throw Failure(ErrorCode::usage, message, remedy);
  };
  if (o.samples < 1000 || o.samples > 100000000)
    refuse("the number of samples is out of range", "give 1000 to 100000000");
  if (!(o.dihedral >= 1 && o.dihedral <= 180))
    refuse("the dihedral threshold is out of range", "give 1 to 180 degrees");
}

// Bytes needed at most, beside the meshes themselves: measured and rounded up.
std::size_t forecast_memory(const Mesh& result, const Mesh& truth, const CompareOptions& o) {
  constexpr std::size_t per_triangle = 280, per_vertex = 100, per_sample = 8, fixed = 32 << 20;
  return fixed + per_triangle * (result.triangles.size() + truth.triangles.size()) +
         per_vertex * (result.vertices.size() + truth.vertices.size()) + per_sample * o.samples;
}

void require_memory(std::size_t need, const Context& context) {
  const std::size_t limit =
      context.memory_limit > 0 ? context.memory_limit : std::size_t{machine_memory()};
  if (limit > 0 && need > limit)
    throw Failure(ErrorCode::out_of_memory,
                  "comparing the meshes needs up to " + std::to_string(need) +
                      " bytes of memory but the limit is " + std::to_string(limit),
                  "raise the memory limit or use a machine with more memory");
}

// The genus of a closed oriented manifold of C components is the sum of theirs: C - chi / 2.
std::optional<std::int64_t> genus_of(const Certificate& c) {
  if (!c.closed() || !c.manifold() || c.misoriented_edges > 0 || c.degenerate_triangles > 0)
    return std::nullopt;
  return static_cast<std::int64_t>(c.components) - c.euler / 2;
}

InsideRule rule_for(const MeshFacts& facts) {
  const bool crosses = facts.certificate.intersecting_pairs > 0;
  return crosses && facts.unbalanced_edges == 0 ? InsideRule::winding : InsideRule::parity;
}

void compare_distances(const Surface& result, const Surface& truth, const CompareOptions& options,
                       Job& job, Comparison& c) {
  c.result_to_truth = directed_distances(result, truth, options, 1, job, 0, 0.5);
  c.truth_to_result = directed_distances(truth, result, options, 2, job, 0.5, 1);
  const Directed &there = c.result_to_truth, &back = c.truth_to_result;
  c.chamfer = (there.mean + back.mean) / 2;
  c.hausdorff = std::max(there.max, back.max);
  c.rms = std::sqrt((there.rms * there.rms + back.rms * back.rms) / 2);
  c.loose = score(there.within_loose, back.within_loose);
  c.strict = score(there.within_strict, back.within_strict);
}

void compare_features(const Surface& result, const Surface& truth, const CompareOptions& options,
                      Job& job, Comparison& c) {
  const EdgeTurns of_result = measure_edges(result), of_truth = measure_edges(truth);
  for (const auto& [turns, facts] : {std::pair{&of_result, &c.result}, {&of_truth, &c.truth}}) {
    facts->odd_edges = turns->odd_edges;
    facts->unbalanced_edges = turns->unbalanced_edges;
  }
  const auto score_at = [&](double dihedral) {
    return match_features(result, find_features(result, of_result, dihedral), truth,
                          find_features(truth, of_truth, dihedral), dihedral, job);
  };
  c.features = score_at(options.dihedral);
  for (const double angle : sweep_angles)
    c.sweep.push_back(angle == options.dihedral ? c.features : score_at(angle));
}

void compare_topology(Comparison& c) {
  for (MeshFacts* facts : {&c.result, &c.truth}) facts->genus = genus_of(facts->certificate);
  const Certificate &r = c.result.certificate, &t = c.truth.certificate;
  c.same_topology =
      r.components == t.components && r.euler == t.euler && c.result.genus == c.truth.genus;
}

void note_defects(const std::string& name, const MeshFacts& facts, Comparison& c) {
  const Certificate& k = facts.certificate;
  const auto note = [&](std::uint64_t count, const char* what) {
    if (count > 0) c.notes.push_back("the " + name + " has " + std::to_string(count) + what);
  };
  note(facts.odd_edges,
       " edge(s) with an odd number of triangles: it has no inside, so there is no volume IoU");
  if (!facts.genus) c.notes.push_back("the " + name + " is no closed oriented manifold: no genus");
  note(k.degenerate_triangles, " degenerate triangle(s), left out of all but the topology");
  note(k.intersecting_pairs, " pair(s) of triangles that intersect");
}

void add_notes(Comparison& c) {
  note_defects("result", c.result, c);
  note_defects("truth", c.truth, c);
  if (c.features.length_truth == 0)
    c.notes.emplace_back(
        "the truth has no sharp edges at this threshold: their recall is undefined");
  if (c.ndc.points_truth == 0 && c.ndc.edge.f1 == 1)
    c.notes.emplace_back(
        "the truth has no edge points in the sense of NDC, which counts as EF1 = 1");
}

Comparison compare_all(const Mesh& result, const Mesh& truth, const CompareOptions& options,
                       Job& job) {
  job.stage("prepare", 0.1);
  const UnitFrame frame = unit_frame(truth, "truth");
  const Surface r = make_surface(result, frame, "result", job.threads());
  const Surface t = make_surface(truth, frame, "truth", job.threads());
  Comparison c;
  c.diagonal = frame.diagonal;
  c.samples = options.samples;
  job.stage("check", 0.15);
  c.result.certificate = certify(result, job);
  job.stage("check truth", 0.15);
  c.truth.certificate = certify(truth, job);
  job.stage("distances", 0.4);
  compare_distances(r, t, options, job, c);
  job.stage("edges", 0.1);
  compare_features(r, t, options, job, c);
  if (options.ndc) c.ndc = ndc_edges(r, t, options, job);
  compare_topology(c);
  job.stage("volume", 0.1);
  if (c.result.odd_edges == 0 && c.truth.odd_edges == 0)
    c.volume_iou = volume_iou({r, rule_for(c.result)}, {t, rule_for(c.truth)}, options, job);
  job.finish();
  add_notes(c);
  return c;
}

}  // namespace

Result<Comparison> compare_meshes(const Mesh& result, const Mesh& truth,
                                  const CompareOptions& options, const Context& context) {
  return guarded([&] {
    require_options(options);
    require_surface(result, "result");
    require_surface(truth, "truth");
    require_memory(forecast_memory(result, truth, options), context);
    Job job(context);
    return compare_all(result, truth, options, job);
  });
}

}  // namespace arris::compare
