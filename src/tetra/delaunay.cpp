#include "tetra/delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

#include "base/failure.h"
#include "base/parallel.h"

namespace arris {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<Tet, Kernel,
                                              CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Engine =
    CGAL::Delaunay_triangulation_3<Kernel,
                                   CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

Kernel::Point_3 to_engine(Vec3 p) {
  return {p.x, p.y, p.z};
}

// Points as the engine reads them, without a copy.
struct PointMap {
  using key_type = Index;
  using value_type = Kernel::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  const std::vector<Vec3>* points;
  friend value_type get(const PointMap& map, Index i) { return to_engine((*map.points)[i]); }
};

// Biased randomised insertion order along a space-filling curve.
std::vector<Index> insertion_order(const std::vector<Vec3>& points) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Kernel, PointMap>(PointMap{&points}));
  return order;
}

void insert_all(Engine& engine, const std::vector<Vec3>& points, Job& job) {
  constexpr std::size_t between_ticks = 4096;
  const std::vector<Index> order = insertion_order(points);
  Engine::Cell_handle hint;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k % between_ticks == 0)
      job.tick(static_cast<double>(k) / static_cast<double>(order.size()));
    const Engine::Vertex_handle v = engine.insert(to_engine(points[order[k]]), hint);
    v->info() = order[k];
    hint = v->cell();
  }
}

// Tetrahedra sorted by their lowest vertex, finite ones first: neighbours in space are neighbours
// in memory, which every later pass profits from.
std::vector<Engine::Cell_handle> number_cells(const Engine& engine, std::size_t points,
                                              std::size_t& finite) {
  const auto infinite = engine.infinite_vertex();
  const auto key = [&](Engine::Cell_handle c) {
    Index low = infinite_vertex;
    bool is_infinite = false;
    for (int i = 0; i < 4; ++i) {
      if (c->vertex(i) == infinite)
        is_infinite = true;
      else
        low = std::min(low, c->vertex(i)->info());
    }
    return static_cast<std::size_t>(low) + (is_infinite ? points : 0);
  };
  std::vector<std::uint32_t> start(2 * points + 1, 0);
  for (auto c = engine.all_cells_begin(); c != engine.all_cells_end(); ++c) ++start[key(c) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  finite = start[points];
  std::vector<Engine::Cell_handle> cells(start.back());
  for (auto c = engine.all_cells_begin(); c != engine.all_cells_end(); ++c) {
    const std::uint32_t index = start[key(c)]++;
    cells[index] = c;
    c->info() = index;
  }
  return cells;
}

void copy_cells(const Engine& engine, const std::vector<Engine::Cell_handle>& cells,
                unsigned threads, TetMesh& mesh) {
  const auto infinite = engine.infinite_vertex();
  mesh.vertices.resize(cells.size());
  mesh.neighbours.resize(cells.size());
  parallel_for(cells.size(), threads, [&](std::size_t t) {
    for (int i = 0; i < 4; ++i) {
      const auto v = cells[t]->vertex(i);
      const auto k = static_cast<std::size_t>(i);
      mesh.vertices[t][k] = v == infinite ? infinite_vertex : v->info();
      mesh.neighbours[t][k] = cells[t]->neighbor(i)->info();
    }
  });
}

}  // namespace

TetMesh delaunay(std::vector<Vec3> points, std::size_t samples, Job& job) {
  Engine engine;
  insert_all(engine, points, job);
  if (engine.dimension() < 3) {
    const char* shape = engine.dimension() < 1   ? "equal"
                        : engine.dimension() < 2 ? "on one line"
                                                 : "in one plane";
    throw Failure(ErrorCode::degenerate,
                  "all " + std::to_string(points.size()) + " distinct points are " + shape +
                      ", so they bound no volume",
                  "scan the object from more sides, or give a cloud that is not flat");
  }
  TetMesh mesh;
  mesh.samples = samples;
  mesh.points = std::move(points);
  const std::vector<Engine::Cell_handle> cells =
      number_cells(engine, mesh.points.size(), mesh.finite);
  if (cells.size() >= most_tets)
    throw Failure(ErrorCode::out_of_memory, "more tetrahedra than 32-bit facet numbers can name",
                  "use fewer points, or split the cloud");
  copy_cells(engine, cells, job.threads(), mesh);
  return mesh;
}

}  // namespace arris
