// The file that a student hands in: which tasks of which labs are done, signed by a key of the
// student's browser (runtime/site/ui/model/progress_file.ts writes it). Pure; do not trust the
// text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Bytes; a course of a hundred labs has less.
inline constexpr std::uint64_t kMostOfProgressFile = std::uint64_t{4} << 20U;

/// Times are ISO 8601 in UTC by the student's clock; empty: it did not happen.
struct HandedTask {
  std::string title;
  std::string done_at;
  std::string hint_at;
  std::string solution_at;
};

struct HandedLab {
  std::string title;
  std::string sha256;  ///< of the site, at the export
  std::vector<HandedTask> tasks;
};

struct ProgressFile {
  std::string student;  ///< as typed; one line without control characters, as all texts here
  std::string exported_at;
  std::string course;  ///< its title; empty: handed in from the page of one lab
  std::vector<HandedLab> labs;
  std::string key;  ///< the first 16 hex digits of the sha256 of the browser's public key
};

/// R2W0670 not such a file, R2W0671 it was changed after it was signed.
[[nodiscard]] Outcome<ProgressFile> read_progress_file(std::string_view text,
                                                       const std::string& shown);

/// The tasks of a site, and what its pages call it.
struct AskedTasks {
  std::string sha256;
  std::vector<std::string> titles;  ///< of its tasks
  std::vector<std::string> names;   ///< its own title, and that in the list of its course
  std::string course;               ///< title of the course that lists this site; empty: none does
};

/// `site_json` must be one that read_site_list() takes. R2W0605.
[[nodiscard]] Outcome<AskedTasks> asked_tasks(std::string_view site_json, const std::string& shown);

/// R2W0672 a lab of the file is none of these sites, is there twice, or has another title or other
/// tasks; or the file is of another course.
[[nodiscard]] Diagnostics check_progress(const ProgressFile& file,
                                         const std::vector<AskedTasks>& sites,
                                         const std::string& shown);

/// R2W0674, a warning: the file is of a whole course, and lacks labs of it that have tasks.
[[nodiscard]] std::optional<Diagnostic> lacking_labs(const ProgressFile& file,
                                                     const std::vector<AskedTasks>& sites,
                                                     const std::string& shown);

/// CSV for a spreadsheet: a head, and one row for each task. No cell is a formula.
[[nodiscard]] std::string progress_csv_head();
[[nodiscard]] std::string progress_csv(const ProgressFile& file, const std::string& shown);

}  // namespace ros2wasm
