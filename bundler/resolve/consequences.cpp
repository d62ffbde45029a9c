// See consequences.hpp.
#include "bundler/resolve/consequences.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "bundler/resolve/virtual_packages.hpp"

namespace ros2wasm {
namespace {

constexpr CandidateId kNobody = std::numeric_limits<CandidateId>::max();
constexpr CandidateId kRequest = kNobody - 1;  ///< owner of what is wanted
constexpr std::size_t kAskEvery = 64;          ///< contradictions between two looks at the budget
constexpr std::size_t kFirstRoom = 1000;       ///< dead ends; the room grows, so the search ends
constexpr std::size_t kShort = 2;              ///< dead ends of so few facts are never forgotten

}  // namespace

Consequences::Consequences(const Universe& universe, const SearchBudget& budget)
    : universe_(universe),
      budget_(budget),
      room_(kFirstRoom),
      group_(universe.candidates.size()),
      states_(universe.candidates.size()),
      holder_(universe.by_name.size(), kNobody),
      watched_(universe.by_name.size()),
      dead_ends_at_(universe.by_name.size()),
      dead_ends_of_(universe.by_name.size(), 0),
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
    ++contradictions_;
    const bool asks = contradictions_ % kAskEvery == 0;
    gave_up_ =
        contradictions_ > budget_.most_contradictions || (asks && budget_.cancellation.requested());
    if (gave_up_) return false;
    learn();
    if (kept_ > room_) forget();
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
  for (const Fact& fact : dead_ends_[dead_end].facts) {
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
std::vector<CandidateId> Consequences::causes(CandidateId candidate, Reason reason) {
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
      dead_ends_[reason.id].last_use = contradictions_;
      for (const Fact& fact : dead_ends_[reason.id].facts) {
        if (fact.candidate != candidate) found.push_back(fact.candidate);
      }
      break;
  }
  return found;
}

/// Puts the blame where it belongs: on the chosen one that ruled the candidate out, if that alone
/// did. What holds from the beginning has none.
void Consequences::blame(CandidateId candidate, Facts& facts, std::size_t& latest) {
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
  Facts facts;
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
  for (const Fact& fact : facts) {
    dead_ends_at_[group_[fact.candidate]].push_back(dead_ends_.size());
    ++dead_ends_of_[group_[fact.candidate]];
  }
  dead_ends_.push_back({.facts = std::move(facts), .last_use = contradictions_});
  ++kept_;
  changed_.push_back(group_[turn]);
}

/// Half of the dead ends: those which were of no use for longest. What stands because of one keeps
/// it, and so does the latest, which has not been looked at.
void Consequences::forget() {
  std::vector<bool> needed(dead_ends_.size(), false);
  needed.back() = true;
  for (const Step& step : steps_) {
    if (step.kind == Step::Kind::kRequired) continue;
    const Reason& reason = states_[step.id].reason;
    if (reason.kind == Reason::Kind::kDeadEnd) needed[reason.id] = true;
  }
  std::vector<std::size_t> old;
  for (std::size_t i = 0; i < dead_ends_.size(); ++i) {
    if (!needed[i] && dead_ends_[i].facts.size() > kShort) old.push_back(i);
  }
  const auto half = old.begin() + static_cast<std::ptrdiff_t>(old.size() / 2);
  std::nth_element(old.begin(), half, old.end(), [this](std::size_t a, std::size_t b) {
    return std::pair(dead_ends_[a].last_use, a) < std::pair(dead_ends_[b].last_use, b);
  });
  std::for_each(old.begin(), half, [this](std::size_t i) { dead_ends_[i].facts = {}; });
  kept_ -= static_cast<std::size_t>(half - old.begin());
  for (std::vector<std::size_t>& of_group : dead_ends_at_)
    std::erase_if(of_group, [this](std::size_t i) { return dead_ends_[i].facts.empty(); });
  room_ += room_ / 10;
}

std::vector<std::string> Consequences::in_the_way(std::size_t count) const {
  std::vector<std::pair<std::size_t, std::string>> names;
  Group group = 0;
  for (const auto& [name, ids] : universe_.by_name) {
    if (dead_ends_of_[group] != 0) names.emplace_back(dead_ends_of_[group], name);
    ++group;
  }
  std::stable_sort(names.begin(), names.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> worst;
  for (std::size_t i = 0; i < std::min(count, names.size()); ++i) worst.push_back(names[i].second);
  return worst;
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
