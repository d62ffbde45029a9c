// Answers requests with the files of a packed site, and nothing outside of it.
#pragma once

#include <filesystem>
#include <optional>

#include "bundler/serve/http_server.hpp"
#include "bundler/serve/reload.hpp"
#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

struct SiteServing {
  std::filesystem::path folder;     ///< absolute; may be replaced by another folder at any time
  bool isolation = true;            ///< send the headers that make the page cross-origin isolated
  bool only_local_hosts = true;     ///< refuse requests for the names of other machines
  std::optional<ReloadHub> reload;  ///< watch mode: pages get the reload script
};

enum class CourseToo { kNo, kYes };

/// R2W0612 the folder is not a packed site, nor, where that will do, a course.
[[nodiscard]] Outcome<Done> check_site(const std::filesystem::path& folder,
                                       CourseToo course_too = CourseToo::kNo);

/// What to serve for a site, and where it is in it: a site that shares a store is served with the
/// folder that both lie in.
struct ServedPlace {
  std::filesystem::path folder;
  std::string site;  ///< empty, or its path there with `/` at the end, as in an address
};

[[nodiscard]] ServedPlace served_place(const std::filesystem::path& site);

/// A short text that changes with the bytes of the site: from the list of files in its site.json.
[[nodiscard]] std::string site_version(const std::filesystem::path& folder);

/// Thread-safe: reads the disk, changes nothing.
[[nodiscard]] HttpResponse site_response(const SiteServing& serving, const HttpRequest& request);

}  // namespace ros2wasm
