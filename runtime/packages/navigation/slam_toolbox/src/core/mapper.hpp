// Scans become a map: each is matched to those before it, and to what was seen long ago.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "core/pose_graph.hpp"
#include "core/scan_matcher.hpp"

namespace slam_toolbox {

struct MapperSettings {
  bool use_scan_matching = true;
  bool use_scan_barycenter = true;  ///< distances between scans are those of the middles of hits
  double minimum_travel_distance = 0.5;  ///< [m]
  double minimum_travel_heading = 0.5;   ///< [rad]
  int scan_buffer_size = 10;
  double scan_buffer_maximum_scan_distance = 10.0;  ///< [m]
  double link_match_minimum_response_fine = 0.1;
  double link_scan_maximum_distance = 1.5;    ///< [m]
  double loop_search_maximum_distance = 3.0;  ///< [m]
  bool do_loop_closing = true;
  int loop_match_minimum_chain_size = 10;
  double loop_match_maximum_variance_coarse = 3.0;  ///< [m^2]
  double loop_match_minimum_response_coarse = 0.35;
  double loop_match_minimum_response_fine = 0.45;
  SearchSpace correlation{0.5, 0.01, 0.1};
  SearchSpace loop{8.0, 0.05, 0.03};
  MatcherSettings matcher;
};

class Mapper {
 public:
  explicit Mapper(const MapperSettings& settings);

  /// Adds a scan unless the robot has hardly moved since the last one. Sets its corrected pose.
  /// Returns the covariance of the pose when it was added.
  std::optional<Eigen::Matrix3d> process(Scan scan);
  /// Adds a scan of a robot that has just been put somewhere: it is matched to the scans around its
  /// corrected pose, and the next ones follow from there.
  std::optional<Eigen::Matrix3d> process_near(Scan scan);

  const std::vector<Scan>& scans() const { return scans_; }
  const PoseGraph& graph() const { return graph_; }
  /// Counts how often poses of old scans were changed.
  int revision() const { return revision_; }
  int closed_loops() const { return closed_loops_; }

  /// Replaces scans and graph by those of a session; edges of missing scans are skipped.
  void restore(std::vector<Scan> scans, const std::vector<Edge>& edges);

 private:
  using Chain = std::vector<int>;

  bool has_moved(const Scan& scan) const;
  std::optional<Eigen::Matrix3d> add(Scan scan, const Chain& base);
  Scan& at(int index) { return scans_[static_cast<size_t>(index)]; }
  const Scan& at(int index) const { return scans_[static_cast<size_t>(index)]; }
  Point place(int index) const { return at(index).place(settings_.use_scan_barycenter); }
  std::vector<const Scan*> pointers(const std::vector<int>& indices) const;

  void add_edges(int scan, const Chain& base, const Eigen::Matrix3d& covariance);
  void link_chain(const Chain& chain, int scan, const Pose& pose,
                  const Eigen::Matrix3d& covariance);
  std::vector<Chain> near_chains(int scan) const;
  /// Scans that are linked to this one by scans that are all within the distance, with itself.
  std::set<int> linked_within(int scan, double distance) const;
  void close_loops(int scan);
  Chain next_loop(int scan, const std::set<int>& linked, int& begin) const;
  bool close_loop(int scan, const Chain& chain);
  void correct();
  void add_to_running(int scan);

  MapperSettings settings_;
  ScanMatcher matcher_;
  ScanMatcher loop_matcher_;
  std::vector<Scan> scans_;
  std::deque<int> running_;  ///< the newest scans, which the next is matched to
  PoseGraph graph_;
  int revision_ = 0;
  int closed_loops_ = 0;
};

}  // namespace slam_toolbox
