// Any text as a lock: refused, or written back in a form that reads as the same lock, with packages
// that stay in their folders.
#include "tests/fuzz/require.hpp"
#include "workspace_schema/schema/lock.hpp"

using namespace ros2wasm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto lock = read_lock(fuzz::text_of(data, size), "ros2wasm.lock");
  if (!lock) return 0;
  for (const PackageRecord& record : lock->packages) {
    for (const std::string* part : {&record.subdir, &record.file_name}) {
      const bool inside = part->find('/') == std::string::npos && !part->starts_with('.');
      fuzz::require(inside, "no package leads out of a channel's folder");
    }
  }
  const std::string text = write_lock(*lock);
  const auto again = read_lock(text, "ros2wasm.lock");
  fuzz::require(again.ok(), "what is written can be read");
  fuzz::require(write_lock(*again) == text, "and is written the same");
  return 0;
}
