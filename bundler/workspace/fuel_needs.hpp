// Models of Gazebo Fuel that worlds, models and launch files name. Reads the files of packages.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bundler/workspace/discovery.hpp"
#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

/// A model that is neither in a package nor built in.
struct FuelNeed {
  std::string title;    ///< `OpenRobotics/Coke Can`, with `/2` for a version, as the lock has it
  std::string name;     ///< `Coke Can`
  std::string archive;  ///< address of its ZIP file; of the newest version if none is named
  std::string folder;   ///< where a site has it; two needs with one folder are the same model
  SourceSpan span;      ///< of the first file that names it
};

/// The models that files of the packages name, each once, in the order of the packages and their
/// files. Known are whole addresses: of elements and attributes of XML, and of texts in Python and
/// YAML. `base` and `shown_base` are those of shown_path().
[[nodiscard]] std::vector<FuelNeed> fuel_needs(const std::vector<LocalPackage>& packages,
                                               const std::filesystem::path& base,
                                               const std::filesystem::path& shown_base);

/// The models that the files of a model of Fuel name. The places are those of `asking`.
[[nodiscard]] std::vector<FuelNeed> fuel_needs_of_model(const std::filesystem::path& folder,
                                                        const FuelNeed& asking,
                                                        const std::vector<LocalPackage>& packages);

/// R2W0532: the model is not in the workspace, and the manifest does not let it be fetched.
[[nodiscard]] Diagnostic missing_fuel_model(const FuelNeed& need);

/// The folder in a site of a model with this title; empty when it is not one, as in the lock of a
/// stranger.
[[nodiscard]] std::string fuel_folder_of(const std::string& title);

/// The archive of another version of a model with this title.
[[nodiscard]] std::string fuel_archive_of(const std::string& title, const std::string& version);

/// Where a launch file would let the simulator find a file or model: beside `folder`, beside
/// packages, in them, in their models. Nothing when it is not there.
[[nodiscard]] std::optional<std::string> find_in_packages(
    const std::string& uri, const std::filesystem::path& folder,
    const std::vector<LocalPackage>& packages);

}  // namespace ros2wasm
