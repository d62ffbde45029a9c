// PNG, BMP and JPEG by stb_image, and which format a file has. See codecs.hpp.
#include "codecs.hpp"

#include <cstdlib>
#include <memory>

namespace {

/// No single block of memory that stb asks for is larger, whatever a file claims.
constexpr std::size_t kMostBlock = std::size_t{1} << 28;

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
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#define STBI_MAX_DIMENSIONS 33554432
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

namespace Magick {
namespace {

struct Free {
  void operator()(void* block) const { stbi_image_free(block); }
};

[[noreturn]] void bad_picture() {
  const char* reason = stbi_failure_reason();
  throw ErrorCorruptImage(std::string("Magick: Corrupt image (") +
                          (reason == nullptr ? "unknown" : reason) + ")");
}

std::string format_of(std::string_view bytes) {
  const auto starts = [&](std::string_view with) { return bytes.substr(0, with.size()) == with; };
  if (starts("\x89PNG\r\n\x1a\n")) return "PNG";
  if (starts("\xff\xd8\xff")) return "JPEG";
  if (starts("BM")) return "BMP";
  throw ErrorMissingDelegate("Magick: No decode delegate for this image format");
}

void append(void* context, void* block, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(block),
                                             static_cast<std::size_t>(size));
}

/// Calls `put(pixel, channel, channels, value)` for each sample that a file has. A palette may add
/// transparency, so that a pixel has one more than the header says.
template <typename PutT>
void take(const stbi_uc* data, int size, bool is_wide, int channels, const PutT& put) {
  int width = 0;
  int height = 0;
  const auto each = [&](const auto* samples, std::uint32_t factor) {
    if (samples == nullptr) bad_picture();
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto* sample = samples;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
      for (int channel = 0; channel < channels; ++channel) {
        put(pixel, channel, channels, static_cast<Quantum>(*sample++ * factor));
      }
    }
  };
  if (is_wide) {
    each(std::unique_ptr<stbi_us, Free>(
             stbi_load_16_from_memory(data, size, &width, &height, &channels, 0))
             .get(),
         1);
  } else {
    each(std::unique_ptr<stbi_uc, Free>(
             stbi_load_from_memory(data, size, &width, &height, &channels, 0))
             .get(),
         257);
  }
}

}  // namespace

void Codecs::allot(Image& image, std::size_t width, std::size_t height) {
  if (width == 0 || height == 0) throw ErrorCorruptImage("Magick: Negative or zero image size");
  if (height > kMostPixels / width) {
    throw ErrorResourceLimit("Magick: Image pixel limit exceeded (" + std::to_string(width) + "x" +
                             std::to_string(height) + " > " + std::to_string(kMostPixels) +
                             " pixels)");
  }
  image.size_ = Geometry(static_cast<unsigned int>(width), static_cast<unsigned int>(height));
  image.pixels_.assign(width * height, {0, 0, 0, OpaqueOpacity});
  image.has_matte_ = false;
}

void Codecs::decode(std::string_view bytes, Image& image) {
  if (bytes.size() > kMostBytes) throw ErrorResourceLimit("Magick: the file has more than 128 MiB");
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') {
    decode_portable_map(bytes, image);
    return;
  }
  const std::string format = format_of(bytes);
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0;
  int height = 0;
  int channels = 0;
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) bad_picture();
  allot(image, static_cast<std::size_t>(width), static_cast<std::size_t>(height));
  const bool is_wide = stbi_is_16_bit_from_memory(data, size) != 0;
  take(data, size, is_wide, channels, [&](std::size_t i, int channel, int of, Quantum value) {
    Image::Pixel& pixel = image.pixels_[i];
    if (of % 2 == 0 && channel == of - 1) {
      pixel.opacity = static_cast<Quantum>(MaxRGB - value);
      image.has_matte_ = true;
    } else if (of < 3) {
      pixel.red = pixel.green = pixel.blue = value;
    } else {
      (channel == 0 ? pixel.red : channel == 1 ? pixel.green : pixel.blue) = value;
    }
  });
  image.magick_ = format;
  image.depth_ = is_wide ? 16 : 8;
}

std::string Codecs::encode(const Image& image, const std::string& format) {
  if (format == "PGM" || format == "PPM" || format == "PNM") {
    return encode_portable_map(image, format == "PGM" || (format == "PNM" && image.is_gray()));
  }
  const bool has_matte = image.has_matte_ && format == "PNG";
  const int channels = has_matte ? 4 : image.is_gray() ? 1 : 3;
  std::vector<stbi_uc> samples;
  samples.reserve(image.pixels_.size() * static_cast<std::size_t>(channels));
  const auto put = [&](Quantum value) { samples.push_back(static_cast<stbi_uc>(value / 257)); };
  for (const Image::Pixel& pixel : image.pixels_) {
    put(pixel.red);
    if (channels == 1) continue;
    put(pixel.green);
    put(pixel.blue);
    if (has_matte) put(static_cast<Quantum>(MaxRGB - pixel.opacity));
  }
  const int width = static_cast<int>(image.columns());
  const int height = static_cast<int>(image.rows());
  std::string bytes;
  const int is_written =
      format == "PNG" ? stbi_write_png_to_func(append, &bytes, width, height, channels,
                                               samples.data(), width * channels)
      : format == "BMP"
          ? stbi_write_bmp_to_func(append, &bytes, width, height, channels, samples.data())
          : stbi_write_jpg_to_func(append, &bytes, width, height, channels, samples.data(),
                                   static_cast<int>(image.quality_));
  if (is_written == 0) throw ErrorCoder("Magick: Unable to write image");
  return bytes;
}

}  // namespace Magick
