// The resolver against libsolv, on universes with too many sets to try them all: whether anything
// fits is what libsolv says too, and whoever would have been preferred to a chosen record is
// refused by libsolv once what was served before is given.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "bundler/resolve/sat_engine.hpp"
#include "property/property_seed.hpp"
#include "unit/bundler/support/small_channel.hpp"

namespace ros2wasm {
namespace {

constexpr int kCases = 150;
constexpr int kVersions = 6;

struct Case {
  std::vector<PackageRecord> records;  ///< by name, then the preferred ones first
  std::vector<std::string> wanted;
};

class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed), names_(8 + below(30)), tight_(below(4)) {}

  Case next() {
    Case made;
    for (int name = 10; name < 10 + names_; ++name) add_versions(name, made);
    const int count = 1 + below(5);
    for (int i = 0; i < count; ++i) made.wanted.push_back(spec(10 + below(names_), kVersions));
    return made;
  }

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }

  void add_versions(int name, Case& made) {
    for (int version = 1 + below(kVersions); version > 0; --version) {
      for (int build = below(2); build >= 0; --build) {
        PackageRecord record = testing::made_record(word(name), std::to_string(version), {},
                                                    static_cast<std::uint64_t>(build));
        for (int i = below(4); i > 0; --i) {
          const int other = 10 + below(names_);
          if (other == name) continue;
          (below(5) == 0 ? record.constrains : record.depends).push_back(spec(other, version));
        }
        made.records.push_back(std::move(record));
      }
    }
  }

  static std::string word(int name) { return "n" + std::to_string(name); }

  /// Versions of packages that fit each other are near each other, as in real channels.
  std::string spec(int name, int near) {
    const int version = std::max(1, std::min(kVersions, near - 1 + below(3)));
    const std::string number = std::to_string(version);
    switch (below(5 + tight_)) {
      case 0:
        return word(name);
      case 1:
        return word(name) + " >=" + number;
      case 2:
        return word(name) + " <=" + number;
      case 3:
        return below(4) == 0 ? word(name / 10) + "* >=" + number : word(name) + " !=" + number;
      default:
        return word(name) + " " + number;
    }
  }

  std::mt19937 random_;
  int names_;
  int tight_;  ///< the larger, the fewer versions fit
};

/// Does libsolv find a solution that has all of these?
bool fits(const Case& made, const std::vector<PackageRecord>& fixed) {
  std::vector<std::string> texts = made.wanted;
  for (const PackageRecord& record : fixed)
    texts.push_back(record.name + " ==" + record.version + " " + record.build);
  std::vector<MatchSpec> specs;
  for (const std::string& text : texts) specs.push_back(MatchSpec::parse(text).value());
  const ResolveRequest request = testing::request_for(texts);
  const RepoIndex index = testing::index_of(made.records);
  return why_impossible(make_universe(request, specs, index)).empty();
}

/// Walks as docs/solving.md says and asks libsolv about each record that was passed over.
std::vector<PackageRecord> confirmed(const Case& made, const std::vector<PackageRecord>& chosen) {
  std::vector<PackageRecord> taken;
  std::vector<std::string> round = made.wanted;
  while (!round.empty()) {
    std::sort(round.begin(), round.end());
    std::vector<std::string> next;
    for (const std::string& text : round) {
      const MatchSpec spec = MatchSpec::parse(text).value();
      if (std::any_of(taken.begin(), taken.end(),
                      [&spec](const PackageRecord& record) { return spec.matches(record); }))
        continue;
      for (const PackageRecord& record : made.records) {
        if (!spec.matches(record)) continue;
        taken.push_back(record);
        if (std::find(chosen.begin(), chosen.end(), record) != chosen.end()) {
          next.insert(next.end(), record.depends.begin(), record.depends.end());
          break;
        }
        EXPECT_FALSE(fits(made, taken)) << record.file_name << " would have been possible";
        taken.pop_back();
      }
    }
    round = next;
  }
  return taken;
}

TEST(SolveProperty, IsWhatLibsolvConfirms) {
  const unsigned first_seed = testing::first_seed();
  int solved = 0;
  int refused = 0;
  for (unsigned seed = first_seed; seed < first_seed + kCases; ++seed) {
    SCOPED_TRACE("R2W_PROPERTY_SEED=" + std::to_string(seed));
    const Case made = Generator(seed).next();
    const ResolveRequest request = testing::request_for(made.wanted);
    const auto resolution = solve(request, testing::index_of(made.records));
    ASSERT_EQ(resolution.ok(), fits(made, {}));
    if (!resolution) {
      ++refused;
      continue;
    }
    ASSERT_TRUE(check_solution(request.specs, resolution->packages).empty());
    ASSERT_EQ(confirmed(made, resolution->packages).size(), resolution->packages.size());
    ++solved;
  }
  EXPECT_GT(solved, kCases / 10);
  EXPECT_GT(refused, kCases / 10);
}

}  // namespace
}  // namespace ros2wasm
