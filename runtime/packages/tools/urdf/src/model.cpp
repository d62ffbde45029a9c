// From a description to a model.
#include "urdf/model.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <vector>

#include "elements.hpp"
#include "sdf_model.hpp"

namespace urdf {
namespace {

template <typename T>
void add(std::map<std::string, std::shared_ptr<T>>& into, const std::shared_ptr<T>& one,
         const char* what) {
  if (!into.emplace(one->name, one).second) {
    throw ParseError(std::string(what) + " '" + one->name + "' is not unique.");
  }
}

/// A visual that only names a material gets the material of that name; other materials are stored
/// under their names.
void share_materials(ModelInterface& model, const Link& link) {
  for (const VisualSharedPtr& visual : link.visual_array) {
    if (visual->material_name.empty()) {
      continue;
    }
    if (const MaterialSharedPtr known = model.getMaterial(visual->material_name)) {
      visual->material = known;
    } else if (visual->material != nullptr) {
      model.materials_.emplace(visual->material_name, visual->material);
    } else {
      throw ParseError("link '" + link.name + "' material '" + visual->material_name +
                       "' undefined.");
    }
  }
}

/// Each link is reached once, from the root.
void check_tree(const ModelInterface& model) {
  std::map<std::string, int> seen;
  std::vector<LinkConstSharedPtr> open{model.getRoot()};
  while (!open.empty()) {
    const LinkConstSharedPtr link = open.back();
    open.pop_back();
    if (++seen[link->name] > 1) {
      throw ParseError("link '" + link->name + "' has two parents");
    }
    open.insert(open.end(), link->child_links.begin(), link->child_links.end());
  }
  for (const auto& [name, link] : model.links_) {
    if (seen.count(name) == 0) {
      throw ParseError("link '" + name + "' is its own ancestor");
    }
  }
}

void read_urdf(const XmlDocument& xml, ModelInterface& model) {
  if (xml.root().name != "robot") {
    throw ParseError("Could not find the 'robot' element in the xml file");
  }
  const std::string* name = xml.root().attribute("name");
  if (name == nullptr) {
    throw ParseError("No name given for the robot.");
  }
  model.name_ = *name;
  for (const XmlElement* element : xml.children(xml.root(), "material")) {
    add(model.materials_, material_of(xml, *element, false), "material");
  }
  for (const XmlElement* element : xml.children(xml.root(), "link")) {
    const LinkSharedPtr link = link_of(xml, *element);
    add(model.links_, link, "link");
    share_materials(model, *link);
  }
  if (model.links_.empty()) {
    throw ParseError("No link elements found in urdf file");
  }
  for (const XmlElement* element : xml.children(xml.root(), "joint")) {
    add(model.joints_, joint_of(xml, *element), "joint");
  }
}

void read_robot(const std::string& text, ModelInterface& model) {
  const XmlDocument xml(text);
  if (xml.root().name == "sdf") {
    read_sdf(xml, model);
  } else {
    read_urdf(xml, model);
  }
  std::map<std::string, std::string> parents;
  model.initTree(parents);
  model.initRoot(parents);
  check_tree(model);
}

/// Links hold each other when they are no tree.
void take_apart(ModelInterface& model) {
  for (const auto& [name, link] : model.links_) {
    link->clear();
  }
  model.clear();
}

}  // namespace

bool Model::initString(const std::string& xmlstring) {
  clear();
  try {
    read_robot(xmlstring, *this);
    return true;
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "Error:   %s\n", error.what());
  }
  take_apart(*this);
  return false;
}

bool Model::initFile(const std::string& filename) {
  std::ifstream file(filename);
  if (!file) {
    std::fprintf(stderr, "Error:   Could not open file [%s] for parsing.\n", filename.c_str());
    clear();
    return false;
  }
  return initString(std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace urdf
