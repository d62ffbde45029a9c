// The consequences of choosing candidates one after the other: others that must be there, others
// that cannot be. A dead end takes decisions back and is remembered, so that the search does not
// reach it again in the same way (conflict-driven clause learning). Pure.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bundler/resolve/search_budget.hpp"
#include "bundler/resolve/universe.hpp"

namespace ros2wasm {

class Consequences {
 public:
  explicit Consequences(const Universe& universe, const SearchBudget& budget);

  /// Virtual packages are there, and what is wanted must be. False: nothing can fit, or gave_up().
  [[nodiscard]] bool begin();

  /// Decides for a candidate that is neither chosen nor ruled out, and draws what follows. Where
  /// that is a dead end, decisions are taken back, the latest first, until something else follows
  /// from what was learnt: depth() says how many still stand. False: nothing can fit, or gave_up().
  [[nodiscard]] bool choose(CandidateId candidate);

  /// The budget is spent: no answer is known.
  [[nodiscard]] bool gave_up() const { return gave_up_; }
  /// Names that were in the most dead ends, the worst first.
  [[nodiscard]] std::vector<std::string> in_the_way(std::size_t count) const;

  [[nodiscard]] std::size_t depth() const { return decisions_.size(); }
  [[nodiscard]] bool is_chosen(CandidateId id) const { return states_[id].chosen; }
  /// No solution has it together with the decisions that stand.
  [[nodiscard]] bool is_ruled_out(CandidateId id) const { return !is_open(id) && !is_chosen(id); }

 private:
  using Group = std::uint32_t;  ///< the candidates of one name

  /// Why a candidate is chosen or banned.
  struct Reason {
    enum class Kind : unsigned char {
      kNone,         ///< a decision, or given from the beginning
      kCandidate,    ///< `id` is chosen
      kRequirement,  ///< it alone is left to serve the requirement `id`
      kDeadEnd,      ///< everything else of the dead end `id` holds
    };
    Kind kind = Kind::kNone;
    std::size_t id = 0;
  };
  struct State {
    bool chosen = false;
    bool banned = false;    ///< for itself; the others of a chosen one's name are ruled out as well
    std::size_t depth = 0;  ///< how many decisions stood when it became so
    Reason reason;
  };
  struct Step {
    enum class Kind : unsigned char { kChosen, kBanned, kRequired };
    Kind kind = Kind::kChosen;
    std::size_t id = 0;
  };
  struct Fact {
    CandidateId candidate = 0;
    bool chosen = false;  ///< or else ruled out
  };
  using Facts = std::vector<Fact>;
  struct DeadEnd {
    Facts facts;               ///< cannot all hold; none: forgotten
    std::size_t last_use = 0;  ///< the number of the contradiction that it last had a part in
  };
  struct Waiting {
    CandidateId candidate = 0;
    Reason reason;
  };

  [[nodiscard]] bool is_open(CandidateId id) const;
  bool settle();
  bool propagate();
  bool take_up(CandidateId candidate, Reason reason);
  bool require(RequirementId requirement, CandidateId owner);
  bool ban(CandidateId candidate, Reason reason);
  bool serve(RequirementId requirement);
  bool avoid(std::size_t dead_end);
  bool contradict(CandidateId candidate, Reason reason);
  void learn();
  void forget();
  void blame(CandidateId candidate, Facts& facts, std::size_t& latest);
  [[nodiscard]] std::vector<CandidateId> causes(CandidateId candidate, Reason reason);
  [[nodiscard]] std::vector<Group> groups_of(RequirementId requirement) const;
  void take_back(std::size_t depth);

  const Universe& universe_;
  const SearchBudget& budget_;
  std::size_t contradictions_ = 0;
  std::size_t kept_ = 0;  ///< dead ends that are not forgotten
  std::size_t room_;      ///< for so many
  bool gave_up_ = false;
  std::vector<Group> group_;                         ///< by candidate
  std::vector<State> states_;                        ///< by candidate
  std::vector<CandidateId> holder_;                  ///< by group: the chosen one, or kNobody
  std::vector<CandidateId> owner_;                   ///< by requirement: a chosen one needs it
  std::vector<std::vector<RequirementId>> watched_;  ///< by group: needed ones that it can serve
  std::vector<DeadEnd> dead_ends_;
  std::vector<std::vector<std::size_t>> dead_ends_at_;  ///< by group
  std::vector<Step> steps_;                             ///< all that was done, to take it back
  std::vector<std::size_t> decisions_;                  ///< where in `steps_` each begins
  std::vector<Waiting> waiting_;                        ///< must be there, not yet taken up
  std::vector<Group> changed_;                          ///< something of it was chosen or banned
  std::vector<CandidateId> contradiction_;              ///< what cannot all be as it is
  std::vector<std::size_t> dead_ends_of_;               ///< by group: how often it was in one
  std::vector<bool> blamed_;                            ///< by candidate; only while learning
};

}  // namespace ros2wasm
