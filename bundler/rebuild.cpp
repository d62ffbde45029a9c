// See rebuild.hpp.
#include "bundler/rebuild.hpp"

#include <algorithm>
#include <optional>
#include <system_error>

#include "bundler/archive/extract_limits.hpp"
#include "bundler/archive/zip_files.hpp"
#include "bundler/carried_sources.hpp"
#include "bundler/io/files.hpp"
#include "bundler/pipeline.hpp"
#include "bundler/verify/open_site.hpp"
#include "bundler/verify/site_check.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

/// Texts of licenses lie in parts in every store, whatever the ceiling for files is.
constexpr const char* kSharedTexts = "LICENSES.txt";

/// The ceiling that the site's files were cut at: the first part of a file is as large. 0: none.
std::uint64_t ceiling_of(const SiteList& list) {
  for (const ListedFile& file : list.files)
    if (!file.parts.empty() && file.path != kSharedTexts) return file.parts.front().size;
  return 0;
}

/// Where the new site goes below `root`, and its store, which is as far from it as the old one's.
struct Places {
  fs::path site;
  fs::path store;
};

Places places_below(const fs::path& root, const SiteList& list) {
  if (list.store.objects.empty()) return {.site = root, .store = {}};
  const fs::path objects(list.store.objects);
  fs::path site = root;
  for (const fs::path& part : objects)
    if (part == "..") site /= "site";
  return {.site = site, .store = (site / objects).lexically_normal().parent_path()};
}

/// The folder of the site, unpacked to `scratch` if it is an archive.
Outcome<fs::path> folder_of(const fs::path& site, const fs::path& scratch,
                            const ExtractLimits& limits) {
  if (site.extension() != ".zip") return site;
  const auto files = read_zip_files(site, site.filename().string(), limits);
  if (!files) return files.errors();
  for (const auto& [path, file] : *files) {
    if (auto written = write_file(scratch / path, file.bytes); !written)
      return std::move(written).errors();
  }
  return scratch;
}

Diagnostic without_sources(const fs::path& site) {
  return Diagnostic{.code = "R2W0662",
                    .message = "the site `" + site.string() + "` does not carry what it is made of",
                    .why = {"its manifest does not say `site: {sources: true}`"},
                    .fix = {"name the workspace: `ros2wasm rebuild SITE --workspace FOLDER`",
                            "pack it with `sources: true` below `site:` in its manifest"}};
}

}  // namespace

Outcome<RebuildReport> rebuild(const RebuildRequest& request, const Cancellation& cancellation,
                               const ProgressSink& progress) {
  const auto limits = extract_limits_of(request.archive_limits, request.variables);
  if (!limits) return limits.errors();
  auto scratch = TemporaryDirectory::make("ros2wasm-rebuild-");
  if (!scratch) return std::move(scratch).errors();

  // 1. the site, every byte of it
  const auto folder = folder_of(request.site, scratch->path() / "given", *limits);
  if (!folder) return folder.errors();
  const auto check = check_site_folder(*folder, cancellation, progress);
  if (!check) return check.errors();
  if (!check->faults.empty()) return check->faults;
  const auto given = open_site(*folder);
  if (!given) return given.errors();

  // 2. what it is made of
  fs::path workspace = request.workspace;
  if (workspace.empty()) {
    const auto& files = given->list.files;
    if (std::none_of(files.begin(), files.end(),
                     [](const ListedFile& file) { return file.path == kSourcesArchive; }))
      return without_sources(request.site);
    const fs::path archive = scratch->path() / kSourcesArchive;
    const auto bytes = site_bytes(*given, kSourcesArchive);
    if (!bytes) return bytes.errors();
    if (auto written = write_file(archive, *bytes); !written) return std::move(written).errors();
    auto manifest = unpack_sources(archive, scratch->path() / "sources", *limits);
    if (!manifest) return std::move(manifest).errors();
    workspace = std::move(*manifest);
  }

  // 3. once more
  const Places places =
      places_below(request.output.empty() ? scratch->path() / "site" : request.output, given->list);
  const auto packed = pack({.input = workspace.string(),
                            .output = places.site,
                            .frozen = true,
                            .offline = request.offline,
                            .executable = request.executable,
                            .variables = request.variables,
                            .jobs = request.jobs,
                            .store = places.store,
                            .max_file_size = ceiling_of(given->list),
                            .built = scratch->path() / "built",
                            .archive_limits = request.archive_limits,
                            .takes_carried = true,
                            .signer = nullptr},
                           cancellation, progress);
  if (!packed) return packed.errors();

  // 4. is it the same?
  const auto made = open_site(places.site);
  if (!made) return made.errors();
  auto differences = site_differences(compared(*given), compared(*made));
  if (!differences) return std::move(differences).errors();
  Diagnostics warnings = packed->notes.warnings;
  if (!check->unlisted.empty())
    warnings.insert(warnings.begin(), unlisted_files(check->unlisted, request.site.string()));
  return RebuildReport{.sha256 = given->list.hash,
                       .made = made->list.hash,
                       .generator = given->list.generator,
                       .differences = std::move(*differences),
                       .warnings = std::move(warnings),
                       .remarks = packed->notes.remarks};
}

}  // namespace ros2wasm
