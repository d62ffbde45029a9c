#ifndef AMENT_INDEX_CPP__HAS_RESOURCE_HPP_
#define AMENT_INDEX_CPP__HAS_RESOURCE_HPP_

#include <string>

namespace ament_index_cpp {

/// Is there such a resource? `prefix_path`, when given, gets the first prefix that has it.
bool has_resource(const std::string& resource_type, const std::string& resource_name,
                  std::string* prefix_path = nullptr);

}  // namespace ament_index_cpp

#endif  // AMENT_INDEX_CPP__HAS_RESOURCE_HPP_
