// The SAT engine: which candidates are chosen, or the rules that cannot all hold. libsolv ends in
// sat_engine.cpp.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "bundler/resolve/universe.hpp"

namespace ros2wasm {

/// One rule of a proof that there is no solution.
struct ProofRule {
  enum class Kind {
    kWanted,    ///< `requirement` is asked for
    kRequires,  ///< `candidate` needs `requirement`
    kExcludes,  ///< `candidate` and `other` cannot both be there
  };
  Kind kind = Kind::kWanted;
  CandidateId candidate = 0;
  RequirementId requirement = 0;
  CandidateId other = 0;
};

/// Candidates that are chosen, in ascending order.
using Choice = std::vector<CandidateId>;
/// One list of rules per independent conflict.
using Proof = std::vector<std::vector<ProofRule>>;

/// Says whether there is a solution, and gives one; which of many is best_choice()'s business.
class SatEngine {
 public:
  explicit SatEngine(const Universe& universe);
  ~SatEngine();
  SatEngine(const SatEngine&) = delete;
  SatEngine& operator=(const SatEngine&) = delete;

  /// A solution of all that is wanted in which all of `fixed` are chosen.
  [[nodiscard]] std::variant<Choice, Proof> solve(std::span<const CandidateId> fixed);

 private:
  class SolvPool;
  std::unique_ptr<SolvPool> pool_;
};

}  // namespace ros2wasm
