// See second_link.hpp.
#include "bundler/build/second_link.hpp"

#include "bundler/build/link_driver.hpp"
#include "bundler/build/split_programs.hpp"
#include "bundler/io/cached_folder.hpp"
#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;

Outcome<fs::path> link_again(SecondLink link, const BuildTools& tools, const fs::path& cache,
                             const Cancellation& cancellation, const ProgressSink& progress) {
  const std::string& name = link.package.name;
  const std::string folder = name + "-" + link.program + "-";
  const fs::path prefix = cache / "built" / (folder + link.hash.substr(0, 20));
  const fs::path file = fs::path("lib") / name / (link.program + ".wasm");
  if (is_kept(prefix, link.hash)) return prefix / file;
  if (progress) progress({.step = "build", .item = name, .done = 0, .total = 0, .unit = {}});
  const auto staging = TemporaryDirectory::make(cache / "built", "." + folder);
  if (!staging) return staging.errors();
  if (auto made = make_directories((staging->path() / file).parent_path()); !made)
    return std::move(made).errors();
  std::vector<std::string> command = {tools.compiler.cxx.string()};
  for (std::string& argument : link.arguments) command.push_back(std::move(argument));
  command.insert(command.end(), {"-o", (staging->path() / file).string()});
  const auto done = link_program(
      {.package = name,
       .command = std::move(command),
       .environment = tools.tool_environment,
       .thread_support = (tools.toolchain.parent_path() / "src/thread_support.cpp").string(),
       .tool_calls = tools.tool_calls.string(),
       .quick = tools.quick},
      cancellation);
  if (!done) return done.errors();
  if (auto split = split_programs(staging->path(), name); !split) return std::move(split).errors();
  if (auto kept = keep_folder(staging->path(), prefix, link.hash); !kept)
    return std::move(kept).errors();
  return prefix / file;
}

}  // namespace ros2wasm
