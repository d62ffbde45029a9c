// See fuel_needs.hpp.
#include "bundler/workspace/fuel_needs.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "bundler/io/files.hpp"
#include "sdf/fuel.hpp"
#include "sdf/sdf_include.hpp"
#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/base/trimmed_text.hpp"
#include "workspace_schema/base/xml_reader.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;
using ros2wasm_sim::FuelModel;

/// More than any course has; a folder of downloaded models has thousands.
constexpr std::size_t kMostFilesOfNeeds = 2000;
constexpr std::string_view kQuotes = "\"'";

constexpr std::array<std::string_view, 7> kXmlEndings{".sdf",   ".world",  ".model", ".urdf",
                                                      ".xacro", ".launch", ".xml"};
constexpr std::array<std::string_view, 3> kTextEndings{".py", ".yaml", ".yml"};

/// Most files name none, and need not be parsed.
bool names_a_host(std::string_view text) {
  return text.find("gazebosim.org/") != std::string_view::npos ||
         text.find("ignitionrobotics.org/") != std::string_view::npos;
}

template <typename Endings>
bool is_one_of(const Endings& endings, std::string_view ending) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// Addresses that are put together when the file is used (`${model}`, `{model}`) are not known.
std::optional<FuelModel> known_model(std::string_view text) {
  if (text.find('{') != std::string_view::npos || text.find('$') != std::string_view::npos)
    return std::nullopt;
  return ros2wasm_sim::fuel_model(std::string(text));
}

FuelNeed fuel_need(FuelModel model, SourceSpan span) {
  model.file.clear();
  return {.title = ros2wasm_sim::fuel_title(model),
          .name = model.name,
          .archive = ros2wasm_sim::fuel_archive(model),
          .folder = ros2wasm_sim::fetched_folder(model),
          .span = std::move(span)};
}

class Finder {
 public:
  explicit Finder(const std::vector<LocalPackage>& packages) : packages_(packages) {}

  /// `shown`: as messages name the file.
  void read(const fs::path& file, const std::string& shown) {
    const std::string ending = file.extension().string();
    const bool is_xml = is_one_of(kXmlEndings, ending) && file.filename() != "package.xml";
    if (!is_xml && !is_one_of(kTextEndings, ending)) return;
    if (++files_ > kMostFilesOfNeeds) return;
    auto text = read_file(file, kMostOfText);
    if (!text || !names_a_host(*text)) return;
    file_ = file;
    shown_ = shown;
    text_ = *std::move(text);
    if (!is_xml) return read_lines();
    const auto root = parse_xml(text_, shown);  // what is wrong is reported by others
    if (root) read_element(*root);
  }

  std::vector<FuelNeed> take() { return std::move(needs_); }

 private:
  void read_element(const XmlElement& element) {
    add(trimmed(element.text));
    for (const auto& [name, value] : element.attributes)
      if (!add(trimmed(value))) read_line(value);
    for (const XmlElement& child : element.children) read_element(child);
  }

  /// A text that is an address, or has some among other words, such as arguments of a program.
  void value_or_words(std::string_view value) {
    if (add(trimmed(value))) return;
    while (!value.empty()) {
      const std::size_t end = std::min(value.find_first_of(" \t"), value.size());
      add(value.substr(0, end));
      value.remove_prefix(std::min(end + 1, value.size()));
    }
  }

  void read_lines() {
    std::string_view rest = text_;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      read_line(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }

  /// Texts in quotes, and words outside of them up to a comment.
  void read_line(std::string_view line) {
    while (!line.empty()) {
      const std::size_t quote = std::min(line.find_first_of(kQuotes), line.size());
      const std::string_view plain = line.substr(0, quote);
      const std::size_t comment = plain.find('#');
      value_or_words(plain.substr(0, comment));
      if (comment != std::string_view::npos || quote == line.size()) return;
      const std::size_t end = std::min(line.find(line[quote], quote + 1), line.size());
      value_or_words(line.substr(quote + 1, end - quote - 1));
      line.remove_prefix(std::min(end + 1, line.size()));
    }
  }

  /// True when it is an address on Fuel.
  bool add(std::string_view address) {
    const auto model = known_model(address);
    if (!model) return false;
    const std::string uri(address);
    if (ros2wasm_sim::built_in_model(uri) != nullptr ||
        find_in_packages(uri, file_.parent_path(), packages_))
      return true;
    FuelNeed need = fuel_need(*model, place_of(uri));
    if (known_.insert(need.folder).second) needs_.push_back(std::move(need));
    return true;
  }

  [[nodiscard]] SourceSpan place_of(const std::string& uri) const {
    const std::size_t at = text_.find(uri);
    if (at == std::string::npos) return SourceSpan{.file = shown_, .line_text = {}};
    const auto begin = text_.begin();
    const auto line = std::count(begin, begin + static_cast<std::ptrdiff_t>(at), '\n');
    const std::size_t start = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
    const std::size_t column = start == std::string::npos ? at : at - start - 1;
    return SourceSpan{.file = shown_,
                      .line = static_cast<std::uint32_t>(line + 1),
                      .column = static_cast<std::uint32_t>(column + 1),
                      .length = static_cast<std::uint32_t>(uri.size()),
                      .line_text = {}};
  }

  const std::vector<LocalPackage>& packages_;
  std::size_t files_ = 0;
  fs::path file_;
  std::string shown_;
  std::string text_;
  std::set<std::string> known_;
  std::vector<FuelNeed> needs_;
};

}  // namespace

std::vector<FuelNeed> fuel_needs(const std::vector<LocalPackage>& packages, const fs::path& base,
                                 const fs::path& shown_base) {
  Finder finder(packages);
  for (const LocalPackage& package : packages) {
    const auto tree = list_tree(package.directory);
    if (!tree) continue;  // discovery has read it
    for (const TreeEntry& entry : *tree) {
      const fs::path file = package.directory / entry.path;
      if (entry.kind == FileKind::kFile) finder.read(file, shown_path(file, base, shown_base));
    }
  }
  return finder.take();
}

std::vector<FuelNeed> fuel_needs_of_model(const fs::path& folder, const FuelNeed& asking,
                                          const std::vector<LocalPackage>& packages) {
  Finder finder(packages);
  if (const auto tree = list_tree(folder)) {
    for (const TreeEntry& entry : *tree)
      if (entry.kind == FileKind::kFile) finder.read(folder / entry.path, entry.path);
  }
  std::vector<FuelNeed> needs = finder.take();
  for (FuelNeed& need : needs) need.span = asking.span;
  return needs;
}

Diagnostic missing_fuel_model(const FuelNeed& need) {
  const FuelModel model{.owner = {}, .name = need.name, .version = {}, .file = {}};
  const std::string folder = ros2wasm_sim::fuel_folders(model).front();
  return Diagnostic{
      .code = "R2W0532",
      .severity = Severity::kWarning,
      .message = "`" + need.span.file + "` needs the model `" + need.name + "` of Gazebo Fuel",
      .span = need.span,
      .label = "no package of the workspace has it",
      .why = {"a site asks no server for models when it runs"},
      .fix = {"simulation: {fuel: true}",
              "or unpack " + need.archive + " into `models/" + folder +
                  "` of your package, and install `models` in its CMakeLists.txt"},
      .detail = {}};
}

std::string fuel_folder_of(const std::string& title) {
  const auto model = ros2wasm_sim::fuel_model(fuel_archive_of(title, {}));
  return model ? ros2wasm_sim::fetched_folder(*model) : std::string();
}

std::string fuel_archive_of(const std::string& title, const std::string& version) {
  const std::size_t name = title.find('/');
  if (name == std::string::npos) return {};
  const std::size_t end = std::min(title.find('/', name + 1), title.size());
  FuelModel model{.owner = title.substr(0, name),
                  .name = title.substr(name + 1, end - name - 1),
                  .version = end < title.size() ? title.substr(end + 1) : version,
                  .file = {}};
  return ros2wasm_sim::fuel_archive(model);
}

std::optional<std::string> find_in_packages(const std::string& uri, const fs::path& folder,
                                            const std::vector<LocalPackage>& packages) {
  if (const auto model = ros2wasm_sim::fuel_model(uri)) {
    for (const std::string& name : ros2wasm_sim::fuel_folders(*model)) {
      if (const auto found = find_in_packages("model://" + name, folder, packages))
        return model->file.empty() ? *found : *found + "/" + model->file;
    }
    return std::nullopt;
  }
  std::string name = uri;
  for (const std::string scheme : {"model://", "package://", "file://"})
    if (name.starts_with(scheme)) name.erase(0, scheme.size());
  std::vector<fs::path> places{folder / name};
  for (const LocalPackage& package : packages) {
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

}  // namespace ros2wasm
