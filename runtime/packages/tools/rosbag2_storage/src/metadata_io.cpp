// metadata.yaml of a bag's folder.
#include "rosbag2_storage/metadata_io.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "metadata_yaml.hpp"

namespace rosbag2_storage {
namespace {

namespace fs = std::filesystem;

constexpr char kRoot[] = "rosbag2_bagfile_information";

fs::path file_of(const std::string& uri) {
  return fs::path(uri) / MetadataIo::metadata_filename;
}

uint64_t size_of_files(const std::string& folder) {
  uint64_t sum = 0;
  for (const auto& one : fs::directory_iterator(folder)) {
    sum += one.is_regular_file() ? one.file_size() : 0;
  }
  return sum;
}

}  // namespace

void MetadataIo::write_metadata(const std::string& uri, const BagMetadata& metadata) {
  std::ofstream file(file_of(uri));
  file << kRoot << ":\n" << metadata_yaml(metadata, "  ");
  file.close();
  if (!file) {
    throw std::runtime_error("failed to write \"" + file_of(uri).generic_string() + "\"");
  }
}

BagMetadata MetadataIo::read_metadata(const std::string& uri) {
  try {
    std::ifstream file(file_of(uri));
    if (!file) {
      throw std::runtime_error("bad file: " + file_of(uri).generic_string());
    }
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const ros2wasm::YamlNode whole = ros2wasm::parse_yaml(text);
    for (const auto& [key, value] : whole.entries) {
      if (key == kRoot) {
        BagMetadata metadata = parse_metadata(value);
        metadata.bag_size = size_of_files(uri);
        return metadata;
      }
    }
    throw std::runtime_error(std::string("there is no '") + kRoot + "'");
  } catch (const std::runtime_error& reason) {
    throw std::runtime_error(std::string("Exception on parsing info file: ") + reason.what());
  }
}

bool MetadataIo::metadata_file_exists(const std::string& uri) {
  std::error_code none;
  return fs::exists(file_of(uri), none);
}

std::string MetadataIo::serialize_metadata(const BagMetadata& metadata) {
  std::string text = metadata_yaml(metadata, "");
  text.pop_back();
  return text;
}

BagMetadata MetadataIo::deserialize_metadata(const std::string& serialized_metadata) {
  return parse_metadata(ros2wasm::parse_yaml(serialized_metadata));
}

}  // namespace rosbag2_storage
