// PNG and BMP by stb_image. See map_image.hpp.
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "map_image.hpp"

namespace {

/// No single block of memory that stb asks for is larger, whatever a file claims.
constexpr std::size_t kMostBlock = 2 * nav2_map_server::kMostBytes;

void* allocated(std::size_t size) {
  return size > kMostBlock ? nullptr : std::malloc(size);
}
void* reallocated(void* block, std::size_t size) {
  return size > kMostBlock ? nullptr : std::realloc(block, size);
}

}  // namespace

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_BMP
#define STBI_ONLY_PNG
#define STBI_MALLOC(size) allocated(size)
#define STBI_REALLOC(block, size) reallocated(block, size)
#define STBI_FREE(block) std::free(block)
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wsign-compare"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace nav2_map_server {
namespace {

constexpr std::uint32_t kWiden = 257;  // from 8 to 16 bits

struct Free {
  void operator()(void* block) const { stbi_image_free(block); }
};

[[noreturn]] void fail() {
  const char* reason = stbi_failure_reason();
  throw std::runtime_error(std::string("the image cannot be read: ") +
                           (reason == nullptr ? "unknown reason" : reason));
}

/// Four bytes of a header; 0 when they are not there.
std::uint32_t number_at(const std::string& bytes, std::size_t at, bool is_big_endian) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4 && at + 4 <= bytes.size(); ++i) {
    const std::size_t next = is_big_endian ? i : 3 - i;
    number = number << 8 | static_cast<unsigned char>(bytes[at + next]);
  }
  return number;
}

/// Before stb looks, which has no words for a picture that is too large.
void check_header(const std::string& bytes) {
  const bool is_png = bytes[0] != 'B';
  constexpr std::size_t kPngWidth = 16;
  constexpr std::size_t kBmpWidth = 18;
  // The oldest header of BMP has sizes of 16 bits, which stb reads before they are checked.
  constexpr std::size_t kBmpHeaderSize = 14;
  constexpr std::uint32_t kOldestHeader = 12;
  if (!is_png && number_at(bytes, kBmpHeaderSize, false) == kOldestHeader) return;
  const std::size_t at = is_png ? kPngWidth : kBmpWidth;
  const std::uint32_t width = number_at(bytes, at, is_png);
  const std::uint32_t height = number_at(bytes, at + 4, is_png);
  // The height of a BMP is negative when its rows are from the top.
  const bool is_negative = !is_png && (height >> 31) != 0;
  check_size(width, is_negative ? 0U - height : height);
}

/// `samples` has `channels` for each pixel; `factor` makes 16 bits of a sample.
template <typename SampleT>
void take(const SampleT* samples, int channels, std::uint32_t factor, MapImage& image) {
  const bool has_alpha = channels == 2 || channels == 4;
  const bool is_gray = channels < 3;
  const std::size_t pixels = image.width * image.height;
  image.gray.reserve(pixels);
  if (has_alpha) image.alpha.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i, samples += channels) {
    const std::uint32_t red = samples[0] * factor;
    const std::uint32_t green = is_gray ? red : samples[1] * factor;
    const std::uint32_t blue = is_gray ? red : samples[2] * factor;
    image.gray.push_back(lightness(red, green, blue));
    if (has_alpha) {
      image.alpha.push_back(static_cast<std::uint8_t>(samples[channels - 1] * factor / kWiden));
    }
  }
}

}  // namespace

MapImage read_picture(const std::string& bytes) {
  if (bytes.size() > kMostBytes) {
    throw std::runtime_error("the image file has more than 64 MiB");
  }
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0;
  int height = 0;
  int channels = 0;
  check_header(bytes);
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) fail();
  MapImage image;
  image.width = static_cast<std::size_t>(width);
  image.height = static_cast<std::size_t>(height);
  check_size(image.width, image.height);
  const bool is_wide = stbi_is_16_bit_from_memory(data, size) != 0;
  // A palette may add transparency, so a pixel has up to one sample more than it says.
  const std::size_t pixel_bytes = static_cast<std::size_t>(channels + 1) * (is_wide ? 2 : 1);
  if (image.width * image.height > kMostBytes / pixel_bytes) {
    throw std::runtime_error("the pixels of the image take more than 64 MiB");
  }
  if (is_wide) {
    const std::unique_ptr<stbi_us, Free> samples(
        stbi_load_16_from_memory(data, size, &width, &height, &channels, 0));
    if (samples == nullptr) fail();
    take(samples.get(), channels, 1, image);
  } else {
    const std::unique_ptr<stbi_uc, Free> samples(
        stbi_load_from_memory(data, size, &width, &height, &channels, 0));
    if (samples == nullptr) fail();
    take(samples.get(), channels, kWiden, image);
  }
  return image;
}

std::string written_picture(const MapImage& image, bool is_png) {
  const bool has_alpha = is_png && !image.alpha.empty();
  const int channels = has_alpha ? 4 : 1;
  std::vector<std::uint8_t> samples;
  if (has_alpha) {
    samples.reserve(image.gray.size() * 4);
    for (std::size_t i = 0; i < image.gray.size(); ++i) {
      samples.insert(samples.end(), 3, image.gray[i]);
      samples.push_back(image.alpha[i]);
    }
  }
  const std::uint8_t* data = has_alpha ? samples.data() : image.gray.data();
  const int width = static_cast<int>(image.width);
  const int height = static_cast<int>(image.height);
  std::string bytes;
  const auto append = [](void* context, void* block, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(block),
                                               static_cast<std::size_t>(size));
  };
  const int is_written =
      is_png
          ? stbi_write_png_to_func(append, &bytes, width, height, channels, data, width * channels)
          : stbi_write_bmp_to_func(append, &bytes, width, height, channels, data);
  if (is_written == 0) throw std::runtime_error("the image cannot be written");
  return bytes;
}

}  // namespace nav2_map_server
