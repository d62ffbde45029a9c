#ifndef AMENT_INDEX_CPP__GET_PACKAGES_WITH_PREFIXES_HPP_
#define AMENT_INDEX_CPP__GET_PACKAGES_WITH_PREFIXES_HPP_

#include <map>
#include <string>

namespace ament_index_cpp {

/// Name -> prefix of all packages of the site that have files, and of those of the workspace.
std::map<std::string, std::string> get_packages_with_prefixes();

}  // namespace ament_index_cpp

#endif  // AMENT_INDEX_CPP__GET_PACKAGES_WITH_PREFIXES_HPP_
