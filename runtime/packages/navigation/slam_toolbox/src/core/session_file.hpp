// A mapping session as a file: scans, their poses and the edges between them.
#pragma once

#include <string>
#include <vector>

#include "core/pose_graph.hpp"
#include "core/scan.hpp"

namespace slam_toolbox {

struct Session {
  std::vector<Scan> scans;
  std::vector<Edge> edges;
};

/// Little-endian: "R2WSLAM1", then counts as uint32 and numbers as double, coordinates as float.
std::string to_bytes(const std::vector<Scan>& scans, const std::vector<Edge>& edges);
/// Throws std::runtime_error for a text that is not a session, or a damaged one.
Session session_of(const std::string& bytes);

}  // namespace slam_toolbox
