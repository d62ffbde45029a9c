// See license_list.hpp.
#include "bundler/render/license_list.hpp"

#include <map>

#include "bundler/render/spdx_expression.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

constexpr const char* kUnstated = "NOASSERTION";

std::string named(const SiteComponent& component) {
  return component.version.empty() ? component.name : component.name + " " + component.version;
}

std::string stated(const std::vector<std::string>& licenses) {
  std::string text;
  for (const std::string& license : licenses) text += (text.empty() ? "" : " and ") + license;
  return text.empty() ? "not stated" : text;
}

/// Expressions for what packages state. What SPDX has no identifier for gets one of the document.
class LicenseNames {
 public:
  std::string expression(const std::vector<std::string>& licenses) {
    std::string all;
    for (const std::string& license : licenses) {
      std::string one = spdx_expression(license).value_or("");
      if (one.empty()) {
        const auto [entry, fresh] = own_.try_emplace(license, own_.size() + 1);
        one = "LicenseRef-" + std::to_string(entry->second);
      }
      if (licenses.size() > 1 && one.find(' ') != std::string::npos) one = "(" + one + ")";
      all += (all.empty() ? "" : " AND ") + one;
    }
    return all.empty() ? kUnstated : all;
  }

  [[nodiscard]] const std::map<std::string, std::size_t>& own() const { return own_; }

 private:
  std::map<std::string, std::size_t> own_;
};

/// Letters, digits, `.` and `-`; `index` keeps names apart that become the same.
std::string element_id(std::size_t index, std::string_view name) {
  std::string id = "SPDXRef-" + std::to_string(index) + "-";
  for (const char c : name) {
    const bool fine = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    id += fine || c == '.' ? c : '-';
  }
  return id;
}

void write_package(JsonWriter& json, const std::string& id, const SiteComponent& component,
                   LicenseNames& licenses) {
  json.begin_object().field("SPDXID", id).field("name", component.name);
  if (!component.version.empty()) json.field("versionInfo", component.version);
  json.field("downloadLocation", component.address.empty() ? kUnstated : component.address.c_str())
      .field_boolean("filesAnalyzed", false)
      .field("licenseConcluded", kUnstated)
      .field("licenseDeclared", licenses.expression(component.licenses))
      .field("copyrightText", kUnstated);
  if (!component.sha256.empty()) {
    json.key("checksums").begin_array().begin_object();
    json.field("algorithm", "SHA256").field("checksumValue", component.sha256);
    json.end_object().end_array();
  }
  if (!component.purl.empty()) {
    json.key("externalRefs").begin_array().begin_object();
    json.field("referenceCategory", "PACKAGE-MANAGER").field("referenceType", "purl");
    json.field("referenceLocator", component.purl).end_object().end_array();
  }
  json.end_object();
}

void write_relationship(JsonWriter& json, std::string_view from, std::string_view type,
                        std::string_view to) {
  json.begin_object().field("spdxElementId", from).field("relationshipType", type);
  json.field("relatedSpdxElement", to).end_object();
}

}  // namespace

std::string license_list(const Manifest& manifest, const std::vector<SiteComponent>& components) {
  std::string text = "What this site is made of, and the licenses that are stated for it. " +
                     std::string("For machines: sbom.spdx.json.\n\n") + manifest.name.value +
                     (manifest.version.empty() ? "" : " " + manifest.version) + ": " +
                     (manifest.license.empty() ? "not stated" : manifest.license) + "\n\n";
  std::vector<std::pair<std::string, std::string>> texts;  // text, whose
  std::map<std::string_view, std::size_t> places;
  for (const SiteComponent& component : components) {
    text += "  " + named(component) + ": " + stated(component.licenses) + "\n";
    for (const std::string& license : component.texts) {
      const auto [place, fresh] = places.try_emplace(license, texts.size());
      if (fresh) texts.emplace_back(license, "");
      std::string& whose = texts[place->second].second;
      const std::string name = named(component);
      if (whose == name || whose.ends_with(", " + name)) continue;
      whose += (whose.empty() ? "" : ", ") + name;
    }
  }
  const std::string line(80, '=');
  for (const auto& [license, whose] : texts) {
    text += "\n" + line + "\nOf " + whose + "\n" + line + "\n\n" + license;
    if (!license.ends_with('\n')) text += '\n';
  }
  return text;
}

std::string spdx_document(const Manifest& manifest, const std::vector<SiteComponent>& components,
                          std::string_view content) {
  LicenseNames licenses;
  JsonWriter json;
  const std::string& name = manifest.name.value;
  const std::string day = manifest.citation ? manifest.citation->date_released : "1970-01-01";
  json.begin_object().field("spdxVersion", "SPDX-2.3").field("dataLicense", "CC0-1.0");
  json.field("SPDXID", "SPDXRef-DOCUMENT").field("name", name);
  json.field("documentNamespace", "urn:ros2wasm:site:" + std::string(content));
  json.key("creationInfo").begin_object().field("created", day + "T00:00:00Z");
  json.key("creators").begin_array().string("Tool: ros2wasm-" ROS2WASM_VERSION);
  json.end_array().end_object();
  SiteComponent site{.kind = ComponentKind::kWorkspace,
                     .name = name,
                     .version = manifest.version,
                     .licenses = {},
                     .sha256 = {},
                     .address = {},
                     .purl = {},
                     .texts = {}};
  if (!manifest.license.empty()) site.licenses.push_back(manifest.license);
  std::vector<std::string> ids{"SPDXRef-Site"};
  json.key("packages").begin_array();
  write_package(json, ids.front(), site, licenses);
  for (const SiteComponent& component : components) {
    ids.push_back(element_id(ids.size(), component.name));
    write_package(json, ids.back(), component, licenses);
  }
  json.end_array().key("relationships").begin_array();
  write_relationship(json, "SPDXRef-DOCUMENT", "DESCRIBES", ids.front());
  for (std::size_t i = 1; i < ids.size(); ++i) {
    // A site may contain only a part of a channel's package, compiled into programs.
    const bool whole = components[i - 1].kind != ComponentKind::kConda;
    write_relationship(json, ids.front(), whole ? "CONTAINS" : "DEPENDS_ON", ids[i]);
  }
  json.end_array();
  if (!licenses.own().empty()) {
    json.key("hasExtractedLicensingInfos").begin_array();
    for (const auto& [words, number] : licenses.own()) {
      json.begin_object().field("licenseId", "LicenseRef-" + std::to_string(number));
      json.field("name", words).field("extractedText", words).end_object();
    }
    json.end_array();
  }
  return json.end_object().text() + "\n";
}

}  // namespace ros2wasm
