// See runtime_assets.hpp.
#include "bundler/plan/runtime_assets.hpp"

#include <algorithm>
#include <iterator>

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/site/site_component.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace {

Diagnostic damaged(const std::filesystem::path& file, const std::string& why) {
  return Diagnostic{
      .code = "R2W0604",
      .kind = FailureKind::kEnvironment,
      .message = "the runtime of this ros2wasm installation is damaged: " + file.string(),
      .why = {why}};
}

}  // namespace

Outcome<std::vector<RuntimeAsset>> read_runtime_assets(const std::filesystem::path& list) {
  const auto text = read_file(list, kMostOfList);
  if (!text) return text.errors();
  const auto json = parse_json(*text, list.string(), "R2W0604");
  if (!json) return json.errors();
  const JsonValue* assets = json->find("assets");
  if (assets == nullptr || assets->items().empty()) return damaged(list, "it lists no files");
  std::vector<RuntimeAsset> result;
  Diagnostics errors;
  for (const JsonValue& item : assets->items()) {
    RuntimeAsset asset{.file = item.text_of("file"), .role = item.text_of("role"), .bytes = {}};
    const auto file = list.parent_path() / asset.file;
    auto bytes = read_file(file, kMostOfData);
    if (!bytes) {
      errors.insert(errors.end(), bytes.errors().begin(), bytes.errors().end());
      continue;
    }
    if (sha256_hex(*bytes) != item.text_of("sha256")) {
      errors.push_back(damaged(file, "its contents are not those that runtime_assets.json names"));
      continue;
    }
    asset.bytes = std::move(bytes).value();
    result.push_back(std::move(asset));
  }
  if (!errors.empty()) return errors;
  return result;
}

Outcome<std::vector<SiteComponent>> with_runtime_components(const std::vector<RuntimeAsset>& assets,
                                                            std::vector<SiteComponent> others) {
  for (const RuntimeAsset& asset : assets) {
    if (asset.role != kComponentsRole) continue;
    const auto json = parse_json(asset.bytes, asset.file, "R2W0604");
    if (!json) return json.errors();
    std::vector<SiteComponent> components;
    for (const JsonValue& item : json->items()) {
      const std::string name = item.text_of("name");
      const std::string version = item.text_of("version");
      const std::string type = item.text_of("type");
      SiteComponent component{.kind = type == "npm" ? ComponentKind::kNpm : ComponentKind::kGeneric,
                              .name = name,
                              .version = version,
                              .licenses = {item.text_of("license")},
                              .sha256 = {},
                              .address = {},
                              .purl = "pkg:" + type + "/" +
                                      (name.starts_with('@') ? "%40" + name.substr(1) : name) +
                                      "@" + version,
                              .texts = {}};
      if (const JsonValue* texts = item.find("texts")) {
        for (const JsonValue& text : texts->items())
          if (const std::string* words = text.string()) component.texts.push_back(*words);
      }
      components.push_back(std::move(component));
    }
    if (components.empty()) break;
    std::move(others.begin(), others.end(), std::back_inserter(components));
    return components;
  }
  return damaged("runtime_assets.json", "it does not say what it is made of");
}

}  // namespace ros2wasm
