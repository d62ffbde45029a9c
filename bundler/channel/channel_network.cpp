// See channel_network.hpp.
#include "bundler/channel/channel_network.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "workspace_schema/base/secret_text.hpp"

namespace ros2wasm {
namespace {

std::string variable(const std::map<std::string, std::string>& variables, const std::string& name) {
  const auto found = variables.find(name);
  return found == variables.end() ? std::string() : found->second;
}

void read_number(const std::string& text, int least, int most, int& target) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size() && number >= least && number <= most)
    target = number;
}

/// `${NAME}` -> its value.
Outcome<std::string> with_variables(std::string_view text, const ChannelNetwork& network) {
  std::string out;
  while (!text.empty()) {
    const std::size_t begin = text.find("${");
    const std::size_t end = begin == std::string_view::npos ? begin : text.find('}', begin);
    if (end == std::string_view::npos) return out.append(text);
    const std::string name(text.substr(begin + 2, end - begin - 2));
    const std::string value = variable(network.variables, name);
    if (value.empty()) {
      return Diagnostic{.code = "R2W0237",
                        .message = "a channel asks for the variable `" + name +
                                   "`, which the environment does not have",
                        .why = {"`${" + name + "}` in a channel is replaced by its value"}};
    }
    out.append(text.substr(0, begin)).append(value);
    text.remove_prefix(end + 1);
  }
  return out;
}

/// The address with `/t/TOKEN` behind the host.
std::string with_token(const std::string& url, const std::string& token) {
  if (token.empty()) return url;
  const std::size_t host = url.find("://") + 3;
  const std::size_t path = std::min(url.find('/', host), url.size());
  return url.substr(0, path) + "/t/" + token + url.substr(path);
}

bool is_below(std::string_view url, std::string_view base) {
  return url.starts_with(base) &&
         (url.size() == base.size() || base.ends_with('/') || url[base.size()] == '/');
}

std::string_view host_of(std::string_view url) {
  std::string_view host = url.substr(url.find("://") + 3);
  host = host.substr(0, host.find_first_of("/?#"));
  return host.starts_with('[') ? host.substr(0, host.find(']') + 1)
                               : host.substr(0, host.find(':'));
}

/// "https://a.b-c.org:8080/x" -> "A_B__C_ORG": variables' names have neither dots nor dashes, and
/// no two hosts that can be registered may have the same one, so `_` is `___`.
std::string host_variable(std::string_view url) {
  std::string name = "ROS2WASM_AUTH_";
  for (const char c : host_of(url)) {
    const bool lower = c >= 'a' && c <= 'z';
    const bool kept = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (lower || kept) {
      name += lower ? static_cast<char>(c - 'a' + 'A') : c;
    } else {
      name += c == '-' ? "__" : c == '_' ? "___" : "_";
    }
  }
  return name;
}

/// Nobody on the way reads what is sent.
bool is_private_way(std::string_view url) {
  if (url.starts_with("https://")) return true;
  const std::string_view host = host_of(url);
  const bool is_number = host.find_first_not_of("0123456789.") == std::string_view::npos;
  return host == "localhost" || host == "[::1]" || (is_number && host.starts_with("127."));
}

/// Adds the credentials of a variable ROS2WASM_AUTH_HOST: "token X" for the path, "user:password",
/// or a bearer token.
void add_host_credentials(DownloadSource& source, const ChannelNetwork& network) {
  const std::string value = variable(network.variables, host_variable(source.shown_url));
  constexpr std::string_view kToken = "token ";
  constexpr std::string_view kBearer = "bearer ";
  if (value.empty() || !is_private_way(source.shown_url)) return;
  if (value.starts_with(kToken)) {
    source.url = with_token(source.url, value.substr(kToken.size()));
  } else if (value.starts_with(kBearer)) {
    source.bearer = value.substr(kBearer.size());
  } else if (value.find(':') != std::string::npos) {
    source.user_info = value;
  } else {
    source.bearer = value;
  }
}

/// Whether a path from an index stays below its folder. An index may not name files outside of it.
bool stays_below(std::string_view rest) {
  while (rest.starts_with('/')) rest.remove_prefix(1);
  const std::filesystem::path path = std::filesystem::path(rest).lexically_normal();
  return path.empty() || *path.begin() != "..";
}

/// Takes the credentials out of an address and remembers them.
std::string remembered(const std::string& url, ChannelNetwork& network) {
  const AddressSecrets secrets = secrets_of(url);
  std::string shown = without_secrets(url);
  if (secrets.user_info.empty() && secrets.token.empty()) return shown;
  network.secrets.push_back(
      {.base = shown, .user_info = secrets.user_info, .token = secrets.token});
  return shown;
}

}  // namespace

ChannelNetwork network_of(std::map<std::string, std::string> variables) {
  ChannelNetwork network;
  network.variables = std::move(variables);
  if (const std::string alias = variable(network.variables, "ROS2WASM_CHANNEL_ALIAS");
      !alias.empty())
    network.alias = alias;
  network.download.http.netrc_file = variable(network.variables, "NETRC");
  network.download.http.certificates = variable(network.variables, "SSL_CERT_FILE");
  read_number(variable(network.variables, "ROS2WASM_RETRIES"), 0, 100, network.download.retries);
  read_number(variable(network.variables, "ROS2WASM_STALL_SECONDS"), 1, 3600,
              network.download.http.stall_seconds);
  return network;
}

bool is_bare_channel_name(std::string_view text) {
  return !text.empty() && text != "embedded" && text != "." && text != ".." &&
         !text.starts_with('/') && !text.starts_with("./") && !text.starts_with("../") &&
         text.find(':') == std::string_view::npos;
}

bool is_network_url(std::string_view url) {
  return url.starts_with("https://") || url.starts_with("http://");
}

Outcome<std::string> channel_address(std::string_view text, ChannelNetwork& network) {
  auto name = with_variables(text, network);
  if (!name || *name == "embedded") return name;
  if (is_bare_channel_name(*name)) {
    if (network.alias.empty()) {
      return Diagnostic{
          .code = "R2W0240",
          .message = "`" + *name + "` names a channel, but not where it is",
          .why = {"there is no folder of that name beside the manifest, and nothing says "
                  "what bare names are below"},
          .fix = {"write its whole address",
                  "say what bare names are below: `channel_alias:` in workspace.yaml, or the "
                  "variable ROS2WASM_CHANNEL_ALIAS"}};
    }
    auto alias = with_variables(network.alias, network);
    if (!alias) return alias;
    while (alias->ends_with('/')) alias->pop_back();
    *name = *alias + "/" + *name;
  }
  while (name->size() > 1 && name->ends_with('/')) name->pop_back();
  return remembered(*name, network);
}

std::vector<std::string> at_mirrors(const std::string& url, const ChannelNetwork& network) {
  std::vector<std::string> places;
  for (const ChannelMirrors& mirrors : network.mirrors) {
    if (!is_below(url, mirrors.base)) continue;
    const std::string rest = url.substr(mirrors.base.size());
    for (const std::string& mirror : mirrors.urls) {
      if (is_network_url(mirror) || stays_below(rest)) places.push_back(mirror + rest);
    }
  }
  return places;
}

DownloadSource source_of(const std::string& url, const ChannelNetwork& network) {
  DownloadSource source{.url = url, .shown_url = url, .user_info = {}, .bearer = {}};
  const ChannelSecret* best = nullptr;
  for (const ChannelSecret& secret : network.secrets) {
    if (is_below(url, secret.base) && (best == nullptr || best->base.size() < secret.base.size()))
      best = &secret;
  }
  if (best == nullptr) {
    add_host_credentials(source, network);
  } else {
    source.url = with_token(url, best->token);
    source.user_info = best->user_info;
  }
  return source;
}

std::vector<DownloadSource> sources_of(const std::string& url, const ChannelNetwork& network) {
  std::vector<DownloadSource> sources;
  for (const std::string& mirror : at_mirrors(url, network)) {
    if (is_network_url(mirror)) sources.push_back(source_of(mirror, network));
  }
  sources.push_back(source_of(url, network));
  return sources;
}

}  // namespace ros2wasm
