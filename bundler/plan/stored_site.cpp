// See stored_site.hpp.
#include "bundler/plan/stored_site.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "bundler/io/sha256.hpp"
#include "bundler/render/html_text.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

constexpr const char* kPage = "index.html";
/// Files that browsers request by their place in the site, and files that name others by their
/// place: the app's manifest names the start page and the icon.
constexpr std::array<std::string_view, 4> kBesideFiles{"app.webmanifest", "icon.svg", kPage,
                                                       "service_worker.js"};
/// It is asked for before site.json is read.
constexpr const char* kWorker = "node_worker.js";

constexpr std::string_view kLoadedWhole[] = {".js", ".css", ".html", ".svg", "site.json"};

void set_parts(PlannedFile& file, const std::vector<std::size_t>& sizes) {
  std::size_t at = 0;
  for (const std::size_t size : sizes) {
    file.parts.push_back(
        {.size = size, .sha256 = sha256_hex(std::string_view(file.bytes).substr(at, size))});
    at += size;
  }
}

/// The page, whose elements find the files where they lie.
std::string placed_page(std::string page, const SitePlan& plan) {
  std::map<std::string, std::vector<std::string>> places;
  for (const PlannedFile& file : plan.files) places[html_text(file.path)] = places_of(file, plan);
  std::string result;
  std::size_t done = 0;
  while (done < page.size()) {
    const std::size_t end = std::min(page.find('\n', done), page.size() - 1) + 1;
    const std::string line = page.substr(done, end - done);
    done = end;
    const std::size_t attribute = std::min(line.find("href=\""), line.find(" src=\""));
    if (attribute == std::string::npos) {
      result += line;
      continue;
    }
    const std::size_t begin = line.find('"', attribute) + 1;
    const std::size_t close = line.find('"', begin);
    const auto found = places.find(line.substr(begin, close - begin));
    if (found == places.end()) {
      result += line;
      continue;
    }
    // A file in parts is requested part by part.
    for (const std::string& place : found->second)
      result += line.substr(0, begin) + html_text(place) + line.substr(close);
  }
  const auto worker = places.find(kWorker);
  constexpr std::string_view kRoot = "<html";
  const std::size_t root = result.find(kRoot);
  if (!plan.store.objects.empty() && worker != places.end() && root != std::string::npos) {
    result.insert(root + kRoot.size(),
                  " data-worker=\"" + html_text(worker->second.front()) + "\"");
  }
  return result;
}

/// Whether hosts send a file of this name as a document, which runs scripts when somebody opens it.
/// In the store it would be out of the reach of the site's service worker, which takes its origin
/// away.
bool is_document(const std::string& path) {
  constexpr auto kEndings = std::to_array<std::string_view>(
      {".atom", ".htm", ".html", ".mathml", ".mht", ".mhtml", ".rdf", ".rss", ".shtml", ".svg",
       ".svgz", ".xht", ".xhtml", ".xml", ".xsl", ".xslt"});
  const std::string name = ascii_lower(path);
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&name](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace

void keep_in_store(SitePlan& plan) {
  if (plan.store.objects.empty()) return;
  for (PlannedFile& file : plan.files) {
    const bool beside =
        std::find(kBesideFiles.begin(), kBesideFiles.end(), file.path) != kBesideFiles.end();
    if (file.kept == Kept::kBeside && !beside && !is_document(file.path)) file.kept = Kept::kObject;
  }
}

Diagnostics split_files(SitePlan& plan, std::uint64_t most_bytes) {
  Diagnostics errors;
  if (most_bytes == 0) return errors;
  std::set<std::string> names;
  for (const PlannedFile& file : plan.files) names.insert(file.path);
  for (PlannedFile& file : plan.files) {
    if (file.bytes.size() <= most_bytes || !file.parts.empty()) continue;
    const bool is_whole =
        std::any_of(std::begin(kLoadedWhole), std::end(kLoadedWhole),
                    [&](std::string_view ending) { return file.path.ends_with(ending); });
    if (is_whole || names.contains(file.path + ".part1")) {
      errors.push_back(Diagnostic{
          .code = "R2W0617",
          .message = "`" + file.path + "` has " + std::to_string(file.bytes.size()) +
                     " bytes, more than --max-file-size",
          .why = {is_whole ? "browsers load it by themselves, so it cannot be split into parts"
                           : "the site has a file of the name that its first part would have"},
          .fix = {"ask for a higher ceiling, or for a host that has one"}});
      continue;
    }
    std::vector<std::size_t> sizes;
    for (std::size_t left = file.bytes.size(); left > 0; left -= sizes.back())
      sizes.push_back(static_cast<std::size_t>(std::min<std::uint64_t>(left, most_bytes)));
    set_parts(file, sizes);
  }
  return errors;
}

void place_page(SitePlan& plan) {
  for (PlannedFile& file : plan.files) {
    if (file.path != kPage) continue;
    file.bytes = placed_page(std::move(file.bytes), plan);
    file.sha256 = sha256_hex(file.bytes);
  }
}

void share_texts(PlannedFile& licenses) {
  const std::size_t texts = licenses.bytes.find("\n====");
  if (texts == std::string::npos) return;
  set_parts(licenses, {texts, licenses.bytes.size() - texts});
}

}  // namespace ros2wasm
