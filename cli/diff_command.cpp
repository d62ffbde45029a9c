// `ros2wasm diff SITE SITE`: which files of two sites differ, and where.
#include <filesystem>
#include <memory>

#include "bundler/verify/open_site.hpp"
#include "bundler/verify/site_check.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/diagnostic_list.hpp"
#include "workspace_schema/json_writer.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

/// Lists are compared, so they must tell the truth: what files are not as site.json lists them.
Outcome<Done> check_files(Context& context, const fs::path& site) {
  auto check = check_site_folder(site, context.cancellation, {});
  if (!check) return std::move(check).errors();
  for (Diagnostic& fault : check->faults)
    fault.why.push_back("so `" + site.string() + "` is not the site that its site.json describes");
  if (!check->faults.empty()) return check->faults;
  return Done{};
}

int diff(Context& context, const fs::path& first, const fs::path& second) {
  const auto a = open_site(first);
  if (!a) return context.console.fail(a.errors());
  const auto b = open_site(second);
  if (!b) return context.console.fail(b.errors());
  Diagnostics faults;
  for (const fs::path& site : {first, second})
    if (auto fine = check_files(context, site); !fine) append(faults, fine.errors());
  if (!faults.empty()) return context.console.fail(faults);
  const auto differences = site_differences(compared(*a), compared(*b));
  if (!differences) return context.console.fail(differences.errors());
  if (context.json) {
    JsonWriter json;
    json.begin_object().key("sha256").begin_array().string(a->list.hash).string(b->list.hash);
    json.end_array().key("differences").begin_array();
    write_differences(json, *differences);
    json.end_array().end_object();
    context.console.result(json.text());
  } else if (differences->empty()) {
    context.console.result("the same site, sha256 " + a->list.hash);
  } else {
    for (const SiteDifference& one : *differences) context.console.result(difference_line(one));
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
