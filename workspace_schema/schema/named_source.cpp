// See named_source.hpp.
#include "workspace_schema/schema/named_source.hpp"

#include <algorithm>
#include <array>

namespace ros2wasm {
namespace {

constexpr auto kGitSchemes =
    std::to_array<std::string_view>({"https://", "http://", "ssh://", "file://"});

/// `git@example.org:group/repository.git`: git takes a colon before the first slash for ssh's.
bool is_scp_form(std::string_view place) {
  const std::size_t colon = place.find(':');
  return colon != std::string_view::npos && place.find('/') > colon;
}

bool is_control(char letter) {
  return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F;
}

/// ssh and git would take such a host for an option.
bool begins_with_dash(std::string_view host) {
  const std::size_t user = host.find('@');
  return host.starts_with('-') ||
         (user != std::string_view::npos && host.substr(user + 1).starts_with('-'));
}

/// `rest`: the address behind its scheme.
std::string password_fault(std::string_view rest) {
  const std::string_view host = rest.substr(0, rest.find('/'));
  const std::size_t user = host.rfind('@');
  const bool has_one =
      user != std::string_view::npos && host.substr(0, user).find(':') != std::string_view::npos;
  return has_one ? "it has a password in it, which the lock would show to everybody" : "";
}

}  // namespace

std::string_view source_kind_word(SourceKind kind) {
  switch (kind) {
    case SourceKind::kGit:
      return "git";
    case SourceKind::kArchive:
      return "archive";
    case SourceKind::kFolder:
      return "folder";
    case SourceKind::kRepos:
      return "repos";
    case SourceKind::kDistribution:
      return "distribution";
  }
  return "git";
}

bool is_source_address(std::string_view place) {
  return is_web_place(place) || is_scp_form(place);
}

bool is_web_place(std::string_view place) {
  return place.find("://") != std::string_view::npos;
}

Reach reach_of(std::string_view git_address) {
  if (git_address.starts_with("https://") || git_address.starts_with("http://")) return Reach::kWeb;
  if (git_address.starts_with("ssh://") || (!is_web_place(git_address) && is_scp_form(git_address)))
    return Reach::kSsh;
  return Reach::kMachine;
}

std::string file_place_fault(std::string_view place) {
  if (std::any_of(place.begin(), place.end(), is_control)) return "it has a control character";
  if (!is_web_place(place)) {
    const bool is_relative = !place.empty() && !place.starts_with('/') && !place.starts_with('~');
    return is_relative ? "" : "a path is relative";
  }
  if (!place.starts_with("https://") && !place.starts_with("http://"))
    return "an address begins with https:// or http://";
  return password_fault(place.substr(place.find("://") + 3));
}

std::string source_name(std::string_view place) {
  while (place.ends_with('/')) place.remove_suffix(1);
  std::string_view name = place.substr(place.find_last_of("/:") + 1);
  for (const std::string_view ending :
       {".git", ".tar.gz", ".tar.bz2", ".tar.xz", ".tar.zst", ".tgz", ".tar", ".zip"}) {
    if (!name.ends_with(ending)) continue;
    name.remove_suffix(ending.size());
    break;
  }
  return name.empty() || name.starts_with('.') ? "source" : std::string(name);
}

std::string git_address_fault(std::string_view place) {
  if (std::any_of(place.begin(), place.end(), is_control)) return "it has a control character";
  if (place.starts_with('-')) return "it begins with `-`";
  // git would start a program of that name.
  if (place.find("::") != std::string_view::npos)
    return "an address begins with https://, http://, ssh:// or file://";
  if (!is_source_address(place)) return {};
  const std::size_t scheme = place.find("://");
  if (scheme == std::string_view::npos)
    return begins_with_dash(place.substr(0, place.find(':'))) ? "its host begins with `-`" : "";
  const bool known = std::any_of(kGitSchemes.begin(), kGitSchemes.end(),
                                 [place](std::string_view one) { return place.starts_with(one); });
  if (!known) return "an address begins with https://, http://, ssh:// or file://";
  const std::string_view rest = place.substr(scheme + 3);
  const std::string_view host = rest.substr(0, rest.find('/'));
  if (begins_with_dash(host)) return "its host begins with `-`";
  return password_fault(rest);
}

std::string git_revision_fault(std::string_view revision) {
  if (revision.starts_with('-')) return "it begins with `-`";
  if (revision.find("..") != std::string_view::npos ||
      revision.find("@{") != std::string_view::npos)
    return "it is not the name of a tag, a branch or a commit";
  const bool bad = std::any_of(revision.begin(), revision.end(), [](char letter) {
    return is_control(letter) ||
           std::string_view(" ~^:?*[\\").find(letter) != std::string_view::npos;
  });
  return bad ? "it has a letter that names of tags and branches cannot have" : "";
}

}  // namespace ros2wasm
