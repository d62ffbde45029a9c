// See photo_file.hpp.
#include "photo_file.hpp"

#include <cstddef>
#include <stdexcept>
#include <utility>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace nav2_waypoint_follower {
namespace {

constexpr int kJpegQuality = 95;
/// The sizes of a picture, its rows and its file are numbers of 32 bits there.
constexpr uint64_t kMostBytes = uint64_t{1} << 28;

struct Encoding {
  const char* name;
  int channels;
  bool is_blue_first;
};
constexpr Encoding kEncodings[] = {
    {"mono8", 1, false}, {"rgb8", 3, false}, {"bgr8", 3, true},
    {"rgba8", 4, false}, {"bgra8", 4, true},
};

const Encoding& encoding_of(const Photo& photo) {
  for (const Encoding& one : kEncodings) {
    if (photo.encoding == one.name) return one;
  }
  throw std::runtime_error("the encoding '" + photo.encoding +
                           "' is not supported; use mono8, rgb8, bgr8, rgba8 or bgra8");
}

/// The rows without what may be between them, red first.
std::vector<uint8_t> samples_of(const Photo& photo, const Encoding& encoding) {
  const size_t channels = static_cast<size_t>(encoding.channels);
  const uint64_t row = uint64_t{photo.width} * channels;
  const uint64_t size = uint64_t{photo.step} * photo.height;
  if (photo.step < row) {
    throw std::runtime_error("the image has a step of " + std::to_string(photo.step) +
                             " bytes, and its width needs " + std::to_string(row));
  }
  if (size > kMostBytes) throw std::runtime_error("the image is larger than 256 MiB");
  if (photo.data.size() < size) {
    throw std::runtime_error("the image has " + std::to_string(photo.data.size()) +
                             " bytes, and its step and height need " + std::to_string(size));
  }
  std::vector<uint8_t> samples;
  samples.reserve(static_cast<size_t>(row) * photo.height);
  for (size_t y = 0; y < photo.height; ++y) {
    const auto begin = photo.data.begin() + static_cast<std::ptrdiff_t>(y * photo.step);
    samples.insert(samples.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
  }
  if (encoding.is_blue_first) {
    for (size_t i = 0; i < samples.size(); i += channels) std::swap(samples[i], samples[i + 2]);
  }
  return samples;
}

}  // namespace

std::string unsupported_format(const std::string& format) {
  for (const char* known : {"png", "jpg", "jpeg", "bmp"}) {
    if (format == known) return "";
  }
  return "the format '" + format + "' is not supported; use png, jpg, jpeg or bmp";
}

std::string photo_file(const Photo& photo, const std::string& format) {
  if (photo.width == 0 || photo.height == 0) throw std::runtime_error("the image has no pixels");
  const Encoding& encoding = encoding_of(photo);
  const std::vector<uint8_t> samples = samples_of(photo, encoding);
  const int width = static_cast<int>(photo.width);
  const int height = static_cast<int>(photo.height);
  const int channels = encoding.channels;
  std::string bytes;
  const auto append = [](void* context, void* block, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(block),
                                               static_cast<size_t>(size));
  };
  int is_written = 0;
  if (format == "png") {
    is_written = stbi_write_png_to_func(append, &bytes, width, height, channels, samples.data(),
                                        width * channels);
  } else if (format == "jpg" || format == "jpeg") {
    is_written = stbi_write_jpg_to_func(append, &bytes, width, height, channels, samples.data(),
                                        kJpegQuality);
  } else if (format == "bmp") {
    is_written = stbi_write_bmp_to_func(append, &bytes, width, height, channels, samples.data());
  } else {
    throw std::runtime_error(unsupported_format(format));
  }
  if (is_written == 0) throw std::runtime_error("the picture cannot be written");
  return bytes;
}

}  // namespace nav2_waypoint_follower
