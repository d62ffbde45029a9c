// See transport.hpp. The transports that need no network.
#include "bundler/channel/transport.hpp"

#include <array>
#include <charconv>

#include "workspace_schema/suggestion.hpp"

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

Outcome<LocalFile> bring_plain(const std::string& url, const ChannelRoots& roots,
                               const Cancellation&) {
  return existing(roots.working_directory / url);
}

Outcome<LocalFile> bring_file_url(const std::string& url, const ChannelRoots&,
                                  const Cancellation&) {
  std::string_view rest = std::string_view(url).substr(std::string_view("file:").size());
  if (rest.starts_with("//localhost/")) {
    rest.remove_prefix(std::string_view("//localhost").size());
  } else if (rest.starts_with("//")) {
    rest.remove_prefix(2);
  }
  return existing(percent_decoded(rest));
}

Outcome<LocalFile> bring_embedded(const std::string& url, const ChannelRoots& roots,
                                  const Cancellation&) {
  std::string_view rest = std::string_view(url).substr(std::string_view("embedded:").size());
  while (rest.starts_with('/')) rest.remove_prefix(1);
  return existing(roots.embedded / rest);
}

constexpr auto kTransports = std::to_array<Transport>({
    {.scheme = "", .bring = bring_plain},
    {.scheme = "embedded", .bring = bring_embedded},
    {.scheme = "file", .bring = bring_file_url},
});

/// "file" of "file:///x"; empty for paths.
std::string_view scheme_of(std::string_view url) {
  const std::size_t colon = url.find(':');
  const std::size_t slash = url.find('/');
  if (colon == std::string_view::npos || slash < colon) return {};
  return url.substr(0, colon);
}

}  // namespace

std::span<const Transport> transports() {
  return kTransports;
}

Outcome<LocalFile> bring(const std::string& url, const ChannelRoots& roots,
                         const Cancellation& cancellation) {
  const std::string_view scheme = scheme_of(url);
  std::vector<std::string> known;
  for (const Transport& transport : transports()) {
    if (transport.scheme == scheme) return transport.bring(url, roots, cancellation);
    if (!transport.scheme.empty()) known.push_back("`" + std::string(transport.scheme) + ":`");
  }
  return Diagnostic{
      .code = "R2W0203",
      .message = "channels at `" + std::string(scheme) + ":` addresses cannot be read",
      .why = {"`" + url +
              "` was asked for; a channel is a folder, or an address that begins with " +
              name_list(known)}};
}

std::string channel_base_url(std::string_view channel_name) {
  if (channel_name == "embedded") return "embedded:";
  while (channel_name.size() > 1 && channel_name.ends_with('/')) channel_name.remove_suffix(1);
  return std::string(channel_name);
}

}  // namespace ros2wasm
