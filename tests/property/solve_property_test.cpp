// The resolver against an oracle that tries everything and shares no code with it: on small random
// universes there is an answer exactly when one exists, it is the one that docs/solving.md prefers,
// and it does not depend on the order of records or specs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <set>
#include <tuple>

#include "property/property_seed.hpp"
#include "unit/bundler/support/small_channel.hpp"

namespace ros2wasm {
namespace {

constexpr int kCases = 1500;
constexpr int kNames = 5;
const std::array<std::string, 3> kChannels{"test", "second", "third"};

/// A spec as numbers; `text()` is what the resolver gets.
struct Need {
  enum class Form { kAny, kAtLeast, kBelow, kExactly, kNot, kEither, kBuild };
  int name = 0;
  Form form = Form::kAny;
  int version = 1;

  [[nodiscard]] std::string text() const {
    const std::string who(1, static_cast<char>('a' + name));
    const std::string number = std::to_string(version);
    switch (form) {
      case Form::kAny:
        return who;
      case Form::kAtLeast:
        return who + " >=" + number;
      case Form::kBelow:
        return who + " <" + number;
      case Form::kExactly:
        return who + " " + number;
      case Form::kNot:
        return who + " !=" + number;
      case Form::kEither:
        return who + " 1|" + number;
      case Form::kBuild:
        return who + " * h_" + std::to_string(version % 2);
    }
    return who;
  }

  [[nodiscard]] bool fits(int record_version, int build) const {
    switch (form) {
      case Form::kAny:
        return true;
      case Form::kAtLeast:
        return record_version >= version;
      case Form::kBelow:
        return record_version < version;
      case Form::kExactly:
        return record_version == version;
      case Form::kNot:
        return record_version != version;
      case Form::kEither:
        return record_version == 1 || record_version == version;
      case Form::kBuild:
        return build == version % 2;
    }
    return true;
  }
};

struct Package {
  int name = 0;
  int version = 1;
  int build = 0;
  int channel = 0;
  int features = 0;
  int timestamp = 0;
  bool needs_linux = false;
  bool needs_unix = false;
  bool locked = false;
  std::vector<Need> depends;
  std::vector<Need> constrains;

  [[nodiscard]] PackageRecord record() const {
    PackageRecord made =
        testing::made_record(std::string(1, static_cast<char>('a' + name)), std::to_string(version),
                             {}, static_cast<std::uint64_t>(build));
    made.channel = kChannels.at(static_cast<std::size_t>(channel));
    made.url = made.channel + "/noarch/" + made.file_name;
    made.timestamp_ms = timestamp;
    for (int i = 0; i < features; ++i) made.track_features.push_back("f" + std::to_string(i));
    for (const Need& need : depends) made.depends.push_back(need.text());
    for (const Need& need : constrains) made.constrains.push_back(need.text());
    if (needs_linux) made.depends.push_back("__linux");
    if (needs_unix) made.depends.push_back("__unix >=0");
    return made;
  }
};

struct Case {
  std::vector<Package> packages;
  std::vector<Need> wanted;
  int channels = 1;
  ChannelPriority priority = ChannelPriority::kStrict;
};

class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

  Case next() {
    Case made;
    made.channels = 1 + below(3);
    constexpr std::array<ChannelPriority, 3> kPriorities{
        ChannelPriority::kStrict, ChannelPriority::kFlexible, ChannelPriority::kDisabled};
    made.priority = kPriorities.at(static_cast<std::size_t>(below(3)));
    for (int name = 0; name < kNames; ++name) add_versions(name, made);
    made.wanted.push_back(need(below(kNames)));
    while (below(2) == 0) made.wanted.push_back(need(below(kNames)));
    return made;
  }

  std::mt19937& random() { return random_; }

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }

  void add_versions(int name, Case& made) {
    std::set<std::tuple<int, int, int>> files;  // of this name
    const int count = 1 + below(4);
    for (int i = 0; i < count; ++i) {
      Package package{.name = name,
                      .version = 1 + below(3),
                      .build = below(2),
                      .channel = below(made.channels),
                      .features = below(8) == 0 ? 1 + below(2) : 0,
                      .timestamp = below(3),
                      .needs_linux = below(16) == 0,
                      .needs_unix = below(8) == 0,
                      .locked = below(12) == 0,
                      .depends = {},
                      .constrains = {}};
      if (!files.emplace(package.version, package.build, package.channel).second) continue;
      for (int other = 0; other < kNames; ++other) {
        if (other == name) continue;
        const int dice = below(12);
        if (dice < 3) package.depends.push_back(need(other));
        if (dice == 3 || dice == 4) package.constrains.push_back(need(other));
      }
      made.packages.push_back(std::move(package));
    }
  }

  Need need(int name) {
    return {.name = name, .form = static_cast<Need::Form>(below(7)), .version = 1 + below(3)};
  }

  std::mt19937 random_;
};

/// Per name the place of a package in Oracle::packages_, or -1.
using Solution = std::array<int, kNames>;

class Oracle {
 public:
  explicit Oracle(const Case& given) : case_(given), packages_(given.packages) {
    if (given.priority == ChannelPriority::kStrict) {
      std::erase_if(packages_, [&given](const Package& one) {
        return std::any_of(given.packages.begin(), given.packages.end(), [&one](const Package& b) {
          return b.name == one.name && b.channel < one.channel;
        });
      });
    }
    std::sort(packages_.begin(), packages_.end(),
              [this](const Package& a, const Package& b) { return key(a) < key(b); });
    Solution none;
    none.fill(-1);
    enumerate(0, none);
  }

  /// "a 2 h_1 second, ..." of the preferred solution; nothing when there is none.
  std::optional<std::set<std::string>> best() {
    if (solutions_.empty()) return std::nullopt;
    std::set<int> taken;
    std::vector<Need> round = case_.wanted;
    while (!round.empty()) {
      std::sort(round.begin(), round.end(),
                [](const Need& a, const Need& b) { return a.text() < b.text(); });
      std::vector<Need> next;
      for (const Need& need : round) {
        if (std::any_of(taken.begin(), taken.end(), [&](int id) { return fits(need, id); }))
          continue;
        for (int id = 0; id < static_cast<int>(packages_.size()); ++id) {
          if (!fits(need, id) || !keep_those_with(id)) continue;
          taken.insert(id);
          const auto& needs = at(id).depends;
          next.insert(next.end(), needs.begin(), needs.end());
          break;
        }
      }
      round = next;
    }
    std::set<std::string> result;
    for (const int id : taken) result.insert(at(id).record().url);
    return result;
  }

 private:
  [[nodiscard]] const Package& at(int id) const { return packages_[static_cast<std::size_t>(id)]; }

  [[nodiscard]] std::tuple<bool, int, int, int, int, int, int> key(const Package& one) const {
    const bool flexible = case_.priority == ChannelPriority::kFlexible;
    return {!one.locked,    one.features, flexible ? one.channel : 0, -one.version, -one.build,
            -one.timestamp, one.channel};
  }

  [[nodiscard]] bool fits(const Need& need, int id) const {
    return at(id).name == need.name && need.fits(at(id).version, at(id).build);
  }

  /// Forgets the solutions without the package, unless none would be left.
  bool keep_those_with(int id) {
    std::vector<Solution> kept;
    for (const Solution& solution : solutions_) {
      if (solution.at(static_cast<std::size_t>(at(id).name)) == id) kept.push_back(solution);
    }
    if (kept.empty()) return false;
    solutions_ = std::move(kept);
    return true;
  }

  void enumerate(int name, Solution& chosen) {
    if (name == kNames) {
      if (holds(chosen)) solutions_.push_back(chosen);
      return;
    }
    int& place = chosen.at(static_cast<std::size_t>(name));
    enumerate(name + 1, chosen);
    for (int id = 0; id < static_cast<int>(packages_.size()); ++id) {
      if (at(id).name != name || at(id).needs_linux) continue;
      place = id;
      enumerate(name + 1, chosen);
    }
    place = -1;
  }

  [[nodiscard]] bool holds(const Solution& chosen) const {
    const auto is_there = [&](const Need& need) {
      const int id = chosen.at(static_cast<std::size_t>(need.name));
      return id >= 0 && fits(need, id);
    };
    const auto allows = [&](const Need& need) {
      const int id = chosen.at(static_cast<std::size_t>(need.name));
      return id < 0 || fits(need, id);
    };
    if (!std::all_of(case_.wanted.begin(), case_.wanted.end(), is_there)) return false;
    return std::all_of(chosen.begin(), chosen.end(), [&](int id) {
      return id < 0 || (std::all_of(at(id).depends.begin(), at(id).depends.end(), is_there) &&
                        std::all_of(at(id).constrains.begin(), at(id).constrains.end(), allows));
    });
  }

  const Case& case_;
  std::vector<Package> packages_;  ///< the preferred ones of a name first
  std::vector<Solution> solutions_;
};

struct Question {
  ResolveRequest request;
  RepoIndex index;
};

Question question_of(const Case& given, std::mt19937& random) {
  Question question;
  std::vector<std::string> specs;
  for (const Need& need : given.wanted) specs.push_back(need.text());
  std::shuffle(specs.begin(), specs.end(), random);
  question.request = testing::request_for(specs);
  question.request.priority = given.priority;
  std::vector<PackageRecord> records;
  for (const Package& package : given.packages) {
    records.push_back(package.record());
    if (package.locked) question.request.locked.push_back(records.back());
  }
  std::shuffle(records.begin(), records.end(), random);
  question.index = testing::index_of(std::move(records));
  question.index.channels.assign(kChannels.begin(), kChannels.begin() + given.channels);
  return question;
}

TEST(SolveProperty, IsWhatTheOraclePrefers) {
  const unsigned first_seed = testing::first_seed();
  int solved = 0;
  int refused = 0;
  for (unsigned seed = first_seed; seed < first_seed + kCases; ++seed) {
    SCOPED_TRACE("R2W_PROPERTY_SEED=" + std::to_string(seed));
    Generator generator(seed);
    const Case made = generator.next();
    const auto expected = Oracle(made).best();
    const Question question = question_of(made, generator.random());
    const auto resolution = solve(question.request, question.index);
    ASSERT_EQ(resolution.ok(), expected.has_value());
    const Question shuffled = question_of(made, generator.random());
    const auto again = solve(shuffled.request, shuffled.index);
    ASSERT_EQ(again.ok(), resolution.ok());
    if (!resolution) {
      EXPECT_FALSE(resolution.errors().front().why.empty() &&
                   resolution.errors().front().code != "R2W0302");
      ++refused;
      continue;
    }
    std::set<std::string> urls;
    for (const PackageRecord& record : resolution->packages) urls.insert(record.url);
    ASSERT_EQ(urls, *expected);
    ASSERT_EQ(again->packages, resolution->packages);
    ASSERT_TRUE(check_solution(question.request.specs, resolution->packages).empty());
    ++solved;
  }
  EXPECT_GT(solved, kCases / 10);
  EXPECT_GT(refused, kCases / 10);
}

}  // namespace
}  // namespace ros2wasm
