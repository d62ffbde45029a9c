// Packs the workspaces of a course.yaml into one folder: a site each, what they share once, and a
// page that lists them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/render/course_page.hpp"
#include "bundler/request.hpp"

namespace ros2wasm {

/// Is it a course.yaml, or a folder that has one and no workspace.yaml?
[[nodiscard]] bool is_course(const std::string& input);

struct CourseRequest {
  PackRequest pack;    ///< what the labs have alike; `output` is the course's
  bool prune = false;  ///< remove earlier packs, labs that are not listed, and objects of none
};

struct CourseReport {
  std::string sha256;  ///< of course.json
  std::vector<PackedLab> labs;
  std::uint64_t bytes = 0;    ///< of all that the course's folder has then
  std::uint64_t removed = 0;  ///< bytes that --prune removed
  Diagnostics warnings;
  std::vector<std::string> remarks;
};

/// The errors of read_course() and pack() for all labs; R2W0601, R2W0615 for the form of the
/// output.
[[nodiscard]] Outcome<CourseReport> pack_course(const CourseRequest& request,
                                                const Cancellation& cancellation,
                                                const ProgressSink& progress);

}  // namespace ros2wasm
