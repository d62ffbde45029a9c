// How bright a surface is: Lambert's law, for the lights of a scene, along the axes of the world.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/scene.hpp"

namespace ros2wasm_sim {

class Lighting {
 public:
  explicit Lighting(const RenderScene& scene) : ambient_(scene.settings().ambient) {
    for (const RenderScene::PlacedLight& one : scene.lights()) {
      Lamp lamp{*one.light, one.pose.position, rotate(one.pose.orientation, one.light->direction)};
      const double size = length(lamp.direction);
      if (size > 0) lamp.direction = (1 / size) * lamp.direction;
      has_local_ = has_local_ || one.light->type != "directional";
      lamps_.push_back(lamp);
    }
  }

  /// Whether the light on a flat face differs from place to place.
  bool has_local() const { return has_local_; }

  /// The colour of a surface whose own one is `look` times `texel`.
  Vector3 shade(const Look& look, const Vector3& texel, const Vector3& at,
                const Vector3& normal) const {
    Vector3 light;
    for (const Lamp& lamp : lamps_) {
      const double strength = lamp.strength(at, normal);
      const Color& c = lamp.light.diffuse;
      light = light + strength * Vector3{c.r, c.g, c.b};
    }
    return {look.emissive.r + texel.x * (look.ambient.r * ambient_.r + look.diffuse.r * light.x),
            look.emissive.g + texel.y * (look.ambient.g * ambient_.g + look.diffuse.g * light.y),
            look.emissive.b + texel.z * (look.ambient.b * ambient_.b + look.diffuse.b * light.z)};
  }

 private:
  struct Lamp {
    Light light;
    Vector3 position;
    Vector3 direction;

    double strength(const Vector3& at, const Vector3& normal) const {
      if (light.type == "directional")
        return light.intensity * std::max(0.0, -dot(direction, normal));
      const Vector3 way = at - position;
      const double distance = length(way);
      if (distance > light.range || distance == 0) return 0;
      const Vector3 ray = (1 / distance) * way;
      double strength = light.intensity * std::max(0.0, -dot(ray, normal));
      const double fade = light.constant + distance * (light.linear + distance * light.quadratic);
      if (fade > 1e-6) strength /= fade;
      if (light.type == "spot") {
        const double inner = std::cos(light.inner_angle / 2);
        const double outer = std::cos(light.outer_angle / 2);
        const double cosine = dot(ray, direction);
        strength *= inner > outer ? std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0)
                                  : (cosine >= outer ? 1.0 : 0.0);
      }
      return strength;
    }
  };

  Color ambient_;
  std::vector<Lamp> lamps_;
  bool has_local_ = false;
};

}  // namespace ros2wasm_sim
