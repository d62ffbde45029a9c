// A world as cameras see it: triangles with colours, and lights. One for all cameras of a
// simulation.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation.hpp"
#include "mesh/triangle_mesh.hpp"
#include "render/texture.hpp"
#include "render/triangles.hpp"

namespace ros2wasm_sim {

struct Look {
  Color ambient, diffuse, emissive;
  std::shared_ptr<const Texture> texture;
};

/// Triangles that move together.
struct Item {
  LinkHandle link;
  Pose in_link;
  std::shared_ptr<const Triangles> triangles;
  Look look;
  Vector3 middle;     ///< of a sphere around all corners, in the item
  double radius = 0;  ///< of that sphere
  bool is_transparent() const { return look.diffuse.a < 1; }
};

/// The files that a scene needs: meshes, and the bytes of pictures.
struct SceneFiles {
  MeshReader mesh;
  std::function<std::optional<std::string>(const std::string& path)> read;
};

class RenderScene {
 public:
  RenderScene(Simulation& simulation, SceneFiles files);

  /// Takes over models that came or went. The items stay valid until the next call.
  const std::vector<Item>& items();
  Pose pose(const Item& item) const;

  struct PlacedLight {
    const Light* light;
    Pose pose;  ///< in the world
  };
  std::vector<PlacedLight> lights() const;
  const Scene& settings() const { return simulation_.world().scene; }

 private:
  struct LinkLight {
    LinkHandle link;
    Light light;
  };

  void rebuild();
  void add_visual(LinkHandle link, const Visual& visual);
  void add_mesh(LinkHandle link, const Visual& visual, const Mesh& mesh);
  void add(LinkHandle link, const Visual& visual, std::shared_ptr<const Triangles> triangles,
           Look look);
  std::shared_ptr<const Texture> texture(const std::string& path);

  Simulation& simulation_;
  SceneFiles files_;
  std::uint64_t revision_ = 0;
  bool is_built_ = false;
  std::vector<Item> items_;
  std::vector<LinkLight> link_lights_;
  std::map<std::string, std::shared_ptr<const Texture>> textures_;
  std::size_t texture_bytes_ = 0;
  std::map<std::string, std::shared_ptr<const Triangles>> parts_;  ///< of meshes
};

}  // namespace ros2wasm_sim
