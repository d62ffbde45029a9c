// Records, indexes and channels for tests, in few words.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bundler/channel/channel_index.hpp"
#include "bundler/channel/channel_writer.hpp"
#include "bundler/resolve/solve.hpp"
#include "bundler/store/store.hpp"
#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm::testing {

/// "name version" or "name version build" or "name version build_number".
inline PackageRecord made_record(const std::string& name, const std::string& version,
                                 std::vector<std::string> depends = {},
                                 std::uint64_t build_number = 0) {
  const std::string build = "h_" + std::to_string(build_number);
  const std::string file = name + "-" + version + "-" + build + ".conda";
  return PackageRecord{.name = name,
                       .version = version,
                       .build = build,
                       .build_number = build_number,
                       .subdir = "noarch",
                       .channel = "test",
                       .file_name = file,
                       .url = "test/noarch/" + file,
                       .sha256 = std::string(64, '0'),
                       .depends = std::move(depends),
                       .noarch = NoarchKind::kGeneric};
}

inline RepoIndex index_of(std::vector<PackageRecord> records) {
  return RepoIndex{.channels = {"test"}, .records = std::move(records), .left_out = {}};
}

inline ResolveRequest request_for(const std::vector<std::string>& specs) {
  ResolveRequest request;
  for (const std::string& text : specs)
    request.specs.push_back({.text = text, .origin = {}, .span = {}});
  return request;
}

/// "a 1.0 h_0, b 2.0 h_0" in install order, or the codes of the errors.
inline std::string answer(const ResolveRequest& request, const RepoIndex& index) {
  const auto resolution = solve(request, index);
  std::string text;
  if (!resolution) {
    for (const Diagnostic& error : resolution.errors())
      text += (text.empty() ? "" : ", ") + error.code;
    return text;
  }
  for (const PackageRecord& record : resolution->packages) {
    text += (text.empty() ? "" : ", ") + record.name + " " + record.version;
    if (record.build_number != 0) text += " " + record.build;
  }
  return text;
}

inline std::string answer(const std::vector<std::string>& specs,
                          const std::vector<PackageRecord>& records) {
  return answer(request_for(specs), index_of(records));
}

/// A channel folder in a temporary tree, with packages of a few files.
class SmallChannel {
 public:
  struct File {
    std::string path;
    std::string text;
  };

  std::filesystem::path add(const std::string& name, const std::string& version,
                            const std::vector<File>& files, std::vector<std::string> depends = {},
                            const std::string& placeholder = {}) {
    const std::string stage = stage_of(name, version);
    std::filesystem::create_directories(tree_ / stage);
    for (const File& file : files) tree_.write(stage + "/" + file.path, file.text);
    const auto archive = add_to_channel(folder(),
                                        {.name = name,
                                         .version = version,
                                         .build = "h_0",
                                         .subdir = "noarch",
                                         .noarch = NoarchKind::kGeneric,
                                         .depends = std::move(depends),
                                         .license = "MIT",
                                         .placeholder = placeholder},
                                        tree_ / stage);
    EXPECT_TRUE(archive.ok());
    return archive.ok() ? *archive : std::filesystem::path();
  }

  struct Link {
    std::string path;
    std::string target;
  };

  /// Version 1.0 of a package of links.
  void add_links(const std::string& name, const std::vector<Link>& links) {
    for (const Link& link : links) {
      const auto place = tree_ / (stage_of(name, "1.0") + "/" + link.path);
      std::filesystem::create_directories(place.parent_path());
      std::filesystem::create_symlink(link.target, place);
    }
    add(name, "1.0", {});
  }

  void write_index() { EXPECT_TRUE(index_channel(folder()).ok()); }

  [[nodiscard]] RepoIndex read() const {
    const std::vector<ChannelSource> sources{{.name = "./channel", .span = {}}};
    auto index = load_channels(sources, roots());
    EXPECT_TRUE(index.ok());
    return index.ok() ? std::move(*index) : RepoIndex{};
  }

  [[nodiscard]] PackageRecord record(const std::string& name) const {
    for (const PackageRecord& one : read().records) {
      if (one.name == name) return one;
    }
    ADD_FAILURE() << "no record " << name;
    return {};
  }

  [[nodiscard]] std::filesystem::path folder() const { return tree_ / "channel"; }
  [[nodiscard]] ChannelRoots roots() const {
    return {.working_directory = tree_.root(), .embedded = folder(), .cache = tree_ / "cache"};
  }
  [[nodiscard]] Store store() const { return Store(roots()); }
  [[nodiscard]] const TemporaryTree& tree() const { return tree_; }

 private:
  static std::string stage_of(const std::string& name, const std::string& version) {
    return "stage-" + name + "-" + version;
  }

  TemporaryTree tree_;
};

}  // namespace ros2wasm::testing
