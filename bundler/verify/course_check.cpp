// See course_check.hpp.
#include "bundler/verify/course_check.hpp"

#include <algorithm>
#include <set>

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/render/course_page.hpp"
#include "bundler/site/site_list.hpp"
#include "bundler/verify/compressed_forms.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// The files of the folder that belong neither to a lab, nor to the store, nor to the course
/// itself.
Outcome<std::vector<std::string>> unlisted_beside_labs(const fs::path& folder,
                                                       const CourseList& course,
                                                       const std::set<std::string>& stores) {
  std::set<std::string> listed{kCourseJsonName, kHashList};
  listed.insert(course.files.begin(), course.files.end());
  std::set<std::string> folders = stores;
  for (const PackedLab& lab : course.labs) folders.insert(lab.name);
  for (const std::string& path : std::vector(listed.begin(), listed.end())) {
    for (const Compression& form : kCompressions) listed.insert(path + std::string(form.ending));
  }
  auto tree = list_tree(folder);
  if (!tree) return std::move(tree).errors();
  std::vector<std::string> result;
  for (const TreeEntry& entry : *tree) {
    if (entry.kind == FileKind::kDirectory || listed.contains(entry.path)) continue;
    // A link in the place of a folder has no slash, and is not what was packed.
    const std::size_t slash = entry.path.find('/');
    if (slash != std::string::npos && folders.contains(entry.path.substr(0, slash))) continue;
    result.push_back(entry.path);
  }
  return result;
}

Diagnostic other_bytes(const std::string& path, std::string why) {
  return Diagnostic{.code = "R2W0650",
                    .message = "`" + path + "` is not the file that the course was packed with",
                    .why = {std::move(why)},
                    .fix = {}};
}

/// The file itself and its compressed forms, which a server sends in its place. R2W0210.
Outcome<Done> check_own_file(const fs::path& folder, const ListedFile& file, Diagnostics& faults) {
  const auto hashes = hash_parts({folder / file.path}, std::min(file.size, kMostOfData));
  if (!hashes) return hashes.errors();
  if (hashes->size != file.size) {
    faults.push_back(other_bytes(file.path, "it has " + std::to_string(hashes->size) +
                                                " bytes, by course.json " +
                                                std::to_string(file.size)));
  } else if (hashes->sha256.empty()) {
    faults.push_back(other_bytes(file.path, "no file of a course has so many bytes"));
  } else if (hashes->sha256 != file.sha256) {
    faults.push_back(other_bytes(
        file.path, "its sha256 is " + hashes->sha256 + ", by course.json " + file.sha256));
  }
  const auto none_taken = [](std::string_view) { return false; };
  const auto wrong = wrong_compressed(folder / file.path, file.size, file.sha256, none_taken);
  if (wrong)
    faults.push_back(other_bytes(file.path + *wrong, "it does not unpack to `" + file.path + "`"));
  return Done{};
}

/// `objects` of `../objects/`; empty for a store elsewhere.
std::string store_beside_labs(const SiteStore& store) {
  constexpr std::string_view kUp = "../";
  if (!store.objects.starts_with(kUp)) return {};
  const std::string rest = store.objects.substr(kUp.size());
  return rest.substr(0, rest.find('/'));
}

}  // namespace

Outcome<SiteCheck> check_course_folder(const fs::path& folder, const Cancellation& cancellation,
                                       const ProgressSink& progress) {
  const auto text = read_file(folder / kCourseJsonName, kMostOfList);
  if (!text) return text.errors();
  const auto course = read_course_list(*text, (folder / kCourseJsonName).string());
  if (!course) return course.errors();
  SiteCheck all{.list = {.hash = course->hash,
                         .generator = course->generator,
                         .carried_page_sha256 = {},
                         .files = {}},
                .faults = {},
                .unlisted = {}};
  for (std::size_t i = 0; i < course->files.size(); ++i) {
    all.list.files.push_back({.path = course->files[i],
                              .size = course->sizes[i].size,
                              .sha256 = course->sizes[i].sha256,
                              .reason = {}});
    if (auto looked = check_own_file(folder, all.list.files.back(), all.faults); !looked)
      return std::move(looked).errors();
  }
  // course.json is what the others are compared with; its own bytes are the course's hash.
  if (auto looked = check_own_file(
          folder,
          {.path = kCourseJsonName, .size = text->size(), .sha256 = course->hash, .reason = {}},
          all.faults);
      !looked)
    return std::move(looked).errors();
  PlaceHashes hashes{{kCourseJsonName, course->hash}};
  for (const ListedFile& file : all.list.files) hashes[file.path] = file.sha256;
  std::set<std::string> stores;
  for (const PackedLab& lab : course->labs) {
    auto check = check_site_folder(folder / lab.name, cancellation, progress);
    if (!check) return check;
    if (check->list.hash != lab.sha256) {
      all.faults.push_back(
          Diagnostic{.code = "R2W0652",
                     .message = "the lab `" + lab.name + "` is another site than the course lists",
                     .why = {"its sha256 is " + check->list.hash, "course.json says " + lab.sha256},
                     .fix = {}});
    }
    for (Diagnostic& fault : check->faults) {
      fault.why.push_back("of the lab `" + lab.name + "`");
      all.faults.push_back(std::move(fault));
    }
    stores.insert(store_beside_labs(check->list.store));
    hashes.merge(places_of_lab(check->list, lab.name));
    for (const std::string& path : check->unlisted) all.unlisted.push_back(lab.name + "/" + path);
    for (ListedFile& file : check->list.files) {
      file.path = lab.name + "/" + file.path;
      all.list.files.push_back(std::move(file));
    }
  }
  const std::string sums = hash_list(hashes);
  if (auto looked = check_own_file(
          folder,
          {.path = kHashList, .size = sums.size(), .sha256 = sha256_hex(sums), .reason = {}},
          all.faults);
      !looked)
    return std::move(looked).errors();
  auto beside = unlisted_beside_labs(folder, *course, stores);
  if (!beside) return std::move(beside).errors();
  all.unlisted.insert(all.unlisted.end(), beside->begin(), beside->end());
  std::sort(all.unlisted.begin(), all.unlisted.end());
  return all;
}

}  // namespace ros2wasm
