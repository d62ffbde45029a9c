// The differences between two sites, file by file, and their places in a file. Pure; bytes come
// through a function.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bundler/site/site_list.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

enum class SiteChange { kChanged, kOnlyFirst, kOnlySecond };

struct SiteDifference {
  SiteChange change = SiteChange::kChanged;
  std::string path;
  std::string reason;  ///< why the file is in its site: names the package or the nodes
  std::string where;   ///< of a changed file: the first place that differs, in the file's own terms
};

/// For people.
[[nodiscard]] std::string difference_line(const SiteDifference& one);

/// For programs: an object for each, in the array that `json` is in.
void write_differences(JsonWriter& json, const std::vector<SiteDifference>& differences);

struct ComparedSite {
  const SiteList& list;
  std::string description;  ///< site.json
  std::function<Outcome<std::string>(const std::string& path)> bytes;
};

/// Sorted by path, site.json first. Empty when both are the same site. R2W0210.
[[nodiscard]] Outcome<std::vector<SiteDifference>> site_differences(const ComparedSite& first,
                                                                    const ComparedSite& second);

/// The first difference of two files with this name: the section of a WebAssembly module, the key
/// of a JSON object, the line of a text, else the byte. Offsets count from 0, lines from 1.
[[nodiscard]] std::string first_difference(const std::string& path, std::string_view first,
                                           std::string_view second);

}  // namespace ros2wasm
