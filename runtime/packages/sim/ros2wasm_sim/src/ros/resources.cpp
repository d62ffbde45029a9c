// See resources.hpp.
#include "ros/resources.hpp"

#include <ament_index_cpp/get_package_share_directory.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <system_error>

#include "sdf/fuel.hpp"

namespace ros2wasm_sim {
namespace {

namespace fs = std::filesystem;

/// No world, model or mesh of a course is larger.
constexpr std::uintmax_t kMostBytes = 256U << 20;

bool exists(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error);
}

std::optional<std::string> share_of(const std::string& package) {
  try {
    return ament_index_cpp::get_package_share_directory(package);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::vector<std::string> folders_of(const char* variable) {
  std::vector<std::string> folders;
  const char* value = std::getenv(variable);
  std::istringstream text(value == nullptr ? "" : value);
  for (std::string folder; std::getline(text, folder, ':');)
    if (!folder.empty()) folders.push_back(folder);
  return folders;
}

std::vector<std::string> search_path() {
  std::vector<std::string> folders;
  for (const char* variable : {"GAZEBO_MODEL_PATH", "GAZEBO_RESOURCE_PATH", "GZ_SIM_RESOURCE_PATH",
                               "IGN_GAZEBO_RESOURCE_PATH", "SDF_PATH"})
    for (std::string& folder : folders_of(variable)) folders.push_back(std::move(folder));
  return folders;
}

/// `NAME/rest`, below a folder of the path, or in the share folder of a package.
std::optional<std::string> find_below(const std::string& name, std::vector<std::string>& searched) {
  for (const std::string& folder : search_path()) {
    searched.push_back(folder);
    const std::string path = folder + "/" + name;
    if (exists(path)) return path;
  }
  const std::size_t slash = name.find('/');
  const auto share = share_of(name.substr(0, slash));
  if (!share) return std::nullopt;
  searched.push_back(*share);
  const std::string path = slash == std::string::npos ? *share : *share + name.substr(slash);
  return exists(path) ? std::optional(path) : std::nullopt;
}

std::optional<std::string> fetched_models() {
  const auto share = share_of("ros2wasm_sim");
  if (!share || !exists(*share + "/" + kFetchedModels)) return std::nullopt;
  return *share + "/" + kFetchedModels;
}

/// Sorted, so that each run takes the same one.
std::vector<std::string> list(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    files.push_back(it->path().string());
  std::sort(files.begin(), files.end());
  return files;
}

/// Folders of versions of one model: numbers, and `tip` for the newest one.
bool is_newer(const std::string& one, const std::string& other) {
  const auto is_tip = [](const std::string& folder) {
    return fs::path(folder).filename() == "tip";
  };
  if (is_tip(one) != is_tip(other)) return is_tip(one);
  return one.size() != other.size() ? one.size() > other.size() : one > other;
}

/// `file` of the newest version below `model` that has it.
std::optional<std::string> in_some_version(const std::string& model, const std::string& file) {
  std::vector<std::string> versions = list(model);
  std::sort(versions.begin(), versions.end(), is_newer);
  for (const std::string& version : versions)
    if (exists(version + file)) return version + file;
  return std::nullopt;
}

/// A model, or a file in it, that was fetched when the site was packed.
std::optional<std::string> find_fetched(const FuelModel& model) {
  const auto models = fetched_models();
  if (!models) return std::nullopt;
  const std::string file = model.file.empty() ? "" : "/" + model.file;
  const std::string exact = *models + "/" + fetched_folder(model);
  if (exists(exact + file)) return exact + file;
  return in_some_version(fs::path(exact).parent_path().string(), file);
}

/// `NAME/rest` of `model://NAME/rest`, of any owner.
std::optional<std::string> find_fetched_name(const std::string& name) {
  const auto models = fetched_models();
  if (!models) return std::nullopt;
  const std::size_t slash = name.find('/');
  const std::string file = slash == std::string::npos ? "" : name.substr(slash);
  for (const std::string& owner : list(*models))
    if (const auto found = in_some_version(owner + "/" + fetched_name(name.substr(0, slash)), file))
      return found;
  return std::nullopt;
}

/// The folder of a model of Fuel, or a file in it.
std::optional<std::string> find_fuel(const FuelModel& model, std::vector<std::string>& searched) {
  if (const auto found = find_fetched(model)) return found;
  for (const std::string& folder : fuel_folders(model))
    if (const auto found = find_below(folder, searched))
      return model.file.empty() ? *found : *found + "/" + model.file;
  return std::nullopt;
}

std::optional<std::string> find(const std::string& uri, std::vector<std::string>& searched) {
  const auto after = [&](const std::string& scheme) { return uri.substr(scheme.size()); };
  if (uri.rfind("model://", 0) == 0) {
    const auto found = find_below(after("model://"), searched);
    return found ? found : find_fetched_name(after("model://"));
  }
  if (uri.rfind("package://", 0) == 0) return find_below(after("package://"), searched);
  if (const auto model = fuel_model(uri)) return find_fuel(*model, searched);
  if (uri.rfind("http://", 0) == 0 || uri.rfind("https://", 0) == 0) return std::nullopt;
  const std::string path = uri.rfind("file://", 0) == 0 ? after("file://") : uri;
  if (path.empty()) return std::nullopt;
  if (path.front() == '/') {
    searched.push_back(fs::path(path).parent_path().string());
    return exists(path) ? std::optional(path) : std::nullopt;
  }
  return find_below(path, searched);
}

std::optional<std::string> read(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error) || fs::file_size(path, error) > kMostBytes)
    return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

Resources site_resources() {
  return {find, read, list};
}

std::string listed(const std::vector<std::string>& folders) {
  std::string result;
  std::set<std::string> known;
  for (const std::string& folder : folders)
    if (known.insert(folder).second) result += (result.empty() ? "" : ", ") + folder;
  return result.empty() ? "no folder was searched" : result;
}

std::optional<std::string> find_world(const std::string& name, std::vector<std::string>& searched) {
  std::error_code error;
  if (fs::is_regular_file(name, error)) return name;
  if (const auto found = find(name, searched)) return found;
  for (const char* folder : {"worlds/", ""})
    if (const auto found = find_below(folder + name, searched)) return found;
  const auto share = share_of("ros2wasm_sim");
  for (const char* ending : {"", ".sdf", ".world"})
    if (share && exists(*share + "/worlds/" + name + ending))
      return *share + "/worlds/" + name + ending;
  return std::nullopt;
}

}  // namespace ros2wasm_sim
