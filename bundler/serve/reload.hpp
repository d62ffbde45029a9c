// Tells open pages that the site was packed again: server-sent events and the script that listens
// to them. Only `serve --watch` uses it; nothing of it is ever in a packed site.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "bundler/serve/http_server.hpp"

namespace ros2wasm {

/// The state that is sent to pages.
struct SiteState {
  std::string version;   ///< changes when the site's bytes change
  std::string problems;  ///< why the last pack failed, as text for people; empty when it did not
};

/// May be used from several threads.
class ReloadHub {
 public:
  void set(SiteState state);
  [[nodiscard]] SiteState state() const;
  /// Ends all streams.
  void close();
  /// The events of one page: first the state now, then each change.
  [[nodiscard]] TextStream events() const;

 private:
  struct Shared {
    std::mutex mutex;
    std::condition_variable changed;
    SiteState state;
    unsigned generation = 1;
    bool closed = false;
  };
  std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
};

/// A state as one server-sent event.
[[nodiscard]] std::string reload_event(const SiteState& state);

/// The script's text. It expects to be loaded as `.ros2wasm/reload.js?VERSION` with the version of
/// the page that loads it, reloads when the site has another, and shows problems on the page.
[[nodiscard]] std::string_view reload_script();

/// `page` with the script's tag before `</head>` (or at its start when it has no head).
[[nodiscard]] std::string with_reload_script(std::string_view page, const std::string& version);

/// `site_json` with the hash of the page as it is served in place of the packed one's: the site's
/// service worker keeps files by these hashes, and would else show the page without the script.
[[nodiscard]] std::string with_page_hash(std::string_view site_json, std::string_view page,
                                         std::string_view served_page);

}  // namespace ros2wasm
