// See build_workspace.hpp.
#include "bundler/build/build_workspace.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>
#include <thread>

#include "bundler/build/cached_work.hpp"
#include "bundler/build/compiler_warnings.hpp"
#include "bundler/build/link_kit.hpp"
#include "bundler/build/missing_headers.hpp"
#include "bundler/build/source_hash.hpp"
#include "bundler/build/split_programs.hpp"
#include "bundler/io/cached_folder.hpp"
#include "bundler/io/file_lock.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/store/build_place.hpp"
#include "bundler/workspace/channel_request.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

Outcome<std::string> hash_of(const LocalPackage& package,
                             const std::vector<const BuiltPackage*>& needs,
                             const std::string& toolchain_hash,
                             const std::string& setup_reader_hash, const BuildTools& tools,
                             const BuildSettings& settings) {
  const bool is_python = package.xml.build_type == kPythonBuildType;
  // CMake reads what links lead to, wherever that is; setup.py gets a copy without it.
  const auto sources = hash_of_tree(package.directory, package.base,
                                    is_python ? LinksOut::kNamed : LinksOut::kHashed);
  if (!sources) return sources.errors();
  HashBuilder hash;
  hash.add("format", kBuildFormat).add("ros2wasm", ROS2WASM_VERSION);
  hash.add("toolchain", toolchain_hash).add("compiler", tools.compiler.identity);
  if (tools.quick) hash.add("link", "quick");
  if (is_python) hash.add("setup", setup_reader_hash);
  hash.add("environment", settings.environment_key);
  for (const BuiltPackage* need : needs) hash.add(need->name, need->hash);
  hash.add("sources", *sources);
  return hash.finish();
}

/// How much there is to compile, roughly: sources, and interfaces, which become sources.
std::size_t source_count(const fs::path& folder) {
  constexpr auto kSources = std::to_array<std::string_view>(
      {".action", ".c", ".cc", ".cpp", ".cxx", ".idl", ".msg", ".srv"});
  std::size_t count = 0;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    const std::string ending = it->path().extension().string();
    if (std::find(kSources.begin(), kSources.end(), ending) != kSources.end()) ++count;
  }
  return count;
}

/// The durations of earlier builds, a file for each package: how much there was to compile, and
/// milliseconds.
constexpr const char* kTimes = "times";
/// For one source, while nothing is known of this machine.
constexpr double kSecondsPerSource = 4;

struct BuildTime {
  double sources = 0;
  double seconds = 0;
};

std::optional<BuildTime> read_time(const fs::path& file) {
  const auto text = read_file(file, kMostOfText);
  if (!text) return std::nullopt;
  std::istringstream words(*text);
  BuildTime time;
  double milliseconds = 0;
  if (!(words >> time.sources >> milliseconds) || time.sources < 1) return std::nullopt;
  time.seconds = milliseconds / 1000;
  return time;
}

/// It only serves estimates: that it cannot be written does not matter.
void note_time(const fs::path& cache, const std::string& name, std::size_t sources,
               std::chrono::steady_clock::time_point began) {
  const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - began);
  static_cast<void>(write_file(
      cache / kTimes / name, std::to_string(sources) + " " + std::to_string(took.count()) + "\n"));
}

/// The average of all packages that were built here.
double seconds_per_source(const fs::path& cache) {
  BuildTime all;
  std::error_code error;
  for (fs::directory_iterator it(cache / kTimes, error), end; !error && it != end;
       it.increment(error)) {
    if (const auto time = read_time(it->path())) {
      all.sources += time->sources;
      all.seconds += time->seconds;
    }
  }
  return all.sources > 0 ? all.seconds / all.sources : kSecondsPerSource;
}

/// CMake or a source asks for what is not there.
bool misses_package(const Diagnostic& error) {
  return error.code == "R2W0507" ||
         (error.code == "R2W0502" && error.message.find("' file not found") != std::string::npos);
}

/// All that the packages' builds share; packages that do not need each other are built at the same
/// time.
class WorkspaceBuilder {
 public:
  WorkspaceBuilder(const std::vector<LocalPackage>& packages, const BuildOrder& order,
                   const LeftOutPackages& left_out, const BuildTools& tools,
                   std::string toolchain_hash, std::string setup_reader_hash,
                   const BuildSettings& settings, const Cancellation& cancellation,
                   const ProgressSink& progress)
      : packages_(packages),
        order_(order),
        tools_(tools),
        settings_(settings),
        cancellation_(cancellation),
        progress_(progress),
        built_(packages.size()),
        state_(packages.size(), State::kWaiting),
        toolchain_hash_(std::move(toolchain_hash)),
        setup_reader_hash_(std::move(setup_reader_hash)),
        free_jobs_(std::max(1U, tools.jobs)),
        known_packages_(settings.channel_packages),
        left_out_(left_out) {
    for (const auto& [index, reason] : left_out_) state_[index] = State::kNotBuilt;
    for (const LocalPackage& package : packages) {
      sizes_.push_back(1 + source_count(package.directory));
      known_packages_.push_back(package.xml.name.value);
    }
    std::sort(known_packages_.begin(), known_packages_.end());
  }

  [[nodiscard]] Outcome<std::vector<PlannedBuild>> plan() {
    std::vector<PlannedBuild> planned;
    const double usual = seconds_per_source(settings_.cache);
    for (const std::size_t index : order_.order) {
      const auto& needs = order_.needs[index];
      if (state_[index] == State::kNotBuilt ||
          std::any_of(needs.begin(), needs.end(),
                      [&](std::size_t need) { return !built_[need].has_value(); }))
        continue;
      auto result = found(index);
      if (!result) return std::move(result).errors();
      const auto sources = static_cast<double>(sizes_[index]);
      const auto before = read_time(settings_.cache / kTimes / result->name);
      const double seconds = before ? before->seconds * sources / before->sources : usual * sources;
      planned.push_back({.name = result->name,
                         .version = result->version,
                         .origin = packages_[index].origin,
                         .is_cached = result->from_cache,
                         .seconds = result->from_cache ? 0 : seconds});
      built_[index] = std::move(*result);
    }
    return planned;
  }

  [[nodiscard]] Outcome<WorkspaceBuild> run() {
    const unsigned workers =
        std::min<unsigned>(free_jobs_, static_cast<unsigned>(packages_.size()));
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < workers; ++i) threads.emplace_back([this] { work(); });
    work();
    for (std::thread& thread : threads) thread.join();
    return result();
  }

 private:
  enum class State { kWaiting, kRunning, kBuilt, kNotBuilt };

  /// Takes packages whose needs are built until none is left.
  void work() {
    std::unique_lock lock(mutex_);
    while (true) {
      const std::vector<std::size_t> ready = ready_packages();
      if (ready.empty() || free_jobs_ == 0) {
        if (std::none_of(state_.begin(), state_.end(),
                         [](State s) { return s == State::kRunning; }))
          break;
        changed_.wait(lock);
        continue;
      }
      const std::size_t next =
          *std::max_element(ready.begin(), ready.end(),
                            [this](std::size_t a, std::size_t b) { return sizes_[a] < sizes_[b]; });
      const unsigned jobs = share_of(next, ready);
      state_[next] = State::kRunning;
      free_jobs_ -= jobs;
      lock.unlock();
      auto outcome = build(next, jobs);
      lock.lock();
      free_jobs_ += jobs;
      finish(next, std::move(outcome));
      changed_.notify_all();
    }
    changed_.notify_all();
  }

  /// Packages that can be built now share the jobs that nobody has by their sizes, the biggest
  /// first and rounded, so that a big one is not left alone with one job at the end.
  [[nodiscard]] unsigned share_of(std::size_t index, const std::vector<std::size_t>& ready) const {
    std::size_t all = 0;
    for (const std::size_t one : ready) all += sizes_[one];
    return std::max(1U, static_cast<unsigned>((free_jobs_ * sizes_[index] + all / 2) / all));
  }

  [[nodiscard]] std::vector<std::size_t> ready_packages() {
    std::vector<std::size_t> result;
    if (cancellation_.requested()) return result;
    for (const std::size_t index : order_.order) {
      if (state_[index] != State::kWaiting) continue;
      const auto& needs = order_.needs[index];
      if (std::any_of(needs.begin(), needs.end(),
                      [&](std::size_t n) { return state_[n] == State::kNotBuilt; })) {
        state_[index] = State::kNotBuilt;
      } else if (std::all_of(needs.begin(), needs.end(),
                             [&](std::size_t n) { return state_[n] == State::kBuilt; })) {
        result.push_back(index);
      }
    }
    return result;
  }

  void finish(std::size_t index, Outcome<BuiltPackage> outcome) {
    if (outcome) {
      built_[index] = std::move(*outcome);
      state_[index] = State::kBuilt;
    } else {
      errors_.emplace_back(index, std::move(outcome).errors());
      state_[index] = State::kNotBuilt;
    }
  }

  /// The place of the package's build, by the hash of all that it is made from; `from_cache` when
  /// it is there.
  [[nodiscard]] Outcome<BuiltPackage> found(std::size_t index) const {
    const LocalPackage& package = packages_[index];
    std::vector<const BuiltPackage*> needs;
    for (const std::size_t need : order_.needs[index]) needs.push_back(&*built_[need]);
    const auto hash =
        hash_of(package, needs, toolchain_hash_, setup_reader_hash_, tools_, settings_);
    if (!hash) return hash.errors();
    const std::string& name = package.xml.name.value;
    BuiltPackage result{.name = name,
                        .version = package.xml.version.value,
                        .prefix = settings_.cache / "built" / (name + "-" + hash->substr(0, 20)),
                        .hash = *hash};
    result.from_cache = is_kept(result.prefix, *hash);
    return result;
  }

  [[nodiscard]] Outcome<BuiltPackage> build(std::size_t index, unsigned jobs) {
    const LocalPackage& package = packages_[index];
    auto there = found(index);
    if (!there) return there;
    BuiltPackage result = *std::move(there);
    if (!result.from_cache) {
      PackageBuilder* const builder = settings_.builder_of(package.xml.build_type);
      std::vector<const BuiltPackage*> needs;
      for (const std::size_t need : order_.needs[index]) needs.push_back(&*built_[need]);
      const auto began = std::chrono::steady_clock::now();
      if (auto done = build_anew(*builder, package, needs, result, jobs); !done)
        return std::move(done).errors();
      note_time(settings_.cache, result.name, sizes_[index], began);
    }
    Diagnostics findings = left_out_programs(result.prefix, place_of(package));
    append(findings, kept_findings(result.prefix, place_of(package)));
    if (has_error(findings)) return findings;
    result.warnings = std::move(findings);
    return result;
  }

  [[nodiscard]] BuildPlace place_of(const LocalPackage& package) const {
    return {.package = package.xml.name.value,
            .source = package.directory,
            .display = shown_path(package.directory, package.base, package.shown_base),
            .compiler_version = tools_.compiler.version,
            .channel_packages = known_packages_};
  }

  [[nodiscard]] Outcome<Done> build_anew(PackageBuilder& builder, const LocalPackage& package,
                                         const std::vector<const BuiltPackage*>& needs,
                                         const BuiltPackage& result, unsigned jobs) {
    const std::string& name = result.name;
    const fs::path& prefix = result.prefix;
    // Ninja does not see another compiler, nor that programs are linked differently: such builds
    // share no folder.
    const std::string key = package.directory.string() + "\n" + tools_.compiler.identity + "\n" +
                            toolchain_hash_ + (tools_.quick ? "\nquick" : "");
    const fs::path work = settings_.cache / "work" / (name + "-" + sha256_hex(key).substr(0, 16));
    if (auto made = make_directories(work); !made) return made;
    const auto lock = FileLock::take(work.string() + ".lock", cancellation_);
    if (!lock) return lock.errors();
    if (is_kept(prefix, result.hash)) return Done{};  // another process was faster
    if (progress_) progress_({.step = "build", .item = name, .done = 0, .total = 0, .unit = {}});
    if (auto forgot = forget_what_times_hide(work, package.directory, package.base); !forgot)
      return forgot;
    auto staging = TemporaryDirectory::make(settings_.cache / "built", "." + name + "-");
    if (!staging) return std::move(staging).errors();

    PackageBuild request{.place = place_of(package),
                         .prefixes = {},
                         .work = work,
                         .install = staging->path(),
                         .final_prefix = prefix,
                         .channel_prefix = settings_.environment_prefix,
                         .workspace = package.base,
                         .jobs = jobs};
    for (auto need = needs.rbegin(); need != needs.rend(); ++need)
      request.prefixes.push_back((*need)->prefix);
    if (!settings_.environment_prefix.empty())
      request.prefixes.push_back(settings_.environment_prefix);

    if (auto done = builder(request, tools_, cancellation_, progress_); !done) return done;
    if (auto done = split_programs(staging->path(), name); !done) return done;
    if (auto done = install_link_kits(work / kLinkKits, staging->path(), name); !done) return done;
    return keep_folder(staging->path(), prefix, result.hash);
  }

  /// The reason for which a package that failed is skipped, if there is one.
  [[nodiscard]] std::optional<LeftOutReason> reason_of(std::size_t index,
                                                       const Diagnostics& errors) const {
    const auto lack = settings_.lacks.find(index);
    if (lack != settings_.lacks.end() &&
        std::all_of(errors.begin(), errors.end(), misses_package)) {
      LeftOutReason reason = lack->second.reason;
      reason.warning.why.insert(reason.warning.why.begin(), errors.front().message);
      return reason;
    }
    // A folder with a project() and without a package.xml is often meant for another machine.
    const bool is_plain = packages_[index].is_plain_cmake;
    const auto is_a_reason = [is_plain](const Diagnostic& one) {
      return one.code == "R2W0507" ? one.fix.empty() || is_plain
                                   : is_plain && one.kind == FailureKind::kUserInput;
    };
    if (!std::all_of(errors.begin(), errors.end(), is_a_reason)) return std::nullopt;
    return left_out_by_cmake(packages_[index], errors.front());
  }

  void skip_what_needs_skipped() {
    for (const std::size_t index : order_.order) {
      if (built_[index] || left_out_.contains(index)) continue;
      if (const auto needed = nearest_left_out(order_.needs[index], left_out_))
        left_out_.emplace(
            index, left_out_with(packages_[index], packages_[*needed], left_out_.at(*needed)));
    }
  }

  /// Skips the packages that ask for things that neither the channels nor the workspace have, and
  /// the packages that need them. When nothing would remain, adds the missing things to the errors
  /// instead.
  void leave_out_what_nobody_can_build() {
    if (std::none_of(built_.begin(), built_.end(),
                     [](const auto& one) { return one.has_value(); })) {
      for (auto& [index, errors] : errors_) {
        const auto lack = settings_.lacks.find(index);
        if (lack == settings_.lacks.end() ||
            !std::all_of(errors.begin(), errors.end(), misses_package))
          continue;
        errors.insert(errors.begin(), lack->second.missing.begin(), lack->second.missing.end());
      }
      return;
    }
    std::erase_if(errors_, [&](const auto& failed) {
      auto reason = reason_of(failed.first, failed.second);
      if (!reason) return false;
      left_out_.emplace(failed.first, std::move(*reason));
      return true;
    });
    skip_what_needs_skipped();
  }

  /// The packages that failed for a fault of their own; those that need them become skipped ones. A
  /// fault of the machine, such as a missing tool, stays an error of all.
  [[nodiscard]] std::vector<FailedPackage> skip_failed() {
    std::vector<FailedPackage> failed;
    std::erase_if(errors_, [&](auto& one) {
      if (std::any_of(one.second.begin(), one.second.end(), [](const Diagnostic& error) {
            return error.kind == FailureKind::kEnvironment;
          }))
        return false;
      failed.push_back({packages_[one.first].xml.name.value, std::move(one.second)});
      left_out_.emplace(one.first, LeftOutReason{.chain = {"it does not build"}, .warning = {}});
      failed_.insert(one.first);
      return true;
    });
    skip_what_needs_skipped();
    return failed;
  }

  [[nodiscard]] Outcome<WorkspaceBuild> result() {
    if (cancellation_.requested()) return interrupted();
    std::sort(errors_.begin(), errors_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    leave_out_what_nobody_can_build();
    std::vector<FailedPackage> failed;
    if (settings_.keeps_going) failed = skip_failed();
    Diagnostics all;
    for (auto& [index, errors] : errors_) {
      for (Diagnostic& one : errors) {
        // A missing tool is said once, not once per package.
        const bool known = std::any_of(all.begin(), all.end(), [&](const Diagnostic& other) {
          return other.kind == FailureKind::kEnvironment && other.message == one.message;
        });
        if (!known) all.push_back(std::move(one));
      }
    }
    if (!all.empty()) {
      std::error_code error;
      const fs::space_info space = fs::space(settings_.cache, error);
      if (!error) {
        if (auto full = little_room(settings_.cache, space.available)) {
          all.insert(all.begin(), std::move(*full));
        }
      }
      return all;
    }
    WorkspaceBuild result;
    result.failed = std::move(failed);
    for (const std::size_t index : order_.order) {
      if (!built_[index]) continue;
      for (const Diagnostic& one : built_[index]->warnings) result.warnings.push_back(one);
      result.packages.push_back(std::move(*built_[index]));
    }
    for (const auto& [index, reason] : left_out_)
      if (!failed_.contains(index)) result.warnings.push_back(reason.warning);
    result.left_out = chains_by_name(packages_, left_out_);
    return result;
  }

  const std::vector<LocalPackage>& packages_;
  const BuildOrder& order_;
  const BuildTools& tools_;
  const BuildSettings& settings_;
  const Cancellation& cancellation_;
  const ProgressSink& progress_;
  std::vector<std::optional<BuiltPackage>> built_;
  std::vector<State> state_;
  std::string toolchain_hash_;
  std::string setup_reader_hash_;
  std::vector<std::size_t> sizes_;
  std::vector<std::pair<std::size_t, Diagnostics>> errors_;
  unsigned free_jobs_;                       ///< that no running package has
  std::vector<std::string> known_packages_;  ///< of channels and workspace, sorted: for advice
  LeftOutPackages left_out_;
  std::set<std::size_t> failed_;  ///< when it keeps going: packages among `left_out_`
  std::mutex mutex_;
  std::condition_variable changed_;
};

struct ToolHashes {
  std::string toolchain;
  std::string setup_reader;
};

/// The hashes of the project's own files that take part in builds.
Outcome<ToolHashes> tool_hashes(const BuildTools& tools) {
  auto toolchain = hash_of_tree(tools.toolchain.parent_path());
  if (!toolchain) return std::move(toolchain).errors();
  const auto c_messages = hash_of_tree(tools.c_messages);
  if (!c_messages) return c_messages.errors();
  auto setup_reader = tools.python_templates.empty() ? Outcome<std::string>(std::string())
                                                     : hash_of_tree(tools.python_templates);
  if (!setup_reader) return std::move(setup_reader).errors();
  return ToolHashes{.toolchain = *toolchain + *c_messages,
                    .setup_reader = *std::move(setup_reader)};
}

}  // namespace

std::optional<Diagnostic> little_room(const fs::path& cache, std::uint64_t available) {
  constexpr std::uint64_t kMegabyte = 1'000'000;
  constexpr std::uint64_t kEnough = 64 * kMegabyte;  // a program being linked takes some 10 MB
  if (available >= kEnough) return std::nullopt;
  return Diagnostic{.code = "R2W0640",
                    .kind = FailureKind::kEnvironment,
                    .message = "the disk has too little room to build: " +
                               std::to_string(available / kMegabyte) + " MB are left",
                    .why = {"packages are built in " + cache.string(),
                            "the errors that follow may come of that alone"},
                    .fix = {"free some space, or set XDG_CACHE_HOME to a folder on another disk"}};
}

Outcome<WorkspaceBuild> build_workspace(const std::vector<LocalPackage>& packages,
                                        const BuildOrder& order, const LeftOutPackages& left_out,
                                        const BuildTools& tools, const BuildSettings& settings,
                                        const Cancellation& cancellation,
                                        const ProgressSink& progress) {
  if (packages.empty()) return WorkspaceBuild{};
  const auto hashes = tool_hashes(tools);
  if (!hashes) return hashes.errors();
  return WorkspaceBuilder(packages, order, left_out, tools, hashes->toolchain, hashes->setup_reader,
                          settings, cancellation, progress)
      .run();
}

Outcome<std::vector<PlannedBuild>> plan_builds(const std::vector<LocalPackage>& packages,
                                               const BuildOrder& order,
                                               const LeftOutPackages& left_out,
                                               const BuildTools& tools,
                                               const BuildSettings& settings) {
  if (packages.empty()) return std::vector<PlannedBuild>();
  const auto hashes = tool_hashes(tools);
  if (!hashes) return hashes.errors();
  return WorkspaceBuilder(packages, order, left_out, tools, hashes->toolchain, hashes->setup_reader,
                          settings, {}, {})
      .plan();
}

std::string build_remark(const std::vector<BuiltPackage>& packages) {
  std::vector<std::string> fresh;
  for (const BuiltPackage& one : packages) {
    if (!one.from_cache) fresh.push_back(one.name);
  }
  if (fresh.empty())
    return "nothing to build: " + std::to_string(packages.size()) + " packages are as before";
  return "built " + name_list(fresh);
}

std::string warnings_remark(const std::vector<BuiltPackage>& packages) {
  std::vector<std::string> counts;
  for (const BuiltPackage& one : packages) {
    const auto count =
        std::count_if(one.warnings.begin(), one.warnings.end(),
                      [](const Diagnostic& warning) { return warning.code == kCompilerWarning; });
    if (count == 0) continue;
    counts.push_back(std::to_string(count) + " in " + one.name +
                     (one.from_cache ? " (as it was built before)" : ""));
  }
  return counts.empty() ? std::string() : "compiler warnings: " + name_list(counts);
}

}  // namespace ros2wasm
