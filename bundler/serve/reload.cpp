// See reload.hpp.
#include "bundler/serve/reload.hpp"

#include <chrono>

#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

/// How long a stream waits before it looks whether the page is still there.
constexpr std::chrono::milliseconds kLookAround{500};

constexpr std::string_view kScript =
    R"js(// Reloads the page when `ros2wasm serve --watch` has packed the site again.
const shown = new URL(import.meta.url).search.slice(1);
const note = document.createElement('pre');
note.setAttribute('role', 'alert');
note.dataset.ros2wasm = 'pack-problems';
Object.assign(note.style, {
  position: 'fixed', inset: 'auto 0 0 0', maxHeight: '50vh', margin: '0', padding: '12px',
  overflow: 'auto', font: '13px/1.4 monospace', whiteSpace: 'pre-wrap', zIndex: '2147483647',
  color: '#fff', background: '#7a1220', borderTop: '2px solid #ff6b81',
});

const events = new EventSource(new URL('events', import.meta.url));
events.onmessage = (event) => {
  const state = JSON.parse(event.data);
  if (state.version !== shown) {
    events.close();
    location.reload();
  } else if (state.problems !== '') {
    note.textContent = `The last good site is shown; packing again failed:\n\n${state.problems}`;
    document.body.append(note);
  } else {
    note.remove();
  }
};
)js";

}  // namespace

void ReloadHub::set(SiteState state) {
  {
    const std::scoped_lock lock(shared_->mutex);
    shared_->state = std::move(state);
    ++shared_->generation;
  }
  shared_->changed.notify_all();
}

SiteState ReloadHub::state() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->state;
}

void ReloadHub::close() {
  {
    const std::scoped_lock lock(shared_->mutex);
    shared_->closed = true;
  }
  shared_->changed.notify_all();
}

TextStream ReloadHub::events() const {
  return [shared = shared_, seen = 0U]() mutable -> std::optional<std::string> {
    std::unique_lock lock(shared->mutex);
    shared->changed.wait_for(lock, kLookAround,
                             [&] { return shared->closed || shared->generation != seen; });
    if (shared->closed) return std::nullopt;
    if (shared->generation == seen) return ":\n";  // a comment: is the page still there?
    seen = shared->generation;
    return reload_event(shared->state);
  };
}

std::string reload_event(const SiteState& state) {
  JsonWriter json;
  json.begin_object().field("version", state.version).field("problems", state.problems);
  json.end_object();
  return "data: " + json.text() + "\n\n";
}

std::string_view reload_script() {
  return kScript;
}

std::string with_reload_script(std::string_view page, const std::string& version) {
  const std::string tag =
      "<script type=\"module\" src=\".ros2wasm/reload.js?" + version + "\"></script>";
  std::string text(page);
  const std::size_t head_end = text.find("</head>");
  text.insert(head_end == std::string::npos ? 0 : head_end, tag);
  return text;
}

std::string with_page_hash(std::string_view site_json, std::string_view page,
                           std::string_view served_page) {
  std::string text(site_json);
  const std::string packed_hash = sha256_hex(page);
  const std::size_t at = text.find(packed_hash);
  if (at != std::string::npos) text.replace(at, packed_hash.size(), sha256_hex(served_page));
  return text;
}

}  // namespace ros2wasm
