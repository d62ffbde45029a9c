// See read_mesh.hpp.
#include "mesh/read_mesh.hpp"

#include <rclcpp/logging.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "mesh/dae.hpp"
#include "mesh/obj.hpp"
#include "mesh/stl.hpp"
#include "ros/resources.hpp"

namespace ros2wasm_sim {
namespace {

constexpr std::size_t kMostTriangles = 200'000;

using ReadFile = std::optional<TriangleMesh> (*)(const std::string& bytes, std::size_t most);

/// The reader of a file name extension. Null when the extension is not supported.
ReadFile reader_of(const std::string& path) {
  std::string ending = path.substr(path.rfind('.') + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char sign) { return static_cast<char>(std::tolower(sign)); });
  return ending == "stl"   ? read_stl
         : ending == "obj" ? read_obj
         : ending == "dae" ? read_dae
                           : nullptr;
}

}  // namespace

MeshReader site_meshes(const rclcpp::Logger& logger) {
  auto known = std::make_shared<std::map<std::string, std::shared_ptr<const TriangleMesh>>>();
  return [known, logger](const Mesh& mesh) -> std::shared_ptr<const TriangleMesh> {
    if (mesh.path.empty()) return nullptr;
    const auto [found, is_new] = known->try_emplace(mesh.path);
    if (!is_new) return found->second;
    const ReadFile reader = reader_of(mesh.path);
    if (reader == nullptr) {
      RCLCPP_WARN(logger, "mesh [%s] is skipped: only STL, OBJ and COLLADA files are supported",
                  mesh.uri.c_str());
      return nullptr;
    }
    const auto bytes = site_resources().read(mesh.path);
    auto read = bytes ? reader(*bytes, kMostTriangles) : std::nullopt;
    if (!read) {
      RCLCPP_ERROR(logger, "mesh [%s] cannot be read, or has more than %zu triangles",
                   mesh.uri.c_str(), kMostTriangles);
      return nullptr;
    }
    found->second = std::make_shared<const TriangleMesh>(std::move(*read));
    return found->second;
  };
}

}  // namespace ros2wasm_sim
