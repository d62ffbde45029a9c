// See obj.hpp.
#include "mesh/obj.hpp"

#include <cmath>
#include <cstdlib>
#include <string_view>

namespace ros2wasm_sim {
namespace {

/// The words of a line, one after the other.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  std::string_view next() {
    const std::size_t from = rest_.find_first_not_of(" \t\r");
    if (from == std::string_view::npos) return {};
    const std::size_t to = rest_.find_first_of(" \t\r", from);
    const std::string_view word = rest_.substr(from, to == std::string_view::npos ? to : to - from);
    rest_ = to == std::string_view::npos ? std::string_view() : rest_.substr(to);
    return word;
  }

 private:
  std::string_view rest_;
};

bool add_vertex(Words& words, std::vector<float>& vertices) {
  for (int i = 0; i < 3; ++i) {
    const std::string word(words.next());
    char* end = nullptr;
    const float value = std::strtof(word.c_str(), &end);
    if (end == word.c_str() || !std::isfinite(value)) return false;
    vertices.push_back(value);
  }
  return true;
}

/// The index of the vertex that `7`, `7/1` or `7/1/2` names. A negative number counts from the end.
/// Returns -1 when the vertex does not exist.
int vertex_of(std::string_view word, std::size_t count) {
  const long number = std::strtol(std::string(word).c_str(), nullptr, 10);
  const long index = number < 0 ? static_cast<long>(count) + number : number - 1;
  return number != 0 && index >= 0 && index < static_cast<long>(count) ? static_cast<int>(index)
                                                                       : -1;
}

bool add_face(Words& words, TriangleMesh& mesh, std::size_t most) {
  const std::size_t count = mesh.vertices.size() / 3;
  std::vector<int> corners;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    corners.push_back(vertex_of(word, count));
    if (corners.back() < 0) return false;
  }
  for (std::size_t i = 2; i < corners.size(); ++i)
    mesh.faces.insert(mesh.faces.end(), {corners[0], corners[i - 1], corners[i]});
  return mesh.faces.size() <= 3 * most;
}

}  // namespace

std::optional<TriangleMesh> read_obj(const std::string& text, std::size_t most) {
  TriangleMesh mesh;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = text.find('\n', at);
    if (end == std::string::npos) end = text.size();
    Words words(std::string_view(text).substr(at, end - at));
    at = end + 1;
    const std::string_view kind = words.next();
    if (kind == "v" && !add_vertex(words, mesh.vertices)) return std::nullopt;
    if (kind == "f" && !add_face(words, mesh, most)) return std::nullopt;
  }
  if (mesh.faces.empty()) return std::nullopt;
  return mesh;
}

}  // namespace ros2wasm_sim
