#include "viewer/shade.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

namespace arris::viewer {
namespace {

// Reflectance and light are linear, per channel.
struct Light {
  double red = 0, green = 0, blue = 0;
  void add(double s, Light l) { red += s * l.red, green += s * l.green, blue += s * l.blue; }
};

constexpr Light white = {1, 1, 1};
constexpr Light front_reflectance = {0.60, 0.67, 0.76};
constexpr Light back_reflectance = {0.75, 0.42, 0.12};
constexpr Light ball_reflectance = {0.10, 0.22, 0.50};

constexpr double ambient = 0.36, key = 0.80, fill = 0.08;
// Direct light is dimmed a little in hollows too, instead of casting hard shadows.
constexpr double key_in_hollows = 0.55;

// Balls fade with distance, so that those behind do not confuse: this share at the far end.
constexpr double fading = 0.75;

// How far occluders count and how far rays start off the surface, in radii of the model.
constexpr double occlusion_reach = 0.5, occlusion_start = 1e-4;

std::uint8_t to_srgb(double linear) {
  const double l = std::clamp(linear, 0.0, 1.0);
  const double s = l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * s));
}

double to_linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

// `count` directions about +z, denser towards it by the cosine: a golden spiral.
std::vector<Vec3> cosine_directions(int count) {
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i) {
    const double r = std::sqrt((i + 0.5) / count);
    const double angle = 2 * std::numbers::pi * (i / std::numbers::phi);
    directions.push_back({r * std::cos(angle), r * std::sin(angle), std::sqrt(1 - r * r)});
  }
  return directions;
}

class Shader {
 public:
  Shader(const RayScene& scene, const Camera& camera, const Quality& quality, const Paint& paint)
      : scene_(scene), camera_(camera), paint_(paint), samples_(quality.supersampling) {
    const int per_pixel = samples_ * samples_;
    rays_ = (quality.occlusion + per_pixel - 1) / per_pixel;
    directions_ = cosine_directions(rays_ * per_pixel);
    key_light_ = normalized(-0.65 * camera.right() + 0.75 * camera.up() - 0.55 * camera.forward());
    fill_light_ = normalized(0.9 * camera.right() + 0.1 * camera.up() - 0.35 * camera.forward());
  }

  // The mean light of a pixel.
  Light pixel(int x, int y) const {
    Light sum;
    int k = 0;
    for (int i = 0; i < samples_; ++i)
      for (int j = 0; j < samples_; ++j, ++k) {
        const Ray ray = camera_.ray({x + (i + 0.5) / samples_, y + (j + 0.5) / samples_});
        sum.add(1.0 / (samples_ * samples_), sample(ray, k));
      }
    return sum;
  }

 private:
  Light sample(const Ray& ray, int k) const {
    const std::optional<Hit> hit = scene_.nearest(ray);
    if (!hit) return white;
    Vec3 n = hit->normal;
    Light reflectance = hit->ball ? ball_reflectance : front_reflectance;
    if (dot(n, ray.direction) > 0) {
      n = -1.0 * n;
      reflectance = back_reflectance;
    }
    const Vec3 at = ray.origin + hit->distance * ray.direction;
    if (paint_ && !hit->ball) {
      const Colour c = paint_(at);
      reflectance = {to_linear(c.red), to_linear(c.green), to_linear(c.blue)};
    }
    const double open = openness(at, n, k);
    const double direct =
        key * std::max(0.0, dot(n, key_light_)) + fill * std::max(0.0, dot(n, fill_light_));
    const double sky = 0.75 + 0.25 * n.z;  // a little more light from above
    Light light;
    const double faded = hit->ball ? fading * camera_.remoteness(hit->distance) : 0;
    light.add(faded, white);
    light.add((1 - faded) *
                  (ambient * sky * open + direct * (key_in_hollows + (1 - key_in_hollows) * open)),
              reflectance);
    return light;
  }

  // The share of the sky that a point sees, by the directions set aside for sample k of a pixel.
  double openness(Vec3 p, Vec3 n, int k) const {
    if (rays_ == 0) return 1;
    const Vec3 across = std::abs(n.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 u = normalized(cross(across, n)), v = cross(n, u);
    const Vec3 start = p + occlusion_start * n;
    int open = 0;
    for (int i = 0; i < rays_; ++i) {
      const Vec3 d = directions_[static_cast<std::size_t>(k + i * samples_ * samples_)];
      open += !scene_.blocked({start, d.x * u + d.y * v + d.z * n}, occlusion_reach);
    }
    return static_cast<double>(open) / rays_;
  }

  const RayScene& scene_;
  const Camera& camera_;
  const Paint& paint_;
  int samples_;
  int rays_ = 0;  // of occlusion, per sample
  std::vector<Vec3> directions_;
  Vec3 key_light_, fill_light_;
};

}  // namespace

void shade(const RayScene& scene, const Camera& camera, const Quality& quality, const Paint& paint,
           const Region& region, const Context& context, Image& image) {
  const Shader shader(scene, camera, quality, paint);
  std::atomic<int> next_row = 0;
  const auto cancelled = [&] { return context.cancel != nullptr && *context.cancel; };
  const auto work = [&] {
    for (int y; !cancelled() && (y = next_row++) < region.height;)
      for (int x = 0; x < region.width; ++x) {
        const Light light = shader.pixel(x, y);
        std::uint8_t* out = image.at(region.x + x, region.y + y);
        out[0] = to_srgb(light.red), out[1] = to_srgb(light.green), out[2] = to_srgb(light.blue);
      }
  };
  const unsigned threads =
      context.threads != 0 ? context.threads : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> workers;
  for (unsigned i = 1; i < threads; ++i) workers.emplace_back(work);
  work();
}

}  // namespace arris::viewer
