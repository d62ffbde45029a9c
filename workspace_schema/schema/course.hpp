// course.yaml, read: workspaces that are packed into one folder, with a page that lists them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

struct CourseLab {
  Spanned<std::string> workspace;  ///< a folder or a manifest, relative to course.yaml
  std::string name;                ///< its folder in the course
  std::string title;               ///< empty: that of the workspace
  std::string description;
};

struct Course {
  std::string name;
  std::string title;
  std::string text;  ///< paragraphs with empty lines between
  std::vector<CourseLab> labs;
};

/// `file` is how the person named it. R2W0101 not YAML, R2W0102 unknown key, R2W0103 wrong type or
/// value, R2W0104 bad name, R2W0105 duplicate key, R2W0106 a required key is missing, R2W0107
/// schema, R2W0114 path.
[[nodiscard]] Outcome<Course> read_course(std::string_view text, const std::string& file);

}  // namespace ros2wasm
