// The files of a course beside its labs: the page that lists them, and course.json. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/site/site_file.hpp"
#include "bundler/site/site_names.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/course.hpp"

namespace ros2wasm {

/// A lab that is packed.
struct PackedLab {
  std::string name;
  std::string title;
  std::string description;
  std::string sha256;                   ///< of its site
  std::vector<std::string> tasks = {};  ///< titles of what it asks for
};

/// index.html and course.css, when a lab has tasks also course.js (these bytes), and course.json,
/// which lists those and the labs, at the end.
[[nodiscard]] std::vector<PlannedFile> course_files(const Course& course,
                                                    const std::vector<PackedLab>& labs,
                                                    const std::string& script);

struct CourseList {
  std::string hash;  ///< sha256 of course.json: of all labs by their hashes
  std::string generator;
  std::string title;
  std::vector<PackedLab> labs;
  std::vector<FilePart> sizes;     ///< of the course's own files
  std::vector<std::string> files;  ///< their names, which are plain
};

/// R2W0605 not a course.json of ours.
[[nodiscard]] Outcome<CourseList> read_course_list(std::string_view text, const std::string& shown);

}  // namespace ros2wasm
