// The emscripten-wasm32 part of the public pixi.lock holds, and not one of its edges may break.
#include <algorithm>
#include <random>

#include "bundler/resolve/solve.hpp"
#include "bundler/workspace/foreign_environment.hpp"
#include "conda_data/conda_data.hpp"
#include "workspace_schema/conda/match_spec.hpp"
#include "workspace_schema/schema/lock.hpp"

namespace ros2wasm {
namespace {

/// Breaks one edge of a lock that holds: `who` needs `what`.
struct Mutation {
  std::string who;
  std::string what;
};

Mutation mutate(std::vector<PackageRecord>& packages, std::mt19937& random) {
  for (;;) {
    PackageRecord& from = packages[random() % packages.size()];
    if (from.depends.empty()) continue;
    const std::size_t which = random() % from.depends.size();
    const std::string text = from.depends[which];
    const auto name = MatchSpec::parse(text)->exact_name().value_or("");
    const auto target =
        std::find_if(packages.begin(), packages.end(),
                     [&name](const PackageRecord& record) { return record.name == name; });
    if (target == packages.end() || target->name == from.name) continue;
    Mutation made{.who = from.name, .what = text};
    switch (random() % 4) {
      case 0:
        packages.erase(target);
        return made;
      case 1: {  // a version that does not fit any more
        PackageRecord changed = *target;
        changed.version = "0.0.0dev0";
        if (MatchSpec::parse(text)->matches(changed)) continue;
        *target = changed;
        return made;
      }
      case 2:  // the edge asks for more
        made.what = from.depends[which] = name + " >=99999";
        return made;
      default:  // the other side allows less
        made = {.who = target->name, .what = from.name + " <0.0.0dev0"};
        target->constrains.push_back(made.what);
        return made;
    }
  }
}

TEST(PublicPixiLock, EveryEdgeCounts) {
  const auto read =
      read_foreign_environment(testing::conda_text("emscripten-wasm32.pixi.lock"), "pixi.lock", {});
  ASSERT_TRUE(read.ok());
  const ForeignEnvironment& made = *read;
  EXPECT_EQ(made.name, "wasm");
  ASSERT_EQ(made.packages.size(), 38U);
  std::uint64_t bytes = 0;
  for (const PackageRecord& record : made.packages) bytes += record.size;
  EXPECT_EQ(bytes, 56'072'544U);
  for (const Diagnostic& fault : check_solution({}, made.packages)) ADD_FAILURE() << fault.message;

  const auto written = write_lock({.channels = made.channels, .packages = made.packages});
  ASSERT_TRUE(read_lock(written, "ros2wasm.lock").ok());
  EXPECT_EQ(read_lock(written, "ros2wasm.lock")->packages, made.packages);

  constexpr unsigned kSeed = 20240726;
  std::mt19937 random(kSeed);
  for (int i = 0; i < 50; ++i) {
    std::vector<PackageRecord> packages = made.packages;
    const Mutation mutation = mutate(packages, random);
    const Diagnostics faults = check_solution({}, packages);
    const bool named = std::any_of(faults.begin(), faults.end(), [&](const Diagnostic& fault) {
      return fault.code == "R2W0311" && fault.message.starts_with(mutation.who + " ") &&
             fault.message.find("`" + mutation.what + "`") != std::string::npos;
    });
    EXPECT_TRUE(named) << "seed " << kSeed << ", mutation " << i << ": " << mutation.who << " -> "
                       << mutation.what;
  }
}

}  // namespace
}  // namespace ros2wasm
