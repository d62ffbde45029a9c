// Collects what a site is made of: the packages of channels and workspace with their licenses. An
// edge: reads the license files that they bring.
#pragma once

#include <filesystem>
#include <vector>

#include "bundler/site/site_component.hpp"
#include "bundler/store/library_files.hpp"
#include "bundler/store/source_trees.hpp"
#include "bundler/store/store.hpp"
#include "bundler/store/wheel_files.hpp"
#include "bundler/workspace/discovery.hpp"
#include "bundler/workspace/skipped_packages.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// The texts of the files in `folder` that are licenses by the beginning of their name (`LICENSE`,
/// `COPYING`, `NOTICE`), or of all below it, with `whatever_name`; in the order of their paths. At
/// most 32 files of 256 KiB; what is more, is not text or is a link is skipped.
[[nodiscard]] std::vector<std::string> license_texts(const std::filesystem::path& folder,
                                                     bool whatever_name);

/// The files that license_texts() reads in the folder itself.
[[nodiscard]] std::vector<std::filesystem::path> license_files(const std::filesystem::path& folder);

/// The packages of channels, which are in the store, wheels, then those of the workspace that were
/// not skipped. A package without license files has those of the workspace, or of its source.
[[nodiscard]] std::vector<SiteComponent> site_components(const std::vector<PackageRecord>& records,
                                                         const Store& store,
                                                         const std::vector<NamedWheel>& wheels,
                                                         const std::vector<LocalPackage>& packages,
                                                         const LeftOutChains& left_out);

/// The component of a library of Pyodide's distribution; `index` is the address before its file,
/// with "/".
[[nodiscard]] SiteComponent library_component(const LibraryFiles& library,
                                              const std::string& index);

/// Adds the models of Gazebo Fuel among the trees.
void append_models(const std::vector<SourceTree>& trees, std::vector<SiteComponent>& components);

}  // namespace ros2wasm
