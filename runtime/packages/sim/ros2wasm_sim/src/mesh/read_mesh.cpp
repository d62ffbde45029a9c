// See read_mesh.hpp.
#include "mesh/read_mesh.hpp"

#include <rclcpp/logging.hpp>

#include <map>

#include "mesh/stl.hpp"
#include "ros/resources.hpp"

namespace ros2wasm_sim {
namespace {

constexpr std::size_t kMostTriangles = 200'000;

bool ends_with_stl(const std::string& path) {
  const std::string end = path.size() < 4 ? "" : path.substr(path.size() - 4);
  return end == ".stl" || end == ".STL";
}

}  // namespace

MeshReader site_meshes(const rclcpp::Logger& logger) {
  auto known = std::make_shared<std::map<std::string, std::shared_ptr<const TriangleMesh>>>();
  return [known, logger](const Mesh& mesh) -> std::shared_ptr<const TriangleMesh> {
    if (mesh.path.empty()) return nullptr;
    const auto [found, is_new] = known->try_emplace(mesh.path);
    if (!is_new) return found->second;
    if (!ends_with_stl(mesh.path)) {
      RCLCPP_WARN(logger, "mesh [%s] is skipped: STL files are read, others not yet",
                  mesh.uri.c_str());
      return nullptr;
    }
    const auto bytes = site_resources().read(mesh.path);
    auto read = bytes ? read_stl(*bytes, kMostTriangles) : std::nullopt;
    if (!read) {
      RCLCPP_ERROR(logger, "mesh [%s] is not an STL file of at most %zu triangles",
                   mesh.uri.c_str(), kMostTriangles);
      return nullptr;
    }
    found->second = std::make_shared<const TriangleMesh>(std::move(*read));
    return found->second;
  };
}

}  // namespace ros2wasm_sim
