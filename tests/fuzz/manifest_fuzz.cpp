// Any text as a workspace.yaml: a manifest, or mistakes that each have a code.
#include "tests/fuzz/require.hpp"
#include "workspace_schema/schema/manifest_reader.hpp"

using namespace ros2wasm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto manifest = read_manifest(std::string(fuzz::text_of(data, size)), "workspace.yaml");
  if (manifest) return 0;
  fuzz::require(!manifest.errors().empty(), "a refusal has a reason");
  for (const Diagnostic& error : manifest.errors())
    fuzz::require(error.code.starts_with("R2W"), "a reason has a code");
  return 0;
}
