// A program that uses no client library finds the files of its package too, and keeps its own.

// Compatibility, works: programs without a client library that ask ament_index_cpp for share files

#include <fstream>
#include <iostream>
#include <string>

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "ament_index_cpp/get_resource.hpp"

int main() {
  std::ifstream gains(ament_index_cpp::get_package_share_directory("file_checks") +
                      "/config/gains.yaml");
  std::string content;
  std::getline(gains, content);
  std::ofstream("/tmp/kept.txt") << content << '\n';
  std::string kept;
  std::getline(std::ifstream("/tmp/kept.txt") >> std::ws, kept);
  std::cout << kept << std::endl;
  ament_index_cpp::get_resource("robots", "file_checks", content);
  std::cout << content << std::endl;
  try {
    ament_index_cpp::get_package_share_directory("absent_package");
  } catch (const ament_index_cpp::PackageNotFoundError&) {
    std::cout << "no such package" << std::endl;
  }
}
