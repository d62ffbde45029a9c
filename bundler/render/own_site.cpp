// See own_site.hpp.
#include "bundler/render/own_site.hpp"

#include "bundler/io/files.hpp"
#include "bundler/render/site_json.hpp"
#include "workspace_schema/json_reader.hpp"

namespace ros2wasm {

bool is_site_json_of_ours(std::string_view text) {
  const auto json = parse_json(text, "site.json", "R2W0605");
  return json && json->text_of("generator").starts_with(kSiteGenerator);
}

bool is_site_of_ours(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(folder / "site.json", error)) return false;
  const auto text = read_file(folder / "site.json");
  return text && is_site_json_of_ours(*text);
}

}  // namespace ros2wasm
