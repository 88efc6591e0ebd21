// read_mesh, write_mesh, write_tetrahedra, write_features and write_text: which extension means
// which format.
#include "arris/io.h"
#include "base/failure.h"
#include "io/atomic_file.h"
#include "io/file_reader.h"
#include "io/readers.h"
#include "io/writers.h"

namespace arris {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what,
                         const std::string& remedy) {
  throw Failure(ErrorCode::unsupported,
                "'" + path + "': " + what + " with the extension '" + extension_of(path) + "'",
                remedy);
}

Shape parse(const Source& source, const std::string& extension) {
  if (extension == ".ply") return read_ply(source, Want::mesh);
  if (extension == ".off") return read_off(source, Want::mesh);
  if (extension == ".obj") return read_obj(source, Want::mesh);
  return read_stl(source);
}

using MeshWriter = void (*)(AtomicFile&, const Mesh&, Job&);
MeshWriter mesh_writer(const std::string& extension) {
  if (extension == ".ply") return write_ply;
  if (extension == ".off") return write_off;
  if (extension == ".obj") return write_obj;
  if (extension == ".stl") return write_stl;
  return nullptr;
}

using VolumeWriter = void (*)(AtomicFile&, const TetVolume&, Job&);
VolumeWriter volume_writer(const std::string& extension) {
  if (extension == ".msh") return write_msh;
  if (extension == ".vtk") return write_vtk;
  return nullptr;
}

using NetworkWriter = void (*)(AtomicFile&, const Mesh&, const FeatureNetwork&, Job&);
NetworkWriter network_writer(const std::string& extension) {
  if (extension == ".ply") return write_network_ply;
  if (extension == ".obj") return write_network_obj;
  if (extension == ".json") return write_network_json;
  return nullptr;
}

template <class Writer, class Data>
void write(const std::string& path, const Context& context, Writer writer, const Data& data) {
  Job job(context);
  job.stage("write", 1);
  AtomicFile file(path);
  writer(file, data, job);
  job.finish();  // the last chance to be cancelled
  file.commit();
}

}  // namespace

Result<Mesh> read_mesh(const std::string& path, const Context& context) {
  return guarded([&] {
    Job job(context);
    job.stage("read", 0.2);
    FileReader file(path);
    const std::string extension = extension_of(path);
    if (!mesh_writer(extension))  // the formats read are those written
      refuse(path, "meshes are not read from files", "use .ply .off .obj or .stl");
    const Source source{path, file.load(job), job};
    job.stage("parse", 0.8);
    Shape shape = parse(source, extension);
    if (shape.positions.empty())
      fail(source, ErrorCode::bad_points, "", "holds no vertices", "give a file with a mesh in it");
    if (shape.triangles.empty())
      malformed(source, "", "holds points, but no faces", "give a file with a mesh in it");
    Mesh mesh;
    mesh.vertices = std::move(shape.positions);
    mesh.triangles = std::move(shape.triangles);
    mesh.attributes = std::move(shape.attributes);
    mesh.face_attributes = std::move(shape.face_attributes);
    mesh.position_type = shape.position_type;
    job.finish();
    return mesh;
  });
}

Result<void> write_mesh(const std::string& path, const Mesh& mesh, const Context& context) {
  return guarded([&] {
    const MeshWriter writer = mesh_writer(extension_of(path));
    if (!writer) refuse(path, "meshes are not written to files", "use .ply .obj .off or .stl");
    require_consistent(path, mesh);
    write(path, context, writer, mesh);
  });
}

Result<void> write_tetrahedra(const std::string& path, const TetVolume& volume,
                              const Context& context) {
  return guarded([&] {
    const VolumeWriter writer = volume_writer(extension_of(path));
    if (!writer) refuse(path, "tetrahedra are not written to files", "use .msh or .vtk");
    require_consistent(path, volume);
    write(path, context, writer, volume);
  });
}

Result<void> write_features(const std::string& path, const Mesh& mesh,
                            const FeatureNetwork& network, const Context& context) {
  return guarded([&] {
    const NetworkWriter writer = network_writer(extension_of(path));
    if (!writer) refuse(path, "feature curves are not written to files", "use .ply .obj or .json");
    require_consistent(path, mesh, network);
    const auto write_on_mesh = [mesh = &mesh, writer](AtomicFile& file, const FeatureNetwork& data,
                                                      Job& job) { writer(file, *mesh, data, job); };
    write(path, context, write_on_mesh, network);
  });
}

Result<void> write_text(const std::string& path, const std::string& text) {
  return guarded([&] {
    AtomicFile file(path);
    file.text(text);
    file.commit();
  });
}

}  // namespace arris
