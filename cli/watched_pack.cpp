// See watched_pack.hpp.
#include "cli/watched_pack.hpp"

#include <algorithm>

#include "bundler/pipeline.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "bundler/serve/site_responder.hpp"
#include "cli/console.hpp"
#include "cli/diagnostic_text.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr int kLeastIntervalMs = 200;

fs::path folder_of(const std::string& workspace) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(fs::absolute(workspace, error), error);
  return fs::is_directory(path, error) ? path : path.parent_path();
}

std::string problem_text(const Diagnostics& errors) {
  std::string text;
  for (const Diagnostic& error : errors) text += diagnostic_text(error, {}) + "\n";
  return text;
}

}  // namespace

WatchedPack::WatchedPack(Context& context, std::string workspace, fs::path site)
    : context_(context),
      workspace_(std::move(workspace)),
      site_(std::move(site)),
      folder_(folder_of(workspace_)),
      watch_(marks()) {
  pages_.set({.version = site_version(site_), .problems = {}});
}

WorkspaceMarks WatchedPack::marks() {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<fs::path> roots = watched_;
  roots.push_back(folder_);
  auto found = workspace_marks(roots, {site_});
  look_time_ = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - begin);
  return found;
}

int WatchedPack::pack_now() {
  auto report = ros2wasm::pack({.input = workspace_,
                                .output = site_,
                                .executable = context_.executable,
                                .variables = context_.environment,
                                .quick = true},
                               context_.cancellation, context_.progress);
  SiteState state{.version = site_version(site_), .problems = {}};
  int exit_code = 0;
  if (report) {
    for (const Diagnostic& warning : report->notes.warnings) context_.console.report(warning);
    for (const std::string& remark : report->notes.remarks) context_.console.remark(remark);
    accept_new_roots(report->notes.watched);
    watched_ = std::move(report->notes.watched);
  } else {
    state.problems = problem_text(report.errors());
    exit_code = context_.console.fail(report.errors());
  }
  watch_.accept(workspace_marks({folder_ / kLockFileName}, {}));
  pages_.set(std::move(state));
  return exit_code;
}

void WatchedPack::accept_new_roots(const std::vector<fs::path>& roots) {
  std::vector<fs::path> fresh;
  for (const fs::path& root : roots) {
    const bool below = *root.lexically_relative(folder_).begin() != "..";
    if (!below && std::find(watched_.begin(), watched_.end(), root) == watched_.end())
      fresh.push_back(root);
  }
  watch_.accept(workspace_marks(fresh, {site_}));
}

void WatchedPack::look() {
  const auto changed = watch_.look(marks());
  if (!changed) return;
  const std::string before = pages_.state().version;
  context_.console.remark(fs::path(*changed).lexically_relative(folder_).string() +
                          " changed; packing again");
  if (pack_now() != 0) {
    context_.console.remark("the last good site is still served");
  } else if (pages_.state().version == before) {
    context_.console.remark("the site is the same as before");
  } else {
    context_.console.remark("packed; open pages reload");
  }
}

int WatchedPack::interval_ms() const {
  return std::max(kLeastIntervalMs, static_cast<int>(10 * look_time_.count()));
}

}  // namespace ros2wasm
