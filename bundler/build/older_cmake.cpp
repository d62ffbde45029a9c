// See older_cmake.hpp.
#include "bundler/build/older_cmake.hpp"

#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "bundler/build/kept_work.hpp"
#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

std::vector<unsigned long> numbers_of(std::string_view version) {
  std::vector<unsigned long> result;
  std::istringstream parts{std::string(version)};
  for (std::string part; std::getline(parts, part, '.');)
    result.push_back(part.empty() || part.size() > 9 ? 0 : std::stoul(part));
  return result;
}

/// The line of a file, or nothing.
std::string line_of(const fs::path& file, std::uint32_t line) {
  const auto text = read_file(file, kMostOfText);
  if (!text) return {};
  const auto lines = output_lines(*text);
  return line == 0 || line > lines.size() ? std::string() : lines[line - 1];
}

}  // namespace

std::optional<NewerCMake> asks_for_newer_cmake(std::string_view cmake_output,
                                               const BuildPlace& place) {
  static const std::regex kPlace(R"(^CMake Error at (.+?):(\d+) \(cmake_minimum_required\):$)");
  static const std::regex kAsked(
      R"(^\s*CMake (\d[\d.]*) or higher is required\.\s+You are running version (\d[\d.]*\d).*$)");
  BuildPlace below = place;  // what is kept must not depend on how the folder was named
  below.display.clear();
  const auto lines = output_lines(cmake_output);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    std::smatch at;
    std::smatch asked;
    if (lines[i].size() > 4000 || lines[i + 1].size() > 4000 ||
        !std::regex_match(lines[i], at, kPlace) || !std::regex_match(lines[i + 1], asked, kAsked))
      continue;
    const fs::path named(at[1].str());
    const fs::path file = named.is_absolute() ? named : place.source / named;
    const auto line = static_cast<std::uint32_t>(std::stoul(at[2]));
    Diagnostic warning{
        .code = "R2W0529",
        .severity = Severity::kWarning,
        .message = "package `" + place.package + "` asks for CMake " + asked[1].str() +
                   ", which is newer than the one on this machine",
        .span = SourceSpan{.file = display_file(file.string(), below),
                           .line = line,
                           .column = 1,
                           .length = std::string_view("cmake_minimum_required").size(),
                           .line_text = line_of(file, line)},
        .why = {"it was configured as far as the older one can; commands and policies that came "
                "later are unknown to it"}};
    return NewerCMake{.warning = std::move(warning), .there = asked[2]};
  }
  return std::nullopt;
}

std::string for_older_cmake(std::string text, std::string_view there) {
  static const std::regex kAsked(R"((cmake_minimum_required\s*\(\s*VERSION\s+)(\d+(?:\.\d+)*))",
                                 std::regex::icase);
  std::string result;
  std::smatch match;
  while (std::regex_search(text, match, kAsked)) {
    const std::string asked = match[2];
    const bool is_newer = numbers_of(asked) > numbers_of(there);
    result += match.prefix().str() + match[1].str() + (is_newer ? std::string(there) : asked);
    text = match.suffix().str();
  }
  return result + text;
}

Outcome<fs::path> copy_for_older_cmake(const fs::path& work, const fs::path& source,
                                       std::string_view there) {
  const auto files = seen_sources(work);
  if (!files) return files.errors();
  const fs::path folder = work.parent_path() / ("older-cmake-" + work.filename().string());
  std::set<fs::path> copied;
  std::error_code error;
  for (const SeenSource& file : *files) {
    auto bytes = read_file(source / file.path, kMostOfData);
    if (!bytes) return std::move(bytes).errors();
    const fs::path path(file.path);
    if (path.filename() == "CMakeLists.txt" || path.extension() == ".cmake")
      *bytes = for_older_cmake(std::move(*bytes), there);
    if (auto done = write_file(folder / path, *bytes); !done) return std::move(done).errors();
    fs::permissions(folder / path, fs::status(source / path, error).permissions(), error);
    copied.insert(folder / path);
  }
  std::vector<fs::path> gone;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    std::error_code ignored;
    if (!it->is_directory(ignored) && !copied.contains(it->path())) gone.push_back(it->path());
  }
  for (const fs::path& file : gone) fs::remove(file, error);
  return folder;
}

}  // namespace ros2wasm
