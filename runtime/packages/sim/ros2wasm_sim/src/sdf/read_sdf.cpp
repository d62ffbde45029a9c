// See read_sdf.hpp.
#include "sdf/read_sdf.hpp"

#include <utility>

#include "sdf/read_urdf.hpp"
#include "sdf/sdf_include.hpp"
#include "sdf/sdf_link.hpp"
#include "sdf/sdf_model.hpp"
#include "sdf/sdf_world.hpp"

namespace ros2wasm_sim {
namespace {

template <typename T>
Reading<T> finished(Context& context, std::optional<T> value) {
  Reading<T> result;
  if (!value && !context.has_error()) {
    context.error({}, "nothing was read");
  }
  const bool has_error = context.has_error();
  result.notes = context.take_notes();
  if (!has_error) {
    result.value = std::move(value);
  }
  return result;
}

/// The root of an SDF; nothing, with an error, when it is another one.
Node sdf_root(Context& context, const Source& source) {
  const Node root{&source, &source.document->root()};
  const std::string& name = root.element->name;
  if (name != "sdf" && name != "gazebo") {
    const char* what =
        name == "robot" ? "a URDF, which is a robot and not a world: spawn it" : "not SDF";
    context.error(root, "the text is " + std::string(what) + " (its first element is <" + name +
                            ">, a world has <sdf>)");
    return {};
  }
  if (!has_attribute(root, "version")) {
    context.warning(root, "<" + name + "> has no attribute `version`, so it is read as SDF 1.6");
  } else if (source.minor_version > kNewestMinorVersion) {
    context.warning(root, "SDF " + attribute(root, "version") +
                              " is newer than 1.12, so new elements may be ignored");
  }
  return root;
}

Model model_of_light(Light light, const Pose& pose) {
  Model model;
  model.name = light.name;
  model.pose = pose;
  model.is_static = true;
  model.canonical_link = "link";
  Link link;
  link.name = "link";
  link.lights.push_back(std::move(light));
  model.links.push_back(std::move(link));
  return model;
}

/// A pose that has nothing to be relative to.
Pose pose_alone(Context& context, const RawPose& pose) {
  if (!pose.relative_to.empty() && pose.relative_to != "world") {
    context.warning(pose.where,
                    "`relative_to` of a spawned model is ignored: its pose is in the world");
  }
  return pose.pose;
}

std::optional<Model> model_of(Context& context, std::optional<ScopedModel> scoped) {
  if (!scoped) {
    return std::nullopt;
  }
  scoped->model.pose = pose_alone(context, scoped->pose) * scoped->placement;
  return std::move(scoped->model);
}

/// The first model, light or include of an element; `found` says whether there was one.
std::optional<Model> first_model(Context& context, const Node& parent, bool& found) {
  for (const Node& one : children(parent)) {
    const std::string& kind = one.element->name;
    found = kind == "model" || kind == "light" || kind == "include";
    if (kind == "model") {
      return model_of(context, read_model_element(context, one, {}, 1));
    }
    if (kind == "light") {
      return model_of_light(read_light(context, one), pose_alone(context, raw_pose(context, one)));
    }
    if (kind == "include") {
      Included included = read_include(context, one, 1);
      if (included.light) {
        return model_of_light(std::move(*included.light), pose_alone(context, included.light_pose));
      }
      if (!included.model && !context.has_error()) {
        context.error(one, "the included model was not read");
      }
      return model_of(context, std::move(included.model));
    }
  }
  return std::nullopt;
}

}  // namespace

Reading<World> read_world(const std::string& text, const std::string& file,
                          const Resources& resources) {
  Context context(resources);
  const Source* source = context.parse(text, file, folder_of(file));
  const Node root = source ? sdf_root(context, *source) : Node{};
  if (!root) {
    return finished<World>(context, std::nullopt);
  }
  context.open_files.push_back(file);
  const std::vector<Node> worlds = children(root, "world");
  if (worlds.empty()) {
    const bool is_model = child(root, "model") || child(root, "light");
    context.error(root, is_model ? "the file has a <model> and no <world>: a model is spawned into "
                                   "a world, or included by one"
                                 : "the file has no <world>");
    return finished<World>(context, std::nullopt);
  }
  if (worlds.size() > 1) {
    context.warning(worlds[1], "the file has more than one <world>; only the first is used");
  }
  return finished<World>(context, read_world_element(context, worlds.front()));
}

Reading<Model> read_model(const std::string& text, const std::string& file,
                          const Resources& resources) {
  Context context(resources);
  const Source* source = context.parse(text, file, folder_of(file));
  if (source != nullptr && source->document->root().name == "robot") {
    return read_urdf(source->document, file, resources);
  }
  const Node root = source ? sdf_root(context, *source) : Node{};
  if (!root) {
    return finished<Model>(context, std::nullopt);
  }
  context.open_files.push_back(file);
  bool found = false;
  std::optional<Model> model = first_model(context, root, found);
  if (!found) {
    model = first_model(context, child(root, "world"), found);
  }
  if (!found) {
    context.error(root, "the text has no <model> and no <light>");
  }
  return finished<Model>(context, std::move(model));
}

}  // namespace ros2wasm_sim
