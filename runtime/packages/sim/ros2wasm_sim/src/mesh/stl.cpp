// See stl.hpp.
#include "mesh/stl.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>

namespace ros2wasm_sim {
namespace {

constexpr std::size_t kHeader = 84, kTriangle = 50;

/// Joins equal vertices, which STL writes once for each triangle.
class Builder {
 public:
  bool add(const std::array<float, 3>& vertex) {
    for (const float one : vertex)
      if (!std::isfinite(one)) return false;
    const auto [found, is_new] = known_.try_emplace(vertex, static_cast<int>(known_.size()));
    if (is_new) mesh.vertices.insert(mesh.vertices.end(), vertex.begin(), vertex.end());
    mesh.faces.push_back(found->second);
    return true;
  }
  TriangleMesh mesh;

 private:
  std::map<std::array<float, 3>, int> known_;
};

std::optional<TriangleMesh> read_binary(const std::string& bytes, std::uint32_t triangles) {
  Builder builder;
  for (std::uint32_t i = 0; i < triangles; ++i)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<float, 3> vertex;
      std::memcpy(vertex.data(), bytes.data() + kHeader + i * kTriangle + 12 * (corner + 1),
                  sizeof vertex);
      if (!builder.add(vertex)) return std::nullopt;
    }
  return std::move(builder.mesh);
}

std::optional<TriangleMesh> read_text(const std::string& bytes, std::size_t most) {
  Builder builder;
  const std::string word = "vertex";
  for (std::size_t at = bytes.find(word); at != std::string::npos; at = bytes.find(word, at)) {
    at += word.size();
    const char* from = bytes.c_str() + at;
    std::array<float, 3> vertex;
    for (float& value : vertex) {
      char* end = nullptr;
      value = std::strtof(from, &end);
      if (end == from) return std::nullopt;
      from = end;
    }
    if (!builder.add(vertex) || builder.mesh.faces.size() > 3 * most) return std::nullopt;
  }
  if (builder.mesh.faces.empty() || builder.mesh.faces.size() % 3 != 0) return std::nullopt;
  return std::move(builder.mesh);
}

}  // namespace

std::optional<TriangleMesh> read_stl(const std::string& bytes, std::size_t most) {
  if (bytes.size() >= kHeader) {
    std::uint32_t triangles = 0;
    std::memcpy(&triangles, bytes.data() + 80, sizeof triangles);
    // Some binary files begin with `solid`, as texts do: the size decides.
    if (bytes.size() == kHeader + triangles * kTriangle)
      return triangles <= most ? read_binary(bytes, triangles) : std::nullopt;
  }
  return bytes.rfind("solid", 0) == 0 ? read_text(bytes, most) : std::nullopt;
}

}  // namespace ros2wasm_sim
