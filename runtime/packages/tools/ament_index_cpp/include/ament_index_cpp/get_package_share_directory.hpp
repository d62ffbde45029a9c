#ifndef AMENT_INDEX_CPP__GET_PACKAGE_SHARE_DIRECTORY_HPP_
#define AMENT_INDEX_CPP__GET_PACKAGE_SHARE_DIRECTORY_HPP_

#include <string>

#include "ament_index_cpp/get_package_prefix.hpp"

namespace ament_index_cpp {

/// Throws PackageNotFoundError.
std::string get_package_share_directory(const std::string& package_name);
void get_package_share_directory(const std::string& package_name, std::filesystem::path& path);

}  // namespace ament_index_cpp

#endif  // AMENT_INDEX_CPP__GET_PACKAGE_SHARE_DIRECTORY_HPP_
