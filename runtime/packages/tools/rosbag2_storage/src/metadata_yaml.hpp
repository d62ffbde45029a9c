// The YAML of metadata.yaml and of what an MCAP file says of its bag: version 9 is written, all are
// read.
#pragma once

#include <string>
#include <vector>

#include "ros2wasm/yaml.hpp"
#include "rosbag2_storage/bag_metadata.hpp"

namespace rosbag2_storage {

/// Lines, each behind `indent`.
[[nodiscard]] std::string metadata_yaml(const BagMetadata& metadata, const std::string& indent);
/// Lines, each behind `indent`, with numbers for policies before version 9; "[]" for none.
[[nodiscard]] std::string profiles_yaml(const std::vector<rclcpp::QoS>& profiles,
                                        const std::string& indent, int version);

// Throw std::runtime_error for other values.
[[nodiscard]] BagMetadata parse_metadata(const ros2wasm::YamlNode& node);
[[nodiscard]] std::vector<rclcpp::QoS> parse_profiles(const ros2wasm::YamlNode& node);
[[nodiscard]] uint64_t to_whole(const ros2wasm::YamlNode& node);

}  // namespace rosbag2_storage
