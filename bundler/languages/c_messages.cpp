// See c_messages.hpp.
#include "bundler/languages/c_messages.hpp"

#include <algorithm>
#include <array>
#include <regex>

#include "bundler/build/cached_work.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/process.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFolder = "c-messages";              ///< in the folder of work
constexpr const char* kDebianPython = "/usr/bin/python3";  ///< has rosidl's modules

bool is_compiled(const fs::path& file) {
  constexpr auto kSuffixes = std::to_array<std::string_view>(
      {".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".hxx", ".inl", ".ipp"});
  const std::string suffix = file.extension().string();
  return std::find(kSuffixes.begin(), kSuffixes.end(), suffix) != kSuffixes.end();
}

void look_into(const fs::path& file, std::set<std::string>& headers) {
  if (!is_compiled(file)) return;
  if (const auto text = read_file(file, kMostOfText)) headers.merge(c_message_headers(*text));
}

/// A header that a package installs itself is used from there.
bool is_installed(const std::string& header, const std::vector<fs::path>& prefixes) {
  const std::string package = header.substr(0, header.find('/'));
  std::error_code error;
  return std::any_of(prefixes.begin(), prefixes.end(), [&](const fs::path& prefix) {
    return fs::exists(prefix / "include" / (header + ".h"), error) ||
           fs::exists(prefix / "include" / package / (header + ".h"), error);
  });
}

/// One that the package has written itself.
bool is_among(const std::vector<SeenSource>& sources, const std::string& header) {
  return std::any_of(sources.begin(), sources.end(), [&](const SeenSource& one) {
    return one.path == header + ".h" || one.path.ends_with("/" + header + ".h");
  });
}

}  // namespace

std::set<std::string> c_message_headers(std::string_view text) {
  static const std::regex kInclude(
      R"(#[ \t]*include[ \t]*[<"]([a-z]\w*/(?:msg|srv|action)/)(?:detail/)?([a-z0-9_]+)\.h[>"])");
  static const std::regex kDetail(R"(__(?:struct|functions|type_support)$)");
  std::set<std::string> result;
  std::size_t at = 0;
  while ((at = text.find("include", at)) != std::string_view::npos) {
    const std::size_t before = text.rfind('\n', at);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line(text.substr(begin, std::min<std::size_t>(end - begin, 400)));
    std::smatch match;
    if (std::regex_search(line, match, kInclude) &&
        line.find_first_not_of(" \t") == static_cast<std::size_t>(match.position(0)))
      result.insert(match[1].str() + std::regex_replace(match[2].str(), kDetail, ""));
    at = end;
  }
  return result;
}

Outcome<std::set<std::string>> included_c_messages(const PackageBuild& request) {
  const auto sources = seen_sources(request.work);
  if (!sources) return sources.errors();
  std::set<std::string> headers;
  for (const SeenSource& one : *sources) look_into(request.place.source / one.path, headers);
  for (const fs::path& prefix : request.prefixes) {
    if (prefix == request.channel_prefix) continue;
    std::error_code error;
    for (fs::recursive_directory_iterator it(prefix / "include", error), end; !error && it != end;
         it.increment(error)) {
      std::error_code gone;
      if (it->is_regular_file(gone)) look_into(it->path(), headers);
    }
  }
  std::erase_if(headers, [&](const std::string& one) {
    return is_installed(one, request.prefixes) || is_among(*sources, one);
  });
  return headers;
}

fs::path c_messages_folder(const PackageBuild& request) {
  return request.work / kFolder;
}

bool has_own_c_messages(const std::set<std::string>& headers, const PackageBuild& request) {
  return std::any_of(headers.begin(), headers.end(), [&](const std::string& one) {
    return one.starts_with(request.place.package + "/");
  });
}

Outcome<Done> make_c_messages(const std::set<std::string>& headers, const PackageBuild& request,
                              const BuildTools& tools, const Cancellation& cancellation) {
  std::error_code error;
  std::vector<std::string> arguments = {
      fs::exists(kDebianPython, error) ? kDebianPython : "python3", "-B",
      (tools.c_messages / "c_headers.py").string(), "--output",
      c_messages_folder(request).string()};
  for (const fs::path& prefix : request.prefixes) {
    arguments.emplace_back("--share");
    arguments.push_back((prefix / "share").string());
  }
  if (has_own_c_messages(headers, request)) {
    arguments.insert(arguments.end(), {"--own-package", request.place.package, "--own-source",
                                       request.place.source.string()});
  }
  arguments.insert(arguments.end(), headers.begin(), headers.end());
  const auto result = run_process({.arguments = std::move(arguments),
                                   .environment = tools.tool_environment,
                                   .directory = request.work},
                                  cancellation);
  if (!result) return result.errors();
  if (result->exit_code == 0) return Done{};
  return Diagnostic{.code = "R2W0506",
                    .message = "package `" + request.place.package +
                               "`: the C headers of messages could not be made",
                    .detail = result->output};
}

}  // namespace ros2wasm
