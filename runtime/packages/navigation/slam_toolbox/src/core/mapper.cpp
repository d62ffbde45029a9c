// See mapper.hpp.
#include "core/mapper.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace slam_toolbox {
namespace {

constexpr double kTolerance = 1e-6;
constexpr double kFarVariance = 500.0;

double squared(double value) {
  return value * value;
}

/// Poses with covariances become one; the surer counts more.
class WeightedMean {
 public:
  void add(const Pose& pose, const Eigen::Matrix3d& covariance) {
    const Eigen::Matrix3d weight = covariance.inverse();
    sum_ += weight;
    // Angles as differences from the first, so that they do not wrap.
    if (is_first_) yaw_ = pose.yaw;
    is_first_ = false;
    weighted_ += weight * Eigen::Vector3d(pose.x, pose.y, wrapped(pose.yaw - yaw_));
  }
  Pose mean() const {
    const Eigen::Vector3d mean = sum_.inverse() * weighted_;
    return {mean.x(), mean.y(), wrapped(yaw_ + mean.z())};
  }

 private:
  bool is_first_ = true;
  double yaw_ = 0.0;
  Eigen::Matrix3d sum_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d weighted_ = Eigen::Vector3d::Zero();
};

}  // namespace

Mapper::Mapper(const MapperSettings& settings)
    : settings_(settings),
      matcher_(settings.correlation, settings.matcher),
      loop_matcher_(settings.loop, settings.matcher) {}

std::optional<Eigen::Matrix3d> Mapper::process(Scan scan) {
  if (!scans_.empty()) {
    const Scan& last = scans_.back();
    scan.corrected = last.corrected * (inverse(last.odometry) * scan.odometry);
    if (!has_moved(scan)) return std::nullopt;
  }
  return add(std::move(scan), {running_.begin(), running_.end()});
}

std::optional<Eigen::Matrix3d> Mapper::process_near(Scan scan) {
  std::vector<int> base;
  const Point here = scan.corrected.position();
  for (size_t i = 0; i < scans_.size(); ++i) {
    const double distance = squared_distance(scans_[i].corrected.position(), here);
    if (distance < squared(settings_.loop_search_maximum_distance)) {
      base.push_back(static_cast<int>(i));
    }
  }
  running_.clear();
  return add(std::move(scan), base);
}

bool Mapper::has_moved(const Scan& scan) const {
  const Scan& last = scans_.back();
  const double turned = std::abs(wrapped(scan.odometry.yaw - last.odometry.yaw));
  if (turned >= settings_.minimum_travel_heading) return true;
  const double moved = squared_distance(scan.odometry * scan.sensor, last.odometry * scan.sensor);
  return moved >= squared(settings_.minimum_travel_distance) - kTolerance;
}

std::optional<Eigen::Matrix3d> Mapper::add(Scan scan, const Chain& base) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  if (settings_.use_scan_matching && !base.empty()) {
    const Match match = matcher_.match(scan, scan.corrected, pointers(base));
    scan.corrected = match.pose;
    covariance = match.covariance;
  }
  const int index = static_cast<int>(scans_.size());
  scans_.push_back(std::move(scan));
  graph_.add_node();
  if (settings_.use_scan_matching) {
    if (index > 0) add_edges(index, base, covariance);
    add_to_running(index);
    if (settings_.do_loop_closing) close_loops(index);
  }
  return covariance;
}

std::vector<const Scan*> Mapper::pointers(const std::vector<int>& indices) const {
  std::vector<const Scan*> result;
  result.reserve(indices.size());
  for (const int index : indices) result.push_back(&at(index));
  return result;
}

void Mapper::add_to_running(int scan) {
  running_.push_back(scan);
  const auto is_too_long = [this] {
    return static_cast<int>(running_.size()) > settings_.scan_buffer_size ||
           squared_distance(place(running_.front()), place(running_.back())) >
               squared(settings_.scan_buffer_maximum_scan_distance);
  };
  while (running_.size() > 1 && is_too_long()) running_.pop_front();
}

void Mapper::add_edges(int scan, const Chain& base, const Eigen::Matrix3d& covariance) {
  // After a new start somewhere else, odometry says nothing about the way there.
  if (!running_.empty()) {
    graph_.link(scan - 1, at(scan - 1).corrected, scan, at(scan).corrected, covariance);
  }
  link_chain(base, scan, at(scan).corrected, covariance);
  if (graph_.neighbours(scan).empty()) {
    // Far from all others: a pose without any edge would leave the graph without a solution.
    graph_.link(scan - 1, at(scan - 1).corrected, scan, at(scan).corrected,
                kFarVariance * Eigen::Matrix3d::Identity());
  }
  WeightedMean mean;
  mean.add(at(scan).corrected, covariance);
  for (const Chain& chain : near_chains(scan)) {
    const Match match = matcher_.match(at(scan), at(scan).corrected, pointers(chain), false);
    if (match.response <= settings_.link_match_minimum_response_fine - kTolerance) continue;
    mean.add(match.pose, match.covariance);
    link_chain(chain, scan, match.pose, match.covariance);
  }
  at(scan).corrected = mean.mean();
}

void Mapper::link_chain(const Chain& chain, int scan, const Pose& pose,
                        const Eigen::Matrix3d& covariance) {
  int nearest = -1;
  double least = squared(settings_.link_scan_maximum_distance) + kTolerance;
  for (const int other : chain) {
    const double distance = squared_distance(place(other), place(scan));
    if (distance >= least) continue;
    least = distance;
    nearest = other;
  }
  if (nearest >= 0) graph_.link(nearest, at(nearest).corrected, scan, pose, covariance);
}

std::vector<Mapper::Chain> Mapper::near_chains(int scan) const {
  const double most = settings_.link_scan_maximum_distance;
  std::vector<Chain> chains;
  std::set<int> used;
  const auto is_near = [&](int other) {
    return squared_distance(place(other), place(scan)) < squared(most) + kTolerance;
  };
  for (const int start : linked_within(scan, most)) {
    if (start == scan || used.count(start) > 0) continue;
    int first = start;
    int last = start;
    while (first > 0 && is_near(first - 1)) --first;
    while (last + 1 < scan && is_near(last + 1)) ++last;
    Chain chain;
    for (int i = first; i <= last; ++i) {
      chain.push_back(i);
      used.insert(i);
    }
    // The scans just before were matched already.
    if (last + 1 < scan) chains.push_back(chain);
  }
  return chains;
}

std::set<int> Mapper::linked_within(int scan, double distance) const {
  std::set<int> seen{scan};
  std::vector<int> open{scan};
  while (!open.empty()) {
    const int current = open.back();
    open.pop_back();
    for (const int other : graph_.neighbours(current)) {
      const bool is_near = squared_distance(place(other), place(scan)) <= squared(distance);
      if (is_near && seen.insert(other).second) open.push_back(other);
    }
  }
  return seen;
}

void Mapper::close_loops(int scan) {
  int begin = 0;
  std::set<int> linked = linked_within(scan, settings_.loop_search_maximum_distance);
  for (;;) {
    const Chain chain = next_loop(scan, linked, begin);
    if (chain.empty()) return;
    if (close_loop(scan, chain)) {
      linked = linked_within(scan, settings_.loop_search_maximum_distance);
    }
  }
}

Mapper::Chain Mapper::next_loop(int scan, const std::set<int>& linked, int& begin) const {
  const auto least = static_cast<size_t>(std::max(settings_.loop_match_minimum_chain_size, 1));
  const double most = squared(settings_.loop_search_maximum_distance) + kTolerance;
  Chain chain;
  for (; begin < scan; ++begin) {
    if (squared_distance(place(begin), place(scan)) >= most) {
      if (chain.size() >= least) return chain;
      chain.clear();
    } else if (linked.count(begin) > 0) {
      chain.clear();
    } else {
      chain.push_back(begin);
    }
  }
  if (chain.size() < least) chain.clear();
  return chain;
}

bool Mapper::close_loop(int scan, const Chain& chain) {
  const std::vector<const Scan*> base = pointers(chain);
  const Match coarse = loop_matcher_.match(at(scan), at(scan).corrected, base, false, false);
  if (coarse.response <= settings_.loop_match_minimum_response_coarse ||
      coarse.covariance(0, 0) >= settings_.loop_match_maximum_variance_coarse ||
      coarse.covariance(1, 1) >= settings_.loop_match_maximum_variance_coarse) {
    return false;
  }
  const Match fine = matcher_.match(at(scan), coarse.pose, base, false);
  if (fine.response < settings_.loop_match_minimum_response_fine) return false;
  at(scan).corrected = fine.pose;
  link_chain(chain, scan, fine.pose, fine.covariance);
  correct();
  ++closed_loops_;
  return true;
}

void Mapper::correct() {
  std::vector<Pose> poses;
  poses.reserve(scans_.size());
  for (const Scan& scan : scans_) poses.push_back(scan.corrected);
  if (!graph_.optimize(poses)) return;
  for (size_t i = 0; i < scans_.size(); ++i) scans_[i].corrected = poses[i];
  ++revision_;
}

void Mapper::restore(std::vector<Scan> scans, const std::vector<Edge>& edges) {
  scans_ = std::move(scans);
  running_.clear();
  graph_ = PoseGraph();
  for (size_t i = 0; i < scans_.size(); ++i) graph_.add_node();
  const int count = static_cast<int>(scans_.size());
  for (const Edge& edge : edges) {
    const bool exists = edge.from >= 0 && edge.to >= 0 && edge.from < count && edge.to < count;
    if (exists && edge.from != edge.to) graph_.link(edge);
  }
  ++revision_;
}

}  // namespace slam_toolbox
