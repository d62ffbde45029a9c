// `ros2wasm diff SITE SITE`: which files of two sites differ, and where.
#include <array>
#include <filesystem>
#include <memory>
#include <vector>

#include "bundler/verify/open_site.hpp"
#include "bundler/verify/site_check.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

/// Lists are compared, so they must be true: which files are not as site.json lists them. The
/// result is the files that it does not list.
Outcome<std::vector<std::string>> check_files(Context& context, const fs::path& site) {
  auto check = check_site_folder(site, context.cancellation, {});
  if (!check) return std::move(check).errors();
  for (Diagnostic& fault : check->faults)
    fault.why.push_back("so `" + site.string() + "` is not the site that its site.json describes");
  if (!check->faults.empty()) return check->faults;
  return std::move(check->unlisted);
}

struct Comparison {
  std::array<std::string, 2> hashes;
  std::array<std::vector<std::string>, 2> unlisted;  ///< no difference: no part of a site
  std::vector<SiteDifference> differences;
};

Outcome<Comparison> compare(Context& context, const std::array<fs::path, 2>& folders) {
  const auto a = open_site(folders[0]);
  if (!a) return a.errors();
  const auto b = open_site(folders[1]);
  if (!b) return b.errors();
  Comparison result{.hashes = {a->list.hash, b->list.hash}, .unlisted = {}, .differences = {}};
  Diagnostics faults;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    auto unlisted = check_files(context, folders.at(i));
    if (unlisted)
      result.unlisted.at(i) = std::move(*unlisted);
    else
      append(faults, unlisted.errors());
  }
  if (!faults.empty()) return faults;
  auto differences = site_differences(compared(*a), compared(*b));
  if (!differences) return std::move(differences).errors();
  result.differences = std::move(*differences);
  return result;
}

std::string as_json(const Comparison& found) {
  JsonWriter json;
  json.begin_object().key("sha256").begin_array();
  for (const std::string& hash : found.hashes) json.string(hash);
  json.end_array().key("differences").begin_array();
  write_differences(json, found.differences);
  json.end_array().key("unlisted").begin_array();
  for (const auto& paths : found.unlisted) {
    json.begin_array();
    for (const std::string& path : paths) json.string(path);
    json.end_array();
  }
  json.end_array().end_object();
  return json.text();
}

int diff(Context& context, const std::array<fs::path, 2>& folders) {
  const auto found = compare(context, folders);
  if (!found) return context.console.fail(found.errors());
  for (std::size_t i = 0; i < folders.size(); ++i) {
    if (!found->unlisted.at(i).empty())
      context.console.report(unlisted_files(found->unlisted.at(i), folders.at(i).string()));
  }
  if (context.json) {
    context.console.result(as_json(*found));
  } else if (found->differences.empty()) {
    context.console.result("the same site, sha256 " + found->hashes[0]);
  } else {
    for (const SiteDifference& one : found->differences)
      context.console.result(difference_line(one));
  }
  return found->differences.empty() ? 0 : 1;
}

}  // namespace

CommandBody diff_command(Arguments& arguments) {
  const auto first = std::make_shared<std::string>();
  const auto second = std::make_shared<std::string>();
  arguments.required("FIRST", *first, "folder of a site");
  arguments.required("SECOND", *second, "folder of another");
  arguments.examples({"ros2wasm diff site ../yesterday/site"});
  return [first, second](Context& context) { return diff(context, {*first, *second}); };
}

}  // namespace ros2wasm
