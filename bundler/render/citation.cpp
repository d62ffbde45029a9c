// See citation.hpp.
#include "bundler/render/citation.hpp"

#include <map>

#include "bundler/render/spdx_expression.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/trimmed_text.hpp"

namespace ros2wasm {
namespace {

const std::string& title_of(const Manifest& manifest) {
  return manifest.title.empty() ? manifest.name.value : manifest.title;
}

/// As a relative address: what is not a letter, a digit or one of `-._~/` is escaped.
std::string as_address(std::string_view path) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string out;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    if (plain) {
      out += c;
    } else {
      out += '%';
      out += kHex[byte >> 4U];
      out += kHex[byte & 15U];
    }
  }
  return out;
}

void reference(JsonWriter& json, std::string_view key, std::string_view id) {
  json.key(key).begin_object().field("@id", id).end_object();
}

std::string author_id(const Author& author, std::size_t index) {
  return author.orcid.empty() ? "#author-" + std::to_string(index + 1)
                              : "https://orcid.org/" + author.orcid;
}

/// The id of the license in the graph: an address in SPDX's list, or an entity of its own.
std::string license_id(const Manifest& manifest) {
  const auto expression = spdx_expression(manifest.license);
  if (expression && is_spdx_identifier(*expression))
    return "https://spdx.org/licenses/" + *expression;
  return "#license";
}

void write_authors(JsonWriter& json, const Manifest& manifest) {
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < manifest.authors.size(); ++i) {
    const Author& author = manifest.authors[i];
    const PersonName name = person_name(author.name);
    json.begin_object().field("@id", author_id(author, i));
    json.field("@type", name.given.empty() ? "Organization" : "Person");
    json.field("name", name.given.empty() ? name.family : name.given + " " + name.family);
    if (!name.given.empty()) json.field("givenName", name.given).field("familyName", name.family);
    if (!author.email.empty()) json.field("email", author.email);
    if (!author.affiliation.empty()) {
      const auto [place, fresh] = places.try_emplace(author.affiliation, places.size() + 1);
      reference(json, "affiliation", "#organization-" + std::to_string(place->second));
    }
    json.end_object();
  }
  for (const auto& [name, number] : places) {
    json.begin_object().field("@id", "#organization-" + std::to_string(number));
    json.field("@type", "Organization").field("name", name).end_object();
  }
}

}  // namespace

PersonName person_name(const std::string& name) {
  const std::string_view whole = trimmed(name);
  if (const std::size_t comma = whole.find(','); comma != std::string_view::npos) {
    return {.family = std::string(trimmed(whole.substr(0, comma))),
            .given = std::string(trimmed(whole.substr(comma + 1)))};
  }
  const std::size_t space = whole.rfind(' ');
  if (space == std::string_view::npos) return {.family = std::string(whole), .given = {}};
  return {.family = std::string(whole.substr(space + 1)),
          .given = std::string(trimmed(whole.substr(0, space)))};
}

std::string citation_cff(const Manifest& manifest) {
  const Citation& citation = *manifest.citation;
  std::string text =
      "cff-version: 1.2.0\nmessage: If you use this site, please cite it as below.\n";
  const auto line = [&text](std::string_view key, const std::string& value) {
    if (!value.empty()) text.append(key).append(": ").append(json_quoted(value)).append("\n");
  };
  text += "type: software\n";
  line("title", title_of(manifest));
  line("version", manifest.version);
  line("date-released", citation.date_released);
  text += "authors:\n";
  for (const Author& author : manifest.authors) {
    const PersonName name = person_name(author.name);
    if (name.given.empty()) {
      line("  - name", name.family);
    } else {
      line("  - family-names", name.family);
      line("    given-names", name.given);
      line("    affiliation", author.affiliation);
    }
    line("    email", author.email);
    if (!author.orcid.empty()) line("    orcid", "https://orcid.org/" + author.orcid);
  }
  const auto expression = spdx_expression(manifest.license);
  if (expression && is_spdx_identifier(*expression)) line("license", *expression);
  line("doi", citation.doi);
  line("repository-code", citation.repository);
  line("abstract", citation.abstract);
  if (!citation.keywords.empty()) text += "keywords:\n";
  for (const std::string& word : citation.keywords) text += "  - " + json_quoted(word) + "\n";
  return text;
}

std::string ro_crate_metadata(const Manifest& manifest, const std::vector<DescribedFile>& files) {
  const Citation& citation = *manifest.citation;
  JsonWriter json;
  json.begin_object().field("@context", "https://w3id.org/ro/crate/1.1/context");
  json.key("@graph").begin_array();
  json.begin_object().field("@id", "ro-crate-metadata.json").field("@type", "CreativeWork");
  reference(json, "about", "./");
  reference(json, "conformsTo", "https://w3id.org/ro/crate/1.1");
  json.end_object();

  json.begin_object().field("@id", "./").field("@type", "Dataset");
  json.field("name", title_of(manifest));
  json.field("description",
             citation.abstract.empty()
                 ? title_of(manifest) + ": a ROS 2 workspace that runs in the browser"
                 : citation.abstract);
  json.field("datePublished", citation.date_released);
  if (!manifest.version.empty()) json.field("version", manifest.version);
  reference(json, "license", license_id(manifest));
  json.key("author").begin_array();
  for (std::size_t i = 0; i < manifest.authors.size(); ++i) {
    json.begin_object().field("@id", author_id(manifest.authors[i], i)).end_object();
  }
  json.end_array();
  if (!citation.keywords.empty()) {
    json.key("keywords").begin_array();
    for (const std::string& word : citation.keywords) json.string(word);
    json.end_array();
  }
  if (!citation.doi.empty()) json.field("identifier", "https://doi.org/" + citation.doi);
  if (!citation.repository.empty()) reference(json, "isBasedOn", citation.repository);
  reference(json, "mainEntity", "index.html");
  json.key("hasPart").begin_array();
  for (const DescribedFile& file : files)
    json.begin_object().field("@id", as_address(file.path)).end_object();
  json.end_array().end_object();

  json.begin_object().field("@id", license_id(manifest)).field("@type", "CreativeWork");
  json.field("name", manifest.license.empty() ? "No license is stated" : manifest.license);
  json.end_object();
  write_authors(json, manifest);
  if (!citation.repository.empty()) {
    json.begin_object().field("@id", citation.repository).field("@type", "SoftwareSourceCode");
    json.field("name", "Sources of " + title_of(manifest)).end_object();
  }
  for (const DescribedFile& file : files) {
    json.begin_object().field("@id", as_address(file.path)).field("@type", "File");
    json.field("name", file.path).field("description", file.reason);
    if (!file.sha256.empty())
      json.field("contentSize", std::to_string(file.size)).field("sha256", file.sha256);
    json.end_object();
  }
  return json.end_array().end_object().text() + "\n";
}

}  // namespace ros2wasm
