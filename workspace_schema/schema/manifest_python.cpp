// See manifest_python.hpp.
#include "workspace_schema/schema/manifest_python.hpp"

#include <algorithm>

#include "workspace_schema/conda/wheel_name.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kForms = "a mapping with `file`, or with `url` and `sha256`";
constexpr std::string_view kHexDigits = "0123456789abcdef";
/// Which mean nothing to YAML.
constexpr std::string_view kPlainLetters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+-";
constexpr std::size_t kSha256Digits = 64;

std::string last_part(std::string_view place) {
  return std::string(place.substr(place.rfind('/') + 1));
}

bool is_sha256(const std::string& text) {
  return text.size() == kSha256Digits && text.find_first_not_of(kHexDigits) == std::string::npos;
}

std::optional<Spanned<std::string>> read_address(Binder& binder, const YamlNode& node) {
  auto url = binder.line(node, "url");
  if (!url) return std::nullopt;
  if (url->value.starts_with("https://") || url->value.starts_with("http://")) return url;
  Diagnostic& wrong = binder.error("R2W0103", "`url` of a wheel must be an address", node.range,
                                   "begins with neither `https://` nor `http://`");
  wrong.why.push_back("a wheel beside the manifest is named with `file`");
  return std::nullopt;
}

std::string read_sha256(Binder& binder, const YamlNode& node) {
  // One without letters is a number to YAML.
  const auto text = binder.written(node, "sha256");
  if (!text) return {};
  if (is_sha256(text->value)) return text->value;
  binder.error("R2W0103", "`sha256` must be 64 hexadecimal digits", node.range,
               "as `sha256sum` writes them, in lower case");
  return {};
}

void check_name(Binder& binder, const YamlNode& node, const Manifest& manifest,
                const std::string& place) {
  const std::string file = last_part(place);
  const auto name = wheel_name(file);
  if (!name) {
    Diagnostic& wrong = binder.error("R2W0119", "`" + file + "` is not the name of a wheel",
                                     node.range, "such as `parts-1.2-py3-none-any.whl`");
    wrong.why.push_back("the name says project, version, and what the wheel runs on");
    return;
  }
  if (!name->is_pure()) {
    Diagnostic& wrong =
        binder.error("R2W0119", "`" + name->project + "` is not a wheel that a site can run",
                     node.range, "made for `" + name->tags + "`");
    wrong.why.push_back(
        "Python in a browser runs wheels of Python files alone, which are made for `py3-none-any`");
    wrong.why.push_back(
        "many projects have such a wheel beside the compiled ones; compiled modules come from "
        "channels, numpy from the one inside ros2wasm");
    return;
  }
  const std::string project = normal_project_name(name->project);
  const bool twice =
      std::any_of(manifest.wheels.begin(), manifest.wheels.end(), [&](const WheelEntry& other) {
        return normal_project_name(wheel_name(last_part(other.place.value))->project) == project;
      });
  if (twice) {
    binder.error("R2W0119", "there are two wheels of `" + project + "`", node.range,
                 "another one is above");
  }
}

void read_wheel(Binder& binder, const YamlNode& node, Manifest& manifest) {
  static const std::vector<KeyRow> kKeys{
      {"file", {"path", "wheel"}}, {"url", {"address", "uri"}}, {"sha256", {"hash", "sha"}}};
  if (!binder.mapping(node, "a wheel", kKeys)) {
    Diagnostic& wrong = binder.wrong_type(node, "an item of `wheels`", kForms);
    if (node.kind == YamlKind::kScalar && node.text.ends_with(".whl") &&
        node.text.find_first_not_of(kPlainLetters) == std::string::npos)
      wrong.fix.push_back("write `{file: " + node.text + "}`");
    return;
  }
  const YamlNode* file = value_of(node, "file");
  const YamlNode* url = value_of(node, "url");
  const YamlNode* sha256 = value_of(node, "sha256");
  if (file != nullptr && url != nullptr) {
    binder.error("R2W0103", "a wheel has `file` or `url`, not both", url->range,
                 "`file` is there too");
    return;
  }
  const YamlNode* place = file != nullptr ? file : url;
  if (place == nullptr) {
    if (Diagnostic* missing = binder.missing(node, "a wheel", "file"))
      missing->why.push_back("it is " + std::string(kForms));
    return;
  }
  WheelEntry entry{.place = {}, .is_url = url != nullptr, .sha256 = {}};
  if (sha256 != nullptr) {
    entry.sha256 = read_sha256(binder, *sha256);
  } else if (entry.is_url) {
    if (Diagnostic* missing = binder.missing(node, "a wheel from an address", "sha256"))
      missing->why.push_back("whoever has the address may put something else there");
  }
  auto found = entry.is_url ? read_address(binder, *url) : binder.path(*file, "file");
  if (!found) return;
  entry.place = std::move(*found);
  check_name(binder, *place, manifest, entry.place.value);
  if (wheel_name(last_part(entry.place.value))) manifest.wheels.push_back(std::move(entry));
}

}  // namespace

void read_python(Binder& binder, const YamlNode& node, Manifest& manifest) {
  static const std::vector<KeyRow> kKeys{{"wheels", {"wheel", "packages", "requirements", "pip"}}};
  if (!binder.mapping(node, "`python`", kKeys)) {
    binder.wrong_type(node, "python", "a mapping");
    return;
  }
  if (const YamlNode* wheels = value_of(node, "wheels")) {
    binder.list(*wheels, "wheels",
                [&](const YamlNode& item) { read_wheel(binder, item, manifest); });
  }
}

}  // namespace ros2wasm
