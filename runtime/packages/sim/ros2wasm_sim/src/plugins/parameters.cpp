// See parameters.hpp.
#include "plugins/parameters.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace ros2wasm_sim {
namespace {

std::string trimmed(const std::string& text) {
  const auto is_space = [](unsigned char sign) { return std::isspace(sign) != 0; };
  const auto first = std::find_if_not(text.begin(), text.end(), is_space);
  const auto last = std::find_if_not(text.rbegin(), text.rend(), is_space).base();
  return first < last ? std::string(first, last) : std::string();
}

}  // namespace

const ros2wasm_xml::XmlElement* Parameters::find(const std::string& name) const {
  return xml_.element == nullptr ? nullptr : xml_.document->child(*xml_.element, name);
}

std::string Parameters::text(const std::string& name, const std::string& otherwise) const {
  const auto* found = find(name);
  return found == nullptr ? otherwise : trimmed(found->text);
}

double Parameters::number(const std::string& name, double otherwise) const {
  return Parameters({xml_.document, find(name)}).own_number(otherwise);
}

double Parameters::own_number(double otherwise) const {
  if (xml_.element == nullptr) return otherwise;
  const std::string text = trimmed(xml_.element->text);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end != text.c_str() && std::isfinite(value) ? value : otherwise;
}

bool Parameters::flag(const std::string& name, bool otherwise) const {
  std::string word = text(name, "");
  if (word.empty()) return otherwise;
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char sign) { return static_cast<char>(std::tolower(sign)); });
  return word == "true" || word == "1" || word == "yes";
}

std::vector<std::string> Parameters::all(const std::string& name) const {
  std::vector<std::string> texts;
  if (xml_.element == nullptr) return texts;
  for (const auto* one : xml_.document->children(*xml_.element, name))
    texts.push_back(trimmed(one->text));
  return texts;
}

Vector3 Parameters::vector(const std::string& name) const {
  std::istringstream text(this->text(name, ""));
  text.imbue(std::locale::classic());
  Vector3 v;
  text >> v.x >> v.y >> v.z;
  return v;
}

Parameters Parameters::inside(const std::string& path) const {
  const std::size_t slash = path.find('/');
  const auto* found = find(path.substr(0, slash));
  const Parameters inner({xml_.document, found});
  return slash == std::string::npos ? inner : inner.inside(path.substr(slash + 1));
}

std::vector<Parameters> Parameters::each(const std::string& name) const {
  std::vector<Parameters> result;
  if (xml_.element == nullptr) return result;
  for (const auto* one : xml_.document->children(*xml_.element, name))
    result.emplace_back(XmlView{xml_.document, one});
  return result;
}

}  // namespace ros2wasm_sim
