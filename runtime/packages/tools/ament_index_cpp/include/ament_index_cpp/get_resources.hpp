#ifndef AMENT_INDEX_CPP__GET_RESOURCES_HPP_
#define AMENT_INDEX_CPP__GET_RESOURCES_HPP_

#include <map>
#include <string>

namespace ament_index_cpp {

/// Name -> prefix of all resources of a type.
std::map<std::string, std::string> get_resources(const std::string& resource_type);

}  // namespace ament_index_cpp

#endif  // AMENT_INDEX_CPP__GET_RESOURCES_HPP_
