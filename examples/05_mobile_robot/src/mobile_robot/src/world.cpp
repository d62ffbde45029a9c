// See world.hpp.
#include "world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace world {
namespace {

/// One character is a square of 25 cm, `#` a wall; y is up.
constexpr std::array<std::string_view, 28> kPicture{
    "########################################",
    "###        #      ####             #####",
    "###        #      ####             #####",
    "###        #      ####             #####",
    "###        #                       #####",
    "###        #                           #",
    "###        #                           #",
    "#          #                           #",
    "#          #                           #",
    "#          #                           #",
    "#          #                           #",
    "#                                      #",
    "#                                      #",
    "#                                      #",
    "#                                      #",
    "#                                      #",
    "#                                      #",
    "#          #                           #",
    "#          #                           #",
    "#          #                           #",
    "#          #                           #",
    "#          #          ##      ##       #",
    "#          #          ##      ##       #",
    "#          #                           #",
    "#####      #                           #",
    "#####      #                           #",
    "#####      #                           #",
    "########################################",
};
constexpr double kSquare = 0.25;  // metres

}  // namespace

bool is_wall(double x, double y) {
  const double column = std::floor((x - kLeft) / kSquare);
  const double row = std::floor((y - kBottom) / kSquare);
  if (!(column >= 0 && row >= 0 && row < static_cast<double>(kPicture.size()))) return true;
  const std::string_view line = kPicture[kPicture.size() - 1 - static_cast<std::size_t>(row)];
  return column >= static_cast<double>(line.size()) || line[static_cast<std::size_t>(column)] == '#';
}

bool has_room(double x, double y, double radius) {
  constexpr int kSides = 24;  // nearer to each other than a square is wide
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * M_PI * i / kSides;
    if (is_wall(x + radius * std::cos(angle), y + radius * std::sin(angle))) return false;
  }
  return true;
}

double ray(double x, double y, double angle, double farthest) {
  // From one border of squares to the next: no wall is jumped over.
  const double dx = std::cos(angle);
  const double dy = std::sin(angle);
  const auto to_border = [](double place, double direction) {
    const double squares = place / kSquare;
    if (direction > 0) return (std::floor(squares) + 1 - squares) * kSquare / direction;
    if (direction < 0) return (squares - std::ceil(squares) + 1) * kSquare / -direction;
    return HUGE_VAL;
  };
  constexpr double kBeyond = 1e-6;  // metres: into the next square
  double gone = 0;
  while (gone < farthest && !is_wall(x + dx * gone, y + dy * gone)) {
    gone += std::min(to_border(x + dx * gone - kLeft, dx), to_border(y + dy * gone - kBottom, dy));
    gone += kBeyond;
  }
  return std::min(gone, farthest);
}

std::vector<std::int8_t> cells() {
  std::vector<std::int8_t> all;
  all.reserve(static_cast<std::size_t>(kColumns) * kRows);
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      all.push_back(is_wall(kLeft + (column + 0.5) * kCell, kBottom + (row + 0.5) * kCell) ? 100 : 0);
  return all;
}

}  // namespace world
