// See sdf_model.hpp.
#include "sdf/sdf_model.hpp"

#include <unordered_set>

#include "sdf/sdf_include.hpp"
#include "sdf/sdf_joint.hpp"
#include "sdf/sdf_link.hpp"

namespace ros2wasm_sim {
namespace {

/// A model in the model, or one whose parts become the model's.
struct Nested {
  ScopedModel value;
  bool is_merged = false;
  std::string frame;  ///< where it is, in the scope of the outer model
};

class ModelReader {
 public:
  ModelReader(Context& context, const Node& node, int depth)
      : context_(context),
        node_(node),
        depth_(depth),
        scope_(std::make_shared<Scope>("__model__")) {}

  std::optional<ScopedModel> read(const ModelChanges& changes);

 private:
  void read_nested();
  void keep_nested(std::optional<ScopedModel> value, bool is_merged);
  void fill_scope();
  void add_merged(const Nested& nested);
  std::string canonical_link() const;
  void read_parts();
  void append(Nested& nested);

  Context& context_;
  Node node_;
  int depth_;
  std::shared_ptr<Scope> scope_;
  std::vector<Nested> nested_;
  std::vector<Node> links_, joints_, frames_;
  Model model_;
};

/// Makes names of a nested model those of the outer one.
void scope_names(Model& model, const std::string& prefix) {
  const auto scoped = [&prefix](std::string& name) { name.insert(0, prefix); };
  for (Link& link : model.links) {
    scoped(link.name);
  }
  for (Joint& joint : model.joints) {
    scoped(joint.name);
    scoped(joint.child);
    if (joint.parent != "world") {
      scoped(joint.parent);
    }
    for (JointAxis& axis : joint.axes) {
      if (axis.mimic) {
        scoped(axis.mimic->joint);
      }
    }
  }
  for (Frame& frame : model.frames) {
    scoped(frame.name);
    scoped(frame.link);
  }
  for (Plugin& plugin : model.plugins) {
    scoped(plugin.model_scope);
  }
  scoped(model.canonical_link);
}

/// A static model in one that moves: each link is fixed to the world.
void fix_to_world(Model& model) {
  std::unordered_set<std::string> names;
  for (const Joint& joint : model.joints) {
    names.insert(joint.name);
  }
  for (const Link& link : model.links) {
    Joint joint;
    joint.name = link.name + "_static";
    while (names.count(joint.name) != 0) {
      joint.name += '_';
    }
    joint.parent = "world";
    joint.child = link.name;
    model.joints.push_back(std::move(joint));
  }
}

void ModelReader::keep_nested(std::optional<ScopedModel> value, bool is_merged) {
  if (!value) {
    return;
  }
  Nested nested;
  nested.is_merged = is_merged;
  const std::string& name = value->model.name;
  nested.frame = is_merged ? "_merged__" + name + "__model__" : name;
  nested.value = std::move(*value);
  nested_.push_back(std::move(nested));
}

void ModelReader::read_nested() {
  for (const Node& one : children(node_)) {
    const std::string& kind = one.element->name;
    if (kind == "link" || kind == "joint" || kind == "frame") {
      if (!context_.spend(one)) {
        return;
      }
      if (required_name(context_, one).empty()) {
        continue;
      }
      (kind == "link" ? links_ : kind == "joint" ? joints_ : frames_).push_back(one);
    } else if (kind == "model") {
      keep_nested(read_model_element(context_, one, {}, depth_ + 1), false);
    } else if (kind == "include") {
      const std::string merge = attribute(one, "merge");
      keep_nested(read_include(context_, one, depth_).model, merge == "true" || merge == "1");
    } else if (kind == "plugin" && context_.spend(one)) {
      model_.plugins.push_back(read_plugin(context_, one));
    }
  }
}

void ModelReader::add_merged(const Nested& nested) {
  const Scope& inner = *nested.value.scope;
  for (std::size_t i = 0; i < inner.entries().size(); ++i) {
    Scope::Entry entry = inner.entries()[i];
    entry.pose.pose = inner.place_of(i).pose;
    entry.pose.relative_to = nested.frame;
    entry.pose.where = {};
    entry.placement = {};
    const bool is_root = entry.attached_to.empty() || entry.attached_to == inner.root();
    if (entry.kind == Scope::Kind::kFrame && is_root) {
      entry.attached_to = nested.value.model.canonical_link;
    }
    scope_->add(context_, std::move(entry));
  }
}

void ModelReader::fill_scope() {
  const auto add = [this](const Node& node, Scope::Kind kind, std::string attached_to) {
    Scope::Entry entry;
    entry.name = attribute(node, "name");
    entry.kind = kind;
    entry.where = node;
    entry.pose = raw_pose(context_, node);
    entry.attached_to = std::move(attached_to);
    scope_->add(context_, std::move(entry));
  };
  for (const Node& link : links_) {
    add(link, Scope::Kind::kLink, "");
  }
  for (const Node& joint : joints_) {
    add(joint, Scope::Kind::kJoint, text_of(joint, "child"));
  }
  for (const Node& frame : frames_) {
    add(frame, Scope::Kind::kFrame, attribute(frame, "attached_to"));
  }
  for (const Nested& nested : nested_) {
    Scope::Entry entry;
    entry.name = nested.frame;
    entry.kind = Scope::Kind::kModel;
    entry.where = nested.value.where;
    entry.pose = nested.value.pose;
    entry.placement = nested.value.placement;
    const std::string& canonical = nested.value.model.canonical_link;
    entry.canonical_link = nested.is_merged ? canonical : nested.frame + "::" + canonical;
    entry.inner = nested.is_merged ? nullptr : nested.value.scope;
    scope_->add(context_, std::move(entry));
    if (nested.is_merged) {
      add_merged(nested);
    }
  }
}

std::string ModelReader::canonical_link() const {
  const std::string wanted = attribute(node_, "canonical_link");
  if (!wanted.empty()) {
    for (const Node& link : links_) {
      if (attribute(link, "name") == wanted) {
        return wanted;
      }
    }
    for (const Nested& nested : nested_) {
      const std::string prefix = nested.is_merged ? "" : nested.frame + "::";
      const std::optional<Place> inside =
          wanted.compare(0, prefix.size(), prefix) == 0
              ? nested.value.scope->find(wanted.substr(prefix.size()))
              : std::nullopt;
      if (inside && !inside->link.empty()) {
        return prefix + inside->link;
      }
    }
    context_.error(node_, "the canonical link `" + wanted + "` of the model `" + model_.name +
                              "` does not exist" +
                              context_.hint(wanted, [this] { return scope_->names(); }));
  }
  if (!links_.empty()) {
    return attribute(links_.front(), "name");
  }
  if (nested_.empty()) {
    return "";
  }
  const Nested& first = nested_.front();
  return (first.is_merged ? "" : first.frame + "::") + first.value.model.canonical_link;
}

void ModelReader::append(Nested& nested) {
  Model& inner = nested.value.model;
  const std::optional<Place> place = scope_->find(nested.frame);
  if (inner.is_static && !model_.is_static) {
    fix_to_world(inner);
  }
  for (Link& link : inner.links) {
    link.pose = (place ? place->pose : Pose{}) * link.pose;
    link.self_collide = link.self_collide || inner.self_collide;
  }
  if (!nested.is_merged) {
    scope_names(inner, nested.frame + "::");
  }
  const auto move_all = [](auto& from, auto& to) {
    for (auto& one : from) {
      to.push_back(std::move(one));
    }
  };
  move_all(inner.links, model_.links);
  move_all(inner.joints, model_.joints);
  move_all(inner.frames, model_.frames);
  move_all(inner.plugins, model_.plugins);
}

void ModelReader::read_parts() {
  for (const Node& link : links_) {
    model_.links.push_back(read_link(context_, link, *scope_, model_.is_static));
  }
  for (Nested& nested : nested_) {
    append(nested);
  }
  for (const Node& joint : joints_) {
    if (auto value = read_joint(context_, joint, *scope_)) {
      model_.joints.push_back(std::move(*value));
    }
  }
  check_mimics(context_, joints_, model_.joints);
  const auto add_frame = [this](const std::string& name) {
    const std::optional<Place> place = scope_->find(name);
    const std::optional<Place> link = place ? scope_->find(place->link) : std::nullopt;
    if (link) {
      model_.frames.push_back({name, place->link, inverse(link->pose) * place->pose});
    }
  };
  for (const Node& frame : frames_) {
    add_frame(attribute(frame, "name"));
  }
  for (const Nested& nested : nested_) {
    if (!nested.is_merged) {
      add_frame(nested.frame);
    }
  }
}

std::optional<ScopedModel> ModelReader::read(const ModelChanges& changes) {
  model_.name = changes.name.empty() ? required_name(context_, node_) : changes.name;
  model_.is_static = changes.is_static.value_or(boolean(context_, node_, "static", false));
  model_.self_collide = boolean(context_, node_, "self_collide", false);
  read_nested();
  if (links_.empty() && nested_.empty()) {
    // Its include was not found: that has been said, and the rest of the world is of use.
    if (child(node_, "include")) {
      return std::nullopt;
    }
    context_.error(node_, "the model `" + model_.name +
                              "` has no link. A model must have at least "
                              "one link.");
    return std::nullopt;
  }
  fill_scope();
  model_.canonical_link = canonical_link();
  scope_->resolve(context_, model_.canonical_link);
  read_parts();
  for (const Plugin& plugin : changes.plugins) {
    model_.plugins.push_back(plugin);
  }
  ScopedModel result;
  result.pose = changes.pose ? *changes.pose : raw_pose(context_, node_);
  const std::string placement = changes.placement_frame.empty()
                                    ? attribute(node_, "placement_frame")
                                    : changes.placement_frame;
  result.placement = inverse(scope_->place(context_, placement, node_).pose);
  result.model = std::move(model_);
  result.scope = scope_;
  result.where = node_;
  return result;
}

}  // namespace

std::optional<ScopedModel> read_model_element(Context& context, const Node& node,
                                              const ModelChanges& changes, int depth) {
  if (depth > kMaxDepth) {
    context.error(node, "models are nested more than " + std::to_string(kMaxDepth) +
                            " deep; an include may include itself");
    return std::nullopt;
  }
  if (!context.spend(node)) {
    return std::nullopt;
  }
  return ModelReader(context, node, depth).read(changes);
}

}  // namespace ros2wasm_sim
