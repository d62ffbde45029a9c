// See manifest_python.hpp.
#include "workspace_schema/schema/manifest_python.hpp"

#include <algorithm>

#include "workspace_schema/conda/wheel_name.hpp"
#include "workspace_schema/conda/wheel_requirement.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kWheelForms = "a mapping with `file`, or with `url` and `sha256`";
/// Which mean nothing to YAML.
constexpr std::string_view kPlainLetters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+-";

std::string last_part(std::string_view place) {
  return std::string(place.substr(place.rfind('/') + 1));
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
  if (!name->is_pure() && !name->is_for_site_abi()) {
    Diagnostic& wrong =
        binder.error("R2W0119", "`" + name->project + "` is not a wheel that a site can run",
                     node.range, "made for `" + name->tags + "`");
    wrong.why.push_back("a site has " + std::string(kSiteAbi) +
                        ": it runs wheels made for `py3-none-any`, and compiled ones made for "
                        "`cp312-cp312-pyodide_2024_0_wasm32` or `abi3` of that platform");
    wrong.why.push_back("if Pyodide's distribution has it, `python: packages: [" +
                        normal_project_name(name->project) + "]` takes it from there");
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
    Diagnostic& wrong = binder.wrong_type(node, "an item of `wheels`", kWheelForms);
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
      missing->why.push_back("it is " + std::string(kWheelForms));
    return;
  }
  WheelEntry entry{.place = {}, .is_url = url != nullptr, .sha256 = {}};
  if (sha256 != nullptr) {
    entry.sha256 = binder.sha256(*sha256);
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

void read_package(Binder& binder, const YamlNode& node, Manifest& manifest) {
  auto package = binder.line(node, "an item of `packages`");
  if (!package) return;
  const auto wanted = wheel_requirement(package->value);
  if (wanted && !wanted->project.empty()) {
    manifest.python_packages.push_back(std::move(*package));
    return;
  }
  binder.error("R2W0103", "`" + package->value + "` is not the name of a Python library",
               node.range, "such as `scipy` or `pandas>=2`");
}

void read_index(Binder& binder, const YamlNode& node, Manifest& manifest) {
  auto index = binder.line(node, "index");
  if (!index) return;
  if (index->value.find("://") == std::string::npos) {
    if (index->value != kNoPythonIndex && !index->value.starts_with('/'))
      index = binder.path(node, "index");
    if (index) manifest.python_index = std::move(index);
    return;
  }
  if (index->value.starts_with("https://") || index->value.starts_with("http://")) {
    manifest.python_index = std::move(index);
    return;
  }
  binder.error("R2W0103", "`index` must be an address, a folder or `none`", node.range,
               "begins with neither `https://` nor `http://`");
}

}  // namespace

void read_python(Binder& binder, const YamlNode& node, Manifest& manifest) {
  static const std::vector<KeyRow> kKeys{{"wheels", {"wheel"}},
                                         {"packages", {"libraries", "requirements", "pip"}},
                                         {"index", {"url", "mirror"}},
                                         {"lock", {"lockfile"}}};
  if (!binder.mapping(node, "`python`", kKeys)) {
    binder.wrong_type(node, "python", "a mapping");
    return;
  }
  if (const YamlNode* wheels = value_of(node, "wheels")) {
    binder.list(*wheels, "wheels",
                [&](const YamlNode& item) { read_wheel(binder, item, manifest); });
  }
  if (const YamlNode* packages = value_of(node, "packages")) {
    binder.list(*packages, "packages",
                [&](const YamlNode& item) { read_package(binder, item, manifest); });
  }
  if (const YamlNode* index = value_of(node, "index")) read_index(binder, *index, manifest);
  if (const YamlNode* lock = value_of(node, "lock"))
    manifest.python_lock = binder.path(*lock, "lock");
}

}  // namespace ros2wasm
