#include "viewer/ray_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <stdexcept>

namespace arris::viewer {
namespace {

constexpr unsigned triangles_id = 0, balls_id = 1;

float narrow(double x) {
  return static_cast<float>(x);
}

template <class T>
T* new_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t items) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), items);
  if (buffer == nullptr) throw std::bad_alloc();
  return static_cast<T*>(buffer);
}

void attach(RTCScene scene, RTCGeometry geometry, unsigned id) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
}

// Geometries are counted references; this one lets go of its own.
struct GeometryHandle {
  GeometryHandle(RTCDevice device, RTCGeometryType type) : it(rtcNewGeometry(device, type)) {}
  ~GeometryHandle() { rtcReleaseGeometry(it); }
  GeometryHandle(const GeometryHandle&) = delete;
  GeometryHandle& operator=(const GeometryHandle&) = delete;
  RTCGeometry it;
};

struct Float3 {
  float x, y, z;
};
struct Float4 {
  float x, y, z, radius;
};

void add_triangles(RTCDevice device, RTCScene scene, const Model& model) {
  const GeometryHandle geometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = new_buffer<Float3>(geometry.it, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3,
                                      model.vertices.size());
  for (const Vec3 p : model.vertices) *vertices++ = {narrow(p.x), narrow(p.y), narrow(p.z)};
  auto* triangles = new_buffer<Triangle>(geometry.it, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3,
                                         model.triangles.size());
  std::copy(model.triangles.begin(), model.triangles.end(), triangles);
  attach(scene, geometry.it, triangles_id);
}

void add_balls(RTCDevice device, RTCScene scene, const Model& model) {
  const GeometryHandle geometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* balls = new_buffer<Float4>(geometry.it, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4,
                                   model.balls.size());
  for (const Vec3 p : model.balls)
    *balls++ = {narrow(p.x), narrow(p.y), narrow(p.z), narrow(model.ball_radius)};
  attach(scene, geometry.it, balls_id);
}

RTCRay to_embree(const Ray& ray, double limit) {
  RTCRay r{};
  r.org_x = narrow(ray.origin.x), r.org_y = narrow(ray.origin.y), r.org_z = narrow(ray.origin.z);
  r.dir_x = narrow(ray.direction.x), r.dir_y = narrow(ray.direction.y);
  r.dir_z = narrow(ray.direction.z);
  r.tfar = narrow(limit);
  r.mask = 0xFFFFFFFFu;
  return r;
}

Hit hit_triangle(const Model& model, const Ray& ray, unsigned index, double fallback) {
  const Triangle& t = model.triangles[index];
  const Vec3 a = model.vertices[t[0]];
  const Vec3 n = normalized(cross(model.vertices[t[1]] - a, model.vertices[t[2]] - a));
  const double slope = dot(n, ray.direction);
  return {slope != 0 ? dot(n, a - ray.origin) / slope : fallback, n, false};
}

Hit hit_ball(const Model& model, const Ray& ray, unsigned index) {
  const Vec3 to_centre = model.balls[index] - ray.origin;
  const double along = dot(to_centre, ray.direction);
  const double r = model.ball_radius;
  const double half_chord = r * r - (dot(to_centre, to_centre) - along * along);
  const double distance = along - std::sqrt(std::max(0.0, half_chord));
  return {distance, normalized(distance * ray.direction - to_centre), true};
}

}  // namespace

struct RayScene::Embree {
  // SSE2 is what every processor has: the same code everywhere. One thread: the same tree.
  RTCDevice device = rtcNewDevice("threads=1,isa=sse2");
  RTCScene scene = device != nullptr ? rtcNewScene(device) : nullptr;

  Embree() = default;
  ~Embree() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
};

RayScene::RayScene(const Model& model) : model_(model), embree_(std::make_unique<Embree>()) {
  if (embree_->scene == nullptr) throw std::runtime_error("Embree does not start");
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);  // no gaps between triangles
  if (!model.triangles.empty()) add_triangles(embree_->device, embree_->scene, model);
  if (!model.balls.empty()) add_balls(embree_->device, embree_->scene, model);
  rtcCommitScene(embree_->scene);
  if (const RTCError error = rtcGetDeviceError(embree_->device); error == RTC_ERROR_OUT_OF_MEMORY)
    throw std::bad_alloc();
  else if (error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree cannot take the model");
}

RayScene::~RayScene() = default;

std::optional<Hit> RayScene::nearest(const Ray& ray) const {
  RTCRayHit query{};
  query.ray = to_embree(ray, std::numeric_limits<double>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == triangles_id)
    return hit_triangle(model_, ray, query.hit.primID, static_cast<double>(query.ray.tfar));
  if (query.hit.geomID == balls_id) return hit_ball(model_, ray, query.hit.primID);
  return std::nullopt;
}

bool RayScene::blocked(const Ray& ray, double limit) const {
  RTCRay query = to_embree(ray, limit);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &query);
  return query.tfar < 0;  // Embree's way to say yes
}

}  // namespace arris::viewer
