// Camera, rays, and which lines are drawn: what is in three dimensions.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/shapes.h"
#include "viewer/camera.h"
#include "viewer/outline.h"
#include "viewer/ray_scene.h"

namespace arris::viewer {
namespace {

constexpr double angle_30 = std::numbers::pi / 6;

// A cube of half side 0.5 round the origin.
Model cube_model() {
  const Mesh mesh = test::cube().mesh;
  Model model = {mesh.vertices, mesh.triangles, {}, 0};
  for (Vec3& p : model.vertices) p = p - Vec3{0.5, 0.5, 0.5};
  return model;
}

rc::Gen<Vec3> in_unit_ball() {
  const auto coordinate =
      rc::gen::map(rc::gen::inRange(-1000, 1001), [](int i) { return i / 1800.0; });
  return rc::gen::map(rc::gen::tuple(coordinate, coordinate, coordinate), [](const auto& t) {
    return Vec3{std::get<0>(t), std::get<1>(t), std::get<2>(t)};
  });
}

Camera any_camera() {
  Camera camera(*rc::gen::inRange(-360, 360), *rc::gen::inRange(-90, 91));
  return camera;
}

RC_GTEST_PROP(Camera, RaysGoThroughTheirPixels, ()) {
  Camera camera = any_camera();
  camera.fit({{-1, 0, 0}, {1, 0.2, 0.5}, {0, 0, 1}}, 300, 200, 1);
  const Vec3 p = *in_unit_ball();
  const Pixel at = camera.project(p);
  const Ray ray = camera.ray(at);
  RC_ASSERT(std::abs(length(ray.direction) - 1) < 1e-12);
  RC_ASSERT(length(cross(ray.direction, p - ray.origin)) < 1e-10);
  RC_ASSERT(dot(ray.direction, p - ray.origin) > 0);
}

RC_GTEST_PROP(Camera, FittedPointsFillThePictureAndStayInside, ()) {
  Camera camera = any_camera();
  auto points = *rc::gen::container<std::vector<Vec3>>(in_unit_ball());
  points.push_back({0.3, -0.2, 0.1});
  points.push_back({-0.3, 0.4, -0.5});
  camera.fit(points, 300, 200, 1);
  double left = 300, right = 0, top = 200, bottom = 0;
  for (const Vec3 p : points) {
    const Pixel q = camera.project(p);
    left = std::min(left, q.x), right = std::max(right, q.x);
    top = std::min(top, q.y), bottom = std::max(bottom, q.y);
  }
  RC_ASSERT(left > 0 && right < 300 && top > 0 && bottom < 200);
  RC_ASSERT(right - left > 0.89 * 300 || bottom - top > 0.89 * 200);
}

TEST(Camera, KnowsRightAndUp) {
  Camera camera(0, 0);
  camera.fit({{-1, 0, -1}, {1, 0, 1}}, 100, 100, 1);
  EXPECT_GT(camera.project({1, 0, 0}).x, camera.project({-1, 0, 0}).x);
  EXPECT_LT(camera.project({0, 0, 1}).y, camera.project({0, 0, -1}).y);
  EXPECT_LT(camera.eye().y, -1) << "looks along +y";
  EXPECT_GT(Camera(90, 0).eye().x, 1) << "from further to the right";
  EXPECT_GT(Camera(0, 80).eye().z, 1) << "from above";
}

TEST(RayScene, HitsTheNearFaceOfACube) {
  const Model model = cube_model();
  const RayScene scene(model);
  const auto hit = scene.nearest({{0.1, -3, 0.2}, {0, 1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->distance, 2.5);
  EXPECT_EQ(hit->normal, (Vec3{0, -1, 0}));
  EXPECT_FALSE(hit->ball);
  EXPECT_FALSE(scene.nearest({{0.1, -3, 0.2}, {0, -1, 0}}));
  EXPECT_TRUE(scene.blocked({{0.1, -3, 0.2}, {0, 1, 0}}, 2.6));
  EXPECT_FALSE(scene.blocked({{0.1, -3, 0.2}, {0, 1, 0}}, 2.4));
}

TEST(RayScene, HitsBallsAndLooksPastThem) {
  const Model model = {{}, {}, {{0, 0, 0}, {0, 0.5, 0}}, 0.25};
  const RayScene scene(model);
  const auto hit = scene.nearest({{0, -2, 0}, {0, 1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->distance, 1.75);
  EXPECT_EQ(hit->normal, (Vec3{0, -1, 0}));
  EXPECT_TRUE(hit->ball);
  EXPECT_FALSE(scene.nearest({{0.3, -2, 0}, {0, 1, 0}}));
}

long count(const std::vector<Line>& lines, LineKind kind) {
  return std::count_if(lines.begin(), lines.end(), [&](const Line& l) { return l.kind == kind; });
}

TEST(Outline, ACubeHasTwelveSharpEdges) {
  const auto lines = classify_edges(cube_model(), angle_30, {0, -4, 0});
  EXPECT_EQ(lines.size(), 18u);
  EXPECT_EQ(count(lines, LineKind::sharp), 12);
  EXPECT_EQ(count(lines, LineKind::smooth), 6);
  for (const Line& l : lines)
    EXPECT_NEAR(length(l.b - l.a), l.kind == LineKind::sharp ? 1 : std::sqrt(2.0), 1e-12);
}

TEST(Outline, MisorientedFacesDoNotMakeEdgesSharp) {
  Model model = cube_model();
  std::swap(model.triangles[0][0], model.triangles[0][1]);
  EXPECT_EQ(count(classify_edges(model, angle_30, {0, -4, 0}), LineKind::sharp), 12);
}

TEST(Outline, BoundariesAndOvercrowdedEdges) {
  Model model = cube_model();
  const Triangle extra = model.triangles.back();
  model.triangles.pop_back();
  EXPECT_EQ(count(classify_edges(model, angle_30, {0, -4, 0}), LineKind::boundary), 3);
  model.triangles.insert(model.triangles.end(), {extra, extra});
  const auto lines = classify_edges(model, angle_30, {0, -4, 0});
  EXPECT_EQ(count(lines, LineKind::boundary), 0);
  EXPECT_EQ(count(lines, LineKind::sharp), 13) << "the diagonal has three triangles";
}

TEST(Outline, TheContourOfASphereIsRound) {
  const Mesh mesh = test::sphere().mesh;
  const Vec3 eye = {0, -4, 0};
  for (const Line& l : classify_edges({mesh.vertices, mesh.triangles, {}, 0}, angle_30, eye))
    if (l.kind == LineKind::contour) {
      EXPECT_NEAR((0.5 * (l.a + l.b)).y, -0.25, 0.06);  // 1 / distance of the eye
    }
}

// Pixels that a line darkens.
int drawn(const Line& line, const RayScene& scene, const Camera& camera) {
  Ink ink(200, 200);
  draw_visible(line, scene, camera, 2, ink);
  Image image(200, 200);
  ink.lay(image, 0, 0, {0, 0, 0});
  int dark = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) dark += *image.at(x, y) < 128;
  return dark;
}

TEST(Outline, ThreeEdgesOfACubeAreHidden) {
  const Model model = cube_model();
  const RayScene scene(model);
  Camera camera(30, 25);
  camera.fit(model.vertices, 200, 200, 1);
  const Vec3 far_corner = {-0.5, 0.5, -0.5};
  for (const Line& l : classify_edges(model, angle_30, camera.eye())) {
    if (l.kind != LineKind::sharp) continue;
    const bool hidden = l.a == far_corner || l.b == far_corner;
    const Pixel a = camera.project(l.a), b = camera.project(l.b);
    const double area = 2 * std::hypot(b.x - a.x, b.y - a.y);
    if (hidden)
      EXPECT_LE(drawn(l, scene, camera), 12);  // the tip at the rim of the cube may show
    else
      EXPECT_NEAR(drawn(l, scene, camera), area, 0.1 * area);
  }
}

}  // namespace
}  // namespace arris::viewer
