// See split_programs.hpp.
#include "bundler/build/split_programs.hpp"

#include "bundler/archive/wasm_module.hpp"
#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;

Outcome<Done> split_programs(const fs::path& prefix, const std::string& package) {
  std::error_code error;
  for (fs::directory_iterator it(prefix / "lib" / package, error), end; !error && it != end;
       it.increment(error)) {
    if (it->path().extension() != ".wasm") continue;
    const auto bytes = read_file(it->path(), kMostOfData);
    if (!bytes) return bytes.errors();
    const auto split = split_names(*bytes);
    if (!split) continue;
    if (auto done = write_file(it->path(), split->program); !done) return done;
    if (split->names.empty()) continue;
    fs::path names = it->path();
    if (auto done = write_file(names.replace_extension(".names"), split->names); !done) return done;
  }
  return Done{};
}

}  // namespace ros2wasm
