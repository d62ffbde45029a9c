// See sdf_frames.hpp.
#include "sdf/sdf_frames.hpp"

#include <algorithm>

namespace ros2wasm_sim {
namespace {

/// The name in the scope of a joint that shares its name with a link.
std::string joint_key(const std::string& name) {
  return "joint " + name;
}

}  // namespace

bool Scope::shares_its_name(const Entry& entry) const {
  const auto found = index_.find(entry.name);
  return found != index_.end() && entry.kind == Kind::kJoint &&
         entries_[found->second].kind != Kind::kJoint && entry.where &&
         entry.where.source->minor_version < 7;
}

void Scope::add(Context& context, Entry entry) {
  if (shares_its_name(entry)) {
    entry.name = joint_key(entry.name);
  }
  const bool is_new = index_.emplace(entry.name, entries_.size()).second;
  if (!is_new || entry.name == root_ || entry.name == "world") {
    context.error(entry.where, "the name `" + entry.name + "` is " +
                                   (is_new ? "reserved" : "used twice in the same model or world"));
    if (!is_new) {
      return;
    }
  }
  entries_.push_back(std::move(entry));
}

Scope::Dependency Scope::depends_on(const std::string& name) const {
  if (is_root(name)) {
    return {};
  }
  const auto found = index_.find(name);
  if (found != index_.end()) {
    Dependency result{Dependency::Kind::kEntry, found->second, {}};
    result.inside.link = entries_[found->second].canonical_link;
    return result;
  }
  const std::size_t at = name.find("::");
  const auto outer = at == std::string::npos ? index_.end() : index_.find(name.substr(0, at));
  if (outer != index_.end() && entries_[outer->second].inner != nullptr) {
    const Entry& entry = entries_[outer->second];
    if (const std::optional<Place> inside = entry.inner->find(name.substr(at + 2))) {
      return {Dependency::Kind::kEntry,
              outer->second,
              {inside->pose, entry.name + "::" + inside->link}};
    }
  }
  return {Dependency::Kind::kUnknown, 0, {}};
}

void Scope::report_unknown(Context& context, const std::string& name, const Node& where) const {
  context.error(where, "frame `" + name + "` is not defined in this scope" +
                           context.hint(name, [this] { return names(); }));
}

std::vector<Scope::Dependency> Scope::pose_dependencies(Context& context) const {
  std::vector<Dependency> result;
  for (const Entry& entry : entries_) {
    // A joint is at its child, a frame at what it is attached to.
    const std::string& name =
        entry.pose.relative_to.empty() ? entry.attached_to : entry.pose.relative_to;
    Dependency dependency = depends_on(name);
    if (dependency.kind == Dependency::Kind::kUnknown) {
      // Unknown children of joints are reported with the joints.
      if (entry.kind != Kind::kJoint || !entry.pose.relative_to.empty()) {
        report_unknown(context, name, entry.pose.where ? entry.pose.where : entry.where);
      }
      dependency = {};
    }
    result.push_back(dependency);
  }
  return result;
}

std::vector<Scope::Dependency> Scope::link_dependencies(Context& context) const {
  std::vector<Dependency> result;
  for (const Entry& entry : entries_) {
    Dependency dependency;
    if (entry.kind == Kind::kFrame || entry.kind == Kind::kJoint) {
      dependency = depends_on(entry.attached_to);
    }
    if (dependency.kind == Dependency::Kind::kUnknown) {
      if (entry.kind == Kind::kFrame && !entry.pose.relative_to.empty()) {
        report_unknown(context, entry.attached_to, entry.where);
      }
      dependency = {};
    }
    result.push_back(dependency);
  }
  return result;
}

std::vector<std::size_t> Scope::ordered(Context& context,
                                        std::vector<Dependency>& dependencies) const {
  enum class State { kNew, kOpen, kDone };
  std::vector<State> states(entries_.size(), State::kNew);
  std::vector<std::size_t> result;
  for (std::size_t begin = 0; begin < entries_.size(); ++begin) {
    std::vector<std::size_t> chain;
    std::size_t at = begin;
    while (states[at] == State::kNew) {
      states[at] = State::kOpen;
      chain.push_back(at);
      if (dependencies[at].kind != Dependency::Kind::kEntry) {
        break;
      }
      const std::size_t next = dependencies[at].entry;
      if (states[next] == State::kOpen) {
        context.error(entries_[at].where, "the place of `" + entries_[at].name +
                                              "` depends on itself, by way of `" +
                                              entries_[next].name + "`");
        dependencies[at] = {};
        break;
      }
      at = next;
    }
    for (auto one = chain.rbegin(); one != chain.rend(); ++one) {
      states[*one] = State::kDone;
      result.push_back(*one);
    }
  }
  return result;
}

void Scope::resolve(Context& context, const std::string& canonical_link) {
  canonical_link_ = canonical_link;
  places_.assign(entries_.size(), Place{});
  std::vector<Dependency> poses = pose_dependencies(context);
  for (const std::size_t i : ordered(context, poses)) {
    const Entry& entry = entries_[i];
    const Dependency& dependency = poses[i];
    Pose base;
    if (dependency.kind == Dependency::Kind::kEntry) {
      base = places_[dependency.entry].pose * dependency.inside.pose;
    }
    places_[i].pose = base * entry.pose.pose * entry.placement;
  }
  std::vector<Dependency> links = link_dependencies(context);
  for (const std::size_t i : ordered(context, links)) {
    const Entry& entry = entries_[i];
    const Dependency& dependency = links[i];
    if (entry.kind == Kind::kLink) {
      places_[i].link = entry.name;
    } else if (entry.kind == Kind::kModel) {
      places_[i].link = entry.canonical_link;
    } else if (dependency.kind == Dependency::Kind::kEntry) {
      const bool is_inside = !dependency.inside.link.empty();
      places_[i].link = is_inside ? dependency.inside.link : places_[dependency.entry].link;
    } else {
      places_[i].link = canonical_link_;
    }
  }
}

std::optional<Place> Scope::find(const std::string& name) const {
  const Dependency dependency = depends_on(name);
  switch (dependency.kind) {
    case Dependency::Kind::kUnknown:
      return std::nullopt;
    case Dependency::Kind::kRoot:
      return Place{{}, canonical_link_};
    case Dependency::Kind::kEntry:
      break;
  }
  const Place& outer = places_[dependency.entry];
  return Place{outer.pose * dependency.inside.pose,
               dependency.inside.link.empty() ? outer.link : dependency.inside.link};
}

std::optional<Place> Scope::find_joint(const std::string& name) const {
  const std::string key = joint_key(name);
  return find(has(key) ? key : name);
}

Place Scope::place(Context& context, const std::string& name, const Node& where) const {
  const std::optional<Place> result = find(name);
  if (!result) {
    report_unknown(context, name, where);
  }
  return result.value_or(Place{{}, canonical_link_});
}

Pose Scope::pose_in_root(Context& context, const RawPose& pose,
                         const std::string& by_default) const {
  const std::string& name = pose.relative_to.empty() ? by_default : pose.relative_to;
  return place(context, name, pose.where).pose * pose.pose;
}

std::vector<std::string> Scope::names() const {
  std::vector<std::string> result;
  for (const Entry& entry : entries_) {
    result.push_back(entry.name);
    if (entry.inner != nullptr && result.size() < 100'000) {
      for (const std::string& inner : entry.inner->names()) {
        result.push_back(entry.name + "::" + inner);
      }
    }
  }
  return result;
}

}  // namespace ros2wasm_sim
