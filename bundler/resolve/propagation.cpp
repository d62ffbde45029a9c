// See propagation.hpp.
#include "bundler/resolve/propagation.hpp"

#include <algorithm>

namespace ros2wasm {

UniverseLinks::UniverseLinks(const Universe& universe)
    : provides(universe.candidates.size()),
      rival_of(universe.candidates.size()),
      dependents(universe.requirements.size()),
      constrainers(universe.requirements.size()) {
  for (RequirementId id = 0; id < universe.requirements.size(); ++id) {
    for (const CandidateId candidate : universe.requirements[id].providers)
      provides[candidate].push_back(id);
    for (const CandidateId candidate : universe.requirements[id].rivals)
      rival_of[candidate].push_back(id);
  }
  for (CandidateId id = 0; id < universe.candidates.size(); ++id) {
    for (const RequirementId need : universe.candidates[id].depends) dependents[need].push_back(id);
    for (const RequirementId ban : universe.candidates[id].constrains)
      constrainers[ban].push_back(id);
  }
}

Propagation::Propagation(const Universe& universe, const UniverseLinks& links)
    : universe_(&universe),
      links_(&links),
      state_(universe.candidates.size(), kOpen),
      required_(universe.requirements.size(), false) {
  left_.reserve(universe.requirements.size());
  for (const Requirement& one : universe.requirements)
    left_.push_back(static_cast<std::uint32_t>(one.providers.size()));
  for (RequirementId id = 0; id < left_.size(); ++id) {
    if (left_[id] != 0) continue;
    for (const CandidateId hopeless : links.dependents[id])
      static_cast<void>(set(hopeless, kBanned));
  }
  static_cast<void>(settle());  // nothing is chosen yet, so nothing can contradict it
}

bool Propagation::choose(CandidateId candidate) {
  return set(candidate, kChosen) && settle();
}

bool Propagation::set(CandidateId candidate, State state) {
  if (state_[candidate] == state) return true;
  if (state_[candidate] != kOpen) return false;
  state_[candidate] = state;
  waiting_.push_back(candidate);
  return true;
}

bool Propagation::settle() {
  while (!waiting_.empty()) {
    const CandidateId candidate = waiting_.back();
    waiting_.pop_back();
    if (!(state_[candidate] == kChosen ? take_up(candidate) : give_up(candidate))) return false;
  }
  return true;
}

bool Propagation::take_up(CandidateId candidate) {
  const Candidate& taken = universe_->candidates[candidate];
  if (!ban_others(candidate)) return false;
  for (const RequirementId need : taken.depends) {
    if (!require(need)) return false;
  }
  for (const RequirementId ban : taken.constrains) {
    for (const CandidateId rival : universe_->requirements[ban].rivals) {
      if (!set(rival, kBanned)) return false;
    }
  }
  for (const RequirementId ban : links_->rival_of[candidate]) {
    for (const CandidateId constrainer : links_->constrainers[ban]) {
      if (!set(constrainer, kBanned)) return false;
    }
  }
  return true;
}

/// One record per name.
bool Propagation::ban_others(CandidateId candidate) {
  const auto& same_name =
      universe_->by_name.find(universe_->candidates[candidate].record->name)->second;
  return std::all_of(same_name.begin(), same_name.end(),
                     [&](CandidateId other) { return other == candidate || set(other, kBanned); });
}

bool Propagation::give_up(CandidateId candidate) {
  for (const RequirementId id : links_->provides[candidate]) {
    if (--left_[id] == 0) {
      for (const CandidateId hopeless : links_->dependents[id]) {
        if (!set(hopeless, kBanned)) return false;
      }
    }
    if (required_[id] && left_[id] < 2 && !require(id)) return false;
  }
  return true;
}

bool Propagation::require(RequirementId requirement) {
  const Requirement& one = universe_->requirements[requirement];
  if (left_[requirement] == 0) return false;
  if (!required_[requirement]) {
    required_[requirement] = true;
    if (one.spec.exact_name()) {  // whoever else has that name cannot be there as well
      for (const CandidateId rival : one.rivals) {
        if (!set(rival, kBanned)) return false;
      }
    }
  }
  if (left_[requirement] > 1) return true;
  const auto last = std::find_if(one.providers.begin(), one.providers.end(),
                                 [this](CandidateId id) { return !banned(id); });
  // A ban that waits is not counted yet; what follows from it comes when its turn does.
  return last == one.providers.end() ? false : set(*last, kChosen);
}

}  // namespace ros2wasm
