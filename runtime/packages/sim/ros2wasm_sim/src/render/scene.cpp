// See scene.hpp.
#include "render/scene.hpp"

#include <algorithm>
#include <utility>

#include "mesh/heights.hpp"

namespace ros2wasm_sim {
namespace {

std::string folder_of(const std::string& path) {
  return path.substr(0, path.rfind('/') + 1);
}

}  // namespace

RenderScene::RenderScene(Simulation& simulation, SceneFiles files)
    : simulation_(simulation), files_(std::move(files)) {}

const std::vector<Item>& RenderScene::items() {
  if (!is_built_ || revision_ != simulation_.revision()) rebuild();
  return items_;
}

Pose RenderScene::pose(const Item& item) const {
  return simulation_.physics().pose(item.link) * item.in_link;
}

std::vector<RenderScene::PlacedLight> RenderScene::lights() const {
  std::vector<PlacedLight> lights;
  for (const Light& light : simulation_.world().lights) lights.push_back({&light, light.pose});
  for (const LinkLight& one : link_lights_)
    lights.push_back({&one.light, simulation_.physics().pose(one.link) * one.light.pose});
  return lights;
}

void RenderScene::rebuild() {
  is_built_ = true;
  revision_ = simulation_.revision();
  items_.clear();
  link_lights_.clear();
  for (const Model& model : simulation_.world().models)
    for (const Link& link : model.links) {
      const LinkHandle handle = simulation_.physics().link(model.name, link.name);
      for (const Visual& visual : link.visuals) add_visual(handle, visual);
      for (const Light& light : link.lights) link_lights_.push_back({handle, light});
    }
}

void RenderScene::add_visual(LinkHandle link, const Visual& visual) {
  if (visual.transparency >= 1) return;
  if (const auto* mesh = std::get_if<Mesh>(&visual.geometry)) return add_mesh(link, visual, *mesh);
  if (const auto* map = std::get_if<Heightmap>(&visual.geometry)) {
    Visual placed = visual;
    placed.pose = visual.pose * Pose{map->position, {}};
    return add_mesh(link, placed, mesh_of(*map));
  }
  auto triangles = std::make_shared<const Triangles>(triangles_of(visual.geometry));
  const Material& material = visual.material;
  add(link, visual, std::move(triangles),
      {material.ambient, material.diffuse, material.emissive, texture(material.texture)});
}

void RenderScene::add_mesh(LinkHandle link, const Visual& visual, const Mesh& mesh) {
  const auto read = files_.mesh(mesh);
  if (read == nullptr) return;
  const Material& material = visual.material;
  std::vector<MeshPart> parts = read->parts;
  if (parts.empty() || material.is_given) parts = {MeshPart()};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t first = parts[i].first_face;
    const std::size_t end = i + 1 < parts.size() ? parts[i + 1].first_face : read->faces.size() / 3;
    const std::string key = part_key(mesh) + " " + std::to_string(first) + " " +
                            std::to_string(mesh.scale.x) + " " + std::to_string(mesh.scale.y) +
                            " " + std::to_string(mesh.scale.z);
    std::shared_ptr<const Triangles>& triangles = parts_[key + (parts.size() > 1 ? "" : " all")];
    if (triangles == nullptr)
      triangles =
          std::make_shared<const Triangles>(triangles_of(*read, mesh.scale, first, end - first));
    Look look{material.ambient, material.diffuse, material.emissive, texture(material.texture)};
    if (parts[i].diffuse) look.ambient = look.diffuse = *parts[i].diffuse;
    if (!parts[i].texture.empty()) look.texture = texture(folder_of(mesh.path) + parts[i].texture);
    add(link, visual, triangles, std::move(look));
  }
}

void RenderScene::add(LinkHandle link, const Visual& visual,
                      std::shared_ptr<const Triangles> triangles, Look look) {
  if (triangles->empty()) return;
  look.diffuse.a *= 1 - visual.transparency;
  Item item{link, visual.pose, std::move(triangles), std::move(look), {}, 0};
  const auto at = [](const Corner& one) {
    return Vector3{one.position[0], one.position[1], one.position[2]};
  };
  Vector3 low = at(item.triangles->front()), high = low;
  for (const Corner& one : *item.triangles) {
    const Vector3 p = at(one);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  item.middle = 0.5 * (low + high);
  item.radius = length(high - item.middle);
  items_.push_back(std::move(item));
}

std::shared_ptr<const Texture> RenderScene::texture(const std::string& path) {
  if (path.empty()) return nullptr;
  const auto [found, is_new] = textures_.try_emplace(path);
  if (!is_new) return found->second;
  const auto bytes = files_.read(path);
  auto picture = bytes ? read_picture(*bytes) : std::nullopt;
  constexpr std::size_t kMostBytes = 256U << 20;  // of all pictures
  if (!picture || (texture_bytes_ += picture->rgb.size()) > kMostBytes) return nullptr;
  found->second = std::make_shared<const Texture>(std::move(*picture));
  return found->second;
}

}  // namespace ros2wasm_sim
