// Names of colours. See Color.h.
#include "Magick++/Color.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "Magick++/Exception.h"

namespace Magick {
namespace {

const std::map<std::string, Color>& known_colors() {
  constexpr Quantum kHalf = 128 * 257;
  static const std::map<std::string, Color> colors = {
      {"black", Color(0, 0, 0)},
      {"blue", Color(0, 0, MaxRGB)},
      {"cyan", Color(0, MaxRGB, MaxRGB)},
      {"gray", Color(126 * 257, 126 * 257, 126 * 257)},
      {"green", Color(0, kHalf, 0)},
      {"lime", Color(0, MaxRGB, 0)},
      {"magenta", Color(MaxRGB, 0, MaxRGB)},
      {"none", Color(0, 0, 0, TransparentOpacity)},
      {"red", Color(MaxRGB, 0, 0)},
      {"transparent", Color(0, 0, 0, TransparentOpacity)},
      {"white", Color(MaxRGB, MaxRGB, MaxRGB)},
      {"yellow", Color(MaxRGB, MaxRGB, 0)},
  };
  return colors;
}

[[noreturn]] void unknown_color(const std::string& name) {
  throw ErrorOption("Magick: Unrecognized color (" + name + ")");
}

/// Digits of one part as 16 bits: F is FFFF, FF is FFFF.
Quantum part_of(const std::string& digits) {
  const std::uint32_t most = (1U << (4 * digits.size())) - 1;
  return static_cast<Quantum>(std::strtoul(digits.c_str(), nullptr, 16) * MaxRGB / most);
}

}  // namespace

Color::Color(const std::string& name) {
  if (name.empty() || name[0] != '#') {
    const auto found = known_colors().find(name);
    if (found == known_colors().end()) unknown_color(name);
    *this = found->second;
    return;
  }
  const std::size_t digits = (name.size() - 1) / 3;
  const bool is_hex = name.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!is_hex || name.size() != 1 + 3 * digits || digits == 0 || digits > 4) unknown_color(name);
  *this = Color(part_of(name.substr(1, digits)), part_of(name.substr(1 + digits, digits)),
                part_of(name.substr(1 + 2 * digits, digits)));
}

double Color::intensity() const {
  return scaled(static_cast<Quantum>((306U * red_ + 601U * green_ + 117U * blue_) >> 10U));
}

Quantum Color::scaled(double value) {
  return static_cast<Quantum>(std::lround(std::clamp(value, 0.0, 1.0) * MaxRGB));
}

}  // namespace Magick
