// Addresses of models on Gazebo Fuel, which a site does not download.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ros2wasm_sim {

struct FuelModel {
  std::string owner;  ///< as written, without `%20`
  std::string name;
  std::string file;  ///< in the model; empty: the model itself
};

/// `https://fuel.gazebosim.org/1.0/OWNER/models/NAME`, with a version and a file behind it or
/// without, and the older hosts. Nothing for other addresses, or names that are not plain.
std::optional<FuelModel> fuel_model(const std::string& uri);

/// Names that the folder of a model may have where worlds are searched, the likely ones first.
std::vector<std::string> fuel_folders(const FuelModel& model);

/// Where a person can download it.
std::string fuel_archive(const FuelModel& model);

}  // namespace ros2wasm_sim
