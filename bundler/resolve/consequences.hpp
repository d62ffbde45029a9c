// What follows at once from choosing some candidates: others that must be there, others that cannot
// be. Cheap and incomplete: it finds most contradictions, never a false one. Pure.
#pragma once

#include <cstdint>
#include <unordered_set>
#include <vector>

#include "bundler/resolve/universe.hpp"

namespace ros2wasm {

class Consequences {
 public:
  explicit Consequences(const Universe& universe);

  /// False when that contradicts what was chosen before; then nothing has changed.
  [[nodiscard]] bool choose(CandidateId candidate);

  /// take_back(depth()) later brings back what is known now.
  [[nodiscard]] std::size_t depth() const { return steps_.size(); }
  void take_back(std::size_t depth);

 private:
  using Group = std::uint32_t;  ///< the candidates of one name
  struct Step {
    enum class Kind : unsigned char { kChosen, kBanned, kRequired };
    Kind kind = Kind::kChosen;
    std::size_t id = 0;
  };

  bool settle(CandidateId candidate);
  bool take_up(CandidateId candidate);
  bool require(RequirementId requirement);
  bool ban(CandidateId candidate);
  bool check(RequirementId requirement);
  [[nodiscard]] bool is_open(CandidateId candidate) const;
  [[nodiscard]] std::vector<Group> groups_of(RequirementId requirement) const;

  const Universe& universe_;
  std::vector<Group> group_;                         ///< by candidate
  std::vector<bool> chosen_;                         ///< by candidate
  std::vector<bool> banned_;                         ///< by candidate
  std::unordered_set<RequirementId> required_;       ///< a chosen candidate depends on them
  std::vector<bool> group_taken_;                    ///< by group: one of it is chosen
  std::vector<std::vector<RequirementId>> watched_;  ///< by group: required ones it can serve
  std::vector<Step> steps_;                          ///< all that was done, to take it back
  std::vector<CandidateId> waiting_;                 ///< must be there, not yet taken up
  std::vector<Group> changed_;                       ///< something of it was chosen or banned
};

}  // namespace ros2wasm
