// See explain.hpp.
#include "bundler/resolve/explain.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kMostLines = 24;
constexpr int kDeepest = 8;

/// The rules of one conflict, by the candidate that they speak of.
struct Facts {
  std::set<RequirementId> wanted;
  std::map<CandidateId, std::set<RequirementId>> needs;
  std::map<CandidateId, std::set<CandidateId>> excludes;
};

Facts facts_of(const std::vector<ProofRule>& conflict) {
  Facts facts;
  for (const ProofRule& rule : conflict) {
    switch (rule.kind) {
      case ProofRule::Kind::kWanted:
        facts.wanted.insert(rule.requirement);
        break;
      case ProofRule::Kind::kRequires:
        facts.needs[rule.candidate].insert(rule.requirement);
        break;
      case ProofRule::Kind::kExcludes:
        facts.excludes[rule.candidate].insert(rule.other);
        facts.excludes[rule.other].insert(rule.candidate);
        break;
    }
  }
  return facts;
}

class Tree {
 public:
  Tree(const ResolveRequest& request, const Universe& universe, const RepoIndex& index,
       const std::vector<ProofRule>& conflict)
      : request_(request), universe_(universe), index_(index), facts_(facts_of(conflict)) {}

  std::vector<std::string> lines() {
    for (std::size_t i = 0; i < universe_.wanted.size(); ++i) {
      if (!facts_.wanted.contains(universe_.wanted[i])) continue;
      const RequestedSpec& spec = request_.specs[i];
      requirement(universe_.wanted[i], "`" + spec.text + "` is asked for" + whence(spec), 0);
      facts_.wanted.erase(universe_.wanted[i]);
    }
    if (lines_.size() > kMostLines) {
      const std::size_t more = lines_.size() - kMostLines;
      lines_.resize(kMostLines);
      lines_.push_back("... and " + std::to_string(more) + " more lines of this kind");
    }
    if (about_compilers()) {
      line(0, "what different versions of Emscripten built (" + std::string(kCompilerPackage) +
                  ") cannot run in one program");
    }
    return std::move(lines_);
  }

 private:
  void line(int depth, const std::string& text) {
    lines_.push_back(std::string(2 * static_cast<std::size_t>(depth), ' ') + text);
  }

  /// " at workspace.yaml:4:5 by ...".
  static std::string whence(const RequestedSpec& spec) {
    std::string text;
    if (spec.span) {
      text += " at " + spec.span->file + ":" + std::to_string(spec.span->line) + ":" +
              std::to_string(spec.span->column);
    }
    const bool said = spec.span && spec.span->file == spec.origin;
    if (!spec.origin.empty() && !said) text += " by " + spec.origin;
    return text;
  }

  [[nodiscard]] bool about_compilers() const {
    return std::any_of(facts_.needs.begin(), facts_.needs.end(), [this](const auto& fact) {
      return std::any_of(fact.second.begin(), fact.second.end(), [this](RequirementId id) {
        return universe_.requirement(id).name == kCompilerPackage;
      });
    });
  }

  [[nodiscard]] std::string nothing_fits(const Requirement& requirement) const {
    const auto name = requirement.spec.exact_name();
    if (!name) return "no package fits";
    const std::string there = versions_there(universe_, *name);
    if (!there.empty()) return "there is only " + *name + " " + there;
    std::string text = "no channel has a package `" + *name + "`";
    if (const auto near = nearest(*name, names_there(universe_, index_)))
      text += " (did you mean `" + *near + "`?)";
    return text;
  }

  /// Candidates that fail for the same reasons, on one line each.
  void requirement(RequirementId id, const std::string& head, int depth) {
    const Requirement& one = universe_.requirement(id);
    const std::vector<CandidateId>& providers = universe_.matches(id).providers;
    if (providers.empty()) {
      line(depth, head + ", but " + nothing_fits(one));
      return;
    }
    if (!shown_.insert(id).second) {
      line(depth, head + " (see above)");
      return;
    }
    line(depth, head);
    if (depth >= kDeepest) return;
    std::map<std::pair<std::set<RequirementId>, std::set<std::string>>, std::vector<CandidateId>>
        groups;
    std::vector<decltype(groups)::key_type> order;
    for (const CandidateId candidate : providers) {
      auto key = std::pair(reasons(candidate), excluded(candidate));
      if (key.first.empty() && key.second.empty()) continue;
      if (!groups.contains(key)) order.push_back(key);
      groups[key].push_back(candidate);
    }
    for (const auto& key : order) {
      const std::string who = names_of(groups[key]);
      for (const RequirementId need : key.first) {
        requirement(need, who + " needs `" + universe_.requirement(need).text + "`", depth + 1);
      }
      if (key.first.empty()) {
        for (const std::string& other : key.second)
          line(depth + 1, who + " cannot be there together with " + other);
      }
    }
  }

  [[nodiscard]] std::set<RequirementId> reasons(CandidateId candidate) const {
    const auto found = facts_.needs.find(candidate);
    return found == facts_.needs.end() ? std::set<RequirementId>() : found->second;
  }

  /// Names of the packages that keep a candidate out.
  [[nodiscard]] std::set<std::string> excluded(CandidateId candidate) const {
    std::set<std::string> others;
    const auto found = facts_.excludes.find(candidate);
    if (found == facts_.excludes.end()) return others;
    std::map<std::string, std::vector<CandidateId>> by_name;
    for (const CandidateId other : found->second)
      by_name[universe_.candidates[other].record->name].push_back(other);
    const std::string& own = universe_.candidates[candidate].record->name;
    for (const auto& [name, ids] : by_name)
      others.insert(name == own ? "another version of " + name : names_of(ids));
    return others;
  }

  /// "x 1.0" or "x 1.2, 1.1, 1.0".
  [[nodiscard]] std::string names_of(const std::vector<CandidateId>& ids) const {
    std::vector<std::string> versions;
    for (const CandidateId id : ids) {
      const std::string& version = universe_.candidates[id].record->version;
      if (std::find(versions.begin(), versions.end(), version) == versions.end())
        versions.push_back(version);
    }
    return universe_.candidates[ids.front()].record->name + " " + name_list(versions, 4);
  }

  const ResolveRequest& request_;
  const Universe& universe_;
  const RepoIndex& index_;
  Facts facts_;
  std::set<RequirementId> shown_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> explain(const ResolveRequest& request, const Universe& universe,
                                 const RepoIndex& index, const std::vector<ProofRule>& conflict) {
  return Tree(request, universe, index, conflict).lines();
}

}  // namespace ros2wasm
