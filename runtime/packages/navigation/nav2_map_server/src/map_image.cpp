// The portable formats, and which format a file has. See map_image.hpp.
#include "map_image.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

namespace nav2_map_server {
namespace {

constexpr std::uint32_t kMostSample = 65535;

/// Reads the words of a portable format: numbers, with white space and comments between them.
class PnmReader {
 public:
  explicit PnmReader(std::string_view bytes) : bytes_(bytes) {}

  std::uint32_t number(const char* name) {
    skip_space();
    std::uint32_t value = 0;
    const std::size_t start = at_;
    for (; at_ < bytes_.size() && is_digit(bytes_[at_]); ++at_) {
      value = value * 10 + static_cast<std::uint32_t>(bytes_[at_] - '0');
      if (value > kMostNumber) fail(std::string("the ") + name + " is not below 10000000");
    }
    if (at_ == start) fail(std::string("the ") + name + " is not a number");
    return value;
  }

  /// A pixel of P1 may stand without a space.
  std::uint32_t bit() {
    skip_space();
    if (at_ == bytes_.size() || (bytes_[at_] != '0' && bytes_[at_] != '1')) {
      fail("a pixel is neither 0 nor 1");
    }
    return static_cast<std::uint32_t>(bytes_[at_++] - '0');
  }

  /// The bytes after the one white space that ends the header.
  std::string_view rest(std::size_t size) {
    if (at_ < bytes_.size()) ++at_;
    const std::string_view data = bytes_.substr(std::min(at_, bytes_.size()));
    if (data.size() < size) {
      fail("it ends after " + std::to_string(data.size()) + " of " + std::to_string(size) +
           " bytes of pixels");
    }
    return data;
  }

  /// Whether so many numbers of at least two characters can follow.
  void require(std::size_t numbers) {
    if (bytes_.size() - at_ + 1 < numbers * 2) fail("it ends before its last pixel");
  }

  [[noreturn]] static void fail(const std::string& reason) {
    throw std::runtime_error("not a valid portable image: " + reason);
  }

 private:
  static constexpr std::uint32_t kMostNumber = 9999999;

  static bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

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

/// Samples of a binary format, one or two bytes each.
class Samples {
 public:
  Samples(std::string_view data, std::uint32_t most) : data_(data), most_(most) {}

  /// With 16 bits.
  std::uint32_t next() {
    std::uint32_t value = byte();
    if (most_ > 255) value = value << 8 | byte();
    return std::min(value, most_) * kMostSample / most_;
  }

 private:
  std::uint32_t byte() { return static_cast<unsigned char>(data_[at_++]); }

  std::string_view data_;
  std::uint32_t most_;
  std::size_t at_ = 0;
};

bool starts_with(const std::string& bytes, std::string_view start) {
  return bytes.compare(0, start.size(), start) == 0;
}

void read_bits(PnmReader& reader, bool is_text, MapImage& image) {
  const std::size_t row_bytes = (image.width + 7) / 8;
  const std::string_view data = is_text ? "" : reader.rest(row_bytes * image.height);
  for (std::size_t row = 0; row < image.height; ++row) {
    for (std::size_t column = 0; column < image.width; ++column) {
      const bool is_black = is_text
                                ? reader.bit() == 1
                                : (data[row * row_bytes + column / 8] >> (7 - column % 8) & 1) != 0;
      image.gray.push_back(is_black ? 0 : 255);
    }
  }
}

}  // namespace

void check_size(std::size_t width, std::size_t height) {
  if (width == 0 || height == 0) throw std::runtime_error("the image has no pixels");
  if (height > kMostPixels / width) {
    throw std::runtime_error("the image has " + std::to_string(width) + " x " +
                             std::to_string(height) + " pixels, more than " +
                             std::to_string(kMostPixels));
  }
}

MapImage read_pnm(const std::string& bytes) {
  const char kind = bytes.size() > 1 ? bytes[1] : '?';
  PnmReader reader(bytes);
  MapImage image;
  image.width = reader.number("width");
  image.height = reader.number("height");
  check_size(image.width, image.height);
  const std::size_t pixels = image.width * image.height;
  if (kind == '1' || kind == '4') {
    if (kind == '1' && bytes.size() < pixels) PnmReader::fail("it ends before its last pixel");
    if (kind == '4' && bytes.size() < pixels / 8) PnmReader::fail("it ends before its last pixel");
    image.gray.reserve(pixels);
    read_bits(reader, kind == '1', image);
    return image;
  }
  const std::uint32_t most = reader.number("largest value");
  if (most == 0 || most > kMostSample) PnmReader::fail("the largest value is not 1 to 65535");
  const bool is_text = kind == '2' || kind == '3';
  const std::size_t samples = pixels * (kind == '3' || kind == '6' ? 3 : 1);
  std::string_view data;
  if (is_text) {
    reader.require(samples);
  } else {
    data = reader.rest(samples * (most > 255 ? 2 : 1));
  }
  Samples binary(data, most);
  const auto next = [&] {
    return is_text ? std::min(reader.number("value of a pixel"), most) * kMostSample / most
                   : binary.next();
  };
  image.gray.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint32_t red = next();
    const bool is_gray = samples == pixels;
    const std::uint32_t green = is_gray ? red : next();
    const std::uint32_t blue = is_gray ? red : next();
    image.gray.push_back(lightness(red, green, blue));
  }
  return image;
}

MapImage read_image(const std::string& bytes) {
  constexpr std::array<std::string_view, 2> kPictures = {"\x89PNG\r\n\x1a\n", "BM"};
  if (bytes.size() > 1 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') {
    return read_pnm(bytes);
  }
  for (const std::string_view start : kPictures) {
    if (starts_with(bytes, start)) return read_picture(bytes);
  }
  throw std::runtime_error("the image is not a PGM, PNG or BMP file");
}

std::string written_image(const MapImage& image, const std::string& format) {
  if (format != "pgm") return written_picture(image, format == "png");
  std::string bytes =
      "P5\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n255\n";
  bytes.append(image.gray.begin(), image.gray.end());
  return bytes;
}

}  // namespace nav2_map_server
