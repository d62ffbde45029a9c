// The sheet that turtles draw on: its pixels, and the strokes that nobody was told of yet.
// Knows nothing of turtles or of ROS.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace turtlesim {

struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
};

struct Pen {
  Rgb color{0xb3, 0xb8, 0xff};
  int width = 3;  ///< [px]
  bool is_on = true;
};

/// A point in pixels from the upper left corner.
struct PixelPoint {
  double x = 0;
  double y = 0;
};

struct PenStroke {
  PixelPoint from;
  PixelPoint to;
  Rgb color;
  int width = 1;
};

/// Equal pixels that follow each other.
struct PixelRun {
  std::uint32_t length = 0;
  std::uint32_t argb = 0;
};

class Paper {
 public:
  static constexpr int kSize = 500;  ///< width and height [px]

  /// Takes a new sheet.
  void clear();
  /// A line with round ends; what lies outside of the sheet is cut off.
  void draw(PixelPoint from, PixelPoint to, const Pen& pen);
  /// White where nothing is drawn and outside of the sheet.
  [[nodiscard]] Rgb color_at(PixelPoint point) const;
  /// All pixels, row by row; 0 where nothing is drawn.
  [[nodiscard]] std::vector<PixelRun> runs() const;

  [[nodiscard]] std::uint32_t number() const { return number_; }         ///< of the sheet, from 1
  [[nodiscard]] std::uint32_t stroke_count() const { return strokes_; }  ///< on this sheet
  /// Those since the last call; the last of them is number stroke_count() - 1.
  [[nodiscard]] std::vector<PenStroke> take_new_strokes();

 private:
  void dot(PixelPoint center, double radius, std::uint32_t argb);

  std::vector<std::uint32_t> pixels_ = std::vector<std::uint32_t>(std::size_t{kSize} * kSize, 0);
  std::vector<PenStroke> new_strokes_;
  std::uint32_t number_ = 1;
  std::uint32_t strokes_ = 0;
};

}  // namespace turtlesim
