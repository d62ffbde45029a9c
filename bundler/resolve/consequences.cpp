// See consequences.hpp.
#include "bundler/resolve/consequences.hpp"

#include <algorithm>
#include <limits>

#include "bundler/resolve/virtual_packages.hpp"

namespace ros2wasm {
namespace {

constexpr CandidateId kNobody = std::numeric_limits<CandidateId>::max();
constexpr CandidateId kRequest = kNobody - 1;  ///< owner of what is wanted

}  // namespace

Consequences::Consequences(const Universe& universe)
    : universe_(universe),
      group_(universe.candidates.size()),
      states_(universe.candidates.size()),
      holder_(universe.by_name.size(), kNobody),
      watched_(universe.by_name.size()),
      dead_ends_at_(universe.by_name.size()),
      blamed_(universe.candidates.size(), false) {
  Group group = 0;
  for (const auto& [name, ids] : universe.by_name) {
    for (const CandidateId id : ids) group_[id] = group;
    ++group;
  }
}

bool Consequences::begin() {
  for (CandidateId id = 0; id < states_.size(); ++id) {
    if (is_virtual(*universe_.candidates[id].record)) waiting_.push_back({.candidate = id});
  }
  return std::all_of(universe_.wanted.begin(), universe_.wanted.end(),
                     [this](RequirementId wanted) { return require(wanted, kRequest); }) &&
         settle();
}

bool Consequences::choose(CandidateId candidate) {
  decisions_.push_back(steps_.size());
  waiting_.push_back({.candidate = candidate});
  return settle();
}

bool Consequences::settle() {
  while (!propagate()) {
    if (depth() == 0) return false;
    waiting_.clear();
    changed_.clear();
    learn();
  }
  return true;
}

/// False: `contradiction_` says what cannot be.
bool Consequences::propagate() {
  while (!waiting_.empty() || !changed_.empty()) {
    if (!waiting_.empty()) {
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      if (!take_up(next.candidate, next.reason)) return false;
      continue;
    }
    const Group group = changed_.back();
    changed_.pop_back();
    for (const RequirementId requirement : watched_[group]) {
      if (!serve(requirement)) return false;
    }
    for (const std::size_t dead_end : dead_ends_at_[group]) {
      if (!avoid(dead_end)) return false;
    }
  }
  return true;
}

bool Consequences::is_open(CandidateId id) const {
  return !states_[id].banned && holder_[group_[id]] == kNobody;
}

bool Consequences::take_up(CandidateId candidate, Reason reason) {
  if (is_chosen(candidate)) return true;
  if (!is_open(candidate)) return contradict(candidate, reason);
  states_[candidate] = {.chosen = true, .depth = depth(), .reason = reason};
  holder_[group_[candidate]] = candidate;
  steps_.push_back({.kind = Step::Kind::kChosen, .id = candidate});
  changed_.push_back(group_[candidate]);
  const Needs& needs = universe_.needs(candidate);
  if (!needs.fault.empty()) {
    contradiction_ = {candidate};
    return false;
  }
  const auto bans_rivals = [&](RequirementId limit) {
    const auto& rivals = universe_.matches(limit).rivals;
    return std::all_of(rivals.begin(), rivals.end(), [&](CandidateId rival) {
      return rival == candidate ||  // nobody is in its own way
             ban(rival, {.kind = Reason::Kind::kCandidate, .id = candidate});
    });
  };
  return std::all_of(needs.depends.begin(), needs.depends.end(),
                     [&](RequirementId need) { return require(need, candidate); }) &&
         std::all_of(needs.constrains.begin(), needs.constrains.end(), bans_rivals);
}

bool Consequences::require(RequirementId requirement, CandidateId owner) {
  if (owner_.size() <= requirement) owner_.resize(requirement + 1, kNobody);
  if (owner_[requirement] != kNobody) return true;
  owner_[requirement] = owner;
  steps_.push_back({.kind = Step::Kind::kRequired, .id = requirement});
  for (const Group group : groups_of(requirement)) watched_[group].push_back(requirement);
  if (universe_.requirement(requirement).name) {  // one record per name: the others are out
    const Reason reason =
        owner == kRequest ? Reason{} : Reason{.kind = Reason::Kind::kCandidate, .id = owner};
    for (const CandidateId rival : universe_.matches(requirement).rivals) {
      if (!ban(rival, reason)) return false;
    }
  }
  return serve(requirement);
}

bool Consequences::ban(CandidateId candidate, Reason reason) {
  if (is_chosen(candidate)) return contradict(candidate, reason);
  if (!is_open(candidate)) return true;
  states_[candidate] = {.banned = true, .depth = depth(), .reason = reason};
  steps_.push_back({.kind = Step::Kind::kBanned, .id = candidate});
  if (changed_.empty() || changed_.back() != group_[candidate])
    changed_.push_back(group_[candidate]);
  return true;
}

/// Is something left that serves it? If only one is, that must be there.
bool Consequences::serve(RequirementId requirement) {
  std::size_t open = 0;
  CandidateId last = kNobody;
  for (const CandidateId id : universe_.matches(requirement).providers) {
    if (is_chosen(id)) return true;
    if (!is_open(id)) continue;
    last = id;
    if (++open == 2) return true;
  }
  const Reason reason{.kind = Reason::Kind::kRequirement, .id = requirement};
  if (open == 0) return contradict(kNobody, reason);
  waiting_.push_back({.candidate = last, .reason = reason});
  return true;
}

/// If all but one of its facts hold, that one must not.
bool Consequences::avoid(std::size_t dead_end) {
  const Fact* open = nullptr;
  for (const Fact& fact : dead_ends_[dead_end]) {
    if (is_open(fact.candidate)) {
      if (open != nullptr) return true;
      open = &fact;
    } else if (is_chosen(fact.candidate) != fact.chosen) {
      return true;
    }
  }
  const Reason reason{.kind = Reason::Kind::kDeadEnd, .id = dead_end};
  if (open == nullptr) return contradict(kNobody, reason);
  if (open->chosen) return ban(open->candidate, reason);
  waiting_.push_back({.candidate = open->candidate, .reason = reason});
  return true;
}

/// The candidate must change because of the reason, but cannot; kNobody: nothing can serve.
bool Consequences::contradict(CandidateId candidate, Reason reason) {
  contradiction_ = causes(candidate, reason);
  if (candidate != kNobody) contradiction_.push_back(candidate);
  return false;
}

/// Those which, as they are, leave the candidate no other way.
std::vector<CandidateId> Consequences::causes(CandidateId candidate, Reason reason) const {
  std::vector<CandidateId> found;
  switch (reason.kind) {
    case Reason::Kind::kNone:
      break;
    case Reason::Kind::kCandidate:
      found.push_back(reason.id);
      break;
    case Reason::Kind::kRequirement:
      if (owner_[reason.id] != kRequest) found.push_back(owner_[reason.id]);
      for (const CandidateId id : universe_.matches(reason.id).providers) {
        if (id != candidate) found.push_back(id);
      }
      break;
    case Reason::Kind::kDeadEnd:
      for (const Fact& fact : dead_ends_[reason.id]) {
        if (fact.candidate != candidate) found.push_back(fact.candidate);
      }
      break;
  }
  return found;
}

/// Puts the blame where it belongs: on the chosen one that ruled the candidate out, if that alone
/// did. What holds from the beginning has none.
void Consequences::blame(CandidateId candidate, DeadEnd& facts, std::size_t& latest) {
  const State& state = states_[candidate];
  if (state.banned && state.reason.kind == Reason::Kind::kCandidate) {
    candidate = state.reason.id;
  } else if (!state.banned && !state.chosen) {
    candidate = holder_[group_[candidate]];
  }
  const State& blamed = states_[candidate];
  if (blamed.depth == 0 || blamed_[candidate]) return;
  blamed_[candidate] = true;
  if (blamed.depth == depth()) {
    ++latest;
  } else {
    facts.push_back({.candidate = candidate, .chosen = blamed.chosen});
  }
}

/// Goes back from the contradiction to the one step since the last decision through which all ways
/// into it lead (the first unique implication point). That and earlier facts are the dead end.
void Consequences::learn() {
  DeadEnd facts;
  std::size_t latest = 0;  // blamed since the last decision, not yet replaced by their causes
  for (const CandidateId id : contradiction_) blame(id, facts, latest);
  std::size_t step = steps_.size();
  CandidateId turn = kNobody;
  while (latest > 0) {
    const Step& last = steps_[--step];
    if (last.kind == Step::Kind::kRequired || !blamed_[last.id]) continue;
    turn = last.id;
    blamed_[turn] = false;
    if (--latest == 0) break;
    for (const CandidateId id : causes(turn, states_[turn].reason)) blame(id, facts, latest);
  }
  std::size_t back_to = 0;
  for (const Fact& fact : facts) {
    blamed_[fact.candidate] = false;
    back_to = std::max(back_to, states_[fact.candidate].depth);
  }
  facts.push_back({.candidate = turn, .chosen = states_[turn].chosen});
  take_back(back_to);
  for (const Fact& fact : facts) dead_ends_at_[group_[fact.candidate]].push_back(dead_ends_.size());
  dead_ends_.push_back(std::move(facts));
  changed_.push_back(group_[turn]);
}

std::vector<Consequences::Group> Consequences::groups_of(RequirementId requirement) const {
  std::vector<Group> groups;
  const auto& providers = universe_.matches(requirement).providers;
  if (!providers.empty() && universe_.requirement(requirement).name)
    return {group_[providers.front()]};
  for (const CandidateId id : providers) {
    if (groups.empty() || groups.back() != group_[id]) groups.push_back(group_[id]);
  }
  return groups;
}

void Consequences::take_back(std::size_t depth) {
  const std::size_t from = decisions_[depth];
  decisions_.resize(depth);
  while (steps_.size() > from) {
    const Step step = steps_.back();
    steps_.pop_back();
    switch (step.kind) {
      case Step::Kind::kChosen:
        states_[step.id] = {};
        holder_[group_[step.id]] = kNobody;
        break;
      case Step::Kind::kBanned:
        states_[step.id] = {};
        break;
      case Step::Kind::kRequired:
        owner_[step.id] = kNobody;
        for (const Group group : groups_of(step.id)) watched_[group].pop_back();
        break;
    }
  }
}

}  // namespace ros2wasm
