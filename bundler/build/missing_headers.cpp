// See missing_headers.hpp.
#include "bundler/build/missing_headers.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

#include "bundler/build/browser_limits.hpp"
#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// The package whose header it is by name, if it has a folder.
std::string first_folder(const std::string& header) {
  const std::size_t end = header.find('/');
  return end == std::string::npos ? std::string() : header.substr(0, end);
}

bool is_of_known_package(const std::string& header, const BuildPlace& place) {
  const auto& known = place.channel_packages;
  const std::string folder = first_folder(header);
  return folder == place.package || std::binary_search(known.begin(), known.end(), folder);
}

std::optional<MissingHeader> missing_header(const FailedCommand& failed, const BuildPlace& place) {
  static const std::regex kTarget(R"((?:^|/)CMakeFiles/([^/]+)\.dir/.*\.o$)");
  static const std::regex kHeader(R"(^'([^'\t]+)' file not found$)");
  std::smatch target;
  std::smatch header;
  if (!std::regex_search(failed.output_file, target, kTarget)) return std::nullopt;
  BuildPlace below = place;  // what is kept must not depend on how the folder was named
  below.display.clear();
  const auto errors = compiler_messages(failed.text, below);
  if (errors.size() != 1 || !std::regex_match(errors.front().message, header, kHeader))
    return std::nullopt;
  return MissingHeader{.target = target[1], .header = header[1], .place = *errors.front().span};
}

/// As CMake's quoted text without expansions.
std::string bracketed(const std::string& text) {
  return "[====[" + text + "]====]";
}

}  // namespace

std::optional<std::vector<MissingHeader>> missing_headers(std::string_view ninja_output,
                                                          const BuildPlace& place) {
  std::vector<MissingHeader> result;
  for (const FailedCommand& failed : failed_commands(ninja_output)) {
    if (is_link(failed)) continue;
    auto one = missing_header(failed, place);
    if (!one) return std::nullopt;
    result.push_back(std::move(*one));
  }
  if (result.empty()) return std::nullopt;
  return result;
}

bool is_given(const MissingHeader& missing, const BuildPlace& place,
              const std::vector<fs::path>& prefixes) {
  const std::string& header = missing.header;
  if (header.starts_with('.') || is_of_known_package(header, place)) return true;
  std::error_code error;
  for (const fs::path& prefix : prefixes) {
    if (fs::exists(prefix / "include" / header, error)) return true;
    for (fs::directory_iterator it(prefix / "include", error), end; !error && it != end;
         it.increment(error)) {
      std::error_code ignored;
      if (fs::exists(it->path() / header, ignored)) return true;
    }
  }
  for (fs::recursive_directory_iterator it(place.source, error), end; !error && it != end;
       it.increment(error)) {
    if (it->path().generic_string().ends_with("/" + header)) return true;
  }
  return false;
}

std::string left_out_line(const std::string& target, const std::string& need) {
  return "ros2wasm_lacks_header(" + bracketed(target) + " " + bracketed(need) + ")\n";
}

std::string left_out_script(const std::vector<MissingHeader>& missing) {
  std::string result;
  for (const MissingHeader& one : missing) {
    result += left_out_line(one.target, "the header `" + one.header + "` (" + one.place.file + ":" +
                                            std::to_string(one.place.line) + ")");
  }
  return result;
}

Outcome<Done> write_missing_headers(const fs::path& prefix,
                                    const std::vector<MissingHeader>& missing) {
  std::string text;
  for (const MissingHeader& one : missing) {
    text += one.target + "\t" + one.header + "\t" + one.place.file + "\t" +
            std::to_string(one.place.line) + "\t" + std::to_string(one.place.column) + "\t" +
            one.place.line_text + "\n";
  }
  return write_file(prefix / kMissingHeaders, text);
}

Diagnostics left_out_programs(const fs::path& prefix, const BuildPlace& place) {
  std::error_code error;
  if (!fs::exists(prefix / kMissingHeaders, error)) return {};
  const auto text = read_file(prefix / kMissingHeaders, kMostOfList);
  if (!text) return text.errors();
  Diagnostics warnings;
  Diagnostics errors;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string target;
    std::string header;
    std::string row;
    std::string column;
    SourceSpan span{.length = 1};
    std::getline(words, target, '\t');
    std::getline(words, header, '\t');
    std::getline(words, span.file, '\t');
    std::getline(words, row, '\t');
    std::getline(words, column, '\t');
    std::getline(words, span.line_text);
    span.line = printed_number(row);
    span.column = printed_number(column);
    if (!place.display.empty() && fs::path(span.file).is_relative())
      span.file = place.display + "/" + span.file;
    if (is_of_known_package(header, place)) {
      errors.push_back({.code = "R2W0502",
                        .message = "package `" + place.package + "` does not compile: '" + header +
                                   "' file not found",
                        .span = std::move(span),
                        .why = {"package.xml does not ask for `" + first_folder(header) + "`"}});
      continue;
    }
    std::vector<std::string> why = told_of_header(header);
    why.emplace_back(
        "it is built when the header is in the package, or when a package that package.xml asks "
        "for installs it");
    warnings.push_back({.code = "R2W0522",
                        .severity = Severity::kWarning,
                        .message = "`" + target + "` of package `" + place.package +
                                   "` is skipped: nothing gives the header `" + header + "`",
                        .span = std::move(span),
                        .label = "included here",
                        .why = std::move(why)});
  }
  return errors.empty() ? warnings : errors;
}

}  // namespace ros2wasm
