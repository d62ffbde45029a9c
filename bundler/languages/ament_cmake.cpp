// C and C++ packages: cmake configures, ninja compiles, cmake installs, all through the site's
// toolchain.
#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

#include "bundler/build/cached_configure.hpp"
#include "bundler/build/cached_header.hpp"
#include "bundler/build/compiler_warnings.hpp"
#include "bundler/build/diagnostic_json.hpp"
#include "bundler/build/link_driver.hpp"
#include "bundler/build/link_kit.hpp"
#include "bundler/build/link_trace.hpp"
#include "bundler/build/missing_headers.hpp"
#include "bundler/build/older_cmake.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/process.hpp"
#include "bundler/languages/c_messages.hpp"
#include "bundler/languages/language.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/replaced_text.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kLinkDiagnostics = "link-diagnostics";
constexpr const char* kConfigureFindings = "configure-findings.json";  ///< of the last configure

std::string joined(const std::vector<fs::path>& paths) {
  std::string result;
  for (const fs::path& path : paths) result += (result.empty() ? "" : ";") + path.string();
  return result;
}

Outcome<Done> missing_tool(const std::string& name, const std::string& debian_package) {
  return Diagnostic{.code = "R2W0501",
                    .kind = FailureKind::kEnvironment,
                    .message = "`" + name + "`, which builds packages, is not installed",
                    .why = {"there is no `" + name + "` on PATH"},
                    .fix = {"sudo apt-get install " + debian_package}};
}

EnvironmentVariables child_environment(const PackageBuild& request, const BuildTools& tools) {
  EnvironmentVariables result = tools.compiler_environment;
  result["NINJA_STATUS"] = "[%f/%t] ";
  // Generators are Python files of the environment, which other packs use and whose files are
  // checked against its seal, and of the user's sources: nothing is written beside them.
  result["PYTHONDONTWRITEBYTECODE"] = "1";
  result["ROS2WASM_LINK_DIAGNOSTICS"] = (request.work / kLinkDiagnostics).string();
  result[kChannelPrefixVariable] = request.channel_prefix.string();
  result[kLinkKitsVariable] = (request.work / kLinkKits).string();
  result[kToolCallsVariable] = tools.tool_calls.string();
  result[kQuickLinkVariable] = tools.quick ? "1" : "";
  result[kKeptHeadersVariable] = tools.kept_headers.string();
  // A native ROS installation that was sourced must not leak its packages in, nor what other
  // builds want of their compilers: the site has to be the same for everybody.
  for (const char* name :
       {"AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH", "COLCON_PREFIX_PATH", "CFLAGS", "CXXFLAGS",
        "CPPFLAGS", "LDFLAGS", "CPATH", "C_INCLUDE_PATH", "CPLUS_INCLUDE_PATH", "LIBRARY_PATH",
        "EMCC_CFLAGS", "CMAKE_GENERATOR", "CMAKE_CONFIGURATION_TYPES", "DESTDIR"}) {
    result[name] = "";
  }
  result["EMCC_DEBUG"] = "0";
  result["CMAKE_BUILD_TYPE"] = "Release";  // as the toolchain file has it
  result["LC_ALL"] = "C.UTF-8";
  return result;
}

/// Tool output with the sources where they are, not where the copy of them is that CMake read:
/// `read` is the folder that configure() gave.
std::string with_own_paths(std::string_view output, const PackageBuild& request,
                           const fs::path& read) {
  return read == request.place.source
             ? std::string(output)
             : with_replaced(output, read.string(), request.place.source.string());
}

/// Tool output for people: the folder where it was built is of no use to them, and differs from run
/// to run.
std::string for_people(std::string_view output, const PackageBuild& request, const fs::path& read) {
  std::string text =
      with_replaced(with_own_paths(output, request, read), request.work.string(), "<build>");
  constexpr std::string_view kNoise =
      "Not searching for unused variables given on the command line.\n";
  const std::size_t noise = text.find(kNoise);
  if (noise != std::string::npos) text.erase(noise, kNoise.size());
  return text;
}

/// Turns "[3/7] Building ..." lines into progress, and counts the warnings between them. Output
/// comes in pieces.
class NinjaProgress {
 public:
  NinjaProgress(const BuildPlace& place, const ProgressSink& sink) : place_(place), sink_(sink) {}

  void operator()(std::string_view piece) {
    if (!sink_) return;
    pending_.append(piece);
    for (std::size_t end = 0; (end = pending_.find('\n')) != std::string::npos;) {
      report(std::string_view(pending_).substr(0, end));
      pending_.erase(0, end + 1);
    }
  }

 private:
  void report(std::string_view line) {
    if (line.find(": warning: ") != line.npos)
      for (const Diagnostic& one : compiler_warnings(line, place_))
        warnings_.insert(one.span->file + ":" + std::to_string(one.span->line) + one.message);
    if (!line.starts_with('[')) return;
    std::uint64_t done = 0;
    std::uint64_t total = 0;
    const char* end = line.data() + line.size();
    const auto first = std::from_chars(line.data() + 1, end, done);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != '/') return;
    const auto second = std::from_chars(first.ptr + 1, end, total);
    if (second.ec != std::errc() || total == 0) return;
    // The step as a whole ends elsewhere, so a package never reports that all is done.
    sink_({.step = "build",
           .item = place_.package,
           .done = std::min(done, total - 1),
           .total = total,
           .unit = "commands",
           .warnings = warnings_.size()});
  }

  const BuildPlace& place_;
  std::set<std::string> warnings_;  ///< each once
  const ProgressSink& sink_;
  std::string pending_;
};

/// The output of a tool, and a line when a signal ended it: then the output may be empty.
std::string told(const ProcessResult& result, const PackageBuild& request, const fs::path& read) {
  return for_people(result.output, request, read) + said_of_signal(result);
}

std::vector<std::string> configure_arguments(const PackageBuild& request, const BuildTools& tools,
                                             const fs::path& from,
                                             const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {
      "cmake", "-S", from.string(), "-B", request.work.string(), "-G", "Ninja", "-Wno-dev",
      "--no-warn-unused-cli",
      // cached_configure.hpp says when; times of files may lie.
      "-DCMAKE_SUPPRESS_REGENERATION=ON", "-DCMAKE_TOOLCHAIN_FILE=" + tools.toolchain.string(),
      "-DCMAKE_PREFIX_PATH=" + joined(request.prefixes), "-DROS2WASM_CLI=" + tools.cli.string(),
      "-DROS2WASM_EMCXX=" + tools.compiler.cxx.string(),
      "-DROS2WASM_EMCC=" + tools.compiler.c.string()};
  if (!tools.kept_headers.empty()) {
    arguments.push_back("-DCMAKE_CXX_COMPILER_LAUNCHER=" + tools.cli.string() +
                        ";compile-source;--");
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Unless the last one would be the same. `from`: the package's folder or a copy of it; `more`:
/// arguments besides. The result is the folder that CMake read: of a package that asks for a newer
/// CMake, a copy that is configured as far as this one can (older_cmake.hpp).
Outcome<fs::path> configure(const PackageBuild& request, const BuildTools& tools,
                            const fs::path& from, const Cancellation& cancellation,
                            const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = configure_arguments(request, tools, from, more);
  std::vector<std::string> inputs = arguments;
  const auto c_messages = included_c_messages(request);
  if (!c_messages) return c_messages.errors();
  inputs.insert(inputs.end(), c_messages->begin(), c_messages->end());
  // Where CMake looks for programs.
  if (const auto path = tools.tool_environment.find("PATH"); path != tools.tool_environment.end())
    inputs.push_back(path->second);
  const auto key = configure_key(request.work, from, inputs);
  if (!key) return key.errors();
  if (reuse_configure(request.work, *key, request.final_prefix)) return from;
  arguments.push_back("-DCMAKE_INSTALL_PREFIX=" + request.final_prefix.string());
  if (!c_messages->empty()) {
    if (auto made = make_c_messages(*c_messages, request, tools, cancellation); !made)
      return std::move(made).errors();
    for (const char* language : {"C", "CXX"})
      arguments.push_back("-DCMAKE_" + std::string(language) +
                          "_STANDARD_INCLUDE_DIRECTORIES=" + c_messages_folder(request).string());
    if (has_own_c_messages(*c_messages, request))
      arguments.push_back("-DCMAKE_PROJECT_" + request.place.package +
                          "_INCLUDE=" + (tools.c_messages / "own_messages.cmake").string());
  }
  std::error_code ignored;
  fs::remove(request.work / "CMakeCache.txt", ignored);  // what it found may have moved
  const auto result = run_process({.arguments = std::move(arguments),
                                   .environment = child_environment(request, tools),
                                   .directory = request.work},
                                  cancellation);
  if (!result) return result.errors();
  if (result->exit_code == 0) {
    if (auto kept = keep_configure(request.work, *key, request.final_prefix); !kept)
      return std::move(kept).errors();
    return from;
  }
  const std::string output = told(*result, request, from);
  const bool is_copy = from != request.place.source;
  const auto newer = is_copy ? std::nullopt : asks_for_newer_cmake(output, request.place);
  if (!newer) return configure_errors(output, request.place);
  auto copy = copy_for_older_cmake(request.work, request.place.source, newer->there);
  if (!copy) return std::move(copy).errors();
  auto read = configure(request, tools, *copy, cancellation, more);
  if (read) {
    auto written =
        write_file(request.work / kConfigureFindings, diagnostics_to_json({newer->warning}));
    if (!written) return std::move(written).errors();
    return read;
  }
  Diagnostics errors = std::move(read).errors();
  for (Diagnostic& one : errors) one.why.push_back(newer->warning.message);
  return errors;
}

/// The findings that the link driver wrote, in the order of the files' names.
std::vector<LinkFindings> link_findings(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  std::vector<LinkFindings> result;
  for (const fs::path& file : files) {
    if (const auto text = read_file(file, kMostOfList))
      result.push_back(link_findings_from_json(*text));
  }
  return result;
}

/// The headers that are all the output complains of, if nobody has them.
std::vector<MissingHeader> headers_of_nobody(std::string_view ninja_output,
                                             const PackageBuild& request) {
  auto missing = missing_headers(ninja_output, request.place);
  if (!missing || std::any_of(missing->begin(), missing->end(), [&](const MissingHeader& one) {
        return is_given(one, request.place, request.prefixes);
      }))
    return {};
  return std::move(*missing);
}

/// The needs of programs of a package that no site can meet.
struct ProgramLacks {
  std::vector<MissingHeader> headers;
  std::vector<LinkFindings> limits;  ///< each with R2W0523 alone, and warnings
};

/// The lacks, when nothing else is wrong with the package; else nothing.
std::optional<ProgramLacks> lacks_of(std::string_view ninja_output, bool has_compile_errors,
                                     const std::vector<LinkFindings>& links,
                                     const PackageBuild& request) {
  ProgramLacks result;
  if (has_compile_errors) {
    result.headers = headers_of_nobody(ninja_output, request);
    if (result.headers.empty()) return std::nullopt;
  }
  for (const LinkFindings& link : links) {
    const bool only_limits =
        std::all_of(link.diagnostics.begin(), link.diagnostics.end(), [](const Diagnostic& one) {
          return one.severity != Severity::kError || one.code == "R2W0523";
        });
    if (!only_limits) return std::nullopt;
    if (has_error(link.diagnostics)) result.limits.push_back(link);
  }
  return result;
}

/// Stores the findings of the commands of this run and of earlier runs for the package.
Outcome<Done> remember_findings(std::string_view ninja_output,
                                const std::vector<LinkFindings>& links,
                                const PackageBuild& request) {
  CommandFindings fresh = command_findings(ninja_output, request.place);
  for (const LinkFindings& link : links)
    for (const Diagnostic& one : link.diagnostics)
      if (one.severity != Severity::kError) fresh[link.output].push_back(one);
  const auto build = read_file(request.work / "build.ninja", kMostOfList);
  if (!build) return build.errors();
  return write_command_findings(request.work, current_findings(read_command_findings(request.work),
                                                               std::move(fresh), *build));
}

/// `read`: the folder that configure() gave. `lacks` becomes what is the only reason of its
/// failure.
Outcome<Done> compile(const PackageBuild& request, const BuildTools& tools, const fs::path& read,
                      const Cancellation& cancellation, const ProgressSink& progress,
                      std::optional<ProgramLacks>& lacks) {
  if (auto cleared = remove_tree(request.work / kLinkDiagnostics); !cleared) return cleared;
  const auto result = run_process({.arguments = {"ninja", "-C", request.work.string(), "-k", "0",
                                                 "-j", std::to_string(request.jobs)},
                                   .environment = child_environment(request, tools),
                                   .on_output = NinjaProgress(request.place, progress)},
                                  cancellation);
  if (!result) return result.errors();
  const auto links = link_findings(request.work / kLinkDiagnostics);
  if (auto kept = remember_findings(with_own_paths(result->output, request, read), links, request);
      !kept)
    return kept;
  if (result->exit_code == 0) return Done{};
  const std::string output = told(*result, request, read);
  Diagnostics errors = compile_errors(output, request.place);
  const bool has_compile_errors = !errors.empty();
  for (const LinkFindings& link : links)
    for (const Diagnostic& one : link.diagnostics)
      if (one.severity == Severity::kError) errors.push_back(one);
  if (errors.empty()) {
    errors.push_back(
        Diagnostic{.code = "R2W0506",
                   .message = "ninja failed for package `" + request.place.package + "`",
                   .detail = output});
  } else {
    lacks = lacks_of(output, has_compile_errors, links, request);
  }
  return errors;
}

Outcome<Done> install(const PackageBuild& request, const BuildTools& tools, const fs::path& read,
                      const Cancellation& cancellation) {
  const auto result = run_process({.arguments = {"cmake", "--install", request.work.string(),
                                                 "--prefix", request.install.string()},
                                   .environment = child_environment(request, tools),
                                   .directory = request.work},
                                  cancellation);
  if (!result) return result.errors();
  if (result->exit_code == 0) return Done{};
  return Diagnostic{.code = "R2W0508",
                    .message = "package `" + request.place.package + "` does not install",
                    .detail = told(*result, request, read)};
}

/// With the package: what was said of it, and which programs are not in it.
Outcome<Done> keep_all_findings(const PackageBuild& request, const ProgramLacks& lacks) {
  Diagnostics findings;
  for (const LinkFindings& link : lacks.limits)
    for (const Diagnostic& one : link.diagnostics)
      if (one.severity == Severity::kError) findings.push_back(left_out_for_limit(one));
  std::error_code error;
  if (fs::exists(request.work / kConfigureFindings, error)) {
    const auto text = read_file(request.work / kConfigureFindings, kMostOfList);
    if (!text) return text.errors();
    append(findings, diagnostics_from_json(*text));
  }
  append(findings, all_findings(read_command_findings(request.work)));
  if (auto kept = keep_findings(request.install, findings); !kept) return kept;
  if (lacks.headers.empty()) return Done{};
  return write_missing_headers(request.install, lacks.headers);
}

/// The package without the programs that lack something. Fails when they are not programs, or all.
Outcome<Done> build_without(ProgramLacks lacks, const PackageBuild& request,
                            const BuildTools& tools, const fs::path& from,
                            const Cancellation& cancellation, const ProgressSink& progress) {
  std::string lines = left_out_script(lacks.headers);
  for (const LinkFindings& link : lacks.limits) {
    const auto limit =
        std::find_if(link.diagnostics.begin(), link.diagnostics.end(),
                     [](const Diagnostic& one) { return one.severity == Severity::kError; });
    lines += left_out_line(link.program, need_of(*limit));
  }
  const fs::path script = request.work / "missing_headers.cmake";
  if (auto done = write_file(script, lines); !done) return done;
  const auto read = configure(request, tools, from, cancellation,
                              {"-DROS2WASM_MISSING_HEADERS=" + script.string()});
  if (!read) return read.errors();
  std::optional<ProgramLacks> still_lacking;
  auto done = compile(request, tools, *read, cancellation, progress, still_lacking);
  if (!done) return done;
  done = install(request, tools, *read, cancellation);
  if (!done) return done;
  return keep_all_findings(request, lacks);
}

}  // namespace

Outcome<Done> build_with_cmake(const PackageBuild& request, const BuildTools& tools,
                               const Cancellation& cancellation, const ProgressSink& progress) {
  if (!find_program("cmake")) return missing_tool("cmake", "cmake");
  if (!find_program("ninja")) return missing_tool("ninja", "ninja-build");
  std::error_code ignored;
  fs::remove(request.work / kConfigureFindings, ignored);  // of the configure that follows
  const auto read = configure(request, tools, request.place.source, cancellation);
  if (!read) return read.errors();
  std::optional<ProgramLacks> lacks;
  if (auto compiled = compile(request, tools, *read, cancellation, progress, lacks); !compiled) {
    forget_configure(request.work);
    const bool is_rest_built =
        lacks && build_without(std::move(*lacks), request, tools, *read, cancellation, progress);
    return is_rest_built ? Outcome<Done>(Done{}) : compiled;
  }
  if (auto installed = install(request, tools, *read, cancellation); !installed) return installed;
  return keep_all_findings(request, {});
}

}  // namespace ros2wasm
