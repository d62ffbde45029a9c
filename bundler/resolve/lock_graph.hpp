// The graph of dependencies between chosen packages. Pure; for `tree` and `why`.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/schema/lock.hpp"

namespace ros2wasm {

struct LockEdge {
  std::size_t package = 0;  ///< the one that is needed, in Lock::packages
  std::string spec;         ///< as it is written
};

class LockGraph {
 public:
  /// `lock` must outlive it.
  explicit LockGraph(const Lock& lock);

  [[nodiscard]] const PackageRecord& package(std::size_t i) const { return lock_.packages[i]; }
  [[nodiscard]] std::size_t size() const { return lock_.packages.size(); }
  /// By name; letter case does not count.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
  /// The packages that the package needs, by name, each once; virtual packages are skipped.
  [[nodiscard]] const std::vector<LockEdge>& needs(std::size_t i) const { return needs_[i]; }
  /// The packages that the request names, by name.
  [[nodiscard]] const std::vector<LockEdge>& roots() const { return roots_; }
  /// From each root that leads to the package, one shortest chain to it. The first edge of a chain
  /// is a root. Empty: nothing needs it.
  [[nodiscard]] std::vector<std::vector<LockEdge>> chains_to(std::size_t package) const;

 private:
  void add(std::vector<LockEdge>& edges, const std::string& spec) const;

  const Lock& lock_;
  std::vector<std::vector<LockEdge>> needs_;
  std::vector<LockEdge> roots_;
};

}  // namespace ros2wasm
