// See consequences.hpp.
#include "bundler/resolve/consequences.hpp"

#include <algorithm>

namespace ros2wasm {

Consequences::Consequences(const Universe& universe)
    : universe_(universe),
      chosen_(universe.candidates.size(), false),
      banned_(universe.candidates.size(), false) {
  group_.resize(universe.candidates.size());
  Group group = 0;
  for (const auto& [name, ids] : universe.by_name) {
    for (const CandidateId id : ids) group_[id] = group;
    ++group;
  }
  group_taken_.resize(group, false);
  watched_.resize(group);
}

bool Consequences::choose(CandidateId candidate) {
  const std::size_t before = steps_.size();
  if (settle(candidate)) return true;
  take_back(before);
  waiting_.clear();
  changed_.clear();
  return false;
}

bool Consequences::settle(CandidateId candidate) {
  waiting_.push_back(candidate);
  while (!waiting_.empty() || !changed_.empty()) {
    if (!waiting_.empty()) {
      const CandidateId next = waiting_.back();
      waiting_.pop_back();
      if (!take_up(next)) return false;
      continue;
    }
    const Group group = changed_.back();
    changed_.pop_back();
    for (const RequirementId requirement : watched_[group]) {
      if (!check(requirement)) return false;
    }
  }
  return true;
}

bool Consequences::is_open(CandidateId candidate) const {
  return !banned_[candidate] && !group_taken_[group_[candidate]];
}

bool Consequences::take_up(CandidateId candidate) {
  if (chosen_[candidate]) return true;
  if (!is_open(candidate)) return false;
  chosen_[candidate] = true;
  group_taken_[group_[candidate]] = true;
  steps_.push_back({.kind = Step::Kind::kChosen, .id = candidate});
  changed_.push_back(group_[candidate]);
  const Needs& needs = universe_.needs(candidate);
  if (!needs.fault.empty()) return false;
  for (const RequirementId need : needs.depends) {
    if (!require(need)) return false;
  }
  for (const RequirementId limit : needs.constrains) {
    for (const CandidateId rival : universe_.matches(limit).rivals) {
      if (!ban(rival)) return false;
    }
  }
  return true;
}

bool Consequences::require(RequirementId requirement) {
  if (!required_.insert(requirement).second) return true;
  steps_.push_back({.kind = Step::Kind::kRequired, .id = requirement});
  for (const Group group : groups_of(requirement)) watched_[group].push_back(requirement);
  if (universe_.requirement(requirement).name) {  // one record per name: the others are out
    for (const CandidateId rival : universe_.matches(requirement).rivals) {
      if (!ban(rival)) return false;
    }
  }
  return check(requirement);
}

bool Consequences::ban(CandidateId candidate) {
  if (banned_[candidate]) return true;
  if (chosen_[candidate]) return false;
  banned_[candidate] = true;
  steps_.push_back({.kind = Step::Kind::kBanned, .id = candidate});
  if (changed_.empty() || changed_.back() != group_[candidate])
    changed_.push_back(group_[candidate]);
  return true;
}

/// Is something left that serves it? If only one is, that must be there.
bool Consequences::check(RequirementId requirement) {
  std::size_t open = 0;
  CandidateId last = 0;
  for (const CandidateId id : universe_.matches(requirement).providers) {
    if (chosen_[id]) return true;
    if (!is_open(id)) continue;
    last = id;
    if (++open == 2) return true;
  }
  if (open == 1) waiting_.push_back(last);
  return open == 1;
}

std::vector<Consequences::Group> Consequences::groups_of(RequirementId requirement) const {
  std::vector<Group> groups;
  for (const CandidateId id : universe_.matches(requirement).providers) {
    if (groups.empty() || groups.back() != group_[id]) groups.push_back(group_[id]);
  }
  return groups;
}

void Consequences::take_back(std::size_t depth) {
  while (steps_.size() > depth) {
    const Step step = steps_.back();
    steps_.pop_back();
    switch (step.kind) {
      case Step::Kind::kChosen:
        chosen_[step.id] = false;
        group_taken_[group_[step.id]] = false;
        break;
      case Step::Kind::kBanned:
        banned_[step.id] = false;
        break;
      case Step::Kind::kRequired:
        required_.erase(step.id);
        for (const Group group : groups_of(step.id)) watched_[group].pop_back();
        break;
    }
  }
}

}  // namespace ros2wasm
