// See mime_types.hpp.
#include "bundler/serve/mime_types.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace ros2wasm {
namespace {

struct MimeRow {
  std::string_view ending;
  std::string_view type;
};

constexpr auto kMimeRows = std::to_array<MimeRow>({
    {"avif", "image/avif"},
    {"bag", "application/octet-stream"},
    {"bin", "application/octet-stream"},
    {"bmp", "image/bmp"},
    {"css", "text/css; charset=utf-8"},
    {"csv", "text/csv; charset=utf-8"},
    {"dae", "model/vnd.collada+xml"},
    {"gif", "image/gif"},
    {"glb", "model/gltf-binary"},
    {"gltf", "model/gltf+json"},
    {"gz", "application/gzip"},
    {"htm", "text/html; charset=utf-8"},
    {"html", "text/html; charset=utf-8"},
    {"ico", "image/x-icon"},
    {"jpeg", "image/jpeg"},
    {"jpg", "image/jpeg"},
    {"js", "text/javascript; charset=utf-8"},
    {"json", "application/json"},
    {"lock", "text/plain; charset=utf-8"},
    {"map", "application/json"},
    {"mcap", "application/octet-stream"},
    {"md", "text/markdown; charset=utf-8"},
    {"mjs", "text/javascript; charset=utf-8"},
    {"mp4", "video/mp4"},
    {"msg", "text/plain; charset=utf-8"},
    {"obj", "model/obj"},
    {"pdf", "application/pdf"},
    {"pgm", "image/x-portable-graymap"},
    {"png", "image/png"},
    {"py", "text/x-python; charset=utf-8"},
    {"sdf", "application/xml"},
    {"srv", "text/plain; charset=utf-8"},
    {"stl", "model/stl"},
    {"svg", "image/svg+xml"},
    {"txt", "text/plain; charset=utf-8"},
    {"urdf", "application/xml"},
    {"wasm", "application/wasm"},
    {"webm", "video/webm"},
    {"webmanifest", "application/manifest+json"},
    {"webp", "image/webp"},
    {"whl", "application/zip"},
    {"woff2", "font/woff2"},
    {"xacro", "application/xml"},
    {"xml", "application/xml"},
    {"yaml", "application/yaml"},
    {"yml", "application/yaml"},
    {"zip", "application/zip"},
    {"zst", "application/zstd"},
});

}  // namespace

std::string_view mime_type(std::string_view file_name) {
  const std::size_t dot = file_name.rfind('.');
  if (dot != std::string_view::npos) {
    std::string ending(file_name.substr(dot + 1));
    for (char& c : ending) {
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    const auto row = std::find_if(kMimeRows.begin(), kMimeRows.end(),
                                  [&](const MimeRow& each) { return each.ending == ending; });
    if (row != kMimeRows.end()) return row->type;
  }
  return "application/octet-stream";
}

}  // namespace ros2wasm
