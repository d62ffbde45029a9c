// See lock_graph.hpp.
#include "bundler/resolve/lock_graph.hpp"

#include <algorithm>
#include <deque>

#include "workspace_schema/conda/match_spec.hpp"

namespace ros2wasm {

LockGraph::LockGraph(const Lock& lock) : lock_(lock), needs_(lock.packages.size()) {
  const auto by_package = [](const LockEdge& a, const LockEdge& b) {
    return a.package != b.package ? a.package < b.package : a.spec < b.spec;
  };
  for (std::size_t i = 0; i < size(); ++i) {
    for (const std::string& spec : lock.packages[i].depends) add(needs_[i], spec);
    std::sort(needs_[i].begin(), needs_[i].end(), by_package);
  }
  for (const std::string& spec : lock.specs) add(roots_, spec);
  std::sort(roots_.begin(), roots_.end(), by_package);
}

void LockGraph::add(std::vector<LockEdge>& edges, const std::string& spec) const {
  const auto parsed = MatchSpec::parse(spec);
  if (!parsed) return;
  const auto name = parsed->exact_name();
  for (std::size_t i = 0; i < size(); ++i) {
    if (name ? package(i).name != *name : !parsed->matches(package(i))) continue;
    const auto same = std::find_if(edges.begin(), edges.end(),
                                   [i](const LockEdge& edge) { return edge.package == i; });
    if (same == edges.end()) {
      edges.push_back({.package = i, .spec = spec});
    } else if (same->spec != spec) {
      same->spec += " and " + spec;
    }
  }
}

std::optional<std::size_t> LockGraph::find(std::string_view name) const {
  const std::string wanted = ascii_lower(name);
  for (std::size_t i = 0; i < size(); ++i)
    if (package(i).name == wanted) return i;
  return std::nullopt;
}

std::vector<std::vector<LockEdge>> LockGraph::chains_to(std::size_t target) const {
  std::vector<std::vector<LockEdge>> chains;
  for (const LockEdge& root : roots_) {
    // Breadth first, so that the first chain found is a shortest one.
    std::vector<std::optional<std::pair<std::size_t, LockEdge>>> reached_by(size());
    std::deque<std::size_t> open{root.package};
    while (!open.empty() && open.front() != target) {
      const std::size_t at = open.front();
      open.pop_front();
      for (const LockEdge& edge : needs_[at]) {
        if (edge.package == root.package || reached_by[edge.package]) continue;
        reached_by[edge.package] = {at, edge};
        open.push_back(edge.package);
      }
    }
    if (open.empty()) continue;
    std::vector<LockEdge> chain;
    for (std::size_t at = target; at != root.package; at = reached_by[at]->first)
      chain.push_back(reached_by[at]->second);
    chain.push_back(root);
    std::reverse(chain.begin(), chain.end());
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace ros2wasm
