// See best_choice.hpp. One walk over the requirements, from the wanted ones outwards, that always
// decides for the best candidate which is not ruled out. What a dead end teaches holds before the
// decisions that it takes back; so in the end each decision was for the best that any solution has
// there.
#include "bundler/resolve/best_choice.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

#include "bundler/resolve/consequences.hpp"
#include "bundler/resolve/virtual_packages.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kMostNames = 5;  // of packages, in a message

class Walk {
 public:
  Walk(const Universe& universe, const SearchBudget& budget)
      : universe_(universe),
        consequences_(universe, budget),
        taken_(universe.candidates.size(), false) {}

  /// Nothing when there is no solution, or none was found before the search was given up.
  std::optional<Choice> choice() {
    if (!consequences_.begin()) return std::nullopt;
    for (CandidateId id = 0; id < universe_.candidates.size(); ++id) {
      if (is_virtual(*universe_.candidates[id].record)) take(id);
    }
    begin_round(universe_.wanted);
    while (!rounds_.back().requirements.empty()) {
      Round& round = rounds_.back();
      if (round.served == round.requirements.size()) {
        begin_round(round.next);
      } else if (!serve(round.requirements[round.served])) {
        return std::nullopt;
      }
    }
    std::sort(choice_.begin(), choice_.end());
    return choice_;
  }

  [[nodiscard]] const Consequences& consequences() const { return consequences_; }

 private:
  struct Round {
    std::vector<RequirementId> requirements;  ///< sorted by text
    std::size_t served = 0;
    std::vector<RequirementId> next;  ///< of those that were taken in this round
  };
  /// How far the walk was.
  struct Place {
    std::size_t rounds = 0;
    std::size_t served = 0;  ///< in the last round
    std::size_t next = 0;    ///< in the last round
    std::size_t taken = 0;
  };

  /// Something that was taken serves it.
  [[nodiscard]] bool is_served(RequirementId requirement) const {
    const auto& providers = universe_.matches(requirement).providers;
    return std::any_of(providers.begin(), providers.end(),
                       [this](CandidateId id) { return taken_[id]; });
  }

  void begin_round(std::vector<RequirementId> requirements) {
    std::sort(requirements.begin(), requirements.end());
    requirements.erase(std::unique(requirements.begin(), requirements.end()), requirements.end());
    // Packages that earlier rounds took stay during this round, so requirements that they serve are
    // met.
    std::erase_if(requirements, [this](RequirementId one) { return is_served(one); });
    std::sort(requirements.begin(), requirements.end(), [this](RequirementId a, RequirementId b) {
      return universe_.requirement(a).text < universe_.requirement(b).text;
    });
    rounds_.push_back({.requirements = std::move(requirements)});
  }

  /// Takes the best provider that is not ruled out, or goes back to where that was a dead end.
  /// False: there is no solution.
  bool serve(RequirementId requirement) {
    if (!is_served(requirement)) {
      const auto& providers = universe_.matches(requirement).providers;
      const auto best = std::find_if(providers.begin(), providers.end(), [this](CandidateId id) {
        return !consequences_.is_ruled_out(id);
      });
      assert(best != providers.end());  // else it would have been a dead end
      if (!consequences_.is_chosen(*best)) {
        decisions_.push_back(here());
        if (!consequences_.choose(*best)) return false;
        if (consequences_.depth() < decisions_.size()) {
          go_back(decisions_[consequences_.depth()]);
          decisions_.resize(consequences_.depth());
          return true;
        }
      }
      take(*best);
    }
    ++rounds_.back().served;
    return true;
  }

  void take(CandidateId candidate) {
    choice_.push_back(candidate);
    taken_[candidate] = true;
    if (rounds_.empty()) return;  // virtual packages need nothing
    const auto& needs = universe_.needs(candidate).depends;
    auto& next = rounds_.back().next;
    next.insert(next.end(), needs.begin(), needs.end());
  }

  [[nodiscard]] Place here() const {
    const Round& round = rounds_.back();
    return {.rounds = rounds_.size(),
            .served = round.served,
            .next = round.next.size(),
            .taken = choice_.size()};
  }

  void go_back(const Place& place) {
    rounds_.resize(place.rounds);
    rounds_.back().served = place.served;
    rounds_.back().next.resize(place.next);
    for (std::size_t i = place.taken; i < choice_.size(); ++i) taken_[choice_[i]] = false;
    choice_.resize(place.taken);
  }

  const Universe& universe_;
  Consequences consequences_;     ///< of all that was taken
  std::vector<Place> decisions_;  ///< where the walk was before each
  std::vector<Round> rounds_;
  std::vector<bool> taken_;  ///< by candidate
  Choice choice_;            ///< what was taken, in that order
};

}  // namespace

Outcome<std::optional<Choice>> best_choice(const Universe& universe, const SearchBudget& budget) {
  if (budget.cancellation.requested()) return interrupted();
  Walk walk(universe, budget);
  auto choice = walk.choice();
  if (!walk.consequences().gave_up()) return choice;
  if (budget.cancellation.requested()) return interrupted();
  const std::string names = name_list(walk.consequences().in_the_way(kMostNames));
  return Diagnostic{
      .code = "R2W0305",
      .message = "the search for packages was given up",
      .why = {"after " + std::to_string(budget.most_contradictions) +
                  " dead ends there is neither a choice nor a proof that there is none",
              "most often in the way were " + names},
      .fix = {"say under `dependencies:` which versions of these you want: the fewer are left, "
              "the shorter the search"}};
}

}  // namespace ros2wasm
