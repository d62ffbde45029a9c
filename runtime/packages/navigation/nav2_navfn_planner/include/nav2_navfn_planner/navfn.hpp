// The navigation function: potentials over a grid that grow with the cost of the way from a cell,
// and paths down their gradient. Without ROS.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace nav2_navfn_planner {

struct Cell {
  int x;
  int y;
};

/// In cells; the lower left corner of cell 0 is 0.
struct PathPoint {
  float x;
  float y;
};

class NavFn {
 public:
  /// Potentials of cells that were not reached.
  static constexpr float kHighPotential = 1.0e10F;

  NavFn(int nx, int ny);
  int nx() const { return nx_; }
  int ny() const { return ny_; }

  /// Takes the costs of a costmap (nx times ny). Cells of 253 and more are obstacles, and so is the
  /// border. Unknown cells are obstacles too, or with `allow_unknown` the most expensive ones.
  void setCostmap(const unsigned char* costs, bool allow_unknown);
  /// Spreads potentials from a cell until they reach another. `cancel_checker` is asked now and
  /// then: when it is true, the work ends and this is false. It is also false when the cell was not
  /// reached, which a caller may accept.
  bool computePotential(Cell from, Cell to, bool use_astar,
                        const std::function<bool()>& cancel_checker);
  float potential(Cell cell) const { return potentials_[index_of(cell)]; }
  /// From a cell down to where the potentials began, in steps of half a cell; empty when there is
  /// no way.
  std::vector<PathPoint> path(Cell from, int most_steps) const;

 private:
  /// Its length is 1, or 0 where it is not defined.
  struct Gradient {
    float x = 0.0F;
    float y = 0.0F;
  };

  size_t index_of(Cell cell) const {
    return static_cast<size_t>(cell.y) * static_cast<size_t>(nx_) + static_cast<size_t>(cell.x);
  }
  float heuristic(size_t index, Cell to) const;
  float potential_from_neighbours(size_t index) const;
  void spread(size_t index, float rank);
  void add(std::vector<size_t>& block, size_t index);
  Gradient gradient_at(size_t index) const;
  static Gradient mixed(const Gradient& a, const Gradient& b, float share);
  std::array<size_t, 9> surroundings(size_t index) const;
  size_t lowest_neighbour(size_t index) const;
  bool has_high_neighbour(size_t index) const;

  int nx_;
  int ny_;
  Cell start_{0, 0};  // where the potentials began
  std::vector<unsigned char> costs_;
  std::vector<float> potentials_;
  // Blocks of cells to work on: now, next below the threshold, and above it.
  std::vector<size_t> now_;
  std::vector<size_t> next_;
  std::vector<size_t> later_;
  std::vector<unsigned char> is_pending_;
  float threshold_ = 0.0F;
};

}  // namespace nav2_navfn_planner
