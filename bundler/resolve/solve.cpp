// See solve.hpp.
#include "bundler/resolve/solve.hpp"

#include <algorithm>
#include <cassert>
#include <set>

#include "bundler/resolve/best_choice.hpp"
#include "bundler/resolve/explain.hpp"
#include "bundler/resolve/sat_engine.hpp"
#include "bundler/resolve/universe.hpp"
#include "bundler/resolve/virtual_packages.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kMostTrials = 8;  // relaxed requests that are solved to prove a way out

Outcome<std::vector<MatchSpec>> parse_specs(const std::vector<RequestedSpec>& specs) {
  std::vector<MatchSpec> parsed;
  Diagnostics errors;
  for (const RequestedSpec& requested : specs) {
    auto spec = MatchSpec::parse(requested.text);
    if (spec) {
      parsed.push_back(std::move(*spec));
      continue;
    }
    for (Diagnostic& error : std::move(spec).errors()) {
      error.span = requested.span;
      if (!requested.origin.empty()) error.why.push_back("it is asked for by " + requested.origin);
      errors.push_back(std::move(error));
    }
  }
  if (!errors.empty()) return errors;
  return parsed;
}

/// Names that are in no channel: said at once, for all specs, with the nearest name.
Diagnostics unknown_names(const ResolveRequest& request, const std::vector<MatchSpec>& specs,
                          const Universe& universe, const RepoIndex& index) {
  Diagnostics errors;
  std::vector<std::string> unknown;
  for (const MatchSpec& spec : specs) {
    const auto name = spec.exact_name();
    if (name && !universe.by_name.contains(*name)) unknown.push_back(*name);
  }
  if (unknown.empty()) return errors;
  const auto elsewhere =
      index.elsewhere ? index.elsewhere(unknown) : std::map<std::string, std::string>();
  std::vector<std::string> names;
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const auto name = specs[i].exact_name();
    if (!name || universe.by_name.contains(*name)) continue;
    const RequestedSpec& requested = request.specs[i];
    Diagnostic error{.code = "R2W0302",
                     .message = "no channel has a package `" + *name + "`",
                     .span = requested.span,
                     .label = "not in any channel"};
    if (!requested.origin.empty()) error.why.push_back("it is asked for by " + requested.origin);
    error.why.push_back("the channels are: " + name_list(index.channels));
    if (const auto other = elsewhere.find(*name); other != elsewhere.end()) {
      error.why.push_back("it is there for " + other->second +
                          ", but has not been built for emscripten-wasm32");
    }
    for (const LeftOutRecord& record : index.left_out) {
      if (record.file_name.starts_with(*name + "-")) {
        error.why.push_back(record.file_name + " was skipped: " + record.reason);
      }
    }
    if (names.empty()) names = names_there(universe, index);
    if (const auto near = nearest(*name, names)) error.fix.push_back("write `" + *near + "`");
    errors.push_back(std::move(error));
  }
  return errors;
}

/// Dependencies before those that need them; names in order where free.
class InstallOrder {
 public:
  InstallOrder(const Universe& universe, const Choice& choice)
      : universe_(universe), choice_(choice) {
    chosen_.insert(choice.begin(), choice.end());
  }

  Resolution resolution() {
    for (const CandidateId id : choice_) visit(id);
    return std::move(resolution_);
  }

 private:
  void visit(CandidateId id) {
    if (!visited_.insert(id).second) return;
    const Candidate& candidate = universe_.candidates[id];
    std::set<CandidateId> needed;  // candidates are numbered by name
    for (const RequirementId need : universe_.needs(id).depends) {
      for (const CandidateId provider : universe_.matches(need).providers) {
        if (chosen_.contains(provider)) needed.insert(provider);
      }
    }
    for (const CandidateId provider : needed) visit(provider);
    if (!is_virtual(*candidate.record)) resolution_.packages.push_back(*candidate.record);
  }

  const Universe& universe_;
  const Choice& choice_;
  std::set<CandidateId> chosen_;
  std::set<CandidateId> visited_;
  Resolution resolution_;
};

/// Requests with one spec set free that do have a solution: proven ways out.
std::vector<std::string> proven_fixes(const ResolveRequest& request,
                                      const std::vector<MatchSpec>& specs, const Universe& universe,
                                      const std::vector<ProofRule>& conflict,
                                      const RepoIndex& index, const SearchBudget& budget) {
  std::vector<std::string> fixes;
  std::size_t trials = 0;
  for (std::size_t i = 0; i < specs.size() && trials < kMostTrials; ++i) {
    const auto name = specs[i].exact_name();
    const bool involved = std::any_of(conflict.begin(), conflict.end(), [&](const ProofRule& rule) {
      return rule.kind == ProofRule::Kind::kWanted && rule.requirement == universe.wanted[i];
    });
    if (!name || !involved || specs[i].text() == *name) continue;
    ++trials;
    std::vector<MatchSpec> relaxed = specs;
    relaxed[i] = *MatchSpec::parse(*name);
    const Universe wider = make_universe(request, relaxed, index);
    const auto choice = best_choice(wider, budget);
    if (!choice || !*choice) continue;
    for (const CandidateId id : **choice) {
      const PackageRecord& record = *wider.candidates[id].record;
      if (record.name == *name) {
        fixes.push_back("write `" + *name + " " + record.version + "` instead of `" +
                        request.specs[i].text + "`");
      }
    }
  }
  return fixes;
}

}  // namespace

Outcome<Resolution> solve(const ResolveRequest& request, const RepoIndex& index,
                          const SearchBudget& budget) {
  const auto specs = parse_specs(request.specs);
  if (!specs) return specs.errors();
  const Universe universe = make_universe(request, *specs, index);
  if (Diagnostics errors = unknown_names(request, *specs, universe, index); !errors.empty())
    return errors;

  const auto choice = best_choice(universe, budget);
  if (!choice) return choice.errors();
  if (*choice) {
    Resolution resolution = InstallOrder(universe, **choice).resolution();
    resolution.left_out = universe.unusable();
    return resolution;
  }

  const Proof proof = why_impossible(universe);
  assert(!proof.empty());  // both engines say so
  Diagnostics errors;
  for (const std::vector<ProofRule>& conflict : proof) {
    if (budget.cancellation.requested()) return interrupted();
    Diagnostic error{.code = "R2W0301",
                     .message = "no choice of packages gives all that is asked for",
                     .why = explain(request, universe, index, conflict),
                     .fix = proven_fixes(request, *specs, universe, conflict, index, budget)};
    for (const LeftOutRecord& record : universe.unusable())
      error.why.push_back(record.file_name + " was skipped: " + record.reason);
    for (std::size_t i = 0; i < universe.wanted.size() && !error.span; ++i) {
      const bool involved =
          std::any_of(conflict.begin(), conflict.end(), [&](const ProofRule& rule) {
            return rule.kind == ProofRule::Kind::kWanted && rule.requirement == universe.wanted[i];
          });
      if (involved) error.span = request.specs[i].span;
    }
    errors.push_back(std::move(error));
  }
  return errors;
}

}  // namespace ros2wasm
