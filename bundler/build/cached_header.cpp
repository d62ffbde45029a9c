// See cached_header.hpp.
#include "bundler/build/cached_header.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>
#include <string_view>

#include "bundler/build/direct_compile.hpp"
#include "bundler/io/file_lock.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Raise it when a header is compiled otherwise.
constexpr std::string_view kFormat = "2";
/// Headers that stand before those of the compiler in every compilation.
constexpr std::string_view kLibraryParts = "ros2wasm_std";
constexpr std::string_view kHeaderName = "rclcpp/rclcpp.hpp";
constexpr std::string_view kHeaderPackage = "rclcpp";
constexpr int kDeepestInclude = 32;

constexpr std::array<std::string_view, 4> kSourceEndings = {".cpp", ".cc", ".cxx", ".C"};
/// They say where things go.
constexpr std::array<std::string_view, 4> kSkippedPairs = {"-o", "-MT", "-MF", "-MQ"};
constexpr std::array<std::string_view, 3> kSkippedFlags = {"-c", "-MD", "-MMD"};
constexpr std::array<std::string_view, 4> kForeign = {"-x", "-include-pch", "-E", "-S"};

template <std::size_t N>
bool is_one_of(std::string_view text, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

/// Macros by which a library tells its own sources from its users': no header of ours asks for
/// them.
bool is_of_library(std::string_view define) {
  const std::string_view name = define.substr(2, define.find('=') - 2);
  return name == "CLASS_LOADER_LIBRARY" || name.ends_with("_DLL") || name.ends_with("_EXPORTS") ||
         name.ends_with("_BUILDING_LIBRARY");
}

bool is_below(const fs::path& path, const fs::path& folder) {
  const auto end = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end.first == folder.end();
}

enum class Beginning { kHeader, kOther, kOpen };

/// Reads a source and its own headers up to the header: only includes may stand before it.
class Scan {
 public:
  explicit Scan(const std::vector<fs::path>& folders) : folders_(folders) {}

  Beginning of(const fs::path& file, int depth) {
    const auto text = read_file(file, kMostOfData);
    if (!text || depth > kDeepestInclude) return Beginning::kOther;
    std::istringstream lines(*text);
    bool in_comment = false;
    std::string guard;
    bool first = true;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(without_comments(line, in_comment));
      std::string name;
      const int character = (words >> std::ws).get();
      if (character == std::istringstream::traits_type::eof()) continue;
      if (character != '#') return Beginning::kOther;
      if (!(words >> name)) continue;
      std::string rest;
      std::getline(words >> std::ws, rest);
      while (!rest.empty() && (rest.back() == ' ' || rest.back() == '\t' || rest.back() == '\r'))
        rest.pop_back();
      if (name.starts_with("include") && name.size() > 7) {
        rest = name.substr(7) + rest;
        name = "include";
      }
      if (name == "include") {
        const Beginning inner = of_include(rest, file, depth);
        if (inner != Beginning::kOpen) return inner;
      } else if (name == "ifndef" && first) {
        guard = rest;
      } else if (!(name == "define" && !guard.empty() && rest == guard) &&
                 !(name == "pragma" && rest == "once") && name != "endif") {
        return Beginning::kOther;
      }
      first = false;
    }
    return Beginning::kOpen;
  }

 private:
  static std::string without_comments(std::string_view line, bool& in_comment) {
    std::string result;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string_view two = line.substr(i, 2);
      if (in_comment) {
        if (two == "*/") {
          in_comment = false;
          ++i;
        }
      } else if (two == "/*") {
        in_comment = true;
        ++i;
      } else if (two == "//") {
        break;
      } else {
        result += line[i];
      }
    }
    return result;
  }

  Beginning of_include(std::string_view rest, const fs::path& from, int depth) {
    const bool quoted = rest.starts_with('"');
    if (rest.size() < 3 || (!quoted && !rest.starts_with('<'))) return Beginning::kOther;
    const std::size_t end = rest.find(quoted ? '"' : '>', 1);
    if (end == std::string_view::npos) return Beginning::kOther;
    const std::string_view name = rest.substr(1, end - 1);
    if (name == kHeaderName) return Beginning::kHeader;
    std::vector<fs::path> folders = folders_;
    if (quoted) folders.insert(folders.begin(), from.parent_path());
    for (const fs::path& folder : folders) {
      std::error_code error;
      const fs::path file = (folder / name).lexically_normal();
      if (!fs::is_regular_file(file, error)) continue;
      return seen_.insert(file).second ? of(file, depth + 1) : Beginning::kOpen;
    }
    return Beginning::kOpen;  // of the system or of a package
  }

  const std::vector<fs::path>& folders_;
  std::set<fs::path> seen_;
};

bool has_files(const fs::path& folder) {
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  return error || std::any_of(begin(entries), end(entries), [](const fs::directory_entry& entry) {
           std::error_code ignored;
           return !entry.is_directory(ignored);
         });
}

/// The include folders of the library's parts and of the packages, these sorted. Nothing when one
/// of a source's own folders stands before one of them.
std::optional<std::vector<fs::path>> package_folders(const HeaderUse& use) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (fs::directory_iterator it(use.packages, error), end; !error && it != end;
       it.increment(error)) {
    for (const fs::path& own : use.own_folders) {
      std::error_code ignored;
      if (fs::exists(own / it->path().filename(), ignored)) return std::nullopt;
    }
    // A ROS package's headers lie one folder deeper; those of others might hide the system's.
    if (!has_files(it->path())) folders.push_back(it->path());
  }
  if (error) return std::nullopt;
  std::sort(folders.begin(), folders.end());
  const fs::path parts = use.packages / kLibraryParts;
  if (fs::exists(parts, error)) folders.insert(folders.begin(), parts);
  return folders;
}

Outcome<ProcessResult> run_compiler(const SourceCompilation& compilation,
                                    std::vector<std::string> command,
                                    const std::vector<std::string>& more,
                                    const Cancellation& cancellation) {
  command.insert(command.begin() + 1, more.begin(), more.end());
  return run_process({.arguments = direct_compile_command(command, compilation.tool_calls,
                                                          compilation.environment, cancellation),
                      .environment = compilation.environment},
                     cancellation);
}

/// The compiled header, made when it is not there yet. Nothing when it cannot be made, or when
/// another process is making it: then this source is compiled meanwhile.
std::optional<fs::path> compiled_header(const HeaderUse& use, const SourceCompilation& compilation,
                                        const Cancellation& cancellation) {
  const auto folders = package_folders(use);
  if (!folders) return std::nullopt;
  std::vector<std::string> flags = use.flags;
  for (const fs::path& folder : *folders) {
    flags.emplace_back("-isystem");
    flags.push_back(folder.string());
  }
  std::string key = std::string(kFormat) + "\n";
  for (const std::string& flag : flags) key += flag + "\n";
  const fs::path stem = compilation.kept / sha256_hex(key).substr(0, 32);
  const auto named = [&](const char* ending) { return fs::path(stem.string() + ending); };
  const fs::path compiled = named(".pch");
  std::error_code error;
  if (fs::exists(compiled, error)) return compiled;
  if (fs::exists(named(".failed"), error)) return std::nullopt;

  if (!make_directories(compilation.kept)) return std::nullopt;
  const auto lock = FileLock::try_take(named(".lock"));
  if (!lock) return std::nullopt;
  if (fs::exists(compiled, error)) return compiled;
  const fs::path source = named(".hpp");
  if (!write_file(source, "#include \"" + std::string(kHeaderName) + "\"\n")) return std::nullopt;
  const fs::path part = named(".part");
  // Templates of the header, too: without them it saves half as much.
  flags.insert(flags.end(), {"-Xclang", "-fpch-instantiate-templates", "-x", "c++-header",
                             source.string(), "-o", part.string()});
  const auto made = run_compiler(compilation, {compilation.command.front()}, flags, cancellation);
  if (made && made->exit_code == 0) {
    fs::rename(part, compiled, error);
    return error ? std::nullopt : std::optional(compiled);
  }
  fs::remove(part, error);
  // Remember the failure only when the source is the reason. A lack of memory or of disk space may
  // be over next time.
  const bool says_why = made && made->exit_code < 128 &&
                        made->output.find("error: ") != std::string::npos &&
                        made->output.find("No space left") == std::string::npos;
  if (says_why) (void)write_file(named(".failed"), made->output);
  return std::nullopt;
}

}  // namespace

std::optional<HeaderUse> header_use(const std::vector<std::string>& command) {
  HeaderUse use;
  std::vector<fs::path> folders;
  for (std::size_t i = 1; i < command.size(); ++i) {
    const std::string& argument = command[i];
    const bool has_next = i + 1 < command.size();
    if (is_one_of(argument, kForeign) || argument.starts_with('@')) return std::nullopt;
    if (is_one_of(argument, kSkippedPairs) && has_next) {
      ++i;
    } else if ((argument == "-I" || argument == "-isystem" || argument == "-iquote") && has_next) {
      folders.emplace_back(command[++i]);
    } else if (argument.starts_with("-I")) {
      folders.emplace_back(argument.substr(2));
    } else if (argument.starts_with("-D") && is_of_library(argument)) {
      continue;
    } else if (argument == "-include" && has_next) {
      // A relative name may mean a different file in another folder.
      if (fs::path(command[i + 1]).is_relative()) return std::nullopt;
      use.flags.push_back(argument);
      use.flags.push_back(command[++i]);
    } else if (!argument.starts_with('-')) {
      if (!use.source.empty()) return std::nullopt;
      use.source = argument;
    } else if (!is_one_of(argument, kSkippedFlags) && !argument.starts_with("-ffile-prefix-map=")) {
      use.flags.push_back(argument);
    }
  }
  const bool compiles = std::find(command.begin(), command.end(), "-c") != command.end();
  if (!compiles || !is_one_of(use.source.extension().string(), kSourceEndings)) return std::nullopt;
  for (const fs::path& folder : folders) {
    std::error_code error;
    if (folder.filename() == kHeaderPackage && fs::exists(folder / kHeaderName, error))
      use.packages = folder.parent_path();
  }
  if (use.packages.empty()) return std::nullopt;
  std::copy_if(folders.begin(), folders.end(), std::back_inserter(use.own_folders),
               [&](const fs::path& folder) { return !is_below(folder, use.packages); });
  return use;
}

bool begins_with_header(const HeaderUse& use) {
  return Scan(use.own_folders).of(use.source, 0) == Beginning::kHeader;
}

fs::path kept_headers_folder(const fs::path& build_cache, const Compiler& compiler) {
  return build_cache / "headers" / sha256_hex(compiler.identity).substr(0, 16);
}

Outcome<ProcessResult> compile_source(const SourceCompilation& compilation,
                                      const Cancellation& cancellation) {
  const auto use = compilation.kept.empty() ? std::nullopt : header_use(compilation.command);
  const auto header = use && begins_with_header(*use)
                          ? compiled_header(*use, compilation, cancellation)
                          : std::nullopt;
  if (header) {
    auto quick = run_compiler(compilation, compilation.command, {"-include-pch", header->string()},
                              cancellation);
    if (!quick || quick->exit_code == 0) return quick;
  }
  // Compile again without the cached header, so that messages are the same as without a cache.
  auto plain = run_compiler(compilation, compilation.command, {}, cancellation);
  if (header && plain && plain->exit_code == 0) {
    std::error_code ignored;
    fs::remove(*header, ignored);
  }
  if (plain) plain->output += said_of_signal(*plain);
  return plain;
}

}  // namespace ros2wasm
