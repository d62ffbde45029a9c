// See navfn.hpp.
#include "nav2_navfn_planner/navfn.hpp"

#include <algorithm>
#include <cmath>

namespace nav2_navfn_planner {
namespace {

constexpr unsigned char kObstacle = 254;
constexpr unsigned char kUnknownInCostmap = 255;
constexpr unsigned char kObstacleInCostmap = 253;
/// The work for a cell without costs, and for each cost.
constexpr float kNeutral = 50.0F;
constexpr float kFactor = 0.8F;
/// The threshold grows by this from block to block.
constexpr float kBlock = 2 * kNeutral;
constexpr float kStep = 0.5F;  // cells
/// Blocks between two questions whether the work is still wanted.
constexpr int kBlocksPerQuestion = 5000;

unsigned char work_of(unsigned char cost, bool allow_unknown) {
  if (cost < kObstacleInCostmap) {
    const float work = kNeutral + kFactor * static_cast<float>(cost);
    return static_cast<unsigned char>(std::min(work, static_cast<float>(kObstacle - 1)));
  }
  return cost == kUnknownInCostmap && allow_unknown ? kObstacle - 1 : kObstacle;
}

}  // namespace

NavFn::NavFn(int nx, int ny)
    : nx_(nx),
      ny_(ny),
      costs_(static_cast<size_t>(nx) * static_cast<size_t>(ny), kObstacle),
      potentials_(costs_.size(), kHighPotential),
      is_pending_(costs_.size(), 0) {}

void NavFn::setCostmap(const unsigned char* costs, bool allow_unknown) {
  std::transform(costs, costs + costs_.size(), costs_.begin(),
                 [allow_unknown](unsigned char cost) { return work_of(cost, allow_unknown); });
  // The border stops all that spreads: no neighbour is outside of the grid.
  for (int x = 0; x < nx_; ++x)
    costs_[index_of({x, 0})] = costs_[index_of({x, ny_ - 1})] = kObstacle;
  for (int y = 0; y < ny_; ++y)
    costs_[index_of({0, y})] = costs_[index_of({nx_ - 1, y})] = kObstacle;
}

float NavFn::heuristic(size_t index, Cell to) const {
  const int x = static_cast<int>(index % static_cast<size_t>(nx_));
  const int y = static_cast<int>(index / static_cast<size_t>(nx_));
  return kNeutral * static_cast<float>(std::hypot(x - to.x, y - to.y));
}

void NavFn::add(std::vector<size_t>& block, size_t index) {
  if (is_pending_[index] != 0 || costs_[index] >= kObstacle) return;
  is_pending_[index] = 1;
  block.push_back(index);
}

float NavFn::potential_from_neighbours(size_t index) const {
  const size_t row = static_cast<size_t>(nx_);
  const float across = std::min(potentials_[index - 1], potentials_[index + 1]);
  const float along = std::min(potentials_[index - row], potentials_[index + row]);
  const float lower = std::min(across, along);
  const float difference = std::abs(across - along);
  const float work = costs_[index];
  if (difference >= work) return lower + work;
  // A plane wave through both neighbours, by a quadratic fit.
  const float share = difference / work;
  return lower + work * (-0.2301F * share * share + 0.5307F * share + 0.7040F);
}

void NavFn::spread(size_t index, float rank) {
  const size_t row = static_cast<size_t>(nx_);
  constexpr float kDiagonal = 0.707106781F;
  for (const size_t neighbour : {index - 1, index + 1, index - row, index + row}) {
    const float gain = kDiagonal * static_cast<float>(costs_[neighbour]);
    if (potentials_[neighbour] > rank + gain) {
      add(rank < threshold_ ? next_ : later_, neighbour);
    }
  }
}

bool NavFn::computePotential(Cell from, Cell to, bool use_astar,
                             const std::function<bool()>& cancel_checker) {
  std::fill(potentials_.begin(), potentials_.end(), kHighPotential);
  std::fill(is_pending_.begin(), is_pending_.end(), static_cast<unsigned char>(0));
  now_.clear();
  next_.clear();
  later_.clear();
  const auto is_inside = [this](Cell cell) {
    return cell.x > 0 && cell.y > 0 && cell.x < nx_ - 1 && cell.y < ny_ - 1;
  };
  // Nothing spreads from the border.
  if (!is_inside(from)) return false;
  start_ = from;
  const size_t first = index_of(from);
  const size_t last = index_of(to);
  const size_t row = static_cast<size_t>(nx_);
  potentials_[first] = 0.0F;
  for (const size_t neighbour : {first + 1, first - 1, first - row, first + row}) {
    add(now_, neighbour);
  }
  threshold_ = kObstacle + (use_astar ? heuristic(first, to) : 0.0F);

  for (int blocks = 0;; ++blocks) {
    if (blocks % kBlocksPerQuestion == 0 && cancel_checker && cancel_checker()) return false;
    if (now_.empty()) break;
    for (const size_t index : now_) is_pending_[index] = 0;
    for (const size_t index : now_) {
      const float potential = potential_from_neighbours(index);
      if (potential >= potentials_[index]) continue;
      potentials_[index] = potential;
      // With A*, cells in the direction of the goal are worked on first, and others less often.
      spread(index, use_astar ? potential + heuristic(index, to) : potential);
    }
    now_.swap(next_);
    next_.clear();
    if (now_.empty()) {
      threshold_ += kBlock;
      now_.swap(later_);
    }
    if (potentials_[last] < kHighPotential) break;
  }
  return potentials_[last] < kHighPotential;
}

NavFn::Gradient NavFn::gradient_at(size_t index) const {
  Gradient gradient;
  const size_t row = static_cast<size_t>(nx_);
  const int x = static_cast<int>(index % row);
  const int y = static_cast<int>(index / row);
  if (x < 1 || y < 1 || x > nx_ - 2 || y > ny_ - 2) return gradient;
  const float own = potentials_[index];
  const auto slope = [&](size_t before, size_t after) {
    const float low = potentials_[before];
    const float high = potentials_[after];
    if (own >= kHighPotential) {
      // In an obstacle: out of it.
      if (low < kHighPotential) return -static_cast<float>(kObstacle);
      return high < kHighPotential ? static_cast<float>(kObstacle) : 0.0F;
    }
    float sum = 0.0F;
    if (low < kHighPotential) sum += low - own;
    if (high < kHighPotential) sum += own - high;
    return sum;
  };
  const float dx = slope(index - 1, index + 1);
  const float dy = slope(index - row, index + row);
  const float length = std::hypot(dx, dy);
  if (length > 0) {
    gradient.x = dx / length;
    gradient.y = dy / length;
  }
  return gradient;
}

/// A cell and those around it.
std::array<size_t, 9> NavFn::surroundings(size_t index) const {
  const size_t row = static_cast<size_t>(nx_);
  return {index,     index - row - 1, index - row, index - row + 1, index - 1,
          index + 1, index + row - 1, index + row, index + row + 1};
}

size_t NavFn::lowest_neighbour(size_t index) const {
  const auto cells = surroundings(index);
  return *std::min_element(cells.begin(), cells.end(),
                           [this](size_t a, size_t b) { return potentials_[a] < potentials_[b]; });
}

bool NavFn::has_high_neighbour(size_t index) const {
  const auto cells = surroundings(index);
  return std::any_of(cells.begin(), cells.end(),
                     [this](size_t cell) { return potentials_[cell] >= kHighPotential; });
}

NavFn::Gradient NavFn::mixed(const Gradient& a, const Gradient& b, float share) {
  return {(1 - share) * a.x + share * b.x, (1 - share) * a.y + share * b.y};
}

std::vector<PathPoint> NavFn::path(Cell from, int most_steps) const {
  const size_t row = static_cast<size_t>(nx_);
  std::vector<PathPoint> points;
  size_t index = index_of(from);
  // From the cell, in cells.
  float dx = 0.0F;
  float dy = 0.0F;
  for (int step = 0; step < most_steps; ++step) {
    const auto x = static_cast<int>(index % row);
    const auto y = static_cast<int>(index / row);
    if (x < 1 || y < 1 || x > nx_ - 2 || y > ny_ - 2) return {};
    const Cell nearest{x + static_cast<int>(std::round(dx)), y + static_cast<int>(std::round(dy))};
    if (potential(nearest) < kNeutral) {
      points.push_back({static_cast<float>(start_.x), static_cast<float>(start_.y)});
      return points;
    }
    points.push_back({static_cast<float>(x) + dx, static_cast<float>(y) + dy});
    const size_t count = points.size();
    const bool swings = count > 2 && points[count - 1].x == points[count - 3].x &&
                        points[count - 1].y == points[count - 3].y;
    if (swings || has_high_neighbour(index)) {
      // Beside an obstacle: from cell to cell.
      index = lowest_neighbour(index);
      if (potentials_[index] >= kHighPotential) return {};
      dx = dy = 0.0F;
      continue;
    }
    const Gradient low = mixed(gradient_at(index), gradient_at(index + 1), dx);
    const Gradient high = mixed(gradient_at(index + row), gradient_at(index + row + 1), dx);
    const Gradient slope = mixed(low, high, dy);
    const float length = std::hypot(slope.x, slope.y);
    if (!(length > 0)) return {};
    dx += slope.x * kStep / length;
    dy += slope.y * kStep / length;
    if (std::abs(dx) > 1.0F) {
      index += dx > 0 ? 1 : static_cast<size_t>(-1);
      dx -= std::copysign(1.0F, dx);
    }
    if (std::abs(dy) > 1.0F) {
      index += dy > 0 ? row : static_cast<size_t>(-nx_);
      dy -= std::copysign(1.0F, dy);
    }
  }
  return {};
}

}  // namespace nav2_navfn_planner
