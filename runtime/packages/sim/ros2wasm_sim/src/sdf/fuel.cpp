// See fuel.hpp.
#include "sdf/fuel.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace ros2wasm_sim {
namespace {

constexpr std::size_t kMostLetters = 1000;
constexpr std::array<std::string_view, 4> kHosts{"fuel.gazebosim.org/",
                                                 "fuel.ignitionrobotics.org/", "app.gazebosim.org/",
                                                 "app.ignitionrobotics.org/"};

/// With spaces for `%20`.
std::string unescaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_space = text.substr(i, 3) == "%20";
    result += is_space ? ' ' : text[i];
    i += is_space ? 2 : 0;
  }
  return result;
}

/// The text up to the next slash, which is removed with it.
std::string next_part(std::string_view& rest) {
  const std::size_t slash = rest.find('/');
  std::string part = unescaped(rest.substr(0, slash));
  rest = slash == std::string_view::npos ? std::string_view() : rest.substr(slash + 1);
  return part;
}

/// It becomes a folder's name.
bool is_plain(const std::string& name) {
  return !name.empty() && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), [](unsigned char letter) {
           return letter >= ' ' && letter != '\\' && letter < 127;
         });
}

bool is_number(const std::string& text) {
  return !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == text.npos;
}

/// People paste the address into a shell: all that is not a letter, a digit or one of `-._~%` is
/// written by its number.
std::string escaped(const std::string& text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string result;
  for (const char letter : text) {
    const bool is_plain_letter = (letter >= 'a' && letter <= 'z') ||
                                 (letter >= 'A' && letter <= 'Z') ||
                                 (letter >= '0' && letter <= '9');
    const auto code = static_cast<unsigned char>(letter);
    if (is_plain_letter || std::string_view("-._~%").find(letter) != std::string_view::npos)
      result += letter;
    else
      result += {'%', kDigits[code / 16], kDigits[code % 16]};
  }
  return result;
}

std::string replaced(std::string text, char from, char to) {
  std::replace(text.begin(), text.end(), from, to);
  return text;
}

std::string in_small_letters(std::string text) {
  for (char& letter : text)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return text;
}

}  // namespace

std::optional<FuelModel> fuel_model(const std::string& uri) {
  if (uri.size() > kMostLetters) return std::nullopt;
  std::string_view rest = uri;
  const auto skip = [&rest](std::string_view prefix) {
    const bool is_there = rest.substr(0, prefix.size()) == prefix;
    rest.remove_prefix(is_there ? prefix.size() : 0);
    return is_there;
  };
  if (!skip("https://") && !skip("http://")) return std::nullopt;
  if (std::none_of(kHosts.begin(), kHosts.end(), skip)) return std::nullopt;
  skip("1.0/");
  FuelModel model;
  model.owner = next_part(rest);
  skip("fuel/");
  if (!skip("models/")) return std::nullopt;
  model.name = next_part(rest);
  if (!is_plain(model.owner) || !is_plain(model.name)) return std::nullopt;
  const std::string version = rest.substr(0, 6) == "files/" ? "" : next_part(rest);
  if (is_number(version)) model.version = version;  // else `tip`, the newest one
  if (!skip("files/")) return model;
  while (!rest.empty()) {
    const std::string part = next_part(rest);
    if (!is_plain(part)) return std::nullopt;
    model.file += (model.file.empty() ? "" : "/") + part;
  }
  return model;
}

std::vector<std::string> fuel_folders(const FuelModel& model) {
  const std::string joined = replaced(model.name, ' ', '_');
  std::vector<std::string> names{model.name};
  for (const std::string& name : {joined, in_small_letters(model.name), in_small_letters(joined)})
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

std::string fuel_title(const FuelModel& model) {
  return model.owner + "/" + model.name + (model.version.empty() ? "" : "/" + model.version);
}

std::string fuel_archive(const FuelModel& model) {
  const std::string name = escaped(model.name);
  return "https://fuel.gazebosim.org/1.0/" + escaped(model.owner) + "/models/" + name + "/" +
         (model.version.empty() ? "tip" : model.version) + "/" + name + ".zip";
}

std::string fetched_name(const std::string& name) {
  std::string result = in_small_letters(name);
  for (char& letter : result) {
    const bool is_letter = letter >= 'a' && letter <= 'z';
    const bool is_digit = letter >= '0' && letter <= '9';
    if (!is_letter && !is_digit && letter != '-' && letter != '.') letter = '_';
  }
  return result;
}

std::string fetched_folder(const FuelModel& model) {
  return fetched_name(model.owner) + "/" + fetched_name(model.name) + "/" +
         (model.version.empty() ? "tip" : model.version);
}

std::string fetched_model_of(const std::string& folder) {
  const std::string begin = std::string("/ros2wasm_sim/") + kFetchedModels + "/";
  std::size_t end = folder.find(begin);
  if (end == std::string::npos) return "";
  end += begin.size();
  for (int part = 0; part < 2; ++part) {
    end = folder.find('/', end);
    if (end == std::string::npos) return "";
    ++end;
  }
  return folder.substr(0, folder.find('/', end));
}

}  // namespace ros2wasm_sim
