// The interfaces that a controller's configuration names.
#include "interface_names.hpp"

// POSIX's: a tenth of the size of std::regex.
#include <regex.h>

#include <algorithm>
#include <stdexcept>

namespace controller_manager {
namespace {

class Pattern {
 public:
  explicit Pattern(const std::string& text) {
    const std::string whole = "^(" + text + ")$";
    if (regcomp(&compiled_, whole.c_str(), REG_EXTENDED | REG_NOSUB) != 0) {
      throw std::runtime_error("'" + text + "' is not a valid regular expression");
    }
  }
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;
  ~Pattern() { regfree(&compiled_); }

  bool matches(const std::string& text) const {
    return regexec(&compiled_, text.c_str(), 0, nullptr, 0) == 0;
  }

 private:
  regex_t compiled_{};
};

}  // namespace

std::vector<std::string> names_of(const controller_interface::InterfaceConfiguration& configuration,
                                  const std::vector<std::string>& available) {
  using Type = controller_interface::interface_configuration_type;
  std::vector<std::string> names;
  switch (configuration.type) {
    case Type::ALL:
      return available;
    case Type::INDIVIDUAL:
      return configuration.names;
    case Type::NONE:
      return names;
    case Type::INDIVIDUAL_BEST_EFFORT:
      std::copy_if(configuration.names.begin(), configuration.names.end(),
                   std::back_inserter(names), [&available](const std::string& name) {
                     return std::binary_search(available.begin(), available.end(), name);
                   });
      return names;
    case Type::REGEX:
      for (const std::string& text : configuration.names) {
        const Pattern pattern(text);
        for (const std::string& name : available) {
          if (pattern.matches(name)) {
            names.push_back(name);
          }
        }
      }
      return names;
  }
  return names;
}

}  // namespace controller_manager
