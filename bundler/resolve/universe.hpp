// The part of the channels that a request can reach, in the order of preference, with every
// dependency looked up. Pure. This is what the SAT engine gets, and what explanations are made
// from.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "bundler/channel/channel_index.hpp"
#include "bundler/resolve/solve.hpp"
#include "workspace_schema/conda/match_spec.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

using CandidateId = std::size_t;
using RequirementId = std::size_t;

/// A match spec as it is written somewhere, once per distinct text.
struct Requirement {
  std::string text;
  MatchSpec spec;
  std::optional<std::string> name;  ///< nothing when the spec has a pattern there
};

/// The candidates that a requirement concerns in this universe.
struct Matches {
  std::vector<CandidateId> providers;  ///< candidates that match, best first
  std::vector<CandidateId> rivals;     ///< of the same name, but not matching
};

/// The requirements of a candidate.
struct Needs {
  std::vector<RequirementId> depends;
  std::vector<RequirementId> constrains;
  std::string
      fault;  ///< why it cannot be used: a spec of its cannot be read; empty when all is well
};

struct Candidate {
  const PackageRecord* record = nullptr;  ///< owned by the index, the request or the universe
  const Version* version = nullptr;       ///< owned by the universe
};

/// Matches and needs are computed when they are first asked for: most requests need only a few of
/// them. The answers do not depend on the order of the questions.
class Universe {
 public:
  std::vector<PackageRecord> virtual_records;
  std::unordered_map<std::string_view, Version> versions;  ///< by text
  std::vector<Candidate> candidates;                       ///< by name, then best first
  std::map<std::string, std::vector<CandidateId>, std::less<>> by_name;
  std::vector<RequirementId> wanted;  ///< one per spec of the request, in its order

  /// The same id for the same text.
  RequirementId add_requirement(const std::string& text, const MatchSpec& spec) const;

  /// The number of requirements that were met so far; after meet_all(), of all requirements.
  [[nodiscard]] std::size_t requirement_count() const { return requirements_.size(); }
  [[nodiscard]] const Requirement& requirement(RequirementId id) const { return requirements_[id]; }
  [[nodiscard]] const Matches& matches(RequirementId id) const;
  [[nodiscard]] const Needs& needs(CandidateId id) const;
  void meet_all() const;
  /// Candidates that cannot be used, among those whose needs were asked for.
  [[nodiscard]] std::vector<LeftOutRecord> unusable() const;

 private:
  // Deques: what was given out stays where it is.
  mutable std::deque<Requirement> requirements_;
  mutable std::deque<std::optional<Matches>> matches_;
  mutable std::deque<std::optional<Needs>> needs_;
  mutable std::unordered_map<std::string, RequirementId> requirement_ids_;
};

/// The request's specs must parse (see solve()).
[[nodiscard]] Universe make_universe(const ResolveRequest& request,
                                     const std::vector<MatchSpec>& specs, const RepoIndex& index);

/// Names of all packages that the channels have, sorted; for messages.
[[nodiscard]] std::vector<std::string> names_there(const Universe& universe,
                                                   const RepoIndex& index);

/// "1.0, 1.1 (and 3 more)": versions of a name that are there, newest first; empty when there is
/// none.
[[nodiscard]] std::string versions_there(const Universe& universe, std::string_view name);

}  // namespace ros2wasm
