// See universe.hpp.
#include "bundler/resolve/universe.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <tuple>
#include <unordered_map>

#include "bundler/resolve/virtual_packages.hpp"
#include "workspace_schema/suggestion.hpp"

namespace ros2wasm {
namespace {

using RecordList = std::vector<const PackageRecord*>;

/// Builds a Universe name by name, from the wanted ones outwards.
class Builder {
 public:
  Builder(const ResolveRequest& request, const RepoIndex& index) : request_(request) {
    for (std::size_t i = 0; i < index.channels.size(); ++i)
      channel_rank_.emplace(index.channels[i], i);
    for (const PackageRecord& record : index.records) records_[record.name].push_back(&record);
    if (request.priority == ChannelPriority::kStrict) hide_lower_channels();
    for (const PackageRecord& locked : request.locked) locked_.emplace(locked.url, locked.sha256);
    universe_.virtual_records = virtual_packages();
    for (const PackageRecord& record : universe_.virtual_records) records_[record.name] = {&record};
  }

  Universe build(const std::vector<MatchSpec>& specs) {
    for (std::size_t i = 0; i < specs.size(); ++i) {
      universe_.wanted.push_back(requirement(specs[i].text(), specs[i]));
    }
    for (const PackageRecord& record : universe_.virtual_records) reach(record.name);
    while (!waiting_.empty()) {
      const std::string name = std::move(waiting_.front());
      waiting_.pop_front();
      add_candidates(name);
    }
    renumber();
    return std::move(universe_);
  }

 private:
  void hide_lower_channels() {
    for (auto& [name, list] : records_) {
      std::size_t best = channel_rank_.size();
      for (const PackageRecord* record : list) best = std::min(best, rank_of(*record));
      std::erase_if(list, [&](const PackageRecord* record) { return rank_of(*record) != best; });
    }
  }

  [[nodiscard]] std::size_t rank_of(const PackageRecord& record) const {
    const auto found = channel_rank_.find(record.channel);
    return found == channel_rank_.end() ? channel_rank_.size() : found->second;
  }

  void reach(const std::string& name) {
    if (reached_.insert(name).second) waiting_.push_back(name);
  }

  RequirementId requirement(const std::string& text, const MatchSpec& spec) {
    const auto [found, fresh] = requirement_ids_.emplace(text, universe_.requirements.size());
    if (!fresh) return found->second;
    universe_.requirements.push_back({.text = text, .spec = spec, .name = spec.exact_name()});
    if (const auto& name = universe_.requirements.back().name) {
      reach(*name);
    } else {
      for (const auto& [name_there, list] : records_) {
        if (spec.name().matches(name_there)) reach(name_there);
      }
    }
    return found->second;
  }

  /// A spec of a record; records with specs that do not parse never get into an index.
  RequirementId requirement(const std::string& text) {
    const auto known = requirement_ids_.find(text);
    if (known != requirement_ids_.end()) return known->second;
    const auto spec = MatchSpec::parse(text);
    return requirement(text, spec ? *spec : MatchSpec());
  }

  const Version* version_of(const PackageRecord& record) {
    const auto known = universe_.versions.find(record.version);
    if (known != universe_.versions.end()) return &known->second;
    auto version = Version::parse(record.version);
    if (!version) return nullptr;
    return &universe_.versions.emplace(record.version, std::move(*version)).first->second;
  }

  void add_candidates(const std::string& name) {
    const auto found = records_.find(name);
    if (found == records_.end()) return;
    for (const PackageRecord* record : found->second) {
      const Version* version = version_of(*record);
      if (version == nullptr) continue;
      Candidate candidate{.record = record, .version = version, .depends = {}, .constrains = {}};
      for (const std::string& text : record->depends)
        candidate.depends.push_back(requirement(text));
      for (const std::string& text : record->constrains)
        candidate.constrains.push_back(requirement(text));
      universe_.candidates.push_back(std::move(candidate));
    }
  }

  [[nodiscard]] bool is_locked(const PackageRecord& record) const {
    const auto found = locked_.find(record.url);
    return found != locked_.end() && found->second == record.sha256;
  }

  /// The order of preference. Total: two records never compare equal unless they are the same file.
  [[nodiscard]] bool better(const Candidate& a, const Candidate& b) const {
    const PackageRecord& left = *a.record;
    const PackageRecord& right = *b.record;
    if (left.name != right.name) return left.name < right.name;
    if (is_locked(left) != is_locked(right)) return is_locked(left);
    if (left.track_features.size() != right.track_features.size()) {
      return left.track_features.size() < right.track_features.size();
    }
    if (request_.priority == ChannelPriority::kFlexible && rank_of(left) != rank_of(right)) {
      return rank_of(left) < rank_of(right);
    }
    if (const auto order = *a.version <=> *b.version; a.version != b.version && order != 0)
      return order > 0;
    if (left.build_number != right.build_number) return left.build_number > right.build_number;
    if (left.timestamp_ms != right.timestamp_ms) return left.timestamp_ms > right.timestamp_ms;
    const auto last = [this](const PackageRecord& record) {
      return std::tuple<std::size_t, bool, const std::string&, const std::string&>(
          rank_of(record), record.subdir == "noarch", record.file_name, record.sha256);
    };
    return last(left) < last(right);
  }

  void renumber() {
    std::sort(universe_.candidates.begin(), universe_.candidates.end(),
              [this](const Candidate& a, const Candidate& b) { return better(a, b); });
    for (CandidateId id = 0; id < universe_.candidates.size(); ++id) {
      universe_.by_name[universe_.candidates[id].record->name].push_back(id);
    }
  }

  const ResolveRequest& request_;
  Universe universe_;
  std::map<std::string, RecordList, std::less<>> records_;
  std::unordered_map<std::string, std::size_t> channel_rank_;
  std::unordered_map<std::string, std::string> locked_;  ///< url -> sha256
  std::unordered_map<std::string, RequirementId> requirement_ids_;
  std::set<std::string> reached_;
  std::deque<std::string> waiting_;
};

}  // namespace

Universe make_universe(const ResolveRequest& request, const std::vector<MatchSpec>& specs,
                       const RepoIndex& index) {
  return Builder(request, index).build(specs);
}

const Matches& Universe::matches(RequirementId requirement) const {
  if (matches_.empty()) matches_.resize(requirements.size());
  std::optional<Matches>& known = matches_[requirement];
  if (known) return *known;
  const Requirement& one = requirements[requirement];
  Matches& found = known.emplace();
  const auto sort_into = [&](const std::vector<CandidateId>& ids) {
    for (const CandidateId id : ids) {
      const bool fits = one.spec.matches(*candidates[id].record, *candidates[id].version);
      (fits ? found.providers : found.rivals).push_back(id);
    }
  };
  if (one.name) {
    const auto same_name = by_name.find(*one.name);
    if (same_name != by_name.end()) sort_into(same_name->second);
    return found;
  }
  for (const auto& [name, ids] : by_name) {
    if (one.spec.name().matches(name)) sort_into(ids);
  }
  return found;
}

std::vector<std::string> names_there(const Universe& universe, const RepoIndex& index) {
  std::vector<std::string> names = index.names;
  for (const auto& [name, ids] : universe.by_name) {
    if (!is_virtual(*universe.candidates[ids.front()].record)) names.push_back(name);
  }
  for (const PackageRecord& record : index.records) names.push_back(record.name);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::string versions_there(const Universe& universe, std::string_view name) {
  const auto found = universe.by_name.find(name);
  if (found == universe.by_name.end()) return {};
  std::vector<CandidateId> ids = found->second;
  std::stable_sort(ids.begin(), ids.end(), [&](CandidateId a, CandidateId b) {
    return *universe.candidates[a].version > *universe.candidates[b].version;
  });
  std::vector<std::string> versions;
  for (const CandidateId id : ids) {
    const std::string& version = universe.candidates[id].record->version;
    if (std::find(versions.begin(), versions.end(), version) == versions.end())
      versions.push_back(version);
  }
  return name_list(versions, 4);
}

}  // namespace ros2wasm
