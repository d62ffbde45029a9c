// See older_cmake.hpp.
#include "bundler/build/older_cmake.hpp"

#include <algorithm>
#include <regex>
#include <sstream>
#include <vector>

#include "bundler/build/cached_work.hpp"
#include "bundler/io/files.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

std::vector<std::uint32_t> numbers_of(std::string_view version) {
  std::vector<std::uint32_t> result;
  std::istringstream parts{std::string(version)};
  for (std::string part; std::getline(parts, part, '.');) result.push_back(printed_number(part));
  return result;
}

/// The line of a file, or nothing.
std::string line_of(const fs::path& file, std::uint32_t line) {
  const auto text = read_file(file, kMostOfText);
  if (!text) return {};
  const auto lines = output_lines(*text);
  return line == 0 || line > lines.size() ? std::string() : lines[line - 1];
}

/// With the times of the source, so that ninja builds what has changed. Files of CMake ask for
/// less.
Outcome<Done> copy_one(const fs::path& from, const fs::path& to, std::string_view there) {
  std::error_code error;
  if (from.filename() == "CMakeLists.txt" || from.extension() == ".cmake") {
    const auto text = read_file(from, kMostOfText);
    if (!text) return text.errors();
    if (auto done = write_file(to, for_older_cmake(*text, there)); !done) return done;
  } else {
    fs::create_directories(to.parent_path(), error);
    fs::copy_file(from, to, error);
    if (error)
      return Diagnostic{.code = "R2W0211",
                        .kind = FailureKind::kEnvironment,
                        .message = "cannot write `" + to.string() + "`: " + error.message()};
  }
  fs::permissions(to, fs::status(from, error).permissions(), error);
  const auto time = fs::last_write_time(from, error);
  if (!error) fs::last_write_time(to, time, error);
  return Done{};
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
    const auto line = printed_number(at[2].str());
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

std::string for_older_cmake(const std::string& text, std::string_view there) {
  constexpr std::string_view kCommand = "cmake_minimum_required";
  constexpr std::string_view kVersion = "version";
  const std::string lower = ascii_lower(text);
  const auto newest = numbers_of(there);
  const auto after_blanks = [&](std::size_t from) {
    return std::min(lower.find_first_not_of(" \t\r\n", from), lower.size());
  };
  std::string result;
  std::size_t copied = 0;
  for (std::size_t at = lower.find(kCommand); at != std::string::npos;
       at = lower.find(kCommand, at)) {
    at = after_blanks(at + kCommand.size());
    if (at == lower.size() || lower[at] != '(') continue;
    at = after_blanks(at + 1);
    if (lower.compare(at, kVersion.size(), kVersion) != 0) continue;
    const std::size_t begin = after_blanks(at + kVersion.size());
    const std::size_t behind =
        std::min(lower.find_first_not_of("0123456789.", begin), lower.size());
    // The lower end of a range, `3.8...3.28`.
    const std::size_t length = std::string_view(lower).substr(begin, behind - begin).find("...");
    const std::size_t end =
        std::min(behind, length == std::string_view::npos ? behind : begin + length);
    at = end;
    if (begin == end || numbers_of(lower.substr(begin, end - begin)) <= newest) continue;
    result.append(text, copied, begin - copied).append(there);
    copied = end;
  }
  return result.append(text, copied);
}

Outcome<fs::path> copy_for_older_cmake(const fs::path& work, const fs::path& source,
                                       std::string_view there) {
  const auto files = seen_sources(work);
  if (!files) return files.errors();
  const fs::path folder = work.parent_path() / ("older-cmake-" + work.filename().string());
  std::error_code error;
  fs::remove_all(folder, error);
  for (const SeenSource& file : *files) {
    if (auto done = copy_one(source / file.path, folder / file.path, there); !done)
      return std::move(done).errors();
  }
  return folder;
}

}  // namespace ros2wasm
