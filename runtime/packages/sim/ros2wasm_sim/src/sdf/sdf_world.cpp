// See sdf_world.hpp.
#include "sdf/sdf_world.hpp"

#include <unordered_map>
#include <unordered_set>

#include "sdf/sdf_include.hpp"
#include "sdf/sdf_link.hpp"
#include "sdf/sdf_model.hpp"

namespace ros2wasm_sim {
namespace {

class WorldReader {
 public:
  WorldReader(Context& context, const Node& node) : context_(context), node_(node) {}

  World read();

 private:
  struct PlacedLight {
    Light light;
    RawPose pose;
  };

  void read_entities();
  void read_entity(const Node& one);
  void keep(std::optional<ScopedModel> model);
  void keep(Light light, RawPose pose);
  void place_entities();
  void read_settings();
  void read_physics(const Node& physics);
  void read_scene(const Node& scene);
  void read_spherical(const Node& node);
  void apply_state(const Node& state);

  Context& context_;
  Node node_;
  Scope scope_{"world"};
  World world_;
  std::vector<ScopedModel> models_;
  std::vector<PlacedLight> lights_;
  std::unordered_set<std::string> names_;         ///< of models and frames
  std::unordered_map<std::string, int> repeats_;  ///< how often a name was given before
};

/// The one with `default`, or the first.
Node physics_of(const Node& world) {
  const std::vector<Node> all = children(world, "physics");
  for (const Node& one : all) {
    const std::string by_default = attribute(one, "default");
    if (by_default == "true" || by_default == "1") {
      return one;
    }
  }
  return all.empty() ? Node{} : all.front();
}

void WorldReader::keep(std::optional<ScopedModel> model) {
  if (!model) {
    return;
  }
  std::string& name = model->model.name;
  if (!name.empty() && !names_.insert(name).second) {
    const std::string first = name;
    do {
      name = first + "_" + std::to_string(++repeats_[first]);
    } while (!names_.insert(name).second);
    context_.warning(model->where, "the world has two models or frames `" + first +
                                       "`, so this one is named `" + name +
                                       "`; give an <include> a <name>");
  }
  models_.push_back(std::move(*model));
}

void WorldReader::keep(Light light, RawPose pose) {
  lights_.push_back({std::move(light), std::move(pose)});
}

void WorldReader::read_entity(const Node& one) {
  const std::string& kind = one.element->name;
  if (kind == "model") {
    keep(read_model_element(context_, one, {}, 1));
  } else if (kind == "include") {
    Included included = read_include(context_, one, 1);
    keep(std::move(included.model));
    if (included.light) {
      keep(std::move(*included.light), std::move(included.light_pose));
    }
  } else if (kind == "light" && context_.spend(one)) {
    keep(read_light(context_, one), raw_pose(context_, one));
  } else if (kind == "plugin" && context_.spend(one)) {
    world_.plugins.push_back(read_plugin(context_, one));
  } else if (kind == "actor" || kind == "population" || kind == "road" || kind == "joint") {
    context_.warning_once(one, "<" + kind + "> of a world is not supported and is skipped");
  }
}

void WorldReader::read_entities() {
  for (const Node& frame : children(node_, "frame")) {
    const std::string name = context_.spend(frame) ? required_name(context_, frame) : "";
    if (name.empty()) {
      continue;
    }
    names_.insert(name);
    Scope::Entry entry;
    entry.name = name;
    entry.where = frame;
    entry.pose = raw_pose(context_, frame);
    entry.attached_to = attribute(frame, "attached_to");
    scope_.add(context_, std::move(entry));
  }
  for (const Node& one : children(node_)) {
    read_entity(one);
  }
}

void WorldReader::place_entities() {
  for (const ScopedModel& model : models_) {
    Scope::Entry entry;
    entry.name = model.model.name;
    entry.kind = Scope::Kind::kModel;
    entry.where = model.where;
    entry.pose = model.pose;
    entry.placement = model.placement;
    entry.canonical_link = entry.name + "::" + model.model.canonical_link;
    entry.inner = model.scope;
    if (!entry.name.empty()) {
      scope_.add(context_, std::move(entry));
    }
  }
  scope_.resolve(context_, "");
  for (ScopedModel& model : models_) {
    if (const std::optional<Place> place = scope_.find(model.model.name)) {
      model.model.pose = place->pose;
    }
    world_.models.push_back(std::move(model.model));
  }
  for (PlacedLight& light : lights_) {
    light.light.pose = scope_.pose_in_root(context_, light.pose, "");
    world_.lights.push_back(std::move(light.light));
  }
}

void WorldReader::read_physics(const Node& physics) {
  PhysicsSettings& value = world_.physics;
  value.max_step_size =
      number(context_, physics, "max_step_size", value.max_step_size, Range::kPositive);
  value.real_time_factor =
      number(context_, physics, "real_time_factor", value.real_time_factor, Range::kNotNegative);
  if (!text_of(physics, "real_time_update_rate").empty()) {
    value.real_time_update_rate =
        number(context_, physics, "real_time_update_rate", 1000, Range::kNotNegative);
  }
}

void WorldReader::read_scene(const Node& scene) {
  Scene& value = world_.scene;
  value.ambient = color(context_, scene, "ambient", value.ambient);
  value.background = color(context_, scene, "background", value.background);
  value.shadows = boolean(context_, scene, "shadows", value.shadows);
  value.grid = boolean(context_, scene, "grid", value.grid);
}

void WorldReader::read_spherical(const Node& node) {
  if (!node) {
    return;
  }
  SphericalCoordinates value;
  value.latitude_deg = number(context_, node, "latitude_deg", 0);
  value.longitude_deg = number(context_, node, "longitude_deg", 0);
  value.elevation = number(context_, node, "elevation", 0);
  value.heading_deg = number(context_, node, "heading_deg", 0);
  world_.spherical = value;
}

void WorldReader::read_settings() {
  const Node physics = physics_of(node_);
  read_physics(physics);
  // Up to version 1.5 these were in <physics>.
  world_.gravity = vector3(context_, physics, "gravity", world_.gravity);
  world_.gravity = vector3(context_, node_, "gravity", world_.gravity);
  world_.magnetic_field = vector3(context_, physics, "magnetic_field", world_.magnetic_field);
  world_.magnetic_field = vector3(context_, node_, "magnetic_field", world_.magnetic_field);
  read_scene(child(node_, "scene"));
  read_spherical(child(node_, "spherical_coordinates"));
}

/// A world that was saved has where its models were then.
void WorldReader::apply_state(const Node& state) {
  std::unordered_map<std::string, Pose> models, lights;
  for (const Node& one : children(state)) {
    const std::string& kind = one.element->name;
    if ((kind == "model" || kind == "light") && child(one, "pose")) {
      (kind == "model" ? models : lights)[attribute(one, "name")] = raw_pose(context_, one).pose;
    }
  }
  for (Model& model : world_.models) {
    const auto found = models.find(model.name);
    model.pose = found == models.end() ? model.pose : found->second;
  }
  for (Light& light : world_.lights) {
    const auto found = lights.find(light.name);
    light.pose = found == lights.end() ? light.pose : found->second;
  }
}

World WorldReader::read() {
  const std::string name = attribute(node_, "name");
  world_.name = name.empty() ? world_.name : name;
  read_settings();
  read_entities();
  place_entities();
  apply_state(child(node_, "state"));
  return std::move(world_);
}

}  // namespace

World read_world_element(Context& context, const Node& node) {
  return WorldReader(context, node).read();
}

}  // namespace ros2wasm_sim
