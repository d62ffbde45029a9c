// Any text as a version: read or refused, and the order of two versions is one.
#include "tests/fuzz/require.hpp"
#include "workspace_schema/conda/version.hpp"

using namespace ros2wasm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const std::size_t middle = text.find('\n');
  const auto a = Version::parse(text.substr(0, middle));
  if (!a) return 0;
  fuzz::require(*a == *a && a->starts_with(*a), "a version is equal to itself");
  const auto again = Version::parse(a->text());
  fuzz::require(again.ok() && *again == *a, "its own text is the same version");
  (void)version_json(a->segments());
  (void)version_json(a->local());
  if (middle == std::string_view::npos) return 0;
  const auto b = Version::parse(text.substr(middle + 1));
  if (b) fuzz::require((*a < *b) + (*b < *a) + (*a == *b) == 1, "less, equal or greater");
  return 0;
}
