// See record_rules.hpp.
#include "workspace_schema/conda/record_rules.hpp"

#include <algorithm>

namespace ros2wasm {
namespace {

constexpr std::size_t kLongestField = 64;
constexpr std::size_t kLongestOldField = 255;

bool lower(char c) {
  return c >= 'a' && c <= 'z';
}
bool upper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool digit(char c) {
  return c >= '0' && c <= '9';
}

template <typename Allowed>
bool all_of(std::string_view text, Allowed allowed) {
  return std::all_of(text.begin(), text.end(), allowed);
}

std::string quoted(std::string_view what, std::string_view text) {
  return std::string(what) + " `" + std::string(text.substr(0, 80)) + "`";
}

std::optional<std::string> name_fault(std::string_view name, Strictness strictness) {
  const bool writing = strictness == Strictness::kWriting;
  if (name.empty()) return "it has no name";
  if (name.size() > (writing ? kLongestField : kLongestOldField))
    return quoted("the name", name) + " is too long";
  const bool begins_well =
      lower(name[0]) || digit(name[0]) || name[0] == '_' || (!writing && upper(name[0]));
  const bool fits = all_of(name, [writing](char c) {
    return lower(c) || digit(c) || c == '-' || c == '_' || c == '.' ||
           (!writing && (upper(c) || c == '+'));
  });
  if (!begins_well || !fits) {
    return quoted("the name", name) + " may have lower-case letters, digits, `-`, `_` and `.` only";
  }
  return std::nullopt;
}

std::optional<std::string> version_fault(std::string_view version, Strictness strictness) {
  if (version.empty()) return "it has no version";
  if (version.size() > (strictness == Strictness::kWriting ? kLongestField : kLongestOldField)) {
    return quoted("the version", version) + " is too long";
  }
  const bool fits = all_of(version, [strictness](char c) {
    return lower(c) || upper(c) || digit(c) || c == '.' || c == '_' || c == '!' || c == '+' ||
           (strictness == Strictness::kReading && c == '-');
  });
  if (!fits || version[0] == '.') {
    return quoted("the version", version) + " may have letters, digits, `.`, `_`, `!` and `+` only";
  }
  return std::nullopt;
}

std::optional<std::string> build_fault(std::string_view build, Strictness strictness) {
  const bool writing = strictness == Strictness::kWriting;
  if (build.empty())
    return writing ? std::optional<std::string>("it has no build string") : std::nullopt;
  if (build.size() > (writing ? kLongestField : kLongestOldField)) {
    return quoted("the build string", build) + " is too long";
  }
  const bool fits = all_of(build, [writing](char c) {
    return lower(c) || upper(c) || digit(c) || c == '_' || c == '.' || c == '+' ||
           (!writing && c == '-');
  });
  if (!fits)
    return quoted("the build string", build) + " may have letters, digits, `_`, `.` and `+` only";
  return std::nullopt;
}

}  // namespace

bool is_subdir(std::string_view text) {
  if (text == "noarch") return true;
  const std::size_t dash = text.find('-');
  if (text.size() > 32 || dash == std::string_view::npos || dash == 0 || dash + 1 == text.size())
    return false;
  const auto word = [](char c) { return lower(c) || digit(c); };
  return all_of(text.substr(0, dash), word) && all_of(text.substr(dash + 1), word);
}

std::string_view archive_stem(std::string_view file_name) {
  for (const std::string_view ending : {std::string_view(".conda"), std::string_view(".tar.bz2")}) {
    if (file_name.size() > ending.size() && file_name.ends_with(ending)) {
      return file_name.substr(0, file_name.size() - ending.size());
    }
  }
  return {};
}

std::optional<std::string> record_fault(const PackageRecord& record, Strictness strictness) {
  if (auto fault = name_fault(record.name, strictness)) return fault;
  if (auto fault = version_fault(record.version, strictness)) return fault;
  if (auto fault = build_fault(record.build, strictness)) return fault;
  if (!is_subdir(record.subdir))
    return quoted("the subdirectory", record.subdir) + " is none of conda's";
  const bool harmless = all_of(record.file_name, [](char c) {
    return lower(c) || upper(c) || digit(c) || c == '.' || c == '_' || c == '-' || c == '+' ||
           c == '!' || c == '~';
  });
  if (archive_stem(record.file_name).empty() || !harmless || record.file_name[0] == '.') {
    return quoted("the file name", record.file_name) + " is not an archive's";
  }
  return std::nullopt;
}

}  // namespace ros2wasm
