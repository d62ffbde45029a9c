// See runtime_assets.hpp.
#include "bundler/plan/runtime_assets.hpp"

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/json_reader.hpp"

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
  const auto text = read_file(list);
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
    auto bytes = read_file(file);
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

}  // namespace ros2wasm
