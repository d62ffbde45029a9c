// See wheel_name.hpp.
#include "workspace_schema/conda/wheel_name.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

namespace ros2wasm {
namespace {

constexpr std::string_view kEnding = ".whl";
constexpr std::string_view kPureTags = "-none-any";

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(at); end != std::string_view::npos; end = text.find(at)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

constexpr std::string_view kPython = "cp312";
/// Names of one platform: Pyodide's, and the older one by the version of Emscripten. PEP 783 names
/// platforms `pyemscripten_YEAR_PATCH_wasm32` from Pyodide 0.28 on, none for this interpreter.
constexpr auto kPlatforms =
    std::to_array<std::string_view>({"pyodide_2024_0_wasm32", "emscripten_3_1_58_wasm32"});
constexpr int kOldestStableAbi = 2;
constexpr int kMinorVersion = 12;

/// "cp39" is made for the stable ABI of Python 3.9, which later ones have too.
bool has_stable_abi(std::string_view python) {
  constexpr std::string_view kBegin = "cp3";
  if (!python.starts_with(kBegin)) return false;
  int minor = 0;
  const std::string_view digits = python.substr(kBegin.size());
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), minor);
  return error == std::errc() && end == digits.data() + digits.size() &&
         minor >= kOldestStableAbi && minor <= kMinorVersion;
}

bool is_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_part(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return is_letter_or_digit(c) || c == '_' || c == '.' || c == '+' || c == '!';
  });
}

}  // namespace

bool WheelName::is_pure() const {
  if (!tags.ends_with(kPureTags)) return false;
  const auto pythons = split(std::string_view(tags).substr(0, tags.size() - kPureTags.size()), '.');
  return std::find(pythons.begin(), pythons.end(), "py3") != pythons.end();
}

bool WheelName::is_for_site_abi() const {
  const auto parts = split(tags, '-');
  if (parts.size() != 3) return false;
  const auto platforms = split(parts[2], '.');
  const bool is_here = std::any_of(kPlatforms.begin(), kPlatforms.end(), [&](auto platform) {
    return std::find(platforms.begin(), platforms.end(), platform) != platforms.end();
  });
  if (!is_here) return false;
  const auto pythons = split(parts[0], '.');
  const auto abis = split(parts[1], '.');
  const auto fits = [](std::string_view python, std::string_view abi) {
    if (abi == "none") return python == "py3" || python == "py312" || python == kPython;
    if (abi == kPython) return python == kPython;
    return abi == "abi3" && has_stable_abi(python);
  };
  return std::any_of(pythons.begin(), pythons.end(), [&](std::string_view python) {
    return std::any_of(abis.begin(), abis.end(),
                       [&](std::string_view abi) { return fits(python, abi); });
  });
}

std::optional<WheelName> wheel_name(std::string_view file_name) {
  if (!file_name.ends_with(kEnding)) return std::nullopt;
  const auto parts = split(file_name.substr(0, file_name.size() - kEnding.size()), '-');
  if (parts.size() != 5 && parts.size() != 6) return std::nullopt;  // with a build number
  if (!std::all_of(parts.begin(), parts.end(), is_part)) return std::nullopt;
  const auto tags = parts.end() - 3;
  return WheelName{
      .project = std::string(parts[0]),
      .version = std::string(parts[1]),
      .tags = std::string(tags[0]) + "-" + std::string(tags[1]) + "-" + std::string(tags[2])};
}

std::string normal_project_name(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (is_letter_or_digit(c)) {
      result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!result.ends_with('-')) {
      result += '-';
    }
  }
  return result;
}

}  // namespace ros2wasm
