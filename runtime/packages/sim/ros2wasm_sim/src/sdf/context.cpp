// See context.hpp.
#include "sdf/context.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "sdf/fuel.hpp"
#include "sdf/nearest_name.hpp"
#include "sdf/xml_values.hpp"

namespace ros2wasm_sim {
namespace {

using ros2wasm_xml::XmlDocument;

constexpr std::size_t kMaxNotes = 200;
constexpr std::size_t kMaxThings = 300'000;
constexpr std::size_t kMaxNoteLength = 2'000;
/// Looking for the nearest name takes time for each name, so not for each of many mistakes.
constexpr int kMaxHints = 20;

/// 10 of `<sdf version="1.10">`, or the default.
int minor_version_of(const Source& source) {
  const std::string* version = source.document->root().attribute("version");
  return parse_minor_version(version ? *version : "").value_or(Source().minor_version);
}

std::string joined(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) {
    result += (result.empty() ? "" : ", ") + word;
  }
  return result;
}

/// How to get the file of `model://NAME/rest` or `package://NAME/rest`.
std::string way_to_file(const std::string& uri, const std::vector<std::string>& searched) {
  if (const auto model = fuel_model(uri)) {
    return ". A site downloads nothing from Gazebo Fuel when it runs. With `simulation: {fuel: "
           "true}` in workspace.yaml it is fetched when the site is packed; or unpack " +
           fuel_archive(*model) + " into a folder `" + fuel_folders(*model).front() +
           "` beside the other models of your package, which its CMakeLists.txt installs";
  }
  const std::size_t scheme = uri.find("://");
  const std::string kind = uri.substr(0, scheme);
  if (scheme == std::string::npos || (kind != "model" && kind != "package")) {
    return "";
  }
  const std::string rest = uri.substr(scheme + 3);
  const std::size_t slash = rest.find('/');
  const std::string package = rest.substr(0, slash);
  const std::string share = "/share/" + package;
  const bool is_package =
      std::any_of(searched.begin(), searched.end(), [&share](const std::string& folder) {
        return folder.size() >= share.size() &&
               folder.compare(folder.size() - share.size(), share.size(), share) == 0;
      });
  if (is_package && slash != std::string::npos) {
    const std::string inside = rest.substr(slash + 1);
    const std::string folder = inside.substr(0, inside.find('/'));
    return ". The package `" + package +
           "` is there without it: mind upper and lower case, and see "
           "whether its CMakeLists.txt or setup.py installs `" +
           folder + "`";
  }
  return ". The package `" + package + "` does not exist; the package with the folder `" + package +
         "` names it with <gazebo_ros gazebo_model_path=\"${prefix}/FOLDER\"/> in the <export> of "
         "its "
         "package.xml, or a launch file adds it to GAZEBO_MODEL_PATH or GZ_SIM_RESOURCE_PATH";
}

}  // namespace

void Context::add_note(Severity severity, const Node& where, const std::string& text) {
  Note note;
  note.severity = severity;
  note.text = text;
  if (where.source != nullptr) {
    note.file = where.source->file;
  }
  if (where.element != nullptr) {
    note.line = where.element->line;
    note.column = where.element->column;
  }
  add_note(std::move(note));
}

void Context::add_note(Note note) {
  const Severity severity = note.severity;
  has_error_ = has_error_ || severity == Severity::kError;
  // An error that comes late is kept, since a value is missing exactly when there is one.
  const bool is_first_error = severity == Severity::kError &&
                              std::none_of(notes_.begin(), notes_.end(), [](const Note& note) {
                                return note.severity == Severity::kError;
                              });
  if (notes_.size() >= kMaxNotes && !is_first_error) {
    ++unsaid_;
    return;
  }
  if (note.text.size() > kMaxNoteLength) {
    note.text = note.text.substr(0, kMaxNoteLength) + "...";
  }
  notes_.push_back(std::move(note));
}

void Context::error(const Node& where, const std::string& text) {
  add_note(Severity::kError, where, text);
}
void Context::warning(const Node& where, const std::string& text) {
  add_note(Severity::kWarning, where, text);
}
void Context::warning_once(const Node& where, const std::string& text) {
  if (said_.insert(text).second) {
    warning(where, text);
  }
}

std::vector<Note> Context::take_notes() {
  if (unsaid_ != 0) {
    Note note;
    note.text = "there are " + std::to_string(unsaid_) + " more messages, which are not shown";
    notes_.push_back(std::move(note));
  }
  return std::move(notes_);
}

bool Context::spend(const Node& where) {
  if (++spent_ == kMaxThings + 1) {
    error(where, "there are more than " + std::to_string(kMaxThings) +
                     " models, links, joints and shapes; includes may multiply them");
  }
  return spent_ <= kMaxThings;
}

const Source* Context::add(std::shared_ptr<const XmlDocument> document, const std::string& file,
                           const std::string& folder) {
  auto source = std::make_unique<Source>();
  source->document = std::move(document);
  source->file = file;
  source->folder = folder;
  source->minor_version = minor_version_of(*source);
  sources_.push_back(std::move(source));
  return sources_.back().get();
}

const Source* Context::parse(const std::string& text, const std::string& file,
                             const std::string& folder) {
  try {
    return add(std::make_shared<const XmlDocument>(text), file, folder);
  } catch (const ros2wasm_xml::XmlError& fault) {
    Note note;
    note.severity = Severity::kError;
    note.file = file;
    note.line = fault.line();
    note.text = "the text is not XML: " + fault.reason();
    add_note(std::move(note));
    return nullptr;
  }
}

const Source* Context::open(const std::string& path, const Node& where) {
  const auto found = opened_.find(path);
  if (found != opened_.end()) {
    return found->second;
  }
  const Source*& source = opened_[path];
  source = nullptr;
  const std::optional<std::string> text = read(path);
  if (!text) {
    error(where, path + " cannot be read");
    return nullptr;
  }
  source = parse(*text, path, folder_of(path));
  return source;
}

std::string Context::find(const std::string& uri, const Node& where, const std::string& what) {
  const std::string& folder = where.source->folder;
  const auto known = found_.find(folder + '\n' + uri);
  if (known != found_.end()) {
    return known->second;
  }
  std::string& path = found_[folder + '\n' + uri];
  if (const auto own = find_in_fetched(uri, folder)) return path = *own;
  const bool is_relative = uri.find("://") == std::string::npos && uri.substr(0, 1) != "/";
  std::vector<std::string> searched;
  std::optional<std::string> result;
  if (resources_.find && !uri.empty()) {
    if (is_relative && !folder.empty()) {
      result = find_quietly(folder + "/" + uri);
      searched.push_back(folder);
    }
    result = result ? result : resources_.find(uri, searched);
  }
  if (!result) {
    const std::string folders = searched.empty() ? "no folder was searched" : joined(searched);
    warning(where, what + " " + uri + " is not found (searched: " + folders + ")" +
                       way_to_file(uri, searched));
  }
  path = result.value_or("");
  return path;
}

std::optional<std::string> Context::find_in_fetched(const std::string& uri,
                                                    const std::string& folder) const {
  constexpr std::string_view kModel = "model://";
  const std::string model = fetched_model_of(folder);
  const std::size_t file = uri.find('/', kModel.size());
  if (model.empty() || uri.compare(0, kModel.size(), kModel) != 0 || file == std::string::npos) {
    return std::nullopt;
  }
  return find_quietly(model + uri.substr(file));
}

std::optional<std::string> Context::find_quietly(const std::string& uri) const {
  std::vector<std::string> searched;
  return resources_.find ? resources_.find(uri, searched) : std::nullopt;
}

std::optional<std::string> Context::read(const std::string& path) const {
  return resources_.read ? resources_.read(path) : std::nullopt;
}

std::vector<std::string> Context::list(const std::string& folder) const {
  return resources_.list ? resources_.list(folder) : std::vector<std::string>();
}

std::string Context::hint(const std::string& wrong,
                          const std::function<std::vector<std::string>()>& names) {
  if (++hints_ > kMaxHints) {
    return "";
  }
  const std::string nearest = nearest_name(wrong, names());
  return nearest.empty() ? "" : "; the nearest name is `" + nearest + "`";
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

}  // namespace ros2wasm_sim
