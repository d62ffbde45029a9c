// See course.hpp.
#include "bundler/course.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "bundler/archive/zip_writer.hpp"
#include "bundler/emit/precompressed.hpp"
#include "bundler/emit/zip_output.hpp"
#include "bundler/io/file_lock.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/installation.hpp"
#include "bundler/pipeline.hpp"
#include "bundler/plan/runtime_assets.hpp"
#include "bundler/site/own_site.hpp"
#include "bundler/site/site_list.hpp"
#include "bundler/verify/compressed_forms.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/schema/course.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kCourseName = "course.yaml";
constexpr const char* kLabManifest = "workspace.yaml";
constexpr const char* kObjects = "objects";

std::optional<Diagnostic> refuse_course(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(folder, error))) return std::nullopt;
  if (fs::is_directory(folder, error) && (fs::is_empty(folder, error) || is_course_of_ours(folder)))
    return std::nullopt;
  return Diagnostic{
      .code = "R2W0601",
      .message = "`" + folder.string() + "` exists and is not a course made by ros2wasm",
      .why = {"it has no course.json that ros2wasm wrote"},
      .fix = {"choose another place with -o"}};
}

std::vector<std::string> titles_of(const std::vector<TaskEntry>& tasks) {
  std::vector<std::string> titles;
  for (const TaskEntry& task : tasks) titles.push_back(task.title.value);
  return titles;
}

Outcome<std::string> course_script(const fs::path& executable) {
  const auto list =
      find_own_data(executable, "runtime/runtime_assets.json", "the runtime of sites");
  if (!list) return list.errors();
  const auto assets = read_runtime_assets(*list);
  if (!assets) return assets.errors();
  for (const RuntimeAsset& asset : *assets)
    if (asset.role == kCourseScriptRole) return asset.bytes;
  return std::string();
}

/// The title in the site's own list: that of the workspace, which is never empty.
std::string title_of(const SitePlan& plan) {
  for (const PlannedFile& file : plan.files) {
    if (file.path != kSiteJsonName) continue;
    if (const auto json = parse_json(file.bytes, kSiteJsonName, "R2W0605"))
      return json->text_of("title");
  }
  return {};
}

/// The hashes of the files of one lab, by their places in the course.
Outcome<PlaceHashes> files_of_site(const fs::path& folder, const std::string& name) {
  const fs::path file = folder / name / kSiteJsonName;
  const auto text = read_file(file, kMostOfSiteJson);
  if (!text) return text.errors();
  const auto list = read_site_list(*text, file.string());
  if (!list) return list.errors();
  return places_of_lab(*list, name);
}

/// `sha256sum --check` finds all that the course's labs have now.
Outcome<std::string> course_hash_list(const fs::path& folder, const CourseReport& report,
                                      const std::vector<PlannedFile>& own) {
  PlaceHashes all;
  for (const PlannedFile& file : own) all[file.path] = file.sha256;
  for (const PackedLab& lab : report.labs) {
    auto files = files_of_site(folder, lab.name);
    if (!files) return std::move(files).errors();
    all.merge(*files);
  }
  return hash_list(all);
}

/// Folders that are sites, but of none of the labs; and what no site names.
Outcome<Done> prune(const fs::path& folder, CourseReport& report) {
  auto tree = list_tree(folder);
  if (!tree) return std::move(tree).errors();
  std::set<std::string> wanted{kHashList, std::string(kObjects) + "/" + kStoreMarker};
  for (const char* own : {kCourseJsonName, "index.html", "course.css"}) wanted.insert(own);
  for (const PackedLab& lab : report.labs) {
    const auto files = files_of_site(folder, lab.name);
    if (!files) return files.errors();
    for (const auto& [path, sha256] : *files) wanted.insert(path);
  }
  // Only what a pack wrote: sites, and objects.
  std::map<std::string, bool> sites;
  const auto is_ours = [&](const std::string& path) {
    const std::string top = path.substr(0, path.find('/'));
    if (top == kObjects) return true;
    if (top == path) return false;
    const auto [known, fresh] = sites.try_emplace(top, false);
    if (fresh) known->second = is_site_of_ours(folder / top);
    return known->second;
  };
  const auto is_wanted = [&](const std::string& path) {
    return wanted.contains(path) ||
           std::any_of(kCompressions.begin(), kCompressions.end(), [&](const Compression& form) {
             return path.ends_with(form.ending) &&
                    wanted.contains(path.substr(0, path.size() - form.ending.size()));
           });
  };
  std::vector<const TreeEntry*> useless;
  for (const TreeEntry& entry : *tree) {
    if (!is_wanted(entry.path) && is_ours(entry.path)) useless.push_back(&entry);
  }
  for (const TreeEntry* entry : useless) {
    if (auto removed = remove_tree(folder / entry->path); !removed) return removed;
    report.removed += entry->size;
    std::error_code error;
    // Folders that are empty now.
    for (fs::path parent = fs::path(entry->path).parent_path(); !parent.empty();
         parent = parent.parent_path())
      if (!fs::remove(folder / parent, error) || error) break;
  }
  return Done{};
}

/// The folder as one archive, course.json first.
Outcome<Done> archive(const fs::path& folder, const fs::path& file,
                      const Cancellation& cancellation) {
  auto tree = list_tree(folder);
  if (!tree) return std::move(tree).errors();
  std::stable_partition(tree->begin(), tree->end(),
                        [](const TreeEntry& one) { return one.path == kCourseJsonName; });
  std::uint64_t size = 0;
  for (const TreeEntry& one : *tree) size += one.size;
  if (auto refusal = refuse_zip_size(file, tree->size(), size)) return *refusal;
  ZipWriter zip;
  for (const TreeEntry& one : *tree) {
    if (cancellation.requested()) return interrupted();
    if (one.kind != FileKind::kFile) continue;
    const auto bytes = read_file(folder / one.path, kMostOfData);
    if (!bytes) return bytes.errors();
    zip.member(one.path, *bytes);
  }
  return write_file(file, zip.finish());
}

Outcome<CourseReport> pack_into(const CourseRequest& request, const Course& course,
                                const fs::path& base, const fs::path& folder,
                                const Cancellation& cancellation, const ProgressSink& progress) {
  CourseReport report;
  Diagnostics errors;
  for (const CourseLab& lab : course.labs) {
    PackRequest one = request.pack;
    one.input = (base / lab.workspace.value).lexically_normal().string();
    one.output = folder / lab.name;
    one.store = folder / kObjects;
    if (is_absent(one.input)) {
      errors.push_back(Diagnostic{.code = "R2W0616",
                                  .message = "there is no workspace `" + lab.workspace.value + "`",
                                  .span = lab.workspace.span,
                                  .label = "no such file or folder",
                                  .why = {},
                                  .fix = {}});
      continue;
    }
    auto packed = pack(one, cancellation, progress);
    if (!packed) {
      append(errors, packed.errors());
      if (cancellation.requested()) return errors;
      continue;
    }
    if (one.precompress && !one.plan_only) {
      if (auto done = precompress_site(one.output, cancellation); !done)
        return std::move(done).errors();
    }
    append(report.warnings, packed->notes.warnings);
    for (const std::string& remark : packed->notes.remarks)
      report.remarks.push_back(lab.name + ": " + remark);
    report.labs.push_back({.name = lab.name,
                           .title = lab.title.empty() ? title_of(packed->plan) : lab.title,
                           .description = lab.description,
                           .sha256 = packed->plan.sha256,
                           .tasks = titles_of(packed->plan.tasks)});
  }
  if (!errors.empty()) return errors;
  const auto script = course_script(request.pack.executable);
  if (!script) return script.errors();
  const std::vector<PlannedFile> own = course_files(course, report.labs, *script);
  report.sha256 = own.back().sha256;
  if (request.pack.plan_only) return report;
  for (const PlannedFile& file : own) {
    if (auto written = write_file(folder / file.path, file.bytes); !written)
      return std::move(written).errors();
    auto forms = request.pack.precompress ? precompress_file(folder / file.path)
                                          : remove_compressed(folder / file.path);
    if (!forms) return std::move(forms).errors();
  }
  const auto hashes = course_hash_list(folder, report, own);
  if (!hashes) return hashes.errors();
  if (auto written = write_file(folder / kHashList, *hashes); !written)
    return std::move(written).errors();
  // Others may pack into the store meanwhile: what they have written there and not yet named stays.
  const auto store = report.labs.empty()
                         ? Outcome<std::optional<FileLock>>(std::optional<FileLock>())
                         : FileLock::take_folder(folder / kObjects, !request.prune, cancellation);
  if (!store) return store.errors();
  if (request.prune) {
    if (auto done = prune(folder, report); !done) return std::move(done).errors();
  }
  const auto tree = list_tree(folder);
  if (!tree) return tree.errors();
  for (const TreeEntry& entry : *tree) report.bytes += entry.size;
  return report;
}

}  // namespace

bool is_course(const std::string& input) {
  std::error_code error;
  const fs::path path = input.empty() ? fs::path(".") : fs::path(input);
  if (fs::is_directory(path, error))
    return !is_absent(path / kCourseName) && is_absent(path / kLabManifest);
  return path.filename() == kCourseName;
}

Outcome<CourseReport> pack_course(const CourseRequest& request, const Cancellation& cancellation,
                                  const ProgressSink& progress) {
  std::error_code error;
  fs::path file = request.pack.input.empty() ? fs::path(".") : fs::path(request.pack.input);
  if (fs::is_directory(file, error)) file = (file / kCourseName).lexically_normal();
  const auto text = read_file(file, kMostOfText);
  if (!text) return text.errors();
  const auto course = read_course(*text, file.string());
  if (!course) return course.errors();
  const fs::path& output = request.pack.output;
  const auto into = [&](const fs::path& folder) {
    return pack_into(request, *course, file.parent_path(), folder, cancellation, progress);
  };
  if (output.extension() == ".html" || !request.pack.store.empty()) {
    return Diagnostic{
        .code = "R2W0615",
        .message = "a course is written as a folder or as one archive",
        .why = {request.pack.store.empty() ? "a page carries one site"
                                           : "its labs share the store in its folder `objects`"},
        .fix = {"ros2wasm pack " + file.string() + " -o course"}};
  }
  if (request.pack.plan_only) return into(output);
  if (output.extension() != ".zip") {
    if (auto refusal = refuse_course(output)) return *refusal;
    return into(output);
  }
  if (auto refusal = refuse_zip(output)) return *refusal;
  auto place = TemporaryDirectory::make("ros2wasm-course-");
  if (!place) return std::move(place).errors();
  auto report = into(place->path() / "course");
  if (!report) return report;
  if (auto written = archive(place->path() / "course", output, cancellation); !written)
    return std::move(written).errors();
  return report;
}

}  // namespace ros2wasm
