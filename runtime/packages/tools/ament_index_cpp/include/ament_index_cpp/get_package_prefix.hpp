#ifndef AMENT_INDEX_CPP__GET_PACKAGE_PREFIX_HPP_
#define AMENT_INDEX_CPP__GET_PACKAGE_PREFIX_HPP_

#include <filesystem>
#include <stdexcept>
#include <string>

namespace ament_index_cpp {

/// Nobody has the package.
class PackageNotFoundError : public std::out_of_range {
 public:
  explicit PackageNotFoundError(const std::string& package_name);
  PackageNotFoundError(const PackageNotFoundError& other) = default;
  ~PackageNotFoundError() override;

  const std::string package_name;
};

/// Throws PackageNotFoundError.
std::string get_package_prefix(const std::string& package_name);
void get_package_prefix(const std::string& package_name, std::filesystem::path& path);

}  // namespace ament_index_cpp

#endif  // AMENT_INDEX_CPP__GET_PACKAGE_PREFIX_HPP_
