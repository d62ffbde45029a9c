// Poses and what is known about the way from one to another; the poses that fit best to all of it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/planar.hpp"

namespace slam_toolbox {

struct Edge {
  int from = 0;
  int to = 0;
  Pose way;  ///< `to` in the frame of `from`
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
};

class PoseGraph {
 public:
  /// Nodes are counted from 0.
  void add_node();
  bool are_linked(int from, int to) const;
  /// The covariance is in the frame of the map.
  void link(int from, const Pose& from_pose, int to, const Pose& to_pose,
            const Eigen::Matrix3d& covariance);
  void link(const Edge& edge);

  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<int>& neighbours(int node) const {
    return neighbours_[static_cast<size_t>(node)];
  }

  /// Moves all poses but the first, so that they fit better to the edges. Returns false when no
  /// move makes the error smaller.
  bool optimize(std::vector<Pose>& poses) const;

 private:
  std::vector<Edge> edges_;
  std::vector<std::vector<int>> neighbours_;
};

}  // namespace slam_toolbox
