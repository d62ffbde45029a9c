// See progress.hpp.
#include "cli/progress.hpp"

#include <algorithm>

#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/text_encoding.hpp"

namespace ros2wasm {
namespace {

constexpr std::int64_t kRedrawMs = 80;
constexpr std::size_t kBarCells = 24;

std::string count_text(const ProgressEvent& event) {
  if (event.unit == "bytes") {
    const auto kilobytes = [](std::uint64_t n) { return std::to_string((n + 999) / 1000); };
    return event.total == 0 ? kilobytes(event.done) + " kB"
                            : kilobytes(event.done) + "/" + kilobytes(event.total) + " kB";
  }
  std::string text = std::to_string(event.done);
  if (event.total > 0) text += "/" + std::to_string(event.total);
  if (!event.unit.empty()) text += " " + event.unit;
  return text;
}

/// " 3.4 MB/s" since the step began; empty when it is too early to tell.
std::string speed_text(std::uint64_t bytes, std::int64_t elapsed_ms) {
  constexpr std::int64_t kTooShortMs = 200;
  if (bytes == 0 || elapsed_ms < kTooShortMs) return {};
  const std::uint64_t tenths = bytes / 100 / static_cast<std::uint64_t>(elapsed_ms);  // of MB/s
  return " " + std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " MB/s";
}

std::string json_line(const ProgressEvent& event) {
  JsonWriter json;
  json.begin_object();
  json.field("event", "progress");
  json.field("step", event.step);
  json.field("item", event.item);
  json.key("done").unsigned_integer(event.done);
  json.key("total").unsigned_integer(event.total);
  json.field("unit", event.unit);
  if (event.warnings > 0) json.key("warnings").unsigned_integer(event.warnings);
  json.end_object();
  return json.text() + "\n";
}

}  // namespace

std::string Progress::speed(const ProgressEvent& event) {
  if (event.unit != "bytes") return {};
  const auto [begin, fresh] = begun_.try_emplace(event.step, Begin{clock_(), event.done});
  if (fresh || event.done < begin->second.done) return {};
  return speed_text(event.done - begin->second.done, clock_() - begin->second.at_ms);
}

std::string Progress::bar(const ProgressEvent& event, const std::string& speed) const {
  std::string line = event.step;
  line.resize(std::max<std::size_t>(line.size(), 8), ' ');
  if (event.total > 0) {
    const std::uint64_t done = std::min(event.done, event.total);
    const auto filled =
        static_cast<std::size_t>(static_cast<double>(done) / static_cast<double>(event.total) *
                                 static_cast<double>(kBarCells));
    line += " [" + std::string(filled, '#') + std::string(kBarCells - filled, '.') + "]";
  }
  line += " " + count_text(event) + speed;
  if (!event.item.empty()) line += "  " + valid_utf8(event.item);
  if (event.warnings > 0)
    line +=
        event.warnings == 1 ? ", 1 warning" : ", " + std::to_string(event.warnings) + " warnings";
  std::size_t width = 0;
  std::size_t end = 0;
  while (end < line.size()) {
    const Utf8Character character = decode_utf8(line, end);
    width += terminal_width(character.code_point);
    if (width >= width_) break;
    end += character.length;
  }
  line.resize(end);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return line;
}

std::string Progress::show(const ProgressEvent& event) {
  if (form_ == ProgressForm::kNone) return {};
  const bool finished = event.total > 0 && event.done >= event.total;
  if (form_ == ProgressForm::kLines) {
    const std::string fast = speed(event);
    return finished ? event.step + ": " + count_text(event) + fast + "\n" : std::string();
  }
  const std::int64_t now = clock_();
  const auto last = last_shown_ms_.find(event.step);
  const bool due = last == last_shown_ms_.end() || now - last->second >= kRedrawMs;
  if (!due && !finished) return {};
  last_shown_ms_[event.step] = now;
  if (form_ == ProgressForm::kJson) return json_line(event);
  if (finished) return wipe();
  drawn_ = true;
  return "\r\x1b[2K" + bar(event, speed(event));
}

std::string Progress::wipe() {
  if (!drawn_) return {};
  drawn_ = false;
  return "\r\x1b[2K";
}

}  // namespace ros2wasm
