// See course_check.hpp.
#include "bundler/verify/course_check.hpp"

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/render/course_page.hpp"
#include "workspace_schema/diagnostic_list.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;

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
    const std::string& path = course->files[i];
    const auto hashes = hash_file(folder / path);
    if (!hashes) return hashes.errors();
    all.list.files.push_back({.path = path,
                              .size = course->sizes[i].size,
                              .sha256 = course->sizes[i].sha256,
                              .reason = {}});
    if (hashes->sha256 == course->sizes[i].sha256) continue;
    all.faults.push_back(
        Diagnostic{.code = "R2W0650",
                   .message = "`" + path + "` is not the file that the course was packed with",
                   .why = {"its sha256 is " + hashes->sha256 + ", course.json says " +
                           course->sizes[i].sha256},
                   .fix = {}});
  }
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
    for (const std::string& path : check->unlisted) all.unlisted.push_back(lab.name + "/" + path);
    for (ListedFile& file : check->list.files) {
      file.path = lab.name + "/" + file.path;
      all.list.files.push_back(std::move(file));
    }
  }
  return all;
}

}  // namespace ros2wasm
