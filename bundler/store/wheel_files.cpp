// See wheel_files.hpp.
#include "bundler/store/wheel_files.hpp"

#include <algorithm>
#include <map>

#include "bundler/channel/verified_files.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/conda/wheel_requirement.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

std::string last_part(const std::string& place) {
  return place.substr(place.rfind('/') + 1);
}

WantedFile wanted_file(const std::string& url, const std::string& sha256, const fs::path& place) {
  return {.what = "the wheel `" + last_part(url) + "`",
          .url = url,
          .place = place,
          .size = 0,
          .sha256 = sha256,
          .md5 = {}};
}

/// Beside the archives of packages, and looked after as they are.
fs::path cached_place(const ChannelRoots& roots, const std::string& sha256) {
  return roots.cache / "archives" / sha256.substr(0, 2) / sha256 / "package.whl";
}

Outcome<Done> bring_wheels(const std::vector<WantedFile>& wanted, const ChannelRoots& roots,
                           const Cancellation& cancellation) {
  Diagnostics errors;
  bring_verified(wanted, roots.network, cancellation, [&](std::size_t, Outcome<Done> outcome) {
    if (!outcome) append(errors, outcome.errors());
  });
  if (cancellation.requested()) return interrupted();
  if (!errors.empty()) return errors;
  return Done{};
}

/// The same, with the place in the manifest where there is none.
Diagnostics at(const SourceSpan& span, Diagnostics errors) {
  for (Diagnostic& one : errors) {
    if (!one.span) one.span = span;
  }
  return errors;
}

Outcome<NamedWheel> read_one(const WheelEntry& entry, const fs::path& place,
                             const ExtractLimits& limits) {
  const SourceSpan& span = entry.place.span;
  const auto hashes = hash_file(place);
  if (!hashes) return at(span, hashes.errors());
  if (!entry.sha256.empty() && hashes->sha256 != entry.sha256) {
    return Diagnostic{.code = "R2W0220",
                      .kind = FailureKind::kEnvironment,
                      .message = "`" + entry.place.value + "` is not the wheel that was asked for",
                      .span = span,
                      .why = {"its sha256 is " + hashes->sha256 + " instead of " + entry.sha256}};
  }
  std::string file_name = last_part(entry.place.value);
  auto wheel = read_wheel(place, *wheel_name(file_name), limits);
  if (!wheel) return at(span, std::move(wheel).errors());
  if (!fits_versions(kSitePython, wheel->python)) {
    return Diagnostic{.code = "R2W0243",
                      .message = "the wheel `" + file_name + "` cannot be installed for a site",
                      .span = span,
                      .why = {"it asks for Python " + wheel->python + ", and sites have " +
                              std::string(kSitePython)}};
  }
  LockedWheel locked{.project = normal_project_name(wheel->project),
                     .version = wheel->version,
                     .file = entry.is_url ? "" : entry.place.value,
                     .url = entry.is_url ? entry.place.value : "",
                     .sha256 = hashes->sha256,
                     .size = hashes->size};
  return NamedWheel{.locked = std::move(locked),
                    .file_name = std::move(file_name),
                    .span = span,
                    .wheel = std::move(*wheel)};
}

/// R2W0243 for files that two wheels have.
Diagnostics shared_files(const std::vector<NamedWheel>& wheels) {
  Diagnostics errors;
  std::map<std::string_view, const NamedWheel*> owners;
  for (const NamedWheel& one : wheels) {
    for (const auto& [path, bytes] : one.wheel.files) {
      const auto [owner, is_new] = owners.emplace(path, &one);
      if (is_new || owner->second == &one || owner->second->wheel.files.at(path) == bytes) continue;
      errors.push_back(
          {.code = "R2W0243",
           .message = "the wheel `" + one.file_name + "` cannot be installed for a site",
           .span = one.span,
           .why = {"`" + owner->second->file_name + "` has another `" + path + "`"}});
      break;
    }
  }
  return errors;
}

}  // namespace

Outcome<std::vector<NamedWheel>> read_wheels(const Manifest& manifest, const ChannelRoots& roots,
                                             const ExtractLimits& limits, bool with_addresses,
                                             const Cancellation& cancellation) {
  std::vector<WantedFile> wanted;
  for (const WheelEntry& entry : manifest.wheels) {
    if (!entry.is_url || !with_addresses) continue;
    wanted.push_back(
        wanted_file(entry.place.value, entry.sha256, cached_place(roots, entry.sha256)));
  }
  if (auto brought = bring_wheels(wanted, roots, cancellation); !brought)
    return std::move(brought).errors();
  std::vector<NamedWheel> wheels;
  Diagnostics errors;
  for (const WheelEntry& entry : manifest.wheels) {
    if (entry.is_url && !with_addresses) continue;
    const fs::path place = entry.is_url ? cached_place(roots, entry.sha256)
                                        : roots.working_directory / entry.place.value;
    auto one = read_one(entry, place, limits);
    if (!one) append(errors, one.errors());
    if (one) wheels.push_back(std::move(*one));
  }
  std::sort(wheels.begin(), wheels.end(), [](const NamedWheel& a, const NamedWheel& b) {
    return a.locked.project < b.locked.project;
  });
  append(errors, shared_files(wheels));
  if (!errors.empty()) return errors;
  return wheels;
}

std::vector<LockedWheel> locked_wheels(const std::vector<NamedWheel>& wheels) {
  std::vector<LockedWheel> locked;
  for (const NamedWheel& one : wheels) locked.push_back(one.locked);
  return locked;
}

Outcome<Done> fetch_wheels(const std::vector<LockedWheel>& wheels, const ChannelRoots& roots,
                           const Cancellation& cancellation) {
  std::vector<WantedFile> wanted;
  for (const LockedWheel& wheel : wheels) {
    if (wheel.url.empty()) continue;
    wanted.push_back(wanted_file(wheel.url, wheel.sha256, cached_place(roots, wheel.sha256)));
  }
  return bring_wheels(wanted, roots, cancellation);
}

}  // namespace ros2wasm
