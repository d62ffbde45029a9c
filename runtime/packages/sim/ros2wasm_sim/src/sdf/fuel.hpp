// Addresses of models on Gazebo Fuel. A site downloads none: they are in the workspace, or were
// fetched when it was packed.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ros2wasm_sim {

struct FuelModel {
  std::string owner;  ///< as written, without `%20`
  std::string name;
  std::string version;  ///< digits; empty: the newest one
  std::string file;     ///< in the model; empty: the model itself
};

/// `https://fuel.gazebosim.org/1.0/OWNER/models/NAME`, with a version and a file behind it or
/// without, and the older hosts. Nothing for other addresses, or names that are not plain.
std::optional<FuelModel> fuel_model(const std::string& uri);

/// `OWNER/NAME` or `OWNER/NAME/VERSION`, for people and locks.
std::string fuel_title(const FuelModel& model);

/// Names that the folder of a model may have where worlds are searched, the likely ones first.
std::vector<std::string> fuel_folders(const FuelModel& model);

/// Where its archive is: that of the model's version, else of the newest one.
std::string fuel_archive(const FuelModel& model);

/// The folder of models that were fetched when the site was packed, in the share folder of this
/// package.
constexpr const char* kFetchedModels = "fuel";

/// Where a fetched model is below kFetchedModels: `OWNER/NAME/VERSION`, in small letters, with `_`
/// for other characters, and `tip` for the newest version.
std::string fetched_folder(const FuelModel& model);

/// One part of such a path.
std::string fetched_name(const std::string& name);

/// The folder of the fetched model that `folder` belongs to; empty for others. Fuel's models name
/// their own files as `model://NAME/FILE`, whatever their name on Fuel is.
std::string fetched_model_of(const std::string& folder);

}  // namespace ros2wasm_sim
