// See dae.hpp.
#include "mesh/dae.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

#include "ros2wasm_xml/xml_document.hpp"

namespace ros2wasm_sim {
namespace {

using ros2wasm_xml::XmlDocument;
using ros2wasm_xml::XmlElement;

/// Row by row; the last row is 0 0 0 1.
using Matrix = std::array<double, 12>;
constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

/// Limits for hostile files, which may place a node or geometry many times: how many are placed,
/// and the bytes of number lists that are read for them.
constexpr int kMostPlaced = 40'000;
constexpr std::size_t kMostBytes = 500'000'000;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) {
      double sum = column == 3 ? a[4 * row + 3] : 0;
      for (int i = 0; i < 3; ++i) sum += a[4 * row + i] * b[4 * i + column];
      result[4 * row + column] = sum;
    }
  return result;
}

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.c_str();
  for (char* end = nullptr;; at = end) {
    const double value = std::strtod(at, &end);
    if (end == at) return numbers;
    numbers.push_back(value);
  }
}

Matrix rotation(double x, double y, double z, double degrees) {
  const double size = std::sqrt(x * x + y * y + z * z);
  if (size == 0) return kIdentity;
  const double angle = degrees * std::numbers::pi / 360;
  const double w = std::cos(angle), s = std::sin(angle) / size;
  x *= s;
  y *= s;
  z *= s;
  return {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),     0,
          2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),     0,
          2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y), 0};
}

/// The transformations of a node, in the order of the file.
Matrix transformation(const XmlDocument& document, const XmlElement& node) {
  Matrix result = kIdentity;
  for (const XmlElement* one : document.children(node)) {
    const bool counts = one->name == "matrix" || one->name == "translate" ||
                        one->name == "rotate" || one->name == "scale";
    if (!counts) continue;
    const std::vector<double> v = numbers_of(one->text);
    if (one->name == "matrix" && v.size() >= 12) {
      Matrix given;
      std::copy_n(v.begin(), 12, given.begin());
      result = product(result, given);
    } else if (one->name == "translate" && v.size() == 3) {
      result = product(result, {1, 0, 0, v[0], 0, 1, 0, v[1], 0, 0, 1, v[2]});
    } else if (one->name == "rotate" && v.size() == 4) {
      result = product(result, rotation(v[0], v[1], v[2], v[3]));
    } else if (one->name == "scale" && v.size() == 3) {
      result = product(result, {v[0], 0, 0, 0, 0, v[1], 0, 0, 0, 0, v[2], 0});
    }
  }
  return result;
}

class Reader {
 public:
  Reader(const XmlDocument& document, std::size_t most) : document_(document), most_(most) {
    for (const XmlElement* library : document.children(document.root()))
      for (const XmlElement* one : document.children(*library)) remember(*one);
  }

  bool read(TriangleMesh& mesh) {
    Matrix scale = kIdentity;
    if (const XmlElement* asset = document_.child(document_.root(), "asset"))
      if (const XmlElement* unit = document_.child(*asset, "unit"))
        if (const std::string* meter = unit->attribute("meter"))
          if (const double factor = std::strtod(meter->c_str(), nullptr); factor > 0)
            scale[0] = scale[5] = scale[10] = factor;
    for (const XmlElement* library : document_.children(document_.root(), "library_visual_scenes"))
      for (const XmlElement* scene : document_.children(*library, "visual_scene"))
        for (const XmlElement* node : document_.children(*scene, "node"))
          if (!place(*node, scale, mesh)) return false;
    return !mesh.faces.empty();
  }

 private:
  struct Placed {
    const XmlElement* node;
    Matrix matrix;
  };

  /// The vertices of a source in the mesh.
  struct Vertices {
    int first = 0;
    int count = 0;
  };

  void remember(const XmlElement& element) {
    if (const std::string* id = element.attribute("id")) by_id_.emplace("#" + *id, &element);
  }

  const XmlElement* named(const XmlElement& element, const char* attribute) const {
    const std::string* url = element.attribute(attribute);
    const auto found = url == nullptr ? by_id_.end() : by_id_.find(*url);
    return found == by_id_.end() ? nullptr : found->second;
  }

  /// Not by recursion: nodes may be as deep as the file likes, and name each other.
  bool place(const XmlElement& root, const Matrix& outer, TriangleMesh& mesh) {
    std::vector<Placed> open{{&root, outer}};
    while (!open.empty()) {
      const Placed one = open.back();
      open.pop_back();
      if (++placed_ > kMostPlaced) return false;
      const Matrix matrix = product(one.matrix, transformation(document_, *one.node));
      for (const XmlElement* inner : document_.children(*one.node)) {
        if (inner->name == "node") open.push_back({inner, matrix});
        const XmlElement* target = named(*inner, "url");
        if (target == nullptr) continue;
        if (inner->name == "instance_node") open.push_back({target, matrix});
        if (inner->name == "instance_geometry" && !add_geometry(*target, matrix, mesh))
          return false;
      }
    }
    return true;
  }

  bool add_geometry(const XmlElement& geometry, const Matrix& matrix, TriangleMesh& mesh) {
    const XmlElement* inner = document_.child(geometry, "mesh");
    if (inner == nullptr) return true;
    if (++placed_ > kMostPlaced) return false;
    std::map<std::string, const XmlElement*> parts;
    for (const XmlElement* part : document_.children(*inner))
      if (const std::string* id = part->attribute("id")) parts.emplace("#" + *id, part);
    std::map<const XmlElement*, Vertices> added;
    for (const XmlElement* part : document_.children(*inner)) {
      const bool counts =
          part->name == "triangles" || part->name == "polylist" || part->name == "polygons";
      if (counts && !add_faces(*part, parts, matrix, added, mesh)) return false;
    }
    return true;
  }

  bool add_faces(const XmlElement& faces, const std::map<std::string, const XmlElement*>& parts,
                 const Matrix& matrix, std::map<const XmlElement*, Vertices>& added,
                 TriangleMesh& mesh) {
    std::size_t stride = 0, offset = 0;
    const XmlElement* source = nullptr;
    for (const XmlElement* input : document_.children(faces, "input")) {
      const std::string* semantic = input->attribute("semantic");
      const std::string* at = input->attribute("offset");
      const std::size_t place = at == nullptr ? 0 : std::strtoul(at->c_str(), nullptr, 10);
      if (place > 100) return false;
      stride = std::max(stride, place + 1);
      if (semantic == nullptr || *semantic != "VERTEX") continue;
      offset = place;
      source = positions(*input, parts);
    }
    if (source == nullptr) return true;
    const auto [found, is_new] = added.try_emplace(source);
    if (is_new && !add_vertices(*source, matrix, found->second, mesh)) return false;
    const Vertices vertices = found->second;
    const XmlElement* counts = document_.child(faces, "vcount");
    bytes_ += counts == nullptr ? 0 : counts->text.size();
    const std::vector<double> sizes =
        counts == nullptr ? std::vector<double>() : numbers_of(counts->text);
    for (const XmlElement* list : document_.children(faces, "p")) {
      if ((bytes_ += list->text.size()) > kMostBytes) return false;
      std::vector<int> corners;
      const std::vector<double> indices = numbers_of(list->text);
      for (std::size_t i = offset; i < indices.size(); i += stride) {
        if (!(indices[i] >= 0) || indices[i] >= vertices.count) return false;
        corners.push_back(vertices.first + static_cast<int>(indices[i]));
      }
      if (!add_polygons(faces.name, sizes, corners, mesh)) return false;
    }
    return bytes_ <= kMostBytes;
  }

  /// The positions of a source, which several lists of faces may share.
  bool add_vertices(const XmlElement& source, const Matrix& matrix, Vertices& added,
                    TriangleMesh& mesh) {
    const XmlElement* array = document_.child(source, "float_array");
    if (array == nullptr) return true;
    if ((bytes_ += array->text.size()) > kMostBytes) return false;
    const std::vector<double> values = numbers_of(array->text);
    added.first = static_cast<int>(mesh.vertices.size() / 3);
    added.count = static_cast<int>(values.size() / 3);
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
      for (int row = 0; row < 3; ++row) {
        const double value = matrix[4 * row] * values[i] + matrix[4 * row + 1] * values[i + 1] +
                             matrix[4 * row + 2] * values[i + 2] + matrix[4 * row + 3];
        if (!std::isfinite(value)) return false;
        mesh.vertices.push_back(static_cast<float>(value));
      }
    return mesh.vertices.size() <= 9 * most_;
  }

  bool add_polygons(const std::string& kind, const std::vector<double>& sizes,
                    const std::vector<int>& corners, TriangleMesh& mesh) const {
    std::size_t at = 0, which = 0;
    while (at < corners.size()) {
      double size = 3;
      if (kind == "polygons") size = static_cast<double>(corners.size());
      if (kind == "polylist") {
        if (which == sizes.size()) break;
        size = sizes[which++];
      }
      if (!(size >= 1) || size > static_cast<double>(corners.size() - at)) return false;
      for (std::size_t i = 2; i < static_cast<std::size_t>(size); ++i)
        mesh.faces.insert(mesh.faces.end(), {corners[at], corners[at + i - 1], corners[at + i]});
      if (mesh.faces.size() > 3 * most_) return false;
      at += static_cast<std::size_t>(size);
    }
    return true;
  }

  /// `VERTEX` names <vertices>, whose `POSITION` names the source.
  const XmlElement* positions(const XmlElement& input,
                              const std::map<std::string, const XmlElement*>& parts) const {
    const auto find = [&](const XmlElement& one) -> const XmlElement* {
      const std::string* name = one.attribute("source");
      const auto found = name == nullptr ? parts.end() : parts.find(*name);
      return found == parts.end() ? nullptr : found->second;
    };
    const XmlElement* vertices = find(input);
    if (vertices == nullptr || vertices->name != "vertices") return vertices;
    for (const XmlElement* one : document_.children(*vertices, "input")) {
      const std::string* semantic = one->attribute("semantic");
      if (semantic != nullptr && *semantic == "POSITION") return find(*one);
    }
    return nullptr;
  }

  const XmlDocument& document_;
  std::size_t most_;
  int placed_ = 0;
  std::size_t bytes_ = 0;
  std::map<std::string, const XmlElement*> by_id_;
};

}  // namespace

std::optional<TriangleMesh> read_dae(const std::string& text, std::size_t most) {
  try {
    const XmlDocument document(text);
    if (document.root().name != "COLLADA") return std::nullopt;
    TriangleMesh mesh;
    if (!Reader(document, most).read(mesh)) return std::nullopt;
    return mesh;
  } catch (const ros2wasm_xml::XmlError&) {
    return std::nullopt;
  }
}

}  // namespace ros2wasm_sim
