// The workspace behind `serve --watch`: packs it, notices changes, packs again, and tells the
// pages.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "bundler/serve/reload.hpp"
#include "bundler/serve/workspace_watch.hpp"
#include "cli/context.hpp"

namespace ros2wasm {

class WatchedPack {
 public:
  /// `workspace` is a manifest or a folder, `site` where to pack it to.
  WatchedPack(Context& context, std::string workspace, std::filesystem::path site);

  /// Packs now. A failure is reported and told to the pages; the last good site stays. Returns the
  /// exit code that the failure asks for, 0 when there is none.
  int pack_now();

  /// Packs when the workspace changed since the last pack. Call again after interval_ms().
  void look();

  /// A look at a big workspace takes longer, so it is done less often.
  [[nodiscard]] int interval_ms() const;
  [[nodiscard]] const ReloadHub& pages() const { return pages_; }
  void close() { pages_.close(); }

 private:
  [[nodiscard]] WorkspaceMarks marks();
  /// Places outside of the folder that only the pack told of: they were not looked at before it.
  void accept_new_roots(const std::vector<std::filesystem::path>& roots);

  Context& context_;
  std::string workspace_;
  std::filesystem::path site_;
  std::filesystem::path folder_;                ///< of the workspace
  std::vector<std::filesystem::path> watched_;  ///< what the last good pack depended on
  ReloadHub pages_;
  WorkspaceWatch watch_;
  std::chrono::milliseconds look_time_{0};
};

}  // namespace ros2wasm
