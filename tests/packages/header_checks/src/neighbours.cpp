#include <array>
#include <cstdint>
#include <nanoflann.hpp>
#include <vector>

#include "expect.hpp"

namespace {

/// Points in the words of nanoflann.
struct Cloud {
  std::vector<std::array<double, 2>> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t index, std::size_t dimension) const {
    return points[index][dimension];
  }
  template <typename BoxT>
  bool kdtree_get_bbox(BoxT&) const {
    return false;
  }
};

}  // namespace

void check_neighbours(Expectations& expectations) {
  Cloud cloud;
  for (int x = 0; x < 20; ++x) {
    for (int y = 0; y < 20; ++y)
      cloud.points.push_back({static_cast<double>(x), static_cast<double>(y)});
  }
  using Tree =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 2>;
  Tree tree(2, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  tree.buildIndex();
  const std::array<double, 2> place = {7.25, 12.0};
  std::array<std::uint32_t, 2> indices = {};
  std::array<double, 2> squares = {};
  EXPECT(tree.knnSearch(place.data(), 2, indices.data(), squares.data()) == 2);
  EXPECT(indices[0] == 7 * 20 + 12 && near(squares[0], 0.0625));
  EXPECT(indices[1] == 8 * 20 + 12 && near(squares[1], 0.5625));
}
