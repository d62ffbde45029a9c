// See universe.hpp.
#include "bundler/resolve/universe.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "bundler/resolve/virtual_packages.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

using RecordList = std::vector<const PackageRecord*>;

/// Puts the records of an index into the order of preference.
class Builder {
 public:
  Builder(const ResolveRequest& request, const RepoIndex& index) : request_(request) {
    for (std::size_t i = 0; i < index.channels.size(); ++i)
      channel_rank_.emplace(index.channels[i], i);
    for (const PackageRecord& record : index.records) records_[record.name].push_back(&record);
    for (const PackageRecord& locked : request.locked) locked_.emplace(locked.url, locked.sha256);
    universe_.virtual_records = virtual_packages();
    universe_.virtual_records.insert(universe_.virtual_records.end(), index.built_here.begin(),
                                     index.built_here.end());
    for (const PackageRecord& record : universe_.virtual_records) records_[record.name] = {&record};
  }

  Universe build(const std::vector<MatchSpec>& specs) {
    if (request_.priority == ChannelPriority::kStrict) hide_lower_channels(specs);
    for (const MatchSpec& spec : specs)
      universe_.wanted.push_back(universe_.add_requirement(spec.text(), spec));
    for (const auto& [name, list] : records_) add_candidates(name, list);
    return std::move(universe_);
  }

 private:
  /// A request that names the channel of a package goes before the order of channels.
  void hide_lower_channels(const std::vector<MatchSpec>& specs) {
    for (auto& [name, list] : records_) {
      const auto is_named = [&, &name = name](const PackageRecord& record) {
        return std::all_of(specs.begin(), specs.end(), [&](const MatchSpec& spec) {
          return !spec.channel() || spec.exact_name() != name ||
                 spec.accepts_channel(record.channel);
        });
      };
      std::size_t best = channel_rank_.size();
      std::size_t best_named = channel_rank_.size();
      for (const PackageRecord* record : list) {
        best = std::min(best, rank_of(*record));
        if (is_named(*record)) best_named = std::min(best_named, rank_of(*record));
      }
      if (best_named < channel_rank_.size()) best = best_named;
      std::erase_if(list, [&](const PackageRecord* record) { return rank_of(*record) != best; });
    }
  }

  [[nodiscard]] std::size_t rank_of(const PackageRecord& record) const {
    const auto found = channel_rank_.find(record.channel);
    return found == channel_rank_.end() ? channel_rank_.size() : found->second;
  }

  const Version* version_of(const PackageRecord& record) {
    const auto known = universe_.versions.find(record.version);
    if (known != universe_.versions.end()) return &known->second;
    auto version = Version::parse(record.version);
    if (!version) return nullptr;
    return &universe_.versions.emplace(record.version, std::move(*version)).first->second;
  }

  /// Those of one name, the best first.
  void add_candidates(const std::string& name, const RecordList& list) {
    auto& all = universe_.candidates;
    const std::size_t first = all.size();
    for (const PackageRecord* record : list) {
      if (const Version* version = version_of(*record))
        all.push_back({.record = record, .version = version});
    }
    std::sort(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(),
              [this](const Candidate& a, const Candidate& b) { return better(a, b); });
    if (all.size() == first) return;
    auto& ids = universe_.by_name[name];
    for (CandidateId id = first; id < all.size(); ++id) ids.push_back(id);
  }

  [[nodiscard]] bool is_locked(const PackageRecord& record) const {
    const auto found = locked_.find(record.url);
    return found != locked_.end() && found->second == record.sha256;
  }

  /// The order of preference within a name. Total: two records never compare equal unless they are
  /// the same file.
  [[nodiscard]] bool better(const Candidate& a, const Candidate& b) const {
    const PackageRecord& left = *a.record;
    const PackageRecord& right = *b.record;
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

  const ResolveRequest& request_;
  Universe universe_;
  std::map<std::string, RecordList, std::less<>> records_;
  std::unordered_map<std::string, std::size_t> channel_rank_;
  std::unordered_map<std::string, std::string> locked_;  ///< url -> sha256
};

}  // namespace

Universe make_universe(const ResolveRequest& request, const std::vector<MatchSpec>& specs,
                       const RepoIndex& index) {
  return Builder(request, index).build(specs);
}

RequirementId Universe::add_requirement(const std::string& text, const MatchSpec& spec) const {
  const auto [found, fresh] = requirement_ids_.emplace(text, requirements_.size());
  if (fresh) requirements_.push_back({.text = text, .spec = spec, .name = spec.exact_name()});
  return found->second;
}

const Matches& Universe::matches(RequirementId id) const {
  if (matches_.size() <= id) matches_.resize(requirements_.size());
  std::optional<Matches>& known = matches_[id];
  if (known) return *known;
  const Requirement& one = requirements_[id];
  Matches& found = known.emplace();
  const auto sort_into = [&](const std::vector<CandidateId>& ids) {
    for (const CandidateId candidate : ids) {
      const bool fits =
          one.spec.matches(*candidates[candidate].record, *candidates[candidate].version);
      (fits ? found.providers : found.rivals).push_back(candidate);
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

const Needs& Universe::needs(CandidateId id) const {
  if (needs_.empty()) needs_.resize(candidates.size());
  std::optional<Needs>& known = needs_[id];
  if (known) return *known;
  Needs& needs = known.emplace();
  const auto read = [&](const std::vector<std::string>& texts, std::vector<RequirementId>& ids) {
    for (const std::string& text : texts) {
      if (const auto met = requirement_ids_.find(text); met != requirement_ids_.end()) {
        ids.push_back(met->second);
        continue;
      }
      const auto spec = MatchSpec::parse(text);
      if (spec) {
        ids.push_back(add_requirement(text, *spec));
      } else if (needs.fault.empty()) {
        needs.fault = spec.errors().front().message;
      }
    }
  };
  read(candidates[id].record->depends, needs.depends);
  read(candidates[id].record->constrains, needs.constrains);
  return needs;
}

void Universe::meet_all() const {
  for (CandidateId id = 0; id < candidates.size(); ++id) static_cast<void>(needs(id));
}

std::vector<LeftOutRecord> Universe::unusable() const {
  std::vector<LeftOutRecord> left_out;
  for (CandidateId id = 0; id < needs_.size(); ++id) {
    if (!needs_[id] || needs_[id]->fault.empty()) continue;
    const PackageRecord& record = *candidates[id].record;
    left_out.push_back({.channel = record.channel,
                        .subdir = record.subdir,
                        .file_name = record.file_name,
                        .reason = needs_[id]->fault});
  }
  return left_out;
}

std::vector<std::string> names_there(const Universe& universe, const RepoIndex& index) {
  std::vector<std::string> names = index.names ? index.names() : std::vector<std::string>();
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
