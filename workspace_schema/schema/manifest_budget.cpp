// See manifest_budget.hpp.
#include "workspace_schema/schema/manifest_budget.hpp"

#include "workspace_schema/base/byte_size.hpp"

namespace ros2wasm {
namespace {

std::optional<Spanned<std::uint64_t>> read_size(Binder& binder, const YamlNode& node,
                                                const std::string& what) {
  const auto text = binder.text(
      node, what, [](const std::string& size) { return parse_byte_size(size).has_value(); },
      "a size with its unit, such as 12 MB");
  if (!text) return std::nullopt;
  if (const auto bytes = parse_byte_size(text->value))
    return Spanned<std::uint64_t>{.value = *bytes, .span = text->span};
  Diagnostic& wrong =
      binder.error("R2W0103", "`" + text->value + "` is not a size", node.range,
                   "a number and B, kB, MB, GB, KiB, MiB or GiB, such as 12 MB or 1.5 MiB");
  if (const auto meant = meant_byte_size(text->value))
    wrong.fix.push_back("write `" + what + ": " + *meant + "`");
  return std::nullopt;
}

}  // namespace

SiteBudget read_site_budget(Binder& binder, const YamlNode& node) {
  SiteBudget budget;
  if (node.kind != YamlKind::kMap) {
    budget.total = read_size(binder, node, "budget");
    return budget;
  }
  static const std::vector<KeyRow> kKeys{{"total", {"all", "size"}},
                                         {"compressed", {"gzip", "download"}}};
  if (!binder.mapping(node, "`budget`", kKeys)) return budget;
  if (const YamlNode* total = value_of(node, "total"))
    budget.total = read_size(binder, *total, "total");
  if (const YamlNode* compressed = value_of(node, "compressed"))
    budget.compressed = read_size(binder, *compressed, "compressed");
  return budget;
}

}  // namespace ros2wasm
