// See dae.hpp.
#include "mesh/dae.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <numbers>
#include <string_view>
#include <utility>

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
    if (!mesh.uvs.empty()) mesh.uvs.resize(2 * mesh.faces.size());
    return !mesh.faces.empty();
  }

 private:
  struct Placed {
    const XmlElement* node;
    Matrix matrix;
    std::string name;  ///< of the node, or of the nearest one around it that has a name
  };

  struct Corner {
    int vertex;
    int place;  ///< in the picture; -1: none
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
    std::vector<Placed> open{{&root, outer, {}}};
    while (!open.empty()) {
      Placed one = std::move(open.back());
      open.pop_back();
      if (++placed_ > kMostPlaced) return false;
      if (const std::string* name = one.node->attribute("name")) one.name = *name;
      const Matrix matrix = product(one.matrix, transformation(document_, *one.node));
      for (const XmlElement* inner : document_.children(*one.node)) {
        if (inner->name == "node") open.push_back({inner, matrix, one.name});
        const XmlElement* target = named(*inner, "url");
        if (target == nullptr) continue;
        if (inner->name == "instance_node") open.push_back({target, matrix, one.name});
        if (inner->name != "instance_geometry") continue;
        const std::string* geometry = target->attribute("name");
        mesh.objects.push_back(
            {mesh.faces.size() / 3, one.name, geometry == nullptr ? std::string() : *geometry});
        if (!add_geometry(*target, *inner, matrix, mesh)) return false;
      }
    }
    return true;
  }

  /// `instance` binds the names of materials to materials.
  bool add_geometry(const XmlElement& geometry, const XmlElement& instance, const Matrix& matrix,
                    TriangleMesh& mesh) {
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
      if (!counts) continue;
      begin_part(*part, instance, mesh);
      if (!add_faces(*part, parts, matrix, added, mesh)) return false;
    }
    return true;
  }

  bool add_faces(const XmlElement& faces, const std::map<std::string, const XmlElement*>& parts,
                 const Matrix& matrix, std::map<const XmlElement*, Vertices>& added,
                 TriangleMesh& mesh) {
    std::size_t stride = 0, offset = 0, place_offset = 0;
    const XmlElement* source = nullptr;
    std::vector<double> places;
    for (const XmlElement* input : document_.children(faces, "input")) {
      const std::string* semantic = input->attribute("semantic");
      const std::string* at = input->attribute("offset");
      const std::size_t place = at == nullptr ? 0 : std::strtoul(at->c_str(), nullptr, 10);
      if (place > 100) return false;
      stride = std::max(stride, place + 1);
      if (semantic != nullptr && *semantic == "TEXCOORD" && places.empty()) {
        place_offset = place;
        places = places_of(*input, parts);
      }
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
      std::vector<Corner> corners;
      const std::vector<double> indices = numbers_of(list->text);
      for (std::size_t i = 0; i + stride <= indices.size(); i += stride) {
        const double vertex = indices[i + offset], at = indices[i + place_offset];
        if (!(vertex >= 0) || vertex >= vertices.count) return false;
        const bool has_place = at >= 0 && at < static_cast<double>(places.size() / 2);
        corners.push_back(
            {vertices.first + static_cast<int>(vertex), has_place ? static_cast<int>(at) : -1});
      }
      if (!add_polygons(faces.name, sizes, corners, places, mesh)) return false;
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

  /// The two coordinates of each place in a picture that a `TEXCOORD` source lists.
  std::vector<double> places_of(const XmlElement& input,
                                const std::map<std::string, const XmlElement*>& parts) {
    const std::string* name = input.attribute("source");
    const auto found = name == nullptr ? parts.end() : parts.find(*name);
    const XmlElement* array =
        found == parts.end() ? nullptr : document_.child(*found->second, "float_array");
    if (array == nullptr || (bytes_ += array->text.size()) > kMostBytes) return {};
    std::size_t step = 2;
    if (const XmlElement* common = document_.child(*found->second, "technique_common"))
      if (const XmlElement* accessor = document_.child(*common, "accessor"))
        if (const std::string* stride = accessor->attribute("stride"))
          step = std::clamp<std::size_t>(std::strtoul(stride->c_str(), nullptr, 10), 2, 4);
    const std::vector<double> values = numbers_of(array->text);
    std::vector<double> places;
    for (std::size_t i = 0; i + 1 < values.size(); i += step)
      places.insert(places.end(), {values[i], values[i + 1]});
    return places;
  }

  /// The faces that follow look like the material of this list of faces.
  void begin_part(const XmlElement& faces, const XmlElement& instance, TriangleMesh& mesh) const {
    const std::string* symbol = faces.attribute("material");
    MeshPart part = symbol == nullptr ? MeshPart() : look_of(bound_to(*symbol, instance));
    part.first_face = mesh.faces.size() / 3;
    if (!mesh.parts.empty() && mesh.parts.back().first_face == part.first_face)
      mesh.parts.pop_back();
    const bool says_nothing = !part.diffuse && part.texture.empty();
    if (says_nothing && mesh.parts.empty()) return;
    if (mesh.parts.empty() && part.first_face > 0) mesh.parts.emplace_back();
    mesh.parts.push_back(std::move(part));
  }

  const XmlElement* bound_to(const std::string& symbol, const XmlElement& instance) const {
    const XmlElement* bind = document_.child(instance, "bind_material");
    const XmlElement* common = bind ? document_.child(*bind, "technique_common") : nullptr;
    if (common != nullptr)
      for (const XmlElement* one : document_.children(*common, "instance_material"))
        if (const std::string* name = one->attribute("symbol"); name != nullptr && *name == symbol)
          return named(*one, "target");
    const auto found = by_id_.find("#" + symbol);
    return found == by_id_.end() ? nullptr : found->second;
  }

  /// The child at a path, or null.
  const XmlElement* inside(const XmlElement* element,
                           std::initializer_list<const char*> path) const {
    for (const char* name : path) element = element ? document_.child(*element, name) : nullptr;
    return element;
  }

  MeshPart look_of(const XmlElement* material) const {
    MeshPart part;
    const XmlElement* link = inside(material, {"instance_effect"});
    const XmlElement* effect = link ? named(*link, "url") : nullptr;
    const XmlElement* profile = inside(effect, {"profile_COMMON"});
    const XmlElement* technique = inside(profile, {"technique"});
    for (const char* model : {"phong", "lambert", "blinn"}) {
      const XmlElement* diffuse = inside(technique, {model, "diffuse"});
      if (const XmlElement* color = inside(diffuse, {"color"})) {
        const std::vector<double> v = numbers_of(color->text);
        if (v.size() >= 3) part.diffuse = Color{v[0], v[1], v[2], v.size() > 3 ? v[3] : 1};
      }
      if (const XmlElement* texture = inside(diffuse, {"texture"}))
        if (const std::string* sampler = texture->attribute("texture")) {
          part.diffuse = Color();
          part.texture = picture_of(*profile, *sampler);
        }
    }
    return part;
  }

  /// A sampler names a surface, which names an image; some writers name the image at once.
  std::string picture_of(const XmlElement& profile, const std::string& sampler) const {
    std::string image = sampler;
    for (const char* kind : {"sampler2D", "surface"})
      for (const XmlElement* one : document_.children(profile, "newparam")) {
        const std::string* sid = one->attribute("sid");
        if (sid == nullptr || *sid != image) continue;
        const bool is_sampler = std::string_view(kind) == "sampler2D";
        if (const XmlElement* next = inside(one, {kind, is_sampler ? "source" : "init_from"})) {
          image = trimmed(next->text);
          break;
        }
      }
    const auto found = by_id_.find("#" + image);
    const XmlElement* file = found == by_id_.end() ? nullptr : inside(found->second, {"init_from"});
    if (file == nullptr) return {};
    const XmlElement* inner = document_.child(*file, "ref");
    std::string name = trimmed(inner ? inner->text : file->text);
    for (const std::string_view prefix : {"file://", "./"})
      if (name.rfind(prefix, 0) == 0) name.erase(0, prefix.size());
    return name;
  }

  static std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(" \t\r\n");
    if (from == std::string::npos) return {};
    return text.substr(from, text.find_last_not_of(" \t\r\n") - from + 1);
  }

  bool add_polygons(const std::string& kind, const std::vector<double>& sizes,
                    const std::vector<Corner>& corners, const std::vector<double>& places,
                    TriangleMesh& mesh) const {
    std::size_t at = 0, polygon = 0;
    while (at < corners.size()) {
      double size = 3;
      if (kind == "polygons") size = static_cast<double>(corners.size());
      if (kind == "polylist") {
        if (polygon == sizes.size()) break;
        size = sizes[polygon++];
      }
      if (!(size >= 1) || size > static_cast<double>(corners.size() - at)) return false;
      for (std::size_t i = 2; i < static_cast<std::size_t>(size); ++i)
        for (const std::size_t which : {at, at + i - 1, at + i})
          add_corner(corners[which], places, mesh);
      if (mesh.faces.size() > 3 * most_) return false;
      at += static_cast<std::size_t>(size);
    }
    return true;
  }

  static void add_corner(const Corner& corner, const std::vector<double>& places,
                         TriangleMesh& mesh) {
    if (corner.place >= 0) {
      mesh.uvs.resize(2 * mesh.faces.size());
      const double* place = &places[2 * static_cast<std::size_t>(corner.place)];
      // COLLADA counts from below.
      mesh.uvs.insert(mesh.uvs.end(),
                      {static_cast<float>(place[0]), static_cast<float>(1 - place[1])});
    }
    mesh.faces.push_back(corner.vertex);
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
