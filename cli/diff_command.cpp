// `ros2wasm diff SITE SITE`: which files of two sites differ, and where.
#include <filesystem>
#include <memory>

#include "bundler/io/files.hpp"
#include "bundler/verify/site_diff.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/json_writer.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

std::string_view word_of(SiteChange change) {
  switch (change) {
    case SiteChange::kChanged:
      return "changed";
    case SiteChange::kOnlyFirst:
      return "only_first";
    case SiteChange::kOnlySecond:
      return "only_second";
  }
  return "changed";
}

std::string line_of(const SiteDifference& one) {
  switch (one.change) {
    case SiteChange::kChanged:
      return one.path + ": differs in " + one.where + " (" + one.reason + ")";
    case SiteChange::kOnlyFirst:
      return one.path + ": only in the first site (" + one.reason + ")";
    case SiteChange::kOnlySecond:
      return one.path + ": only in the second site (" + one.reason + ")";
  }
  return one.path;
}

struct OpenSite {
  std::string text;
  SiteList list;
};

Outcome<OpenSite> open_site(const fs::path& folder) {
  auto text = read_file(folder / kSiteJsonName);
  if (!text) return std::move(text).errors();
  auto list = read_site_list(*text, (folder / kSiteJsonName).string());
  if (!list) return std::move(list).errors();
  return OpenSite{.text = std::move(*text), .list = std::move(*list)};
}

/// Files of a site are read by their real path: what a site calls its own may be a link out of it,
/// or out of the store.
std::function<Outcome<std::string>(const std::string&)> reader_of(const fs::path& folder,
                                                                  const SiteList& list) {
  return [folder, &list](const std::string& path) -> Outcome<std::string> {
    std::vector<std::string> places{path};
    for (const ListedFile& file : list.files) {
      if (file.path == path) places = places_of(file, list);
    }
    std::string bytes;
    for (const std::string& place : places) {
      const fs::path root = place.starts_with("../") ? folder / list.store.objects : folder;
      const auto file = path_within(root, folder / place);
      if (!file) return cannot_read(folder / place, ENOENT);
      auto part = read_file(*file);
      if (!part) return part;
      bytes += *part;
    }
    return bytes;
  };
}

int diff(Context& context, const fs::path& first, const fs::path& second) {
  const auto a = open_site(first);
  if (!a) return context.console.fail(a.errors());
  const auto b = open_site(second);
  if (!b) return context.console.fail(b.errors());
  const auto differences = site_differences({a->list, a->text, reader_of(first, a->list)},
                                            {b->list, b->text, reader_of(second, b->list)});
  if (!differences) return context.console.fail(differences.errors());
  if (context.json) {
    JsonWriter json;
    json.begin_object().key("sha256").begin_array().string(a->list.hash).string(b->list.hash);
    json.end_array().key("differences").begin_array();
    for (const SiteDifference& one : *differences) {
      json.begin_object().field("path", one.path).field("change", word_of(one.change));
      if (!one.where.empty()) json.field("where", one.where);
      json.field("reason", one.reason).end_object();
    }
    json.end_array().end_object();
    context.console.result(json.text());
  } else if (differences->empty()) {
    context.console.result("the same site, sha256 " + a->list.hash);
  } else {
    for (const SiteDifference& one : *differences) context.console.result(line_of(one));
  }
  return differences->empty() ? 0 : 1;
}

}  // namespace

CommandBody diff_command(Arguments& arguments) {
  const auto first = std::make_shared<std::string>();
  const auto second = std::make_shared<std::string>();
  arguments.required("FIRST", *first, "folder of a site");
  arguments.required("SECOND", *second, "folder of another");
  arguments.examples({"ros2wasm diff site ../yesterday/site"});
  return [first, second](Context& context) { return diff(context, *first, *second); };
}

}  // namespace ros2wasm
