// Answers requests with the files of a packed site, and nothing outside of it.
#pragma once

#include <filesystem>
#include <optional>

#include "bundler/serve/http_server.hpp"
#include "bundler/serve/reload.hpp"
#include "bundler/serve/served_place.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct SiteServing {
  ServedPlace place;
  bool isolation = true;            ///< send the headers that make the page cross-origin isolated
  bool only_local_hosts = true;     ///< refuse requests for the names of other machines
  std::optional<ReloadHub> reload;  ///< watch mode: pages get the reload script
};

enum class CourseToo { kNo, kYes };

/// R2W0612 the folder is not a packed site, nor, where that will do, a course.
[[nodiscard]] Outcome<Done> check_site(const std::filesystem::path& folder,
                                       CourseToo course_too = CourseToo::kNo);

/// A short text that changes with the bytes of the site: from the list of files in its site.json.
[[nodiscard]] std::string site_version(const std::filesystem::path& folder);

/// Thread-safe: reads the disk, changes nothing.
[[nodiscard]] HttpResponse site_response(const SiteServing& serving, const HttpRequest& request);

}  // namespace ros2wasm
