// See link_json.hpp.
#include "bundler/archive/link_json.hpp"

#include <algorithm>
#include <optional>

#include "bundler/archive/archive_library.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace {

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// Names with dots between them. Letters of other scripts are allowed in Python, so their bytes
/// are.
bool is_dotted_name(std::string_view text) {
  bool begins = true;
  for (const char c : text) {
    const bool digit = c >= '0' && c <= '9';
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
                        static_cast<unsigned char>(c) >= 0x80;
    if (c == '.' ? begins : !letter && (begins || !digit)) return false;
    begins = c == '.';
  }
  return !begins;
}

/// One file in bin/, which is neither hidden nor can be taken for an option.
bool is_command(std::string_view text) {
  const bool plain = std::all_of(text.begin(), text.end(), [](char c) {
    return c != '/' && c != '\\' && static_cast<unsigned char>(c) > 0x20 && c != 0x7F;
  });
  return plain && !text.empty() && text.front() != '.' && text.front() != '-';
}

std::optional<EntryPoint> read_entry_point(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::size_t colon = text.find(':', std::min(equals, text.size()));
  if (equals == std::string_view::npos || colon == std::string_view::npos) return std::nullopt;
  const std::string_view command = trimmed(text.substr(0, equals));
  const std::string_view module = trimmed(text.substr(equals + 1, colon - equals - 1));
  const std::string_view function = trimmed(text.substr(colon + 1));
  if (!is_command(command) || !is_dotted_name(module) || !is_dotted_name(function))
    return std::nullopt;
  return EntryPoint{.command = std::string(command),
                    .module = std::string(module),
                    .function = std::string(function)};
}

}  // namespace

Outcome<std::vector<EntryPoint>> parse_entry_points(std::string_view link_json,
                                                    const std::string& name) {
  const auto json = parse_json(link_json, "info/link.json of " + name, "R2W0221");
  if (!json) return json.errors();
  std::vector<EntryPoint> entry_points;
  const JsonValue* noarch = json->find("noarch");
  const JsonValue* list = noarch == nullptr ? nullptr : noarch->find("entry_points");
  if (list == nullptr) return entry_points;
  for (const JsonValue& item : list->items()) {
    const std::string* text = item.string();
    auto entry_point = text == nullptr ? std::nullopt : read_entry_point(*text);
    if (!entry_point) {
      return damaged_archive(name, text == nullptr
                                       ? "info/link.json has an entry point that is not text"
                                       : "info/link.json has the entry point `" + *text + "`");
    }
    entry_points.push_back(std::move(*entry_point));
  }
  return entry_points;
}

}  // namespace ros2wasm
