// The resolver against brute force: on small random universes it finds a solution exactly when
// there is one, and what it finds is one.
#include <gtest/gtest.h>

#include <random>

#include "unit/bundler/support/small_channel.hpp"

namespace ros2wasm {
namespace {

using testing::made_record;

class Universes {
 public:
  explicit Universes(unsigned seed) : random_(seed) {}

  std::vector<PackageRecord> records() {
    std::vector<PackageRecord> made;
    for (int name = 0; name < 4; ++name) {
      const int versions = below(3) + 1;
      for (int version = 1; version <= versions; ++version) {
        PackageRecord record = made_record(name_of(name), std::to_string(version));
        for (int other = 0; other < 5; ++other) {  // 4 is a name that nothing has
          if (other == name) continue;
          const int dice = below(12);
          if (other < 4 && dice < 3) record.depends.push_back(spec(other));
          if (other == 4 && dice == 0) record.depends.push_back("missing");
          if (dice == 3) record.constrains.push_back(spec(other));
        }
        made.push_back(std::move(record));
      }
    }
    return made;
  }

  std::vector<std::string> specs() {
    std::vector<std::string> wanted{spec(below(4))};
    while (below(2) == 0) wanted.push_back(spec(below(4)));
    return wanted;
  }

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  static std::string name_of(int name) { return std::string(1, static_cast<char>('a' + name)); }
  std::string spec(int name) {
    static const std::vector<std::string> kForms{"", " >=2", " <2", " 1", " 2", " !=2", " 1|3"};
    return name_of(name) + kForms[static_cast<std::size_t>(below(static_cast<int>(kForms.size())))];
  }

  std::mt19937 random_;
};

/// Tries every choice of at most one record per name.
bool has_solution(const ResolveRequest& request, const std::vector<PackageRecord>& records,
                  std::size_t from, std::vector<PackageRecord>& chosen) {
  if (check_solution(request.specs, chosen).empty()) return true;
  for (std::size_t i = from; i < records.size(); ++i) {
    if (!chosen.empty() && chosen.back().name == records[i].name) continue;
    chosen.push_back(records[i]);
    if (has_solution(request, records, i + 1, chosen)) return true;
    chosen.pop_back();
  }
  return false;
}

TEST(SolveOracle, AgreesWithBruteForce) {
  int solved = 0;
  int refused = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    Universes universes(seed);
    const std::vector<PackageRecord> records = universes.records();
    const ResolveRequest request = testing::request_for(universes.specs());
    std::vector<PackageRecord> chosen;
    const bool possible = has_solution(request, records, 0, chosen);
    const auto resolution = solve(request, testing::index_of(records));
    ASSERT_EQ(resolution.ok(), possible) << "seed " << seed;
    if (resolution) {
      EXPECT_TRUE(check_solution(request.specs, resolution->packages).empty()) << "seed " << seed;
      ++solved;
    } else {
      EXPECT_FALSE(resolution.errors().front().why.empty()) << "seed " << seed;
      ++refused;
    }
  }
  EXPECT_GT(solved, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace ros2wasm
