// The surface reconstructions of CGAL, as peers in the benchmark: one method, one process.
//
//   cgal_peers METHOD POINTS.ply MESH.ply     METHOD: poisson advancing_front scale_space
//   alpha_wrap cgal_peers --version
//
// Settings are those of CGAL's own tutorial on surface reconstruction where it has them, with
// lengths in units of the average spacing; bench/harness/methods.py states them for the page.
#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Scale_space_reconstruction_3/Advancing_front_mesher.h>
#include <CGAL/Scale_space_reconstruction_3/Jet_smoother.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/boost/graph/IO/PLY.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/version.h>

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Points = std::vector<Point>;
using Triangle = std::array<std::size_t, 3>;

constexpr unsigned spacing_neighbours = 6, normal_neighbours = 18;

double spacing_of(const Points& points) {
  return CGAL::compute_average_spacing<CGAL::Sequential_tag>(points, spacing_neighbours);
}

void write(const std::string& path, const SurfaceMesh& mesh) {
  if (mesh.number_of_faces() == 0) throw std::runtime_error("no faces");
  if (!CGAL::IO::write_PLY(path, mesh, CGAL::parameters::stream_precision(17)))
    throw std::runtime_error("cannot write " + path);
}

void write(const std::string& path, const Points& points, const std::vector<Triangle>& triangles) {
  if (triangles.empty()) throw std::runtime_error("no faces");
  if (!CGAL::IO::write_PLY(path, points, triangles, CGAL::parameters::stream_precision(17)))
    throw std::runtime_error("cannot write " + path);
}

void poisson(const Points& points, const std::string& out) {
  using PointNormal = std::pair<Point, Kernel::Vector_3>;
  using PointMap = CGAL::First_of_pair_property_map<PointNormal>;
  using NormalMap = CGAL::Second_of_pair_property_map<PointNormal>;
  std::vector<PointNormal> cloud;
  for (const Point& p : points) cloud.push_back({p, {0, 0, 0}});
  const auto maps = CGAL::parameters::point_map(PointMap()).normal_map(NormalMap());
  CGAL::jet_estimate_normals<CGAL::Sequential_tag>(cloud, normal_neighbours, maps);
  cloud.erase(CGAL::mst_orient_normals(cloud, normal_neighbours, maps), cloud.end());
  SurfaceMesh mesh;
  // The default radius of 30 spacings leaves a thousand triangles where there are 4000 points.
  constexpr double angle = 20, radius = 2, distance = 0.1;  // degrees, average spacings
  if (!CGAL::poisson_surface_reconstruction_delaunay(cloud.begin(), cloud.end(), PointMap(),
                                                     NormalMap(), mesh, spacing_of(points), angle,
                                                     radius, distance))
    throw std::runtime_error("the Poisson function could not be computed");
  write(out, mesh);
}

void advancing_front(const Points& points, const std::string& out) {
  std::vector<Triangle> triangles;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                               std::back_inserter(triangles));
  write(out, points, triangles);
}

void scale_space(const Points& points, const std::string& out) {
  namespace scale = CGAL::Scale_space_reconstruction_3;
  constexpr std::size_t smoothings = 4;
  constexpr double longest_edge = 5;  // in units of the average spacing
  CGAL::Scale_space_surface_reconstruction_3<Kernel> reconstruction(points.begin(), points.end());
  reconstruction.increase_scale(smoothings, scale::Jet_smoother<Kernel>());
  reconstruction.reconstruct_surface(
      scale::Advancing_front_mesher<Kernel>(longest_edge * spacing_of(points)));
  std::vector<Triangle> triangles(reconstruction.facets_begin(), reconstruction.facets_end());
  write(out, points, triangles);
}

void alpha_wrap(const Points& points, const std::string& out) {
  constexpr double alpha = 4, offset = 0.05;  // in units of the average spacing
  const double spacing = spacing_of(points);
  SurfaceMesh mesh;
  CGAL::alpha_wrap_3(points, alpha * spacing, offset * spacing, mesh);
  write(out, mesh);
}

int run(const std::string& method, const std::string& in, const std::string& out) {
  Points points;
  if (!CGAL::IO::read_points(in, std::back_inserter(points)) || points.empty())
    throw std::runtime_error("cannot read " + in);
  if (method == "poisson")
    poisson(points, out);
  else if (method == "advancing_front")
    advancing_front(points, out);
  else if (method == "scale_space")
    scale_space(points, out);
  else if (method == "alpha_wrap")
    alpha_wrap(points, out);
  else
    throw std::runtime_error("unknown method " + method);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "--version") {
    std::printf("%s\n", CGAL_VERSION_STR);
    return 0;
  }
  if (argc != 4) {
    std::fprintf(stderr, "usage: cgal_peers METHOD POINTS.ply MESH.ply\n");
    return 2;
  }
  try {
    return run(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cgal_peers: %s\n", error.what());
    return 1;
  }
}
