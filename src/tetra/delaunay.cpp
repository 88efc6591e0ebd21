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
struct Number {
  Tet tet = no_tet;
};
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<Number, Kernel,
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

// The engine as it was when it gave `mesh`, its cells numbered as there. Returns the vertices.
std::vector<Engine::Vertex_handle> load(const TetMesh& mesh, Engine& engine) {
  auto& structure = engine.tds();
  structure.clear();
  structure.set_dimension(3);
  engine.set_infinite_vertex(structure.create_vertex());
  std::vector<Engine::Vertex_handle> vertices(mesh.points.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    vertices[v] = structure.create_vertex();
    vertices[v]->set_point(to_engine(mesh.points[v]));
    vertices[v]->info() = static_cast<Index>(v);
  }
  std::vector<Engine::Cell_handle> cells(mesh.size());
  const auto vertex = [&](Index v) {
    return v == infinite_vertex ? engine.infinite_vertex() : vertices[v];
  };
  for (std::size_t t = 0; t < cells.size(); ++t) {
    const auto& v = mesh.vertices[t];
    cells[t] = structure.create_cell(vertex(v[0]), vertex(v[1]), vertex(v[2]), vertex(v[3]));
    cells[t]->info().tet = static_cast<Tet>(t);
    for (Index w : v) vertex(w)->set_cell(cells[t]);
  }
  for (std::size_t t = 0; t < cells.size(); ++t) {
    const auto& n = mesh.neighbours[t];
    cells[t]->set_neighbors(cells[n[0]], cells[n[1]], cells[n[2]], cells[n[3]]);
  }
  return vertices;
}

struct Numbering {
  std::vector<Engine::Cell_handle> cells;  // in the order of the engine, their numbers within
  std::vector<Tet> former;                 // by number: the numbers they had before
  std::size_t finite = 0;
};

// The lowest vertex; more by the number of points for an infinite cell.
std::uint32_t sorting_key(const Engine& engine, Engine::Cell_handle c, std::size_t points) {
  Index low = infinite_vertex;
  bool is_infinite = false;
  for (int i = 0; i < 4; ++i) {
    if (c->vertex(i) == engine.infinite_vertex())
      is_infinite = true;
    else
      low = std::min(low, c->vertex(i)->info());
  }
  return low + (is_infinite ? static_cast<std::uint32_t>(points) : 0);
}

// Tetrahedra sorted by their lowest vertex, finite ones first: neighbours in space are neighbours
// in memory, which every later pass profits from.
Numbering number_cells(const Engine& engine, std::size_t points, unsigned threads) {
  Numbering numbering;
  numbering.cells.reserve(engine.tds().number_of_cells());
  for (auto c = engine.all_cells_begin(); c != engine.all_cells_end(); ++c)
    numbering.cells.push_back(c);
  std::vector<std::uint32_t> key(numbering.cells.size());
  parallel_for(key.size(), threads,
               [&](std::size_t k) { key[k] = sorting_key(engine, numbering.cells[k], points); });
  std::vector<std::uint32_t> start(2 * points + 1, 0);
  for (std::uint32_t k : key) ++start[k + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  numbering.finite = start[points];
  numbering.former.resize(key.size());
  for (std::size_t k = 0; k < key.size(); ++k) {
    const Tet number = start[key[k]]++;
    numbering.former[number] = numbering.cells[k]->info().tet;
    numbering.cells[k]->info().tet = number;
  }
  return numbering;
}

void copy_cells(const Engine& engine, const std::vector<Engine::Cell_handle>& cells,
                unsigned threads, TetMesh& mesh) {
  const auto infinite = engine.infinite_vertex();
  mesh.vertices.resize(cells.size());
  mesh.neighbours.resize(cells.size());
  parallel_for(cells.size(), threads, [&](std::size_t k) {
    const Tet t = cells[k]->info().tet;
    for (int i = 0; i < 4; ++i) {
      const auto v = cells[k]->vertex(i);
      const auto j = static_cast<std::size_t>(i);
      mesh.vertices[t][j] = v == infinite ? infinite_vertex : v->info();
      mesh.neighbours[t][j] = cells[k]->neighbor(i)->info().tet;
    }
  });
}

// The mesh of the engine over `points`, without its engine.
Extension unload(const Engine& engine, std::vector<Vec3> points, std::size_t samples, Job& job) {
  Numbering numbering = number_cells(engine, points.size(), job.threads());
  if (numbering.cells.size() >= most_tets)
    throw Failure(ErrorCode::out_of_memory, "more tetrahedra than 32-bit facet numbers can name",
                  "use fewer points, or split the cloud");
  Extension result;
  result.former = std::move(numbering.former);
  result.mesh.points = std::move(points);
  result.mesh.samples = samples;
  result.mesh.finite = numbering.finite;
  copy_cells(engine, numbering.cells, job.threads(), result.mesh);
  return result;
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
  return unload(engine, std::move(points), samples, job).mesh;
}

Extension add_points(const TetMesh& mesh, const std::vector<Vec3>& added,
                     const std::vector<Index>& near, Job& job) {
  constexpr std::size_t between_ticks = 4096;
  Engine engine;
  const std::vector<Engine::Vertex_handle> vertices = load(mesh, engine);
  for (std::size_t k = 0; k < added.size(); ++k) {
    if (k % between_ticks == 0)
      job.tick(static_cast<double>(k) / static_cast<double>(added.size()));
    const Engine::Vertex_handle v = engine.insert(to_engine(added[k]), vertices[near[k]]->cell());
    v->info() = static_cast<Index>(mesh.points.size() + k);
  }
  std::vector<Vec3> points = mesh.points;
  points.insert(points.end(), added.begin(), added.end());
  const std::size_t samples = points.size();
  return unload(engine, std::move(points), samples, job);
}

}  // namespace arris
