// What follows at once from choosing some candidates: others that must be there, others that cannot
// be. Cheap and incomplete: it finds most contradictions, never a false one. Pure.
#pragma once

#include <cstdint>
#include <vector>

#include "bundler/resolve/universe.hpp"

namespace ros2wasm {

/// Where candidates and requirements meet; made once per universe.
struct UniverseLinks {
  explicit UniverseLinks(const Universe& universe);

  std::vector<std::vector<RequirementId>> provides;    ///< by candidate
  std::vector<std::vector<RequirementId>> rival_of;    ///< by candidate: `constrains` that ban it
  std::vector<std::vector<CandidateId>> dependents;    ///< by requirement
  std::vector<std::vector<CandidateId>> constrainers;  ///< by requirement
};

class Propagation {
 public:
  Propagation(const Universe& universe, const UniverseLinks& links);

  /// False when that contradicts what was chosen before; then this object is of no more use.
  [[nodiscard]] bool choose(CandidateId candidate);

  [[nodiscard]] bool chosen(CandidateId candidate) const { return state_[candidate] == kChosen; }
  [[nodiscard]] bool banned(CandidateId candidate) const { return state_[candidate] == kBanned; }

 private:
  enum State : unsigned char { kOpen, kChosen, kBanned };

  bool set(CandidateId candidate, State state);
  bool settle();
  bool take_up(CandidateId candidate);
  bool give_up(CandidateId candidate);
  bool require(RequirementId requirement);
  bool ban_others(CandidateId candidate);

  const Universe* universe_;
  const UniverseLinks* links_;
  std::vector<State> state_;          ///< by candidate
  std::vector<std::uint32_t> left_;   ///< by requirement: providers that are not banned
  std::vector<bool> required_;        ///< by requirement: a chosen candidate depends on it
  std::vector<CandidateId> waiting_;  ///< set, but what follows is not yet looked at
};

}  // namespace ros2wasm
