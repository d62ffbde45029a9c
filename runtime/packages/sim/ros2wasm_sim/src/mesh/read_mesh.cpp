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

bool is_supported(const std::string& ending) {
  return ending == "stl" || ending == "obj" || ending == "dae";
}

/// In lower case.
std::string ending_of(const std::string& path) {
  std::string ending = path.substr(path.rfind('.') + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char sign) { return static_cast<char>(std::tolower(sign)); });
  return ending;
}

std::optional<TriangleMesh> read_file(const std::string& path, const std::string& ending) {
  const auto read = site_resources().read;
  const auto bytes = read(path);
  if (!bytes) return std::nullopt;
  if (ending == "stl") return read_stl(*bytes, kMostTriangles);
  if (ending == "dae") return read_dae(*bytes, kMostTriangles);
  return read_obj(*bytes, kMostTriangles, [&](const std::string& name) {
    return read(path.substr(0, path.rfind('/') + 1) + name);
  });
}

}  // namespace

MeshReader site_meshes(const rclcpp::Logger& logger) {
  auto known = std::make_shared<std::map<std::string, std::shared_ptr<const TriangleMesh>>>();
  return [known, logger](const Mesh& mesh) -> std::shared_ptr<const TriangleMesh> {
    if (mesh.path.empty()) return nullptr;
    const auto [found, is_new] = known->try_emplace(mesh.path);
    if (!is_new) return found->second;
    const std::string ending = ending_of(mesh.path);
    if (!is_supported(ending)) {
      RCLCPP_WARN(logger, "mesh [%s] is skipped: only STL, OBJ and COLLADA files are supported",
                  mesh.uri.c_str());
      return nullptr;
    }
    auto read = read_file(mesh.path, ending);
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
