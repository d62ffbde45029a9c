// Something that a site is made of, for the lists of components and licenses that it carries.
#pragma once

#include <string>
#include <vector>

namespace ros2wasm {

enum class ComponentKind { kGeneric, kNpm, kConda, kWheel, kWorkspace };

struct SiteComponent {
  ComponentKind kind = ComponentKind::kGeneric;
  std::string name;
  std::string version;
  std::vector<std::string> licenses;  ///< as stated; all of them hold
  std::string sha256;                 ///< of the archive that it came in, where that has one form
  std::string address;                ///< of that archive on the web; may be empty
  std::string purl;                   ///< package URL; may be empty
  std::vector<std::string> texts;     ///< of its license files
};

}  // namespace ros2wasm
