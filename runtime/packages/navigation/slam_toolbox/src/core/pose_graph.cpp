// See pose_graph.hpp. Levenberg and Marquardt's method: the normal equations of all edges, damped
// as much as it takes for the error to fall.
#include "core/pose_graph.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>

namespace slam_toolbox {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Solver = Eigen::SimplicialLDLT<SparseMatrix>;

constexpr int kMostRounds = 50;
constexpr double kLeastProgress = 1e-6;  // of the error
constexpr double kLeastDamping = 1e-9;
constexpr double kMostDamping = 1e9;

Eigen::Vector3d error_of(const Edge& edge, const Pose& from, const Pose& to) {
  const Pose way = inverse(from) * to;
  return {way.x - edge.way.x, way.y - edge.way.y, wrapped(way.yaw - edge.way.yaw)};
}

double cost_of(const std::vector<Edge>& edges, const std::vector<Pose>& poses) {
  double cost = 0.0;
  for (const Edge& edge : edges) {
    const Eigen::Vector3d error =
        error_of(edge, poses[static_cast<size_t>(edge.from)], poses[static_cast<size_t>(edge.to)]);
    cost += error.dot(edge.information * error);
  }
  return cost;
}

/// The normal equations of all nodes but the first.
struct Equations {
  SparseMatrix matrix;
  Eigen::VectorXd vector;
};

Equations equations_of(const std::vector<Edge>& edges, const std::vector<Pose>& poses) {
  const auto size = static_cast<Eigen::Index>(3 * (poses.size() - 1));
  Equations result{SparseMatrix(size, size), Eigen::VectorXd::Zero(size)};
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(36 * edges.size());
  for (const Edge& edge : edges) {
    const Pose& from = poses[static_cast<size_t>(edge.from)];
    const Pose& to = poses[static_cast<size_t>(edge.to)];
    const double c = std::cos(from.yaw);
    const double s = std::sin(from.yaw);
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    std::array<Eigen::Matrix3d, 2> slopes;
    slopes[0] << -c, -s, -s * dx + c * dy, s, -c, -c * dx - s * dy, 0.0, 0.0, -1.0;
    slopes[1] << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
    const std::array<int, 2> nodes{edge.from, edge.to};
    const Eigen::Vector3d error = error_of(edge, from, to);
    for (size_t i = 0; i < 2; ++i) {
      // The first node is fixed.
      if (nodes[i] == 0) continue;
      const Eigen::Matrix3d weighted = slopes[i].transpose() * edge.information;
      const Eigen::Index row = 3 * (nodes[i] - 1);
      result.vector.segment<3>(row) -= weighted * error;
      for (size_t j = 0; j < 2; ++j) {
        if (nodes[j] == 0) continue;
        const Eigen::Matrix3d block = weighted * slopes[j];
        const Eigen::Index column = 3 * (nodes[j] - 1);
        for (int k = 0; k < 9; ++k) {
          entries.emplace_back(row + k / 3, column + k % 3, block(k / 3, k % 3));
        }
      }
    }
  }
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

std::vector<Pose> moved(const std::vector<Pose>& poses, const Eigen::VectorXd& step) {
  std::vector<Pose> result = poses;
  for (size_t i = 1; i < result.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(3 * (i - 1));
    result[i].x += step(row);
    result[i].y += step(row + 1);
    result[i].yaw = wrapped(result[i].yaw + step(row + 2));
  }
  return result;
}

}  // namespace

void PoseGraph::add_node() {
  neighbours_.emplace_back();
}

bool PoseGraph::are_linked(int from, int to) const {
  const std::vector<int>& others = neighbours(from);
  return std::find(others.begin(), others.end(), to) != others.end();
}

void PoseGraph::link(int from, const Pose& from_pose, int to, const Pose& to_pose,
                     const Eigen::Matrix3d& covariance) {
  if (from == to || are_linked(from, to)) return;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation(0, 0) = rotation(1, 1) = std::cos(from_pose.yaw);
  rotation(0, 1) = std::sin(from_pose.yaw);
  rotation(1, 0) = -rotation(0, 1);
  const Eigen::Matrix3d turned = rotation * covariance * rotation.transpose();
  link({from, to, inverse(from_pose) * to_pose, turned.inverse()});
}

void PoseGraph::link(const Edge& edge) {
  edges_.push_back(edge);
  neighbours_[static_cast<size_t>(edge.from)].push_back(edge.to);
  neighbours_[static_cast<size_t>(edge.to)].push_back(edge.from);
}

bool PoseGraph::optimize(std::vector<Pose>& poses) const {
  if (poses.size() < 2 || edges_.empty()) return false;
  double cost = cost_of(edges_, poses);
  double damping = 1e-4;
  bool is_better = false;
  Solver solver;
  for (int round = 0; round < kMostRounds && cost > 0.0; ++round) {
    const Equations equations = equations_of(edges_, poses);
    double next_cost = cost;
    while (damping < kMostDamping) {
      SparseMatrix damped = equations.matrix;
      for (Eigen::Index i = 0; i < damped.rows(); ++i) damped.coeffRef(i, i) *= 1.0 + damping;
      solver.compute(damped);
      if (solver.info() == Eigen::Success) {
        std::vector<Pose> next = moved(poses, solver.solve(equations.vector));
        next_cost = cost_of(edges_, next);
        if (next_cost < cost) {
          poses = std::move(next);
          break;
        }
      }
      damping *= 10.0;
    }
    if (!(next_cost < cost)) break;
    is_better = true;
    const bool is_done = cost - next_cost < kLeastProgress * cost;
    cost = next_cost;
    damping = std::max(damping / 10.0, kLeastDamping);
    if (is_done) break;
  }
  return is_better;
}

}  // namespace slam_toolbox
