// Turns YAML nodes into typed values and mistakes into diagnostics. What every part of the manifest
// reader shares.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/names.hpp"
#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/base/yaml_reader.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// A key of a mapping, and what people of other tools call it.
struct KeyRow {
  std::string_view name;
  std::vector<std::string_view>
      also_called;  ///< not accepted, only understood: the error names the key
};

using NameCheck = std::optional<NameFault> (*)(std::string_view);

/// Collects diagnostics; every method that finds something wrong reports it and returns nothing.
class Binder {
 public:
  explicit Binder(const SourceText& source) : source_(source) {}

  /// Adds an error and returns it, to be completed by the caller.
  Diagnostic& error(DiagnosticCode code, std::string message, TextRange at, std::string label = {});
  Diagnostic& warning(DiagnosticCode code, std::string message, TextRange at,
                      std::string label = {});

  [[nodiscard]] SourceSpan span(TextRange at) const { return source_.span(at.offset, at.length); }
  [[nodiscard]] SourceSpan span(const YamlNode& node) const { return span(node.range); }

  /// "`what` must be <wanted>, here is <what stands there>".
  Diagnostic& wrong_type(const YamlNode& node, const std::string& what, std::string_view wanted);

  /// A text. Numbers and booleans are refused with the quoted form as fix. `what` is the key's
  /// name.
  /// The quoted form is offered only when `accepts` takes its text.
  /// `wanted` says what the text is, and `rule` which rule it follows, for the message.
  std::optional<Spanned<std::string>> text(
      const YamlNode& node, const std::string& what,
      const std::function<bool(const std::string&)>& accepts = {},
      std::string_view wanted = "a text", const std::string& rule = {});
  /// A text that is not empty and has one line.
  std::optional<Spanned<std::string>> line(const YamlNode& node, const std::string& what);
  /// A text or a number, as it is written: for versions and arguments.
  std::optional<Spanned<std::string>> written(const YamlNode& node, const std::string& what);
  std::optional<bool> boolean(const YamlNode& node, const std::string& what);
  /// One of a few words.
  std::optional<Spanned<std::string>> word(const YamlNode& node, const std::string& what,
                                           std::span<const std::string> words);
  /// A name under a rule: R2W0104 with the caret at the first wrong character.
  std::optional<Spanned<std::string>> name(const YamlNode& node, const std::string& what,
                                           NameCheck check);
  /// A relative path with forward slashes: R2W0114.
  std::optional<Spanned<std::string>> path(const YamlNode& node, const std::string& what);
  /// The sha256 of a file, in lower case; empty when it is not one, which is reported.
  std::string sha256(const YamlNode& node);
  /// R2W0104 for a text inside a scalar; `inner_offset` is where the checked text begins in the
  /// scalar's text.
  void name_error(const YamlNode& node, std::string message, std::size_t inner_offset,
                  const NameFault& fault);

  /// A list; each item goes to `each`. A single value is refused with the list form as fix.
  void list(const YamlNode& node, const std::string& what,
            const std::function<void(const YamlNode&)>& each);
  /// A list of texts made by `item`.
  std::vector<Spanned<std::string>> texts(
      const YamlNode& node, const std::string& what,
      const std::function<std::optional<Spanned<std::string>>(const YamlNode&)>& item);

  /// True for a mapping whose keys are all known; unknown keys are reported (R2W0102), and false
  /// only says that it is not a mapping at all. `where` completes "there is no key `x` in ...".
  bool mapping(const YamlNode& node, const std::string& where, std::span<const KeyRow> keys);

  /// R2W0106 for a required key, unless a misspelt key was reported that must have meant it.
  /// Returns the error to be completed, or nullptr.
  Diagnostic* missing(const YamlNode& map, const std::string& what, const std::string& key);

  [[nodiscard]] Diagnostics take_errors() { return std::move(errors_); }
  /// In the order of the text.
  [[nodiscard]] Diagnostics errors_in_order();
  [[nodiscard]] Diagnostics take_warnings() { return std::move(warnings_); }
  [[nodiscard]] bool failed() const { return !errors_.empty(); }
  void add(Diagnostics found);

 private:
  void unknown_key(const YamlNode& map, const YamlEntry& entry, const std::string& where,
                   std::span<const KeyRow> keys);

  const SourceText& source_;
  Diagnostics errors_;
  Diagnostics warnings_;
  std::set<std::pair<std::size_t, std::string>>
      meant_;  ///< start of a mapping, key that was misspelt in it
};

/// The value of a key, or nullptr. `map` may be anything; only mappings have keys.
[[nodiscard]] const YamlNode* value_of(const YamlNode& map, std::string_view key);

}  // namespace ros2wasm
