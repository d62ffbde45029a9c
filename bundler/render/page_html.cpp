// See page_html.hpp.
#include "bundler/render/page_html.hpp"

#include <algorithm>

#include "bundler/render/html_text.hpp"

namespace ros2wasm {
std::string page_html(std::string page, std::string_view title, std::string_view theme,
                      const std::vector<std::string>& programs) {
  constexpr std::string_view kOpen = "<title>";
  const std::size_t open = page.find(kOpen);
  const std::size_t close = page.find("</title>");
  if (open != std::string::npos && close != std::string::npos && open < close) {
    const std::size_t begin = open + kOpen.size();
    page.replace(begin, close - begin, html_text(title));
  }
  constexpr std::string_view kRoot = "<html";
  const std::size_t root = page.find(kRoot);
  if (root != std::string::npos && (theme == "light" || theme == "dark")) {
    page.insert(root + kRoot.size(), " data-theme=\"" + std::string(theme) + "\"");
  }
  std::string hints;
  for (const std::string& program : programs) {
    hints +=
        "<link rel=\"preload\" href=\"" + html_text(program) + "\" as=\"fetch\" crossorigin>\n";
  }
  // Before what else is fetched: scripts and style sheets hold up what stands behind them.
  const std::size_t head_end = page.find("</head>");
  if (head_end != std::string::npos) page.insert(std::min(page.find("<link"), head_end), hints);
  return page;
}

}  // namespace ros2wasm
