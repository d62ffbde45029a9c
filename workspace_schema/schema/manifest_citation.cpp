// See manifest_citation.hpp.
#include "workspace_schema/schema/manifest_citation.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace ros2wasm {
namespace {

/// `0000-0002-1825-0097`; the last may be X.
bool is_orcid(std::string_view text) {
  if (text.size() != 19) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool digit = text[i] >= '0' && text[i] <= '9';
    const bool good = i % 5 == 4 ? text[i] == '-' : digit || (i == 18 && text[i] == 'X');
    if (!good) return false;
  }
  return true;
}

/// A day of the calendar, `2026-11-23`.
bool is_date(std::string_view text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  const auto number = [text](std::size_t at, std::size_t count) {
    int value = 0;
    const char* end = text.data() + at + count;
    const auto [stop, fault] = std::from_chars(text.data() + at, end, value);
    return fault == std::errc() && stop == end ? value : -1;
  };
  const int year = number(0, 4);
  const int month = number(5, 2);
  const int day = number(8, 2);
  if (year < 1 || month < 1 || month > 12 || day < 1) return false;
  constexpr std::array<int, 12> kDays{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  return day <= kDays[static_cast<std::size_t>(month - 1)] + (month == 2 && leap ? 1 : 0);
}

bool is_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < '\x7f'; });
}

/// As in an address, without what would have to be escaped there.
bool is_doi(std::string_view text) {
  return text.starts_with("10.") && text.find('/') != std::string_view::npos &&
         is_printable(text) && text.find_first_of("\"<>\\^`{|}#?%") == std::string_view::npos;
}

bool is_web_address(std::string_view text) {
  return (text.starts_with("https://") || text.starts_with("http://")) && is_printable(text) &&
         text.find_first_of("\"<>\\^`{|}") == std::string_view::npos;
}

void keep(std::optional<Spanned<std::string>> found, std::string& target) {
  if (found) target = std::move(found->value);
}

void read_orcid(Binder& binder, const YamlNode& node, Author& author) {
  auto text = binder.text(node, "orcid", is_orcid, "an ORCID iD such as 0000-0002-1825-0097");
  if (!text) return;
  if (is_orcid(text->value)) {
    author.orcid = std::move(text->value);
    return;
  }
  Diagnostic& wrong = binder.error("R2W0103", "`" + text->value + "` is not an ORCID iD",
                                   node.range, "four groups of four, such as 0000-0002-1825-0097");
  const std::size_t slash = text->value.rfind('/');
  if (slash != std::string::npos && is_orcid(std::string_view(text->value).substr(slash + 1))) {
    wrong.fix.push_back("write `orcid: " + text->value.substr(slash + 1) + "`");
  }
}

void read_date(Binder& binder, const YamlNode& node, Citation& citation) {
  auto text = binder.text(node, "date_released", is_date, "a date such as 2026-11-23");
  if (!text) return;
  if (!is_date(text->value)) {
    binder.error("R2W0103", "`" + text->value + "` is not a date", node.range,
                 "year, month and day, such as 2026-11-23");
    return;
  }
  citation.date_released = std::move(text->value);
}

void read_doi(Binder& binder, const YamlNode& node, Citation& citation) {
  auto text = binder.line(node, "doi");
  if (!text) return;
  if (is_doi(text->value)) {
    citation.doi = std::move(text->value);
    return;
  }
  Diagnostic& wrong = binder.error("R2W0103", "`" + text->value + "` is not a DOI", node.range,
                                   "such as 10.5281/zenodo.1234567");
  const std::size_t begin = text->value.find("10.");
  if (begin != std::string::npos && is_doi(std::string_view(text->value).substr(begin)))
    wrong.fix.push_back("write `doi: " + text->value.substr(begin) + "`");
}

void read_repository(Binder& binder, const YamlNode& node, Citation& citation) {
  auto text = binder.line(node, "repository");
  if (!text) return;
  if (is_web_address(text->value)) {
    citation.repository = std::move(text->value);
    return;
  }
  binder.error("R2W0103", "`" + text->value + "` is not a web address", node.range,
               "it begins with https:// and has no spaces");
}

}  // namespace

std::optional<Author> read_author(Binder& binder, const YamlNode& node) {
  static const std::vector<KeyRow> kKeys{
      {"name", {}}, {"email", {"mail", "e-mail"}}, {"orcid", {}}, {"affiliation", {}}};
  Author author;
  if (node.kind == YamlKind::kScalar) {
    const auto text = binder.line(node, "an item of `authors`");
    if (!text) return std::nullopt;
    const std::size_t open = text->value.find('<');
    const std::size_t close = text->value.rfind('>');
    if (open != std::string::npos && close != std::string::npos && close > open) {
      author.email = text->value.substr(open + 1, close - open - 1);
      author.name = text->value.substr(0, text->value.find_last_not_of(" <", open) + 1);
    } else {
      author.name = text->value;
    }
    return author;
  }
  if (!binder.mapping(node, "an author", kKeys)) {
    binder.wrong_type(node, "an item of `authors`", "a name, or a mapping with `name`");
    return std::nullopt;
  }
  const YamlNode* name = value_of(node, "name");
  if (name == nullptr) binder.missing(node, "an author", "name");
  if (name != nullptr) keep(binder.line(*name, "name"), author.name);
  if (const YamlNode* email = value_of(node, "email"))
    keep(binder.line(*email, "email"), author.email);
  if (const YamlNode* place = value_of(node, "affiliation"))
    keep(binder.line(*place, "affiliation"), author.affiliation);
  if (const YamlNode* orcid = value_of(node, "orcid")) read_orcid(binder, *orcid, author);
  return author;
}

std::optional<Citation> read_citation(Binder& binder, const YamlNode& node, const YamlNode& root) {
  static const std::vector<KeyRow> kKeys{{"date_released", {"date", "date-released", "released"}},
                                         {"doi", {}},
                                         {"repository", {"repository-code", "url", "source"}},
                                         {"abstract", {"description", "summary"}},
                                         {"keywords", {"tags"}}};
  if (!binder.mapping(node, "`citation`", kKeys)) {
    binder.wrong_type(node, "citation", "a mapping with `date_released`");
    return std::nullopt;
  }
  Citation citation;
  const YamlNode* date = value_of(node, "date_released");
  if (date == nullptr) {
    if (Diagnostic* missing = binder.missing(node, "`citation`", "date_released")) {
      missing->why.push_back("a citation needs a date, and a site that can be packed again " +
                             std::string("cannot take it from the clock"));
      missing->fix.push_back("write `date_released: 2026-11-23`, with the day of your release");
    }
  } else {
    read_date(binder, *date, citation);
  }
  const YamlNode* authors = value_of(root, "authors");
  if (authors == nullptr || (authors->kind == YamlKind::kSequence && authors->items.empty())) {
    if (Diagnostic* missing = binder.missing(root, "a manifest with `citation`", "authors"))
      missing->fix.push_back("write `authors: [Your Name]`");
  }
  if (const YamlNode* doi = value_of(node, "doi")) read_doi(binder, *doi, citation);
  if (const YamlNode* place = value_of(node, "repository"))
    read_repository(binder, *place, citation);
  if (const YamlNode* text = value_of(node, "abstract"))
    keep(binder.text(*text, "abstract"), citation.abstract);
  if (const YamlNode* words = value_of(node, "keywords")) {
    for (auto& word : binder.texts(*words, "keywords", [&binder](const YamlNode& item) {
           return binder.line(item, "an item of `keywords`");
         }))
      citation.keywords.push_back(std::move(word.value));
  }
  return citation;
}

}  // namespace ros2wasm
