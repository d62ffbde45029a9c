#ifndef AMENT_INDEX_CPP__GET_RESOURCE_HPP_
#define AMENT_INDEX_CPP__GET_RESOURCE_HPP_

#include <string>

namespace ament_index_cpp {

/// Writes the resource's text to `content`. False: there is no such resource.
bool get_resource(const std::string& resource_type, const std::string& resource_name,
                  std::string& content, std::string* prefix_path = nullptr);

}  // namespace ament_index_cpp

#endif  // AMENT_INDEX_CPP__GET_RESOURCE_HPP_
