// See world_files.hpp. The readers are those of the simulator, compiled for this machine.
#include "bundler/workspace/world_files.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "bundler/io/files.hpp"
#include "sdf/fuel.hpp"
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
      auto found = find(uri);
      const bool is_built_in = ros2wasm_sim::built_in_model(uri) != nullptr;
      if (!found && !is_built_in && ros2wasm_sim::fuel_model(uri)) fuel_.insert(uri);
      misses_model_ = misses_model_ || (!found && !is_built_in);
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

  /// Addresses on Gazebo Fuel in the file that was read, of models that no package has.
  const std::set<std::string>& missing_of_fuel() const { return fuel_; }

  /// Nothing when the file includes what is not in the workspace.
  std::vector<ros2wasm_sim::Note> read(const fs::path& path, const std::string& shown) {
    const auto text = resources_.read(path.string());
    if (!text) return {};
    misses_model_ = false;
    fuel_.clear();
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
  /// Where a launch file would let the simulator search: beside packages, in them, in their models.
  std::optional<std::string> find(const std::string& uri) const {
    if (const auto model = ros2wasm_sim::fuel_model(uri)) {
      for (const std::string& folder : ros2wasm_sim::fuel_folders(*model))
        if (const auto found = find("model://" + folder))
          return model->file.empty() ? *found : *found + "/" + model->file;
      return std::nullopt;
    }
    std::string name = uri;
    for (const std::string scheme : {"model://", "package://", "file://"})
      if (name.starts_with(scheme)) name.erase(0, scheme.size());
    std::vector<fs::path> places{folder_ / name};
    for (const LocalPackage& package : packages_) {
      const std::string& own = package.xml.name.value;
      if (name == own || name.starts_with(own + "/"))
        places.push_back(package.directory / name.substr(std::min(name.size(), own.size() + 1)));
      places.push_back(package.directory / name);
      places.push_back(package.directory / "models" / name);
    }
    std::error_code error;
    for (const fs::path& place : places)
      if (fs::exists(place, error)) return place.string();
    return std::nullopt;
  }

  const std::vector<LocalPackage>& packages_;
  ros2wasm_sim::Resources resources_;
  fs::path folder_;  ///< of the file that is being read
  bool misses_model_ = false;
  std::set<std::string> fuel_;
};

/// The place of the address in the file: the readers say it only for files that they judge.
SourceSpan place_of(const std::string& uri, const std::string& text, const std::string& shown) {
  const std::size_t at = text.find(uri);
  if (at == std::string::npos) return SourceSpan{.file = shown};
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  const std::size_t start = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const std::size_t column = start == std::string::npos ? at : at - start - 1;
  return SourceSpan{.file = shown,
                    .line = static_cast<std::uint32_t>(line + 1),
                    .column = static_cast<std::uint32_t>(column + 1),
                    .length = static_cast<std::uint32_t>(uri.size()),
                    .line_text = {}};
}

Diagnostic missing_of_fuel(const std::string& uri, const std::string& text,
                           const std::string& shown) {
  const ros2wasm_sim::FuelModel model = *ros2wasm_sim::fuel_model(uri);
  const std::string folder = ros2wasm_sim::fuel_folders(model).front();
  return Diagnostic{
      .code = "R2W0532",
      .severity = Severity::kWarning,
      .message = "`" + shown + "` needs the model `" + model.name + "` of Gazebo Fuel",
      .span = place_of(uri, text, shown),
      .label = "no package of the workspace has it",
      .why = {"a site asks no server for models when it runs"},
      .fix = {"curl -LO " + ros2wasm_sim::fuel_archive(model),
              "unpack it into `models/" + folder +
                  "` of your package, and install `models` in its " +
                  "CMakeLists.txt; the address may stay as it is"},
      .detail = {}};
}

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
      if (judge.missing_of_fuel().empty()) continue;
      const auto text = read_file(path, kMostOfText);
      for (const std::string& uri : judge.missing_of_fuel())
        found.push_back(missing_of_fuel(uri, text ? *text : "", shown));
    }
  }
  return found;
}

}  // namespace ros2wasm
