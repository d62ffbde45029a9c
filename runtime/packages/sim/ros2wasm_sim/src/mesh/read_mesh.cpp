// See read_mesh.hpp.
#include "mesh/read_mesh.hpp"

#include <rclcpp/logging.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <utility>

#include "mesh/dae.hpp"
#include "mesh/heights.hpp"
#include "mesh/obj.hpp"
#include "mesh/stl.hpp"
#include "mesh/submesh.hpp"
#include "ros/resources.hpp"

namespace ros2wasm_sim {
namespace {

constexpr std::size_t kMostTriangles = 200'000;

bool is_picture(const std::string& ending) {
  return ending == "png" || ending == "jpg" || ending == "jpeg" || ending == "bmp" ||
         ending == "tga";
}

bool is_supported(const std::string& ending) {
  return ending == "stl" || ending == "obj" || ending == "dae" || is_picture(ending);
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
  if (is_picture(ending)) return read_heights(*bytes);
  if (ending == "stl") return read_stl(*bytes, kMostTriangles);
  if (ending == "dae") return read_dae(*bytes, kMostTriangles);
  return read_obj(*bytes, kMostTriangles, [&](const std::string& name) {
    return read(path.substr(0, path.rfind('/') + 1) + name);
  });
}

/// The files that have been read, and parts of them.
class KnownMeshes {
 public:
  explicit KnownMeshes(rclcpp::Logger logger) : logger_(std::move(logger)) {}

  std::shared_ptr<const TriangleMesh> get(const Mesh& mesh) {
    if (mesh.path.empty()) return nullptr;
    const auto whole = file(mesh);
    if (whole == nullptr || mesh.submesh.empty()) return whole;
    const auto [found, is_new] = known_.try_emplace(part_key(mesh));
    if (!is_new) return found->second;
    auto part = submesh_of(*whole, mesh.submesh, mesh.center_submesh);
    if (!part)
      RCLCPP_ERROR(logger_, "mesh [%s] has no submesh [%s]; its submeshes: %s", mesh.uri.c_str(),
                   mesh.submesh.c_str(), object_names(*whole).c_str());
    else
      found->second = std::make_shared<const TriangleMesh>(std::move(*part));
    return found->second;
  }

 private:
  std::shared_ptr<const TriangleMesh> file(const Mesh& mesh) {
    const auto [found, is_new] = known_.try_emplace(mesh.path);
    if (!is_new) return found->second;
    const std::string ending = ending_of(mesh.path);
    if (!is_supported(ending)) {
      RCLCPP_WARN(logger_,
                  "mesh [%s] is skipped: only STL, OBJ and COLLADA files, and pictures of heights, "
                  "are supported",
                  mesh.uri.c_str());
      return nullptr;
    }
    auto read = read_file(mesh.path, ending);
    if (read) {
      found->second = std::make_shared<const TriangleMesh>(std::move(*read));
    } else if (is_picture(ending)) {
      RCLCPP_ERROR(logger_,
                   "heightmap [%s] cannot be read, or has more than %d pixels along a side",
                   mesh.uri.c_str(), kMostHeights);
    } else {
      RCLCPP_ERROR(logger_, "mesh [%s] cannot be read, or has more than %zu triangles",
                   mesh.uri.c_str(), kMostTriangles);
    }
    return found->second;
  }

  rclcpp::Logger logger_;
  std::map<std::string, std::shared_ptr<const TriangleMesh>> known_;  ///< null: it was reported
};

}  // namespace

MeshReader site_meshes(const rclcpp::Logger& logger) {
  return [known = std::make_shared<KnownMeshes>(logger)](const Mesh& mesh) {
    return known->get(mesh);
  };
}

}  // namespace ros2wasm_sim
