// See carried_page.hpp.
#include "bundler/render/carried_page.hpp"

#include <algorithm>

#include "bundler/archive/deflate.hpp"
#include "bundler/io/base64.hpp"
#include "bundler/render/html_text.hpp"
#include "bundler/render/site_json.hpp"
#include "bundler/site/site_list.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kOpen = "\n<script type=\"application/octet-stream\" data-path=\"";
constexpr std::string_view kBetween = "\">";
constexpr std::string_view kClose = "</script>";

}  // namespace

std::string carried_page(const SitePlan& plan) {
  std::string files;
  for (const bool lists : {true, false}) {
    for (const PlannedFile& file : plan.files) {
      if ((file.path == kSiteJsonName) != lists) continue;
      files.append(kOpen).append(html_text(file.path)).append(kBetween);
      files.append(base64(deflated(file.bytes))).append(kClose);
    }
  }
  std::string page = plan.carried_page;
  page.insert(std::min(page.size(), page.rfind("</body>")), files + "\n");
  const std::string generator = std::string(kSiteGenerator) + " " ROS2WASM_VERSION;
  page.insert(kCarriedPageDoctype.size(), carried_page_mark(generator, plan.sha256));
  return page;
}

std::string carried_page_mark(const std::string& generator, const std::string& hash) {
  return std::string(kCarriedPageMark) + generator + ", sha256 " + hash + " -->\n";
}

Outcome<CarriedPage> read_carried_page(std::string_view page, const std::string& shown) {
  CarriedPage read;
  const std::size_t line_end =
      is_carried_page(page) ? page.find('\n', kCarriedPageDoctype.size()) : page.size();
  const std::size_t begin = page.find(kOpen, std::min(line_end, page.size()));
  std::size_t at = begin;
  while (at != std::string_view::npos && page.substr(at).starts_with(kOpen)) {
    const std::size_t path = at + kOpen.size();
    const std::size_t text = page.find(kBetween, path);
    const std::size_t end = text == std::string_view::npos ? text : page.find(kClose, text);
    if (end == std::string_view::npos) {
      at = end;
      break;
    }
    read.files.push_back(
        {.path = page.substr(path, text - path),
         .text = page.substr(text + kBetween.size(), end - text - kBetween.size())});
    at = end + kClose.size();
  }
  if (at == std::string_view::npos || read.files.front().path != kSiteJsonName ||
      !page.substr(at).starts_with('\n'))
    return Diagnostic{.code = "R2W0605",
                      .message = "`" + shown + "` is not a site that ros2wasm wrote",
                      .why = {"a page that carries a site has its site.json before other files"},
                      .fix = {}};
  read.mark = page.substr(kCarriedPageDoctype.size(), line_end + 1 - kCarriedPageDoctype.size());
  read.bare.append(kCarriedPageDoctype).append(page.substr(line_end + 1, begin - line_end - 1));
  read.bare.append(page.substr(at + 1));
  return read;
}

Outcome<std::string> unpacked(const CarriedFile& file, std::uint64_t limit_bytes) {
  const std::string name(file.path);
  const auto packed = base64_read(file.text);
  if (!packed)
    return Diagnostic{.code = "R2W0202",
                      .kind = FailureKind::kEnvironment,
                      .message = "`" + name + "` cannot be decompressed",
                      .why = {"it is not base64"}};
  return inflated(*packed, limit_bytes, name);
}

}  // namespace ros2wasm
