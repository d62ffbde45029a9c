// The formats PBM, PGM and PPM (P1 to P6). See codecs.hpp.
#include <algorithm>

#include "codecs.hpp"

namespace Magick {
namespace {

[[noreturn]] void bad_header(const std::string& reason) {
  throw ErrorCorruptImage("Magick: Improper image header (" + reason + ")");
}

/// Numbers in text, with white space and comments between them, and the binary samples behind.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::uint32_t number() {
    skip_space();
    const std::size_t start = at_;
    std::uint32_t value = 0;
    for (; at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9'; ++at_) {
      value = value * 10 + static_cast<std::uint32_t>(bytes_[at_] - '0');
      if (value > kMostNumber) bad_header("a number is too large");
    }
    if (at_ == start) bad_header("a number is missing");
    return value;
  }

  /// A pixel of P1 may be without a space behind it.
  std::uint32_t digit() {
    skip_space();
    if (at_ == bytes_.size() || (bytes_[at_] != '0' && bytes_[at_] != '1'))
      bad_header("a pixel is neither 0 nor 1");
    return static_cast<std::uint32_t>(bytes_[at_++] - '0');
  }

  void end_header() { ++at_; }
  void require(std::size_t size) const {
    if (at_ > bytes_.size() || bytes_.size() - at_ < size)
      bad_header("it ends before its last pixel");
  }
  std::uint32_t byte() { return static_cast<unsigned char>(bytes_[at_++]); }

 private:
  static constexpr std::uint32_t kMostNumber = 9999999;

  void skip_space() {
    for (; at_ < bytes_.size(); ++at_) {
      if (bytes_[at_] == '#') {
        at_ = std::min(bytes_.find('\n', at_), bytes_.size() - 1);
      } else if (std::string_view(" \t\r\n\v\f").find(bytes_[at_]) == std::string_view::npos) {
        return;
      }
    }
  }

  std::string_view bytes_;
  std::size_t at_ = 2;  // after P and a digit
};

void append_sample(std::string& bytes, Quantum value, bool is_wide) {
  if (!is_wide) {
    bytes.push_back(static_cast<char>(value / 257));
    return;
  }
  bytes.push_back(static_cast<char>(value >> 8));
  bytes.push_back(static_cast<char>(value & 255));
}

}  // namespace

void Codecs::decode_portable_map(std::string_view bytes, Image& image) {
  const char kind = bytes[1];
  Reader reader(bytes);
  const std::uint32_t width = reader.number();
  const std::uint32_t height = reader.number();
  const bool is_bits = kind == '1' || kind == '4';
  const bool is_text = kind <= '3';
  const std::size_t channels = kind == '3' || kind == '6' ? 3 : 1;
  const std::uint32_t most = is_bits ? 1 : reader.number();
  if (most == 0 || most > MaxRGB) bad_header("the largest value is not 1 to 65535");
  const std::size_t pixels = std::size_t{width} * height;
  if (!is_text) reader.end_header();
  if (pixels > kMostPixels) allot(image, width, height);  // says so
  const std::size_t row_bytes =
      is_bits ? (std::size_t{width} + 7) / 8 : width * channels * (most > 255 ? 2 : 1);
  reader.require(is_text ? pixels * channels * (is_bits ? 1 : 2) - (is_bits ? 0 : 1)
                         : row_bytes * height);
  allot(image, width, height);
  image.magick_ = is_bits ? "PBM" : channels == 3 ? "PPM" : "PGM";
  image.depth_ = most > 255 ? 16 : 8;
  std::uint32_t bits = 0;
  const auto sample = [&](std::size_t column) -> Quantum {
    if (is_bits && is_text) return reader.digit() == 1 ? 0 : MaxRGB;
    if (is_bits) {
      if (column % 8 == 0) bits = reader.byte();
      return (bits >> (7 - column % 8) & 1U) != 0 ? 0 : MaxRGB;
    }
    std::uint32_t value = is_text ? reader.number() : reader.byte();
    if (!is_text && most > 255) value = value << 8 | reader.byte();
    return static_cast<Quantum>(std::min(value, most) * MaxRGB / most);
  };
  for (std::size_t i = 0; i < pixels; ++i) {
    const Quantum red = sample(i % width);
    const Quantum green = channels == 3 ? sample(i % width) : red;
    const Quantum blue = channels == 3 ? sample(i % width) : red;
    image.pixels_[i] = {red, green, blue, OpaqueOpacity};
  }
}

std::string Codecs::encode_portable_map(const Image& image, bool is_gray) {
  const bool is_wide = image.depth_ > 8;
  std::string bytes = (is_gray ? "P5\n" : "P6\n") + std::to_string(image.columns()) + " " +
                      std::to_string(image.rows()) + "\n" + (is_wide ? "65535" : "255") + "\n";
  for (const Image::Pixel& pixel : image.pixels_) {
    if (is_gray) {
      append_sample(bytes, pixel.gray(), is_wide);
      continue;
    }
    for (const Quantum part : {pixel.red, pixel.green, pixel.blue})
      append_sample(bytes, part, is_wide);
  }
  return bytes;
}

}  // namespace Magick
