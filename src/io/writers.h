// The writers, one per format. Each fills a file that the caller commits.
#pragma once

#include <string>

#include "arris/features.h"
#include "arris/types.h"
#include "base/job.h"
#include "io/atomic_file.h"

namespace arris {

// Throw usage if an index or the length of an attribute does not fit the vertices or triangles. All
// writers need that to hold; they throw unwritable or cancelled.
void require_consistent(const std::string& path, const Mesh& mesh);
void require_consistent(const std::string& path, const TetVolume& volume);
void require_consistent(const std::string& path, const Mesh& mesh, const FeatureNetwork& network);

// Binary, little endian. All attributes, each in its own type: values are rounded to it and cut
// off at its ends. Blanks in names become underscores, and a name already taken gets one more.
void write_ply(AtomicFile& file, const Mesh& mesh, Job& job);
// No attributes.
void write_off(AtomicFile& file, const Mesh& mesh, Job& job);
// Of the attributes, red, green and blue if all are u8, as vertex colours in [0, 1]. Faces are
// written group by group if they have an i32 attribute "patch".
void write_obj(AtomicFile& file, const Mesh& mesh, Job& job);
// No attributes. Unit normals, 0 for a triangle without area. Binary if every coordinate is a
// float32 value.
void write_stl(AtomicFile& file, const Mesh& mesh, Job& job);
// Gmsh 2.2 ascii.
void write_msh(AtomicFile& file, const TetVolume& volume, Job& job);
// VTK legacy ascii, an unstructured grid.
void write_vtk(AtomicFile& file, const TetVolume& volume, Job& job);

// Feature curves over the vertices that they use, Binary PLY with an
// element edge; OBJ with a group and a polyline per curve; JSON.
void write_network_ply(AtomicFile& file, const Mesh& mesh, const FeatureNetwork& network, Job& job);
void write_network_obj(AtomicFile& file, const Mesh& mesh, const FeatureNetwork& network, Job& job);
void write_network_json(AtomicFile& file, const Mesh& mesh, const FeatureNetwork& network,
                        Job& job);

// "x y z" with the shortest digits that read back the same.
void write_position(AtomicFile& file, Vec3 p);
// Whether a float32 holds exactly `v`. NaN and infinity count as exact.
bool is_float(double v) noexcept;
bool all_float(const std::vector<Vec3>& positions) noexcept;

// Ticks the job every few thousand calls, for the element `i` of `n`, which are the share of the
// work from `begin` to `end` in [0, 1].
class Ticker {
 public:
  Ticker(Job& job, double begin, double end, std::size_t n)
      : job_(job), begin_(begin), step_((end - begin) / static_cast<double>(n ? n : 1)) {}
  void operator()(std::size_t i) {
    constexpr std::size_t between_ticks = 4096;
    if (i % between_ticks == 0) job_.tick(begin_ + step_ * static_cast<double>(i));
  }

 private:
  Job& job_;
  double begin_, step_;
};

}  // namespace arris
