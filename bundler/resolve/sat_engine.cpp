// See sat_engine.hpp. libsolv knows nothing of conda here: each distinct requirement is one Id,
// which every candidate that matches provides, and the place in the order of preference is the
// version.
#include "bundler/resolve/sat_engine.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <unordered_map>

#include "bundler/resolve/virtual_packages.hpp"

#define LIBSOLV_SOLVABLE_PREPEND_DEP 1  // its field `requires` is a word of C++20
extern "C" {
#include <solv/pool.h>
#include <solv/problems.h>
#include <solv/queue.h>
#include <solv/repo.h>
#include <solv/solver.h>
}

namespace ros2wasm {
namespace {

using PoolPointer = std::unique_ptr<Pool, decltype(&pool_free)>;
using SolverPointer = std::unique_ptr<Solver, decltype(&solver_free)>;

class IdQueue {
 public:
  IdQueue() { queue_init(&queue_); }
  ~IdQueue() { queue_free(&queue_); }
  IdQueue(const IdQueue&) = delete;
  IdQueue& operator=(const IdQueue&) = delete;
  Queue* get() { return &queue_; }
  [[nodiscard]] std::vector<Id> ids() const {
    return {queue_.elements, queue_.elements + queue_.count};
  }

 private:
  Queue queue_{};
};

/// A Universe as libsolv's pool, with the way back from its Ids.
class SolvPool {
 public:
  explicit SolvPool(const Universe& universe)
      : universe_(universe), pool_(pool_create(), pool_free) {
    universe.meet_all();
    Repo* repo = repo_create(pool_.get(), "channels");
    for (RequirementId id = 0; id < universe.requirement_count(); ++id) {
      needs_.push_back(text_id("n" + std::to_string(id)));
      bans_.push_back(text_id("b" + std::to_string(id)));
      requirement_of_.emplace(needs_.back(), id);
    }
    std::vector<std::vector<RequirementId>> provides(universe.candidates.size());
    std::vector<std::vector<RequirementId>> rivals(universe.candidates.size());
    for (RequirementId id = 0; id < universe.requirement_count(); ++id) {
      for (const CandidateId candidate : universe.matches(id).providers)
        provides[candidate].push_back(id);
      for (const CandidateId candidate : universe.matches(id).rivals)
        rivals[candidate].push_back(id);
    }
    for (CandidateId id = 0; id < universe.candidates.size(); ++id)
      add(repo, id, provides[id], rivals[id]);
    pool_createwhatprovides(pool_.get());
  }

  Proof proof() {
    IdQueue job;
    const auto install = [&job](Id need) {
      queue_push2(job.get(), SOLVER_INSTALL | SOLVER_SOLVABLE_PROVIDES, need);
    };
    for (const auto& [name, ids] : universe_.by_name) {
      if (is_virtual(*universe_.candidates[ids.front()].record))
        queue_push2(job.get(), SOLVER_INSTALL | SOLVER_SOLVABLE, solvables_[ids.front()]);
    }
    std::vector<RequirementId> wanted = universe_.wanted;
    // The order of the request must not matter.
    std::sort(wanted.begin(), wanted.end(), [this](RequirementId a, RequirementId b) {
      return universe_.requirement(a).text < universe_.requirement(b).text;
    });
    for (const RequirementId id : wanted) install(needs_[id]);
    const SolverPointer solver(solver_create(pool_.get()), solver_free);
    solver_set_flag(solver.get(), SOLVER_FLAG_IGNORE_RECOMMENDED, 1);
    if (solver_solve(solver.get(), job.get()) == 0) return {};
    return problems(solver.get());
  }

 private:
  Id text_id(const std::string& text) { return pool_str2id(pool_.get(), text.c_str(), 1); }

  void add(Repo* repo, CandidateId id, const std::vector<RequirementId>& provides,
           const std::vector<RequirementId>& rivals) {
    const Candidate& candidate = universe_.candidates[id];
    const Needs& needs = universe_.needs(id);
    const Id solvable_id = repo_add_solvable(repo);
    Solvable* solvable = pool_id2solvable(pool_.get(), solvable_id);
    solvable->name = text_id("p" + candidate.record->name);
    // The first of a name is the best: the largest number.
    solvable->evr = text_id(std::to_string(1'000'000'000 - id));
    solvable->arch = ARCH_NOARCH;
    solvable->dep_provides = repo_addid_dep(repo, solvable->dep_provides, solvable->name, 0);
    for (const RequirementId need : provides) {
      solvable->dep_provides = repo_addid_dep(repo, solvable->dep_provides, needs_[need], 0);
    }
    for (const RequirementId ban : rivals) {
      solvable->dep_provides = repo_addid_dep(repo, solvable->dep_provides, bans_[ban], 0);
    }
    for (const RequirementId need : needs.depends) {
      solvable->dep_requires = repo_addid_dep(repo, solvable->dep_requires, needs_[need], 0);
    }
    for (const RequirementId ban : needs.constrains) {
      solvable->dep_conflicts = repo_addid_dep(repo, solvable->dep_conflicts, bans_[ban], 0);
    }
    if (!needs.fault.empty()) {
      solvable->dep_requires = repo_addid_dep(repo, solvable->dep_requires, text_id("nothing"), 0);
    }
    solvables_.push_back(solvable_id);
    candidate_of_.emplace(solvable_id, id);
  }

  Proof problems(Solver* solver) {
    Proof conflicts;
    const auto count = static_cast<Id>(solver_problem_count(solver));
    for (Id problem = 1; problem <= count; ++problem) {
      IdQueue rules;
      solver_findallproblemrules(solver, problem, rules.get());
      std::vector<ProofRule> conflict;
      for (const Id rule : rules.ids()) {
        if (const auto known = proof_rule(solver, rule)) conflict.push_back(*known);
      }
      conflicts.push_back(std::move(conflict));
    }
    return conflicts;
  }

  std::optional<ProofRule> proof_rule(Solver* solver, Id rule) {
    Id source = 0;
    Id target = 0;
    Id dependency = 0;
    switch (solver_ruleinfo(solver, rule, &source, &target, &dependency)) {
      case SOLVER_RULE_JOB:
      case SOLVER_RULE_JOB_NOTHING_PROVIDES_DEP:
        if (!requirement_of_.contains(dependency)) return std::nullopt;
        return ProofRule{.kind = ProofRule::Kind::kWanted,
                         .requirement = requirement_of_.at(dependency)};
      case SOLVER_RULE_PKG_REQUIRES:
      case SOLVER_RULE_PKG_NOTHING_PROVIDES_DEP:
        if (!requirement_of_.contains(dependency)) return std::nullopt;
        return ProofRule{.kind = ProofRule::Kind::kRequires,
                         .candidate = candidate_of_.at(source),
                         .requirement = requirement_of_.at(dependency)};
      case SOLVER_RULE_PKG_CONFLICTS:
      case SOLVER_RULE_PKG_SAME_NAME:
        return ProofRule{.kind = ProofRule::Kind::kExcludes,
                         .candidate = candidate_of_.at(source),
                         .other = candidate_of_.at(target)};
      default:
        return std::nullopt;
    }
  }

  const Universe& universe_;
  PoolPointer pool_;
  std::vector<Id> needs_;      ///< by requirement: provided by what matches
  std::vector<Id> bans_;       ///< by requirement: provided by what has the name and does not match
  std::vector<Id> solvables_;  ///< by candidate
  std::unordered_map<Id, RequirementId> requirement_of_;
  std::unordered_map<Id, CandidateId> candidate_of_;
};

}  // namespace

Proof why_impossible(const Universe& universe) {
  return SolvPool(universe).proof();
}

}  // namespace ros2wasm
