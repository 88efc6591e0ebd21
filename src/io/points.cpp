// read_points: which reader reads which extension.
#include "arris/io.h"
#include "base/failure.h"
#include "io/file_reader.h"
#include "io/readers.h"

namespace arris {
namespace {

bool known(const std::string& extension) {
  for (const char* e : {".ply", ".xyz", ".txt", ".asc", ".csv", ".pts", ".off", ".obj"})
    if (extension == e) return true;
  return false;
}

Shape parse(const Source& source, const std::string& extension) {
  if (extension == ".ply") return read_ply(source, Want::points);
  if (extension == ".off") return read_off(source, Want::points);
  if (extension == ".obj") return read_obj(source, Want::points);
  return read_text(source, extension == ".pts" ? TextKind::pts : TextKind::plain);
}

}  // namespace

Result<PointCloud> read_points(const std::string& path, const Context& context) {
  return guarded([&] {
    Job job(context);
    job.stage("read", 0.2);
    FileReader file(path);
    const std::string extension = extension_of(path);
    if (!known(extension))
      throw Failure(
          ErrorCode::unsupported,
          "'" + path + "': points are not read from files with the extension '" + extension + "'",
          "use .ply .xyz .txt .asc .csv .pts .off or .obj");
    const Source source{path, file.load(job), job};
    job.stage("parse", 0.8);
    Shape shape = parse(source, extension);
    if (shape.positions.empty())
      fail(source, ErrorCode::bad_points, "", "holds no points", "give a file with points in it");
    PointCloud cloud;
    cloud.positions = std::move(shape.positions);
    cloud.attributes = std::move(shape.attributes);
    cloud.position_type = shape.position_type;
    for (const std::string& w : shape.warnings)
      cloud.warnings.push_back(std::string("'").append(path).append("': ").append(w));
    job.finish();
    return cloud;
  });
}

}  // namespace arris
