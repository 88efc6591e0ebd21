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
#include "base/memory.h"
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

// Per point its name in the engine: itself, unless an added point lies exactly there.
using Names = std::vector<Index>;

Names load_and_insert(const TetMesh& mesh, const std::vector<Vec3>& added,
                      const std::vector<Index>& near, Engine& engine, Job& job) {
  constexpr std::size_t between_ticks = 4096;
  const std::vector<Engine::Vertex_handle> vertices = load(mesh, engine);
  Names names(mesh.points.size());
  std::iota(names.begin(), names.end(), Index{0});
  for (std::size_t k = 0; k < added.size(); ++k) {
    if (k % between_ticks == 0)
      job.tick(static_cast<double>(k) / static_cast<double>(added.size()));
    const std::size_t before = engine.number_of_vertices();
    const Engine::Vertex_handle v = engine.insert(to_engine(added[k]), vertices[near[k]]->cell());
    const auto name = static_cast<Index>(mesh.points.size() + k);
    if (engine.number_of_vertices() == before)
      std::replace(names.begin(), names.end(), v->info(), name);
    v->info() = name;
  }
  return names;
}

// Calls body(k, cell) for all cells in the order of the engine, in parallel. A list of all of them
// would take as much memory as a quarter of the mesh: they are handed out some at a time.
template <class Body>
void for_cells(const Engine& engine, unsigned threads, Body&& body) {
  constexpr std::size_t at_a_time = std::size_t{1} << 16;  // they fit into the cache
  std::vector<Engine::Cell_handle> cells;
  cells.reserve(at_a_time);
  std::size_t done = 0;
  for (auto c = engine.all_cells_begin(); c != engine.all_cells_end(); done += cells.size()) {
    cells.clear();
    for (; c != engine.all_cells_end() && cells.size() < at_a_time; ++c) cells.push_back(c);
    parallel_for(cells.size(), threads, [&](std::size_t k) { body(done + k, cells[k]); });
  }
}

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
// in memory, which every later pass profits from. Leaves the numbers in the cells, and those that
// they had before in `former`, by number, if it is asked for. Returns how many are finite.
std::size_t number_cells(const Engine& engine, std::size_t points, unsigned threads,
                         std::vector<Tet>* former) {
  std::vector<std::uint32_t> key(engine.tds().number_of_cells());
  if (key.size() >= most_tets)
    throw Failure(ErrorCode::out_of_memory, "more tetrahedra than 32-bit facet numbers can name",
                  "use fewer points, or split the cloud");
  for_cells(engine, threads,
            [&](std::size_t k, Engine::Cell_handle c) { key[k] = sorting_key(engine, c, points); });
  std::vector<std::uint32_t> start(2 * points + 1, 0);
  for (std::uint32_t k : key) ++start[k + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  const std::size_t finite = start[points];
  if (former) former->resize(key.size());
  auto next = key.begin();
  for (auto c = engine.all_cells_begin(); c != engine.all_cells_end(); ++c) {
    const Tet number = start[*next++]++;
    if (former) (*former)[number] = c->info().tet;
    c->info().tet = number;
  }
  return finite;
}

// A cell in flat numbers.
struct CellCopy {
  Tet number;
  std::array<Index, 4> vertices;
  std::array<Tet, 4> neighbours;
};

CellCopy copy_cell(const Engine& engine, Engine::Cell_handle c) {
  CellCopy copy{c->info().tet, {}, {}};
  for (int i = 0; i < 4; ++i) {
    const auto v = c->vertex(i);
    const auto j = static_cast<std::size_t>(i);
    copy.vertices[j] = v == engine.infinite_vertex() ? infinite_vertex : v->info();
    copy.neighbours[j] = c->neighbor(i)->info().tet;
  }
  return copy;
}

void copy_cells(const Engine& engine, unsigned threads, TetMesh& mesh) {
  mesh.vertices.resize(engine.tds().number_of_cells());
  mesh.neighbours.resize(mesh.vertices.size());
  for_cells(engine, threads, [&](std::size_t, Engine::Cell_handle c) {
    const CellCopy copy = copy_cell(engine, c);
    mesh.vertices[copy.number] = copy.vertices;
    mesh.neighbours[copy.number] = copy.neighbours;
  });
}

// Those that the mesh before had not.
std::vector<CellCopy> new_cells(const Engine& engine, const std::vector<Tet>& former) {
  std::vector<CellCopy> cells;
  cells.reserve(static_cast<std::size_t>(std::count(former.begin(), former.end(), no_tet)));
  for (auto c = engine.all_cells_begin(); c != engine.all_cells_end(); ++c)
    if (former[c->info().tet] == no_tet) cells.push_back(copy_cell(engine, c));
  return cells;
}

// The corner of the tetrahedron with these vertices that is beyond facet i of `tet`.
std::size_t corner_beyond(const std::array<Index, 4>& vertices, const CellCopy& tet,
                          std::size_t i) {
  const auto shared = [&](Index v) {
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i && tet.vertices[j] == v) return true;
    return false;
  };
  std::size_t corner = 0;
  while (corner < 3 && shared(vertices[corner])) ++corner;
  return corner;
}

// The tetrahedra of an extension from those that it had `before`, under new numbers, and the
// `added` ones: the engine, which takes more memory than both meshes, need not be there.
void assemble(const TetMesh& before, const Names& names, const std::vector<CellCopy>& added,
              unsigned threads, Extension& extension) {
  const std::vector<Tet>& former = extension.former;
  TetMesh& mesh = extension.mesh;
  std::vector<Tet> now(before.size(), no_tet);
  for (Tet t = 0; t < former.size(); ++t)
    if (former[t] != no_tet) now[former[t]] = t;
  mesh.vertices.resize(former.size());
  mesh.neighbours.resize(former.size());
  parallel_for(former.size(), threads, [&](std::size_t t) {
    if (former[t] == no_tet) return;
    for (std::size_t i = 0; i < 4; ++i) {
      const Index v = before.vertices[former[t]][i];
      mesh.vertices[t][i] = v == infinite_vertex ? v : names[v];
      mesh.neighbours[t][i] = now[before.neighbours[former[t]][i]];
    }
  });
  for (const CellCopy& tet : added) {
    mesh.vertices[tet.number] = tet.vertices;
    mesh.neighbours[tet.number] = tet.neighbours;
    for (std::size_t i = 0; i < 4; ++i) {
      const Tet n = tet.neighbours[i];
      if (former[n] != no_tet)
        mesh.neighbours[n][corner_beyond(mesh.vertices[n], tet, i)] = tet.number;
    }
  }
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
  mesh.finite = number_cells(engine, points.size(), job.threads(), nullptr);
  copy_cells(engine, job.threads(), mesh);
  mesh.points = std::move(points);
  mesh.samples = samples;
  return mesh;
}

Extension add_points(const TetMesh& mesh, const std::vector<Vec3>& added,
                     const std::vector<Index>& near, Job& job) {
  return_free_memory();  // the small pieces that sensing freed are of no use to an engine
  Engine engine;
  const Names names = load_and_insert(mesh, added, near, engine, job);
  Extension result;
  TetMesh& next = result.mesh;
  next.samples = mesh.points.size() + added.size();
  next.finite = number_cells(engine, next.samples, job.threads(), &result.former);
  const std::vector<CellCopy> cells = new_cells(engine, result.former);
  engine.clear();
  assemble(mesh, names, cells, job.threads(), result);
  next.points.reserve(next.samples);
  next.points = mesh.points;
  next.points.insert(next.points.end(), added.begin(), added.end());
  return result;
}

}  // namespace arris
