// The libraries of Pyodide's distribution in a pack: which are asked for, before the channels are
// solved, and the files of those that programs import, once that is known.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "bundler/pack_values.hpp"
#include "bundler/workspace/channel_request.hpp"

namespace ros2wasm {

/// The libraries that a workspace can have: of Pyodide's distribution, which this program knows
/// without asking anybody, or of the manifest's own list. R2W0128, R2W0210, R2W0912.
[[nodiscard]] Outcome<PythonLibraries> offered_libraries(const std::filesystem::path& executable,
                                                         const Manifest& manifest,
                                                         const std::filesystem::path& folder);

/// False for `python: index: none`.
[[nodiscard]] bool takes_libraries(const Manifest& manifest);

/// The request to the distribution, and the packages of channels that it needs.
struct AskedLibraries {
  LibrarySupply supply;
  std::vector<RequestedSpec> specs;
};

/// `packages` lose the dependencies that the libraries bring, so that no channel is asked for them.
/// R2W0127, and those of offered_libraries().
[[nodiscard]] Outcome<AskedLibraries> ask_for_libraries(
    const std::filesystem::path& executable, const std::vector<NamedWheel>& wheels,
    const KnownNames& known, const std::vector<Spanned<std::string>>& notebook_modules,
    const ReadWorkspace& read, std::vector<LocalPackage>& packages, PackNotes& notes);

/// Compiled wheels of the manifest and asked libraries, as imports find them.
struct SiteLibraries {
  std::map<std::string, std::string> project_of;            ///< by top-level module
  std::map<std::string, std::vector<std::string>> depends;  ///< by project
};

[[nodiscard]] SiteLibraries site_libraries(const Supplies& supplies);

/// The projects that the manifest names, as library or as compiled wheel.
[[nodiscard]] std::set<std::string> named_libraries(const Manifest& manifest,
                                                    const Supplies& supplies);

/// Hides modules of channels that libraries replace: whatever the manifest asks for, and parts of a
/// library under its name when some program needs more (`reached`). True when something was hidden.
bool hide_replaced(const Manifest& manifest, const Supplies& supplies,
                   const std::set<std::string>& reached, PythonFiles& channels);

/// Puts the files of these projects, and of what they need, into `python` and their licenses into
/// `components`. Files of a folder are among those that a rebuild depends on. Errors of
/// read_libraries(); R2W0245 a compiled module needs what no library has.
[[nodiscard]] Outcome<Done> add_libraries(const BuiltWorkspace& workspace,
                                          const std::set<std::string>& reached, PythonInput& python,
                                          std::vector<SiteComponent>& components, PackNotes& notes,
                                          const Cancellation& cancellation);

}  // namespace ros2wasm
