// See sdf_material.hpp.
#include "sdf/sdf_material.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "sdf/material_script.hpp"

namespace ros2wasm_sim {
namespace {

struct NamedColor {
  std::string_view name;  ///< after `Gazebo/`
  Color ambient;
  Color diffuse;
};

/// Materials that are pictures in Gazebo have the colour of the whole picture here.
const NamedColor kColors[] = {
    {"Black", {0, 0, 0}, {0, 0, 0}},
    {"Blue", {0, 0, 1}, {0, 0, 1}},
    {"BlueLaser", {0, 0, 1}, {0, 0, 1, 0.4}},
    {"BlueTransparent", {0, 0, 1}, {0, 0, 1, 0.5}},
    {"Bricks", {0.55, 0.3, 0.23}, {0.62, 0.35, 0.27}},
    {"CeilingTiled", {0.8, 0.8, 0.77}, {0.86, 0.86, 0.83}},
    {"DarkGray", {0.175, 0.175, 0.175}, {0.175, 0.175, 0.175}},
    {"DarkGrey", {0.175, 0.175, 0.175}, {0.175, 0.175, 0.175}},
    {"FlatBlack", {0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}},
    {"Gold", {0.4, 0.2487, 0.0208}, {0.8, 0.6487, 0.1208}},
    {"Grass", {0.25, 0.42, 0.15}, {0.3, 0.5, 0.18}},
    {"Gray", {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}},
    {"Green", {0, 1, 0}, {0, 1, 0}},
    {"GreenTransparent", {0, 1, 0}, {0, 1, 0, 0.5}},
    {"Grey", {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}},
    {"GreyTransparent", {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5, 0.5}},
    {"Indigo", {0.33, 0, 0.5}, {0.33, 0, 0.5}},
    {"JointAnchor", {1, 1, 1}, {1, 1, 1}},
    {"LightOff", {1, 0, 0}, {1, 0, 0}},
    {"LightOn", {0, 1, 0}, {0, 1, 0}},
    {"Orange", {1, 0.5088, 0.0468}, {1, 0.5088, 0.0468}},
    {"OrangeTransparent", {1, 0.44, 0}, {1, 0.44, 0, 0.4}},
    {"PaintedWall", {0.75, 0.72, 0.66}, {0.82, 0.79, 0.72}},
    {"Pioneer2Body", {0.9, 0.1, 0.1}, {0.9, 0.1, 0.1}},
    {"Purple", {1, 0, 1}, {1, 0, 1}},
    {"Red", {1, 0, 0}, {1, 0, 0}},
    {"RedBright", {0.87, 0.26, 0.07}, {0.87, 0.26, 0.07}},
    {"RedTransparent", {1, 0, 0}, {1, 0, 0, 0.5}},
    {"Residential", {0.6, 0.55, 0.5}, {0.65, 0.6, 0.55}},
    {"Road", {0.2, 0.2, 0.2}, {0.25, 0.25, 0.25}},
    {"Silver", {0.6, 0.6, 0.6}, {0.75, 0.75, 0.75}},
    {"SkyBlue", {0.13, 0.44, 0.70}, {0, 0, 1}},
    {"Turquoise", {0, 1, 1}, {0, 1, 1}},
    {"White", {1, 1, 1}, {1, 1, 1}},
    {"Wood", {0.55, 0.36, 0.18}, {0.65, 0.45, 0.25}},
    {"WoodFloor", {0.5, 0.33, 0.18}, {0.6, 0.42, 0.25}},
    {"WoodPallet", {0.6, 0.45, 0.28}, {0.7, 0.55, 0.36}},
    {"Yellow", {1, 1, 0}, {1, 1, 0}},
    {"YellowTransparent", {1, 1, 0}, {1, 1, 0, 0.5}},
    {"ZincYellow", {0.9725, 0.9529, 0.2078}, {0.9725, 0.9529, 0.2078}},
};

const NamedColor* color_named(std::string_view name) {
  const auto* found = std::find_if(std::begin(kColors), std::end(kColors),
                                   [&](const NamedColor& color) { return color.name == name; });
  return found == std::end(kColors) ? nullptr : found;
}

/// A <pbr>: its own colours are those of the <material>, or white under a picture.
void read_pbr(Context& context, const Node& pbr, bool has_color, Material& material) {
  const Node metal = child(pbr, "metal");
  const Node workflow = metal ? metal : child(pbr, "specular");
  if (!workflow) {
    return;
  }
  if (metal) {
    material.roughness = number(context, metal, "roughness", 0.5, Range::kNotNegative);
    material.metalness = number(context, metal, "metalness", 0.5, Range::kNotNegative);
  } else {
    material.roughness = 1 - number(context, workflow, "glossiness", 0.5, Range::kNotNegative);
  }
  material.roughness = std::clamp(material.roughness, 0.0, 1.0);
  material.metalness = std::clamp(material.metalness, 0.0, 1.0);
  const Node albedo = child(workflow, "albedo_map");
  if (!text_of(albedo).empty()) {
    material.texture = context.find(text_of(albedo), albedo, "the texture");
    if (!has_color) {
      material.ambient = material.diffuse = {1, 1, 1, 1};
    }
  }
}

}  // namespace

Material plain_material(const Color& color) {
  Material result;
  result.ambient = result.diffuse = color;
  result.is_given = true;
  return result;
}

Material named_material(Context& context, const Node& where, const std::string& name) {
  const std::string_view prefix = "Gazebo/";
  std::string_view word = name;
  if (word.substr(0, prefix.size()) == prefix) {
    word.remove_prefix(prefix.size());
    const std::string_view glow = "Glow";
    const bool glows = word.size() > glow.size() && word.substr(word.size() - glow.size()) == glow;
    word.remove_suffix(glows ? glow.size() : 0);
    if (const NamedColor* color = color_named(word)) {
      Material result;
      result.is_given = true;
      result.ambient = color->ambient;
      result.diffuse = color->diffuse;
      const bool is_lamp = word == "LightOn" || word == "LightOff";
      result.emissive = glows || is_lamp ? color->diffuse : result.emissive;
      return result;
    }
  }
  context.warning_once(where, "material `" + name + "` is not known, so its visuals are grey");
  return Material();
}

namespace {

/// The scripts that a <script> names: files, and all files of folders.
std::vector<std::string> scripts_of(Context& context, const Node& script) {
  std::vector<std::string> files;
  for (const Node& uri : children(script, "uri")) {
    const auto path = context.find_quietly(text_of(uri));
    if (!path) continue;
    const std::vector<std::string> inside = context.list(*path);
    if (inside.empty()) files.push_back(*path);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  const std::string_view ending = ".material";
  files.erase(std::remove_if(files.begin(), files.end(),
                             [&](const std::string& file) {
                               return file.size() < ending.size() ||
                                      file.substr(file.size() - ending.size()) != ending;
                             }),
              files.end());
  return files;
}

/// Gazebo's renderer looks for pictures in all folders that it knows: here in those of the
/// <script>, beside it, and in `materials/textures` of the model.
std::string script_texture(Context& context, const Node& script, const std::string& script_file,
                           const std::string& name) {
  const std::string beside = folder_of(script_file);
  for (const std::string& folder : {beside, folder_of(beside) + "/textures"})
    if (const auto path = context.find_quietly(folder + "/" + name)) return *path;
  for (const Node& uri : children(script, "uri"))
    if (const auto path = context.find_quietly(text_of(uri) + "/" + name)) return *path;
  context.warning_once(script, "the texture `" + name + "` of a material script is not found");
  return {};
}

/// A <script>: one of Gazebo's own materials, or one of a `.material` file.
Material script_material(Context& context, const Node& script) {
  const Node name = child(script, "name");
  for (const std::string& file : scripts_of(context, script)) {
    const auto text = context.read(file);
    const auto found = text ? find_material(*text, text_of(name)) : std::nullopt;
    if (!found) continue;
    Material result;
    result.is_given = true;
    result.ambient = found->ambient;
    result.diffuse = found->diffuse;
    result.emissive = found->emissive;
    if (!found->texture.empty())
      result.texture = script_texture(context, script, file, found->texture);
    return result;
  }
  return named_material(context, name, text_of(name));
}

}  // namespace

Material read_material(Context& context, const Node& node) {
  Material result;
  const Node script = child(node, "script");
  const bool has_diffuse = !text_of(node, "diffuse").empty();
  const bool has_ambient = !text_of(node, "ambient").empty();
  const bool has_pbr = static_cast<bool>(child(node, "pbr"));
  if (!text_of(script, "name").empty() && !has_diffuse && !has_ambient && !has_pbr) {
    result = script_material(context, script);
  }
  // With one of both, the other one is the same.
  result.ambient = color(context, node, has_ambient ? "ambient" : "diffuse", result.ambient);
  result.diffuse = color(context, node, has_diffuse ? "diffuse" : "ambient", result.diffuse);
  result.specular = color(context, node, "specular", result.specular);
  result.emissive = color(context, node, "emissive", result.emissive);
  read_pbr(context, child(node, "pbr"), has_diffuse || has_ambient, result);
  result.is_given = result.is_given || has_diffuse || has_ambient || has_pbr;
  return result;
}

}  // namespace ros2wasm_sim
