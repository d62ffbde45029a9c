// The names of a model or world that poses are relative to, and where they are: SDF's rules for
// `relative_to`, `attached_to` and `inner::link`.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "sdf/xml_values.hpp"

namespace ros2wasm_sim {

/// Where a name is.
struct Place {
  Pose pose;         ///< in the root of the scope
  std::string link;  ///< that it moves with; empty in a world
};

class Scope {
 public:
  enum class Kind { kLink, kFrame, kJoint, kModel };
  struct Entry {
    std::string name;
    Kind kind = Kind::kFrame;
    Node where;
    RawPose pose;                        ///< `relative_to` empty: the root
    std::string attached_to;             ///< of frames and joints; empty: the root
    std::shared_ptr<const Scope> inner;  ///< of models: their names
    Pose placement;                      ///< of models: moves their root from where `pose` is
    std::string canonical_link;          ///< of models: as it is called here
  };

  /// `__model__` or `world`.
  explicit Scope(std::string root) : root_(std::move(root)) {}

  /// Adds a name, or reports an error when it is used already. Before SDF 1.7 a joint may have the
  /// name of a link: find() then finds the link, and find_joint() the joint.
  void add(Context& context, Entry entry);
  /// Finds the places of all names. A name whose place cannot be found is reported, and gets the
  /// place of the root.
  /// `canonical_link` is the link that the root of a model moves with.
  void resolve(Context& context, const std::string& canonical_link);

  /// After resolve(). The root has an empty or its own name.
  std::optional<Place> find(const std::string& name) const;
  std::optional<Place> find_joint(const std::string& name) const;
  /// Like find(), but reports an unknown name as an error and then returns the root.
  Place place(Context& context, const std::string& name, const Node& where) const;
  /// A pose that is relative to `by_default` unless it says otherwise, in the root.
  Pose pose_in_root(Context& context, const RawPose& pose, const std::string& by_default) const;
  std::vector<std::string> names() const;
  bool has(const std::string& name) const { return index_.count(name) != 0; }
  const std::vector<Entry>& entries() const { return entries_; }
  /// The place of an entry, after resolve().
  const Place& place_of(std::size_t entry) const { return places_[entry]; }
  const std::string& root() const { return root_; }

 private:
  /// The thing that the place of a name depends on.
  struct Dependency {
    enum class Kind { kRoot, kEntry, kUnknown } kind = Kind::kRoot;
    std::size_t entry = 0;
    Place inside;  ///< in the root of an inner model
  };
  bool shares_its_name(const Entry& entry) const;
  Dependency depends_on(const std::string& name) const;
  bool is_root(const std::string& name) const { return name.empty() || name == root_; }
  std::vector<Dependency> pose_dependencies(Context& context) const;
  std::vector<Dependency> link_dependencies(Context& context) const;
  void report_unknown(Context& context, const std::string& name, const Node& where) const;
  /// An order in which each comes after what it depends on. Cycles are reported and cut.
  std::vector<std::size_t> ordered(Context& context, std::vector<Dependency>& dependencies) const;

  std::string root_;
  std::string canonical_link_;
  std::vector<Entry> entries_;
  std::vector<Place> places_;
  std::unordered_map<std::string, std::size_t> index_;
};

}  // namespace ros2wasm_sim
