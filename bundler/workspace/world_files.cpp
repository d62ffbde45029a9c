// See world_files.hpp. The readers are those of the simulator, compiled for this machine.
#include "bundler/workspace/world_files.hpp"

#include <string>
#include <utility>

#include "bundler/io/files.hpp"
#include "bundler/workspace/fuel_needs.hpp"
#include "sdf/read_sdf.hpp"
#include "sdf/sdf_include.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

/// More than any course has; a folder of downloaded models has thousands.
constexpr std::size_t kMostFiles = 500;

class Judge {
 public:
  explicit Judge(const std::vector<LocalPackage>& packages) : packages_(packages) {
    resources_.find = [this](const std::string& uri, std::vector<std::string>&) {
      auto found = find_in_packages(uri, folder_, packages_);
      misses_model_ = misses_model_ || (!found && ros2wasm_sim::built_in_model(uri) == nullptr);
      return found;
    };
    resources_.read = [](const std::string& path) -> std::optional<std::string> {
      std::error_code error;
      if (!fs::is_regular_file(path, error)) return std::nullopt;
      auto text = read_file(path, kMostOfText);
      if (!text) return std::nullopt;
      return *std::move(text);
    };
  }

  /// Nothing when the file includes what is not in the workspace.
  std::vector<ros2wasm_sim::Note> read(const fs::path& path, const std::string& shown) {
    const auto text = resources_.read(path.string());
    if (!text) return {};
    misses_model_ = false;
    folder_ = path.parent_path();
    std::vector<ros2wasm_sim::Note> notes =
        text->find("<world") != std::string::npos
            ? ros2wasm_sim::read_world(*text, shown, resources_).notes
            : ros2wasm_sim::read_model(*text, shown, resources_).notes;
    if (misses_model_) notes.clear();
    std::erase_if(notes, [&](const ros2wasm_sim::Note& note) {
      return note.severity != ros2wasm_sim::Severity::kError || note.file != shown;
    });
    return notes;
  }

 private:
  const std::vector<LocalPackage>& packages_;
  ros2wasm_sim::Resources resources_;
  fs::path folder_;  ///< of the file that is being read
  bool misses_model_ = false;
};

Diagnostic diagnostic_of(const ros2wasm_sim::Note& note) {
  return Diagnostic{.code = "R2W0531",
                    .severity = Severity::kWarning,
                    .message = "`" + note.file + "` cannot be simulated",
                    .span = SourceSpan{.file = note.file,
                                       .line = static_cast<std::uint32_t>(note.line),
                                       .column = static_cast<std::uint32_t>(note.column),
                                       .length = 1,
                                       .line_text = {}},
                    .label = note.text,
                    .why = {},
                    .fix = {},
                    .detail = {}};
}

}  // namespace

Diagnostics check_worlds(const std::vector<LocalPackage>& packages, const fs::path& base,
                         const fs::path& shown_base) {
  Diagnostics found;
  Judge judge(packages);
  std::size_t files = 0;
  for (const LocalPackage& package : packages) {
    const auto tree = list_tree(package.directory);
    if (!tree) continue;  // discovery has read it
    for (const TreeEntry& entry : *tree) {
      const fs::path path = package.directory / entry.path;
      const std::string ending = path.extension().string();
      if ((ending != ".sdf" && ending != ".world") || ++files > kMostFiles) continue;
      const std::string shown = shown_path(path, base, shown_base);
      for (const auto& note : judge.read(path, shown)) found.push_back(diagnostic_of(note));
    }
  }
  return found;
}

}  // namespace ros2wasm
