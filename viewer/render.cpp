#include "viewer/render.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <numbers>
#include <optional>

#include "viewer/lettering.h"
#include "viewer/outline.h"
#include "viewer/ray_scene.h"

namespace arris::viewer {
namespace {

constexpr Colour ink_colour = {0.08, 0.09, 0.12};
constexpr Colour wire_colour = {0.30, 0.33, 0.40};
constexpr Colour boundary_colour = {0.88, 0.08, 0.10};
constexpr double line_pen = 1.7, contour_pen = 1.2, wire_pen = 0.8, boundary_pen = 2.4;  // pixels

constexpr double letter_unit = 1.6, letter_pen = 1.5;  // pixels
constexpr int caption_height = 32;                     // pixels

constexpr double largest_picture = 1 << 28;  // pixels

// Beyond these, in either direction, squares of lengths leave the range of doubles.
constexpr double largest_coordinate = 1e150, smallest_radius = 1e-150;

bool in_range(Vec3 p) {
  const auto is = [](double c) { return std::abs(c) <= largest_coordinate; };  // not if it is NaN
  return is(p.x) && is(p.y) && is(p.z);
}

std::optional<Error> defect(const Panel& panel) {
  if (panel.mesh.triangles.empty() && panel.points.empty())
    return Error{ErrorCode::bad_points, "there is nothing to draw", "give a mesh or points"};
  for (const std::vector<Vec3>* points : {&panel.mesh.vertices, &panel.points})
    if (!std::all_of(points->begin(), points->end(), in_range))
      return Error{ErrorCode::bad_points, "a coordinate is not a finite number, or beyond 1e150",
                   "remove such points first"};
  for (const Triangle& t : panel.mesh.triangles)
    for (const Index v : t)
      if (v >= panel.mesh.vertices.size())
        return Error{ErrorCode::unreadable, "a triangle has a corner that names no vertex",
                     "repair the mesh"};
  return std::nullopt;
}

std::optional<Error> defect(const View& v, std::size_t panels) {
  const auto usage = [](const char* message, const char* remedy) {
    return Error{ErrorCode::usage, message, remedy};
  };
  const auto within = [](double x, double low, double high) { return x >= low && x <= high; };
  if (panels == 0) return usage("there is nothing to draw", "give at least one file");
  if (!within(v.width, 16, 16384) || !within(v.height, 16, 16384))
    return usage("the size is out of range", "give 16 to 16384 pixels");
  if (!std::isfinite(v.azimuth) || !within(v.elevation, -90, 90))
    return usage("the direction of view is out of range", "give an elevation of -90 to 90 degrees");
  if (!within(v.zoom, 1e-3, 1e3)) return usage("the zoom is out of range", "give 0.001 to 1000");
  if (!within(v.edge_angle, 0, 180))
    return usage("the edge angle is out of range", "give 0 to 180 degrees");
  if (!within(v.point_size, 0.1, 1000))
    return usage("the point size is out of range", "give 0.1 to 1000 pixels");
  if (v.columns < 0) return usage("the number of columns is negative", "give 0 or more");
  if (!within(v.quality.supersampling, 1, 16) || !within(v.quality.occlusion, 0, 4096))
    return usage("the quality is out of range", "give 1 to 16 samples, 0 to 4096 occlusion rays");
  if (static_cast<double>(panels) * v.width * (v.height + caption_height) > largest_picture)
    return usage("the picture is too large", "give a smaller size or fewer files");
  return std::nullopt;
}

struct Cancelled {};

void throw_if_cancelled(const Context& context) {
  if (context.cancel != nullptr && *context.cancel) throw Cancelled();
}

// The ball that the camera shows.
struct Frame {
  Vec3 centre;
  double radius = 0;
};

class BoundingBox {
 public:
  void add(Vec3 p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  }
  // Only what is drawn counts: vertices of triangles, and points.
  void add(const Panel& panel) {
    for (const Triangle& t : panel.mesh.triangles)
      for (const Index v : t) add(panel.mesh.vertices[v]);
    for (const Vec3 p : panel.points) add(p);
  }
  Frame frame() const {
    const Vec3 centre = 0.5 * (low_ + high_);
    const double radius = length(high_ - centre);
    return {centre, radius > smallest_radius ? radius : 1};
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low_ = {infinity, infinity, infinity}, high_ = {-infinity, -infinity, -infinity};
};

// Turns the model so that its up axis becomes z.
Vec3 upright(Vec3 p, Up up) {
  if (up == Up::x) return {p.y, p.z, p.x};
  if (up == Up::y) return {p.x, -p.z, p.y};
  return p;
}

// The other way round.
Vec3 toppled(Vec3 p, Up up) {
  if (up == Up::x) return {p.z, p.x, p.y};
  if (up == Up::y) return {p.x, p.z, -p.y};
  return p;
}

// The paint of a panel as a function of positions in the scene.
Paint framed(const Paint& paint, const Frame& frame, Up up) {
  if (!paint) return {};
  return [=](Vec3 p) { return paint(frame.radius * toppled(p, up) + frame.centre); };
}

std::vector<Vec3> framed(const std::vector<Vec3>& points, const Frame& frame, Up up) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Vec3 p : points)
    result.push_back(upright((1 / frame.radius) * (p - frame.centre), up));
  return result;
}

// What the camera has to show: used vertices and points.
std::vector<Vec3> shown_points(const Model& model) {
  std::vector<Vec3> points = model.balls;
  std::vector<bool> used(model.vertices.size());
  for (const Triangle& t : model.triangles)
    for (const Index v : t) used[v] = true;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) points.push_back(model.vertices[v]);
  return points;
}

void draw_lines(const Model& model, const RayScene& scene, const Camera& camera, const View& view,
                const Region& region, const Context& context, Image& image) {
  Ink wire(region.width, region.height), dark = wire, boundary = wire;
  const double angle = view.edge_angle * std::numbers::pi / 180;
  for (const Line& line : classify_edges(model, angle, camera.eye())) {
    throw_if_cancelled(context);
    const auto draw = [&](double pen, Ink& ink) { draw_visible(line, scene, camera, pen, ink); };
    if (line.kind == LineKind::boundary)
      draw(boundary_pen, boundary);
    else if (line.kind == LineKind::sharp)
      draw(line_pen, dark);
    else if (line.kind == LineKind::contour)
      draw(contour_pen, dark);
    else if (view.wireframe)
      draw(wire_pen, wire);
  }
  wire.lay(image, region.x, region.y, wire_colour);
  dark.lay(image, region.x, region.y, ink_colour);
  boundary.lay(image, region.x, region.y, boundary_colour);
}

void draw_caption(const std::string& text, int x, int y, int width, Image& image) {
  Ink ink(width, caption_height);
  const double left = std::max(4.0, (width - text_width(text, letter_unit)) / 2);
  draw_text(ink, text, {left, caption_height * 0.55}, letter_unit, letter_pen);
  ink.lay(image, x, y, ink_colour);
}

void draw_panel(const std::string& caption, const Model& model, const Paint& paint,
                const Camera& camera, const View& view, const Region& region,
                const Context& context, Image& image) {
  const RayScene scene(model);
  shade(scene, camera, view.quality, paint, region, context, image);
  throw_if_cancelled(context);
  draw_lines(model, scene, camera, view, region, context, image);
  if (!caption.empty())
    draw_caption(caption, region.x, region.y + region.height, region.width, image);
}

Image draw(const std::vector<Panel>& panels, const View& view, const Context& context) {
  BoundingBox all;
  for (const Panel& panel : panels) all.add(panel);
  Camera camera(view.azimuth, view.elevation);
  const auto fit = [&](const std::vector<Vec3>& points) {
    camera.fit(points, view.width, view.height, view.zoom);
  };

  std::vector<Model> models;
  std::vector<Paint> paints;
  std::vector<Vec3> shown;  // in all panels
  for (const Panel& panel : panels) {
    BoundingBox own;
    own.add(panel);
    const Frame frame = (view.common_frame ? all : own).frame();
    models.push_back({framed(panel.mesh.vertices, frame, view.up), panel.mesh.triangles,
                      framed(panel.points, frame, view.up), 0});
    paints.push_back(framed(panel.paint, frame, view.up));
    const std::vector<Vec3> points = shown_points(models.back());
    if (view.common_frame) shown.insert(shown.end(), points.begin(), points.end());
  }

  const bool captions = std::any_of(panels.begin(), panels.end(),
                                    [](const Panel& panel) { return !panel.caption.empty(); });
  const int count = static_cast<int>(panels.size());
  const int columns = view.columns == 0 ? count : std::min(view.columns, count);
  const int rows = (count + columns - 1) / columns;
  const int pitch = view.height + (captions ? caption_height : 0);
  Image image(columns * view.width, rows * pitch);
  for (int i = 0; i < count; ++i) {
    Model& model = models[static_cast<std::size_t>(i)];
    fit(view.common_frame ? shown : shown_points(model));
    model.ball_radius = view.point_size / 2 * camera.pixel_size();
    const Region region = {i % columns * view.width, i / columns * pitch, view.width, view.height};
    const auto at = static_cast<std::size_t>(i);
    draw_panel(panels[at].caption, model, paints[at], camera, view, region, context, image);
    if (context.progress) context.progress("render", (i + 1.0) / count);
  }
  return image;
}

}  // namespace

Result<Image> render(const std::vector<Panel>& panels, const View& view, const Context& context) {
  if (const auto error = defect(view, panels.size())) return *error;
  for (const Panel& panel : panels)
    if (const auto error = defect(panel)) return *error;
  try {
    return draw(panels, view, context);
  } catch (const Cancelled&) {
    return Error{ErrorCode::cancelled, "the picture was stopped", "start it again"};
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::out_of_memory, "the machine has no memory left for this picture",
                 "give a smaller size or fewer files"};
  } catch (const std::exception& e) {
    return Error{ErrorCode::internal, std::string("unexpected failure: ") + e.what(),
                 "please report it with the input"};
  }
}

}  // namespace arris::viewer
