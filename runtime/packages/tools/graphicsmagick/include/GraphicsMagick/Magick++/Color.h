// Colours of 16 bits, as Debian's GraphicsMagick has them.
#pragma once

#include <cstdint>
#include <string>

// Macros there too. Opacity counts the other way round than alpha: 0 is opaque.
#define MaxRGB 65535U
#define OpaqueOpacity 0UL
#define TransparentOpacity MaxRGB

namespace Magick {

using Quantum = std::uint16_t;

class Color {
 public:
  Color() = default;  // not valid until it is set
  Color(Quantum red, Quantum green, Quantum blue) : Color(red, green, blue, OpaqueOpacity) {}
  Color(Quantum red, Quantum green, Quantum blue, Quantum opacity)
      : red_(red), green_(green), blue_(blue), opacity_(opacity), is_valid_(true) {}
  /// One of a few names ("red"), or "#RGB", "#RRGGBB", "#RRRRGGGGBBBB". Throws ErrorOption for
  /// others.
  Color(const std::string& name);  // NOLINT: converts, as upstream's
  Color(const char* name) : Color(std::string(name)) {}

  Quantum redQuantum() const { return red_; }
  Quantum greenQuantum() const { return green_; }
  Quantum blueQuantum() const { return blue_; }
  Quantum alphaQuantum() const { return opacity_; }
  void redQuantum(Quantum value) { set(red_, value); }
  void greenQuantum(Quantum value) { set(green_, value); }
  void blueQuantum(Quantum value) { set(blue_, value); }
  void alphaQuantum(Quantum value) { set(opacity_, value); }

  /// 0 (opaque) to 1.
  double alpha() const { return scaled(opacity_); }
  void alpha(double value) { set(opacity_, scaled(value)); }
  /// Brightness, 0 to 1.
  double intensity() const;

  bool isValid() const { return is_valid_; }
  void isValid(bool is_valid) { *this = is_valid ? Color(0, 0, 0) : Color(); }

  static double scaled(Quantum value) { return value / static_cast<double>(MaxRGB); }
  /// Values beyond 0 to 1 count as the nearer of these.
  static Quantum scaled(double value);

  friend bool operator==(const Color& one, const Color& other) {
    return one.is_valid_ == other.is_valid_ && one.red_ == other.red_ &&
           one.green_ == other.green_ && one.blue_ == other.blue_;
  }
  friend bool operator!=(const Color& one, const Color& other) { return !(one == other); }

 private:
  void set(Quantum& part, Quantum value) {
    part = value;
    is_valid_ = true;
  }

  Quantum red_ = 0;
  Quantum green_ = 0;
  Quantum blue_ = 0;
  Quantum opacity_ = OpaqueOpacity;
  bool is_valid_ = false;
};

/// Parts from 0 to 1.
class ColorRGB : public Color {
 public:
  ColorRGB() : Color(0, 0, 0) {}
  ColorRGB(const Color& color) : Color(color) {}  // NOLINT: converts, as upstream's
  ColorRGB(double red, double green, double blue)
      : Color(scaled(red), scaled(green), scaled(blue)) {}
  double red() const { return scaled(redQuantum()); }
  double green() const { return scaled(greenQuantum()); }
  double blue() const { return scaled(blueQuantum()); }
  void red(double value) { redQuantum(scaled(value)); }
  void green(double value) { greenQuantum(scaled(value)); }
  void blue(double value) { blueQuantum(scaled(value)); }
};

class ColorGray : public Color {
 public:
  ColorGray() : ColorGray(0.0) {}
  ColorGray(const Color& color) : Color(color) {}  // NOLINT: converts, as upstream's
  ColorGray(double shade) : Color(scaled(shade), scaled(shade), scaled(shade)) {}  // NOLINT
  double shade() const { return scaled(greenQuantum()); }
  void shade(double value) { *this = ColorGray(value); }
};

class ColorMono : public Color {
 public:
  ColorMono() : ColorMono(false) {}
  ColorMono(bool is_white) : Color(ColorGray(is_white ? 1.0 : 0.0)) {}  // NOLINT
  bool mono() const { return greenQuantum() != 0; }
};

}  // namespace Magick
