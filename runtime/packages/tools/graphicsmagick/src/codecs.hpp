// Bytes of files to pixels and back.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "Magick++/Image.h"

namespace Magick {

/// No picture has more pixels, and no file more bytes: eight bytes are in memory for each pixel.
constexpr std::size_t kMostPixels = std::size_t{1} << 25;
constexpr std::size_t kMostBytes = std::size_t{1} << 27;

struct Codecs {
  /// The format's name in capitals, and the pixels. Throws ErrorCorruptImage, ErrorMissingDelegate,
  /// ErrorResourceLimit.
  static void decode(std::string_view bytes, Image& image);
  static void decode_portable_map(std::string_view bytes, Image& image);
  static std::string encode(const Image& image, const std::string& format);
  static std::string encode_portable_map(const Image& image, bool is_gray);

  static void allot(Image& image, std::size_t width, std::size_t height);
};

}  // namespace Magick
