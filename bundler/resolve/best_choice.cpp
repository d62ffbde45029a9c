// See best_choice.hpp. Most requests need no search: taking the best candidate that nothing taken
// before contradicts leads to the end, and then there is nothing better. Where that gets stuck, the
// SAT engine says of each candidate whether a solution can have it.
#include "bundler/resolve/best_choice.hpp"

#include <algorithm>
#include <optional>

#include "bundler/resolve/consequences.hpp"
#include "bundler/resolve/virtual_packages.hpp"

namespace ros2wasm {
namespace {

/// One walk over the requirements, from the wanted ones outwards.
class Walk {
 public:
  explicit Walk(const Universe& universe)
      : universe_(universe), consequences_(universe), taken_(universe.candidates.size(), false) {}

  /// With an engine, and a solution of its to begin with, the walk cannot get stuck.
  Walk(const Universe& universe, SatEngine& engine, const Choice& solution) : Walk(universe) {
    engine_ = &engine;
    use(solution);
  }

  /// Nothing when it got stuck.
  std::optional<Choice> choice() {
    for (CandidateId id = 0; id < universe_.candidates.size(); ++id) {
      if (!is_virtual(*universe_.candidates[id].record)) continue;
      if (!consequences_.choose(id)) return std::nullopt;
      take(id);
    }
    std::vector<RequirementId> round = universe_.wanted;
    while (!round.empty()) {
      sort_by_text(round);
      next_round_.clear();
      for (const RequirementId requirement : round) {
        if (!serve(requirement)) return std::nullopt;
      }
      round = next_round_;
    }
    std::sort(choice_.begin(), choice_.end());
    return choice_;
  }

 private:
  void sort_by_text(std::vector<RequirementId>& round) const {
    std::sort(round.begin(), round.end(), [this](RequirementId a, RequirementId b) {
      return universe_.requirement(a).text < universe_.requirement(b).text;
    });
    round.erase(std::unique(round.begin(), round.end()), round.end());
  }

  /// Takes the best provider that is possible.
  bool serve(RequirementId requirement) {
    const auto& providers = universe_.matches(requirement).providers;
    if (std::any_of(providers.begin(), providers.end(),
                    [this](CandidateId id) { return taken_[id]; })) {
      return true;
    }
    const auto best = std::find_if(providers.begin(), providers.end(),
                                   [this](CandidateId id) { return is_possible(id); });
    if (best == providers.end()) return false;
    take(*best);
    return true;
  }

  /// As far as is known: with an engine that is certain. Afterwards its consequences are drawn.
  bool is_possible(CandidateId candidate) {
    if (engine_ == nullptr || in_solution_[candidate]) return consequences_.choose(candidate);
    const std::size_t before = consequences_.depth();
    if (!consequences_.choose(candidate)) return false;
    Choice fixed = choice_;
    fixed.push_back(candidate);
    const auto answer = engine_->solve(fixed);
    if (const auto* solution = std::get_if<Choice>(&answer)) {
      use(*solution);
      return true;
    }
    consequences_.take_back(before);
    return false;
  }

  void take(CandidateId candidate) {
    choice_.push_back(candidate);
    taken_[candidate] = true;
    const auto& needs = universe_.needs(candidate).depends;
    next_round_.insert(next_round_.end(), needs.begin(), needs.end());
  }

  void use(const Choice& solution) {
    in_solution_.assign(universe_.candidates.size(), false);
    for (const CandidateId id : solution) in_solution_[id] = true;
  }

  const Universe& universe_;
  SatEngine* engine_ = nullptr;
  Consequences consequences_;      ///< of all that was taken
  std::vector<bool> in_solution_;  ///< by candidate: of a solution that has all that was taken
  std::vector<bool> taken_;        ///< by candidate
  Choice choice_;                  ///< what was taken, in that order
  std::vector<RequirementId> next_round_;
};

}  // namespace

std::variant<Choice, Proof> best_choice(const Universe& universe) {
  if (auto choice = Walk(universe).choice()) return std::move(*choice);
  SatEngine engine(universe);
  auto answer = engine.solve({});
  if (auto* solution = std::get_if<Choice>(&answer)) {
    if (auto choice = Walk(universe, engine, *solution).choice()) return std::move(*choice);
  }
  return answer;
}

}  // namespace ros2wasm
