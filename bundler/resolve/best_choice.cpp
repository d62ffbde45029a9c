// See best_choice.hpp. The engine says whether something is possible; which possibility is taken is
// decided here, one requirement after the other.
#include "bundler/resolve/best_choice.hpp"

#include <algorithm>

#include "bundler/resolve/propagation.hpp"
#include "bundler/resolve/virtual_packages.hpp"

namespace ros2wasm {
namespace {

class Walk {
 public:
  Walk(const Universe& universe, SatEngine& engine, Choice solution)
      : universe_(universe),
        engine_(engine),
        links_(universe),
        settled_(universe, links_),
        is_taken_(universe.candidates.size()) {
    use(std::move(solution));
  }

  Choice choice() {
    for (CandidateId id = 0; id < universe_.candidates.size(); ++id) {
      if (is_virtual(*universe_.candidates[id].record)) take(id);
    }
    std::vector<RequirementId> round = universe_.wanted;
    while (!round.empty()) {
      sort_by_text(round);
      next_round_.clear();
      for (const RequirementId requirement : round) serve(requirement);
      round = next_round_;
    }
    std::sort(taken_.begin(), taken_.end());
    return taken_;
  }

 private:
  void sort_by_text(std::vector<RequirementId>& round) const {
    std::sort(round.begin(), round.end(), [this](RequirementId a, RequirementId b) {
      return universe_.requirements[a].text < universe_.requirements[b].text;
    });
    round.erase(std::unique(round.begin(), round.end()), round.end());
  }

  /// Takes the best provider that a solution with all that was taken can have.
  void serve(RequirementId requirement) {
    const auto& providers = universe_.requirements[requirement].providers;
    if (std::any_of(providers.begin(), providers.end(),
                    [this](CandidateId id) { return is_taken_[id]; })) {
      return;
    }
    const auto best = std::find_if(providers.begin(), providers.end(),
                                   [this](CandidateId id) { return is_possible(id); });
    take(*best);  // the solution at hand has one
  }

  bool is_possible(CandidateId candidate) {
    if (in_solution_[candidate]) return true;
    if (settled_.banned(candidate)) return false;
    Propagation trial = settled_;
    if (!trial.choose(candidate)) return false;
    Choice fixed = taken_;
    fixed.push_back(candidate);
    auto answer = engine_.solve(fixed);
    auto* solution = std::get_if<Choice>(&answer);
    if (solution == nullptr) return false;
    use(std::move(*solution));
    return true;
  }

  void take(CandidateId candidate) {
    taken_.push_back(candidate);
    is_taken_[candidate] = true;
    static_cast<void>(settled_.choose(candidate));  // a solution has it, so it contradicts nothing
    const auto& needs = universe_.candidates[candidate].depends;
    next_round_.insert(next_round_.end(), needs.begin(), needs.end());
  }

  void use(Choice solution) {
    in_solution_.assign(universe_.candidates.size(), false);
    for (const CandidateId id : solution) in_solution_[id] = true;
  }

  const Universe& universe_;
  SatEngine& engine_;
  UniverseLinks links_;
  Propagation settled_;            ///< what follows from taken_
  std::vector<bool> in_solution_;  ///< by candidate: of a solution that has all of taken_
  Choice taken_;
  std::vector<bool> is_taken_;  ///< by candidate
  std::vector<RequirementId> next_round_;
};

}  // namespace

std::variant<Choice, Proof> best_choice(const Universe& universe) {
  SatEngine engine(universe);
  auto answer = engine.solve({});
  if (auto* solution = std::get_if<Choice>(&answer))
    return Walk(universe, engine, std::move(*solution)).choice();
  return answer;
}

}  // namespace ros2wasm
