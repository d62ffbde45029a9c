// The state of one reading: the documents, what was said about them, and how much was read.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <unordered_set>
#include <vector>

#include "sdf/reading.hpp"

namespace ros2wasm_sim {

/// A text that was parsed.
struct Source {
  std::shared_ptr<const ros2wasm_xml::XmlDocument> document;
  std::string file;       ///< as it is named to people
  std::string folder;     ///< that relative paths in it begin at; empty: none
  int minor_version = 6;  ///< 10 of SDF 1.10
};

/// An element and the text it is in. The source belongs to the context.
struct Node {
  const Source* source = nullptr;
  const ros2wasm_xml::XmlElement* element = nullptr;

  explicit operator bool() const { return element != nullptr; }
};

/// Models in models, and includes in includes.
constexpr int kMaxDepth = 32;

class Context {
 public:
  explicit Context(const Resources& resources) : resources_(resources) {}
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void error(const Node& where, const std::string& text);
  void warning(const Node& where, const std::string& text);
  /// Does nothing when a warning with this text was given before.
  void warning_once(const Node& where, const std::string& text);
  bool has_error() const { return has_error_; }
  std::vector<Note> take_notes();

  /// Counts a model, link, joint, shape and so on. False, with an error, when there are too many:
  /// includes can multiply a small text without end.
  bool spend(const Node& where);

  /// A text as XML, or null with an error. `folder` is for relative paths.
  const Source* parse(const std::string& text, const std::string& file, const std::string& folder);
  const Source* add(std::shared_ptr<const ros2wasm_xml::XmlDocument> document,
                    const std::string& file, const std::string& folder);
  /// As parse(), of a file that was found. The same file is read only once.
  const Source* open(const std::string& path, const Node& where);

  /// The file of a URI of a mesh, texture or model. Empty when it is not found; the warning then
  /// begins with `what`, and is given once for a URI.
  std::string find(const std::string& uri, const Node& where, const std::string& what);
  std::optional<std::string> find_quietly(const std::string& uri) const;
  std::optional<std::string> read(const std::string& path) const;
  std::vector<std::string> list(const std::string& folder) const;

  /// The end of a message: the nearest of some names, or nothing.
  std::string hint(const std::string& wrong,
                   const std::function<std::vector<std::string>()>& names);

  /// The files that are being read, the outermost first, to see when one includes itself.
  std::vector<std::string> open_files;

 private:
  void add_note(Note note);
  /// A file of the fetched model that `folder` is in, by `model://ANY/FILE`.
  std::optional<std::string> find_in_fetched(const std::string& uri,
                                             const std::string& folder) const;
  void add_note(Severity severity, const Node& where, const std::string& text);

  const Resources& resources_;
  std::vector<Note> notes_;
  std::size_t unsaid_ = 0;
  bool has_error_ = false;
  std::size_t spent_ = 0;
  int hints_ = 0;
  std::unordered_set<std::string> said_;
  std::vector<std::unique_ptr<Source>> sources_;
  std::map<std::string, const Source*> opened_;  ///< by path; null: it could not be read
  std::map<std::string, std::string> found_;     ///< paths by folder and URI
};

/// The folder of a path, without the last slash; empty when it has none.
std::string folder_of(const std::string& path);

}  // namespace ros2wasm_sim
