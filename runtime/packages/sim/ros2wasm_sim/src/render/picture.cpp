// See picture.hpp.
#include "render/picture.hpp"

#include <algorithm>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_BMP
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#define STBI_ONLY_TGA
#define STBI_MAX_DIMENSIONS 4096
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

namespace ros2wasm_sim {

std::optional<Picture> read_picture(const std::string& bytes) {
  constexpr std::size_t kMostBytes = 64U << 20;
  if (bytes.size() > kMostBytes) return std::nullopt;
  Picture picture;
  int channels = 0;
  constexpr int kColors = 3;
  stbi_uc* pixels = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                          static_cast<int>(bytes.size()), &picture.width,
                                          &picture.height, &channels, kColors);
  if (pixels == nullptr) return std::nullopt;
  const std::size_t size = std::size_t{kColors} * picture.width * picture.height;
  picture.rgb.assign(pixels, pixels + size);
  stbi_image_free(pixels);
  return picture;
}

std::vector<std::uint8_t> jpeg_of(const Picture& picture, int quality) {
  std::vector<std::uint8_t> bytes;
  const auto append = [](void* context, void* data, int size) {
    auto& out = *static_cast<std::vector<std::uint8_t>*>(context);
    const auto* from = static_cast<const std::uint8_t*>(data);
    out.insert(out.end(), from, from + size);
  };
  stbi_write_jpg_to_func(append, &bytes, picture.width, picture.height, 3, picture.rgb.data(),
                         std::clamp(quality, 1, 100));
  return bytes;
}

}  // namespace ros2wasm_sim
