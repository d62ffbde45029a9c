// See sdf_include.hpp.
#include "sdf/sdf_include.hpp"

#include <algorithm>

#include "sdf/sdf_link.hpp"

namespace ros2wasm_sim {
namespace {

/// The file that a `model.config` names: that of the newest version that can be read.
std::string file_in_folder(Context& context, const std::string& folder, const Node& where) {
  for (const char* name : {"/model.config", "/manifest.xml"}) {
    if (!context.read(folder + name)) {
      continue;
    }
    const Source* config = context.open(folder + name, where);
    if (config == nullptr) {
      return "";
    }
    std::string best;
    int best_version = -1;
    for (const Node& sdf : children({config, &config->document->root()}, "sdf")) {
      const int version = parse_minor_version(attribute(sdf, "version")).value_or(0);
      if (version > best_version && version <= kNewestMinorVersion && !text_of(sdf).empty()) {
        best_version = version;
        best = text_of(sdf);
      }
    }
    if (best.empty()) {
      context.warning(
          {config, &config->document->root()},
          "the model names no <sdf> file of a version up to 1.12, so model.sdf is read");
    }
    return folder + "/" + (best.empty() ? "model.sdf" : best);
  }
  return context.read(folder + "/model.sdf") ? folder + "/model.sdf" : folder;
}

/// The text that an <include> asks for; null with a note when it is not found.
const Source* included_source(Context& context, const Node& uri_node, const std::string& uri) {
  const char* built_in = built_in_model(uri);
  if (built_in != nullptr) {
    // A model of that name in the user's folders comes first.
    const std::optional<std::string> own = context.find_quietly(uri);
    const std::string file = own ? file_in_folder(context, *own, uri_node) : "";
    return own && context.read(file) ? context.open(file, uri_node)
                                     : context.parse(built_in, uri, "");
  }
  const std::string found = context.find(uri, uri_node, "the model");
  if (found.empty()) {
    return nullptr;
  }
  const std::string file = file_in_folder(context, found, uri_node);
  if (file == found && !context.read(file)) {
    context.error(uri_node, "the model " + uri + " cannot be read: " + found +
                                " is not a file, and has no model.config and no model.sdf");
    return nullptr;
  }
  return file.empty() ? nullptr : context.open(file, uri_node);
}

ModelChanges changes_of(Context& context, const Node& node) {
  ModelChanges changes;
  changes.name = checked_name(context, node, text_of(node, "name"));
  const RawPose pose = raw_pose(context, node);
  if (pose.where) {
    changes.pose = pose;
  }
  if (!text_of(node, "static").empty()) {
    changes.is_static = boolean(context, node, "static", false);
  }
  changes.placement_frame = text_of(node, "placement_frame");
  for (const Node& plugin : children(node, "plugin")) {
    if (context.spend(plugin)) {
      changes.plugins.push_back(read_plugin(context, plugin));
    }
  }
  return changes;
}

Included read_included(Context& context, const Node& node, const Node& root, int depth) {
  Included result;
  const ModelChanges changes = changes_of(context, node);
  for (const Node& one : children(root)) {
    const std::string& kind = one.element->name;
    if (kind == "model") {
      result.model = read_model_element(context, one, changes, depth + 1);
      return result;
    }
    if (kind == "light") {
      result.light = read_light(context, one);
      result.light->name = changes.name.empty() ? result.light->name : changes.name;
      result.light_pose = changes.pose.value_or(raw_pose(context, one));
      return result;
    }
    if (kind == "actor") {
      context.warning_once(node, "actors are not supported and are skipped");
      return result;
    }
  }
  context.error(node, root.source->file + " has no <model>, so it cannot be included");
  return result;
}

}  // namespace

Included read_include(Context& context, const Node& node, int depth) {
  const Node uri_node = child(node, "uri");
  const std::string uri = text_of(uri_node);
  if (uri.empty()) {
    context.error(node, "<include> needs a <uri>");
    return {};
  }
  if (!context.spend(node)) {
    return {};
  }
  const Source* source = included_source(context, uri_node, uri);
  if (source == nullptr) {
    return {};
  }
  const Node root{source, &source->document->root()};
  std::vector<std::string>& open = context.open_files;
  if (std::find(open.begin(), open.end(), source->file) != open.end()) {
    context.error(node, source->file + " includes itself");
    return {};
  }
  if (root.element->name != "sdf" && root.element->name != "gazebo") {
    context.error(node, source->file + " is not SDF: its first element is <" + root.element->name +
                            "> instead of <sdf>");
    return {};
  }
  open.push_back(source->file);
  Included result = read_included(context, node, root, depth);
  open.pop_back();
  return result;
}

}  // namespace ros2wasm_sim
