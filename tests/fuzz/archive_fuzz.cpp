// Any bytes as a conda archive: listed and unpacked or refused, with nothing outside of the folder.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "bundler/archive/package_listing.hpp"
#include "bundler/archive/package_reader.hpp"
#include "tests/fuzz/require.hpp"

using namespace ros2wasm;
namespace fs = std::filesystem;

namespace {

/// A folder of this process, in memory where that may be written.
const fs::path& own_folder() {
  static const fs::path folder = [] {
    const bool in_memory = ::access("/dev/shm", W_OK) == 0;
    const fs::path base = in_memory ? "/dev/shm" : fs::temp_directory_path();
    fs::path made = base / ("ros2wasm-fuzz-" + std::to_string(::getpid()));
    fs::create_directories(made);
    std::atexit([] { fs::remove_all(own_folder()); });
    return made;
  }();
  return folder;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const bool tar = data[0] == 'B';  // bzip2 begins with "BZh", zip with "PK"
  const fs::path archive = own_folder() / (tar ? "demo-1.0-0.tar.bz2" : "demo-1.0-0.conda");
  std::ofstream(archive, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  const fs::path target = own_folder() / "target";
  fs::create_directories(target);
  const ExtractLimits limits{
      .total_bytes = 1U << 20U, .members = 64, .ratio = 50, .ratio_from_bytes = 1U << 16U};
  (void)list_package(archive, limits);
  (void)unpack_package(archive, target, "demo", limits);
  fs::remove_all(target);
  fs::remove(archive);
  fuzz::require(fs::is_empty(own_folder()), "nothing is written outside of the folder");
  return 0;
}
