// The proof that nothing fits: the rules that cannot all hold. libsolv ends in sat_engine.cpp.
#pragma once

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

/// One list of rules per independent conflict.
using Proof = std::vector<std::vector<ProofRule>>;

/// The rules that contradict each other when nothing fits; empty when something does.
[[nodiscard]] Proof why_impossible(const Universe& universe);

}  // namespace ros2wasm
