// See transport.hpp. The transports that need no network, and the way to the one that does.
#include "bundler/channel/transport.hpp"

#include <array>
#include <charconv>

#include "bundler/channel/index_cache.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

Outcome<LocalFile> existing(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) return LocalFile(path);
  return LocalFile();
}

/// "%20" -> " ". A broken escape stays as it is.
std::string percent_decoded(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned value = 0;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, value, 16).ptr ==
            text.data() + i + 3) {
      out += static_cast<char>(value);
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

Outcome<LocalFile> plain(const std::string& url, const ChannelRoots& roots) {
  return existing(roots.working_directory / url);
}

fs::path path_of_file_url(std::string_view url) {
  std::string_view rest = url.substr(std::string_view("file:").size());
  if (rest.starts_with("//localhost/")) {
    rest.remove_prefix(std::string_view("//localhost").size());
  } else if (rest.starts_with("//")) {
    rest.remove_prefix(2);
  }
  return percent_decoded(rest);
}

Outcome<LocalFile> file_url(const std::string& url, const ChannelRoots&) {
  return existing(path_of_file_url(url));
}

Outcome<LocalFile> embedded(const std::string& url, const ChannelRoots& roots) {
  std::string_view rest = std::string_view(url).substr(std::string_view("embedded:").size());
  while (rest.starts_with('/')) rest.remove_prefix(1);
  return existing(roots.embedded / rest);
}

/// The same for each address.
template <Outcome<LocalFile> (*find)(const std::string&, const ChannelRoots&)>
std::vector<Outcome<LocalFile>> each(std::span<const std::string> urls, const ChannelRoots& roots,
                                     const Cancellation&) {
  std::vector<Outcome<LocalFile>> files;
  files.reserve(urls.size());
  for (const std::string& url : urls) files.push_back(find(url, roots));
  return files;
}

constexpr auto kTransports = std::to_array<Transport>({
    {.scheme = "", .bring = each<plain>},
    {.scheme = "embedded", .bring = each<embedded>},
    {.scheme = "file", .bring = each<file_url>},
    {.scheme = "http", .bring = bring_indexes},
    {.scheme = "https", .bring = bring_indexes},
});

/// "file" of "file:///x"; empty for paths.
std::string_view scheme_of(std::string_view url) {
  const std::size_t colon = url.find(':');
  const std::size_t slash = url.find('/');
  if (colon == std::string_view::npos || slash < colon) return {};
  return url.substr(0, colon);
}

Diagnostic unknown_scheme(const std::string& url) {
  std::vector<std::string> known;
  for (const Transport& transport : transports()) {
    if (!transport.scheme.empty()) known.push_back("`" + std::string(transport.scheme) + ":`");
  }
  return Diagnostic{
      .code = "R2W0203",
      .message = "channels at `" + std::string(scheme_of(url)) + ":` addresses cannot be read",
      .why = {"`" + url +
              "` was asked for; a channel is a folder, or an address that begins with " +
              name_list(known)}};
}

}  // namespace

std::span<const Transport> transports() {
  return kTransports;
}

std::vector<Outcome<LocalFile>> bring_all(std::span<const std::string> urls,
                                          const ChannelRoots& roots,
                                          const Cancellation& cancellation) {
  std::vector<Outcome<LocalFile>> files;
  files.reserve(urls.size());
  for (const std::string& url : urls) files.emplace_back(unknown_scheme(url));
  for (const Transport& transport : transports()) {
    std::vector<std::string> mine;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < urls.size(); ++i) {
      if (scheme_of(urls[i]) != transport.scheme) continue;
      mine.push_back(urls[i]);
      places.push_back(i);
    }
    if (mine.empty()) continue;
    auto found = transport.bring(mine, roots, cancellation);
    for (std::size_t k = 0; k < places.size(); ++k) files[places[k]] = std::move(found[k]);
  }
  return files;
}

Outcome<LocalFile> bring(const std::string& url, const ChannelRoots& roots,
                         const Cancellation& cancellation) {
  return bring_all({&url, 1}, roots, cancellation).front();
}

LocalFile local_channel_folder(const std::string& channel_name, const fs::path& working_directory) {
  if (channel_name == "embedded") return std::nullopt;
  const std::string_view scheme = scheme_of(channel_name);
  if (scheme == "file") return path_of_file_url(channel_name);
  if (!scheme.empty()) return std::nullopt;
  return working_directory / channel_name;
}

}  // namespace ros2wasm
