// See create_flags.hpp.
#include "create_flags.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>

namespace ros_gz_sim {
namespace {

bool is_true(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text == "1" || text == "t" || text == "true" || text == "y" || text == "yes";
}

}  // namespace

CreateFlags read_create_flags(const std::vector<std::string>& words) {
  CreateFlags flags;
  const std::map<std::string, std::string*> texts{
      {"world", &flags.world},   {"file", &flags.file},   {"param", &flags.param},
      {"string", &flags.string}, {"topic", &flags.topic}, {"name", &flags.name}};
  const std::map<std::string, double*> numbers{{"x", &flags.x},     {"y", &flags.y},
                                               {"z", &flags.z},     {"R", &flags.roll},
                                               {"P", &flags.pitch}, {"Y", &flags.yaw}};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--") break;
    const std::size_t begin = word.find_first_not_of('-');
    if (begin == std::string::npos || begin == 0 || begin > 2) continue;
    const std::size_t equals = word.find('=');
    const std::string name =
        word.substr(begin, equals == std::string::npos ? equals : equals - begin);
    if (name == "allow_renaming" || name == "noallow_renaming") {
      flags.allow_renaming =
          name[0] == 'a' && (equals == std::string::npos || is_true(word.substr(equals + 1)));
      continue;
    }
    const auto text = texts.find(name);
    const auto number = numbers.find(name);
    if (text == texts.end() && number == numbers.end()) continue;
    if (equals == std::string::npos && i + 1 == words.size()) {
      flags.fault = "flag '" + word + "' is missing its argument";
      break;
    }
    const std::string value = equals == std::string::npos ? words[++i] : word.substr(equals + 1);
    if (text != texts.end()) {
      *text->second = value;
      continue;
    }
    char* end = nullptr;
    *number->second = std::strtod(value.c_str(), &end);
    if (value.empty() || *end != '\0') {
      flags.fault = "illegal value '" + value + "' specified for double flag '" + name + "'";
      break;
    }
  }
  return flags;
}

}  // namespace ros_gz_sim
