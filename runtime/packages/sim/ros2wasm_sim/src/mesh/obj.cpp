// See obj.hpp.
#include "mesh/obj.hpp"

#include <cmath>
#include <cstdlib>
#include <map>
#include <string_view>
#include <utility>

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

/// The rest of the line: a file name may have spaces.
std::string rest_of(Words& words) {
  std::string rest(words.next());
  for (std::string_view word = words.next(); !word.empty(); word = words.next())
    rest += " " + std::string(word);
  return rest;
}

/// Reads finite numbers; fewer than `count` are an error.
bool add_numbers(Words& words, int count, std::vector<float>& numbers) {
  for (int i = 0; i < count; ++i) {
    const std::string word(words.next());
    char* end = nullptr;
    const float value = std::strtof(word.c_str(), &end);
    if (end == word.c_str() || !std::isfinite(value)) return false;
    numbers.push_back(value);
  }
  return true;
}

/// Calls `use` with the words of each line.
template <typename Use>
bool each_line(const std::string& text, Use use) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = text.find('\n', at);
    if (end == std::string::npos) end = text.size();
    Words words(std::string_view(text).substr(at, end - at));
    at = end + 1;
    if (!use(words)) return false;
  }
  return true;
}

using Materials = std::map<std::string, MeshPart>;

void add_materials(const std::string& text, Materials& materials) {
  MeshPart* current = nullptr;
  each_line(text, [&](Words& words) {
    const std::string_view kind = words.next();
    std::vector<float> v;
    if (kind == "newmtl") {
      current = &materials[rest_of(words)];
    } else if (current == nullptr) {
      return true;
    } else if (kind == "Kd" && add_numbers(words, 3, v)) {
      const double alpha = current->diffuse ? current->diffuse->a : 1;
      current->diffuse = Color{v[0], v[1], v[2], alpha};
    } else if (kind == "d" && add_numbers(words, 1, v)) {
      if (!current->diffuse) current->diffuse = Color();
      current->diffuse->a = v[0];
    } else if (kind == "map_Kd") {
      current->texture = rest_of(words);
    }
    return true;
  });
}

/// The index that `text` counts from 1, or from the end when it is negative; -1 if there is none.
int index_of(std::string_view text, std::size_t count) {
  const long number = std::strtol(std::string(text).c_str(), nullptr, 10);
  const long index = number < 0 ? static_cast<long>(count) + number : number - 1;
  return number != 0 && index >= 0 && index < static_cast<long>(count) ? static_cast<int>(index)
                                                                       : -1;
}

class Reader {
 public:
  Reader(std::size_t most, const ReadBeside& beside) : most_(most), beside_(beside) {}

  bool read_line(Words& words) {
    const std::string_view kind = words.next();
    if (kind == "v") return add_numbers(words, 3, mesh_.vertices);
    if (kind == "vt") return add_numbers(words, 2, places_);
    if (kind == "f") return add_face(words);
    if (kind == "usemtl") begin_part(rest_of(words));
    if (kind == "o" || kind == "g") begin_object(rest_of(words));
    if (kind == "mtllib") read_materials(rest_of(words));
    return true;
  }

  std::optional<TriangleMesh> take() {
    if (mesh_.faces.empty()) return std::nullopt;
    if (!mesh_.uvs.empty()) mesh_.uvs.resize(2 * mesh_.faces.size());
    if (!mesh_.parts.empty() && mesh_.parts.front().first_face > 0)
      mesh_.parts.insert(mesh_.parts.begin(), MeshPart());
    return std::move(mesh_);
  }

 private:
  struct Corner {
    int vertex, place;
  };

  void read_materials(const std::string& name) {
    constexpr int kMostFiles = 16;
    const auto text = beside_ && ++files_ <= kMostFiles ? beside_(name) : std::nullopt;
    if (text) add_materials(*text, materials_);
  }

  void begin_part(const std::string& material) {
    const auto found = materials_.find(material);
    if (found == materials_.end() && mesh_.parts.empty()) return;
    MeshPart part = found == materials_.end() ? MeshPart() : found->second;
    part.first_face = mesh_.faces.size() / 3;
    if (!mesh_.parts.empty() && mesh_.parts.back().first_face == part.first_face)
      mesh_.parts.pop_back();
    mesh_.parts.push_back(std::move(part));
  }

  void begin_object(std::string name) {
    const std::size_t first = mesh_.faces.size() / 3;
    auto& objects = mesh_.objects;
    if (!objects.empty() && objects.back().first_face == first) {  // `o` and `g` of the same faces
      if (objects.back().geometry.empty()) objects.back().geometry = std::move(name);
      return;
    }
    constexpr std::size_t kMostObjects = 10'000;
    if (objects.size() < kMostObjects) objects.push_back({first, std::move(name), {}});
  }

  /// Corners such as `7`, `7/1`, `7/1/2` and `7//2`: a vertex, a place in a picture, a normal.
  bool add_face(Words& words) {
    std::vector<Corner> corners;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      const std::size_t slash = word.find('/');
      Corner corner{index_of(word.substr(0, slash), mesh_.vertices.size() / 3), -1};
      if (slash != std::string_view::npos)
        corner.place = index_of(word.substr(slash + 1), places_.size() / 2);
      if (corner.vertex < 0) return false;
      corners.push_back(corner);
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
      for (const Corner& one : {corners[0], corners[i - 1], corners[i]}) add_corner(one);
    return mesh_.faces.size() <= 3 * most_;
  }

  void add_corner(const Corner& corner) {
    if (corner.place >= 0) {
      mesh_.uvs.resize(2 * mesh_.faces.size());
      const float* place = &places_[2 * static_cast<std::size_t>(corner.place)];
      // An OBJ file counts from below.
      mesh_.uvs.insert(mesh_.uvs.end(), {place[0], 1 - place[1]});
    }
    mesh_.faces.push_back(corner.vertex);
  }

  std::size_t most_;
  const ReadBeside& beside_;
  TriangleMesh mesh_;
  std::vector<float> places_;
  Materials materials_;
  int files_ = 0;
};

}  // namespace

std::optional<TriangleMesh> read_obj(const std::string& text, std::size_t most,
                                     const ReadBeside& beside) {
  Reader reader(most, beside);
  if (!each_line(text, [&](Words& words) { return reader.read_line(words); })) return std::nullopt;
  return reader.take();
}

}  // namespace ros2wasm_sim
