// See link_line.hpp.
#include "bundler/build/link_line.hpp"

#include <cxxabi.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include "bundler/build/single_link_object.hpp"

namespace ros2wasm {
namespace {

/// Options and libraries that a native link has and a site has no use for.
constexpr std::array<std::string_view, 16> kDropped = {"-pthread",
                                                       "-lpthread",
                                                       "-ldl",
                                                       "-lrt",
                                                       "-lm",
                                                       "-latomic",
                                                       "-lstdc++fs",
                                                       "-rdynamic",
                                                       "-static-libgcc",
                                                       "-static-libstdc++",
                                                       "-Wl,--as-needed",
                                                       "-Wl,--no-as-needed",
                                                       "-Wl,--no-undefined",
                                                       "-Wl,-Bstatic",
                                                       "-Wl,-Bdynamic",
                                                       "-fPIC"};
constexpr std::array<std::string_view, 5> kDroppedPrefixes = {
    "-Wl,-rpath", "-Wl,-z,", "-Wl,-soname", "-Wl,--disable-new-dtags", "-Wl,--enable-new-dtags"};

/// Functions outside WASI and "ros2wasm" that the site's loader supplies to every program.
constexpr std::array<std::string_view, 5> kLoaderFunctions = {
    "emscripten_notify_memory_growth", "getentropy", "system", "abort", "_emscripten_get_progname"};

bool is_dropped(std::string_view argument) {
  return std::find(kDropped.begin(), kDropped.end(), argument) != kDropped.end() ||
         std::any_of(kDroppedPrefixes.begin(), kDroppedPrefixes.end(),
                     [&](std::string_view prefix) { return argument.starts_with(prefix); });
}

bool loader_supplies(const WasmImport& import) {
  if (import.module == "wasi_snapshot_preview1" || import.module == "ros2wasm") return true;
  if (import.module != "env" || import.kind != WasmExternal::kFunction) return false;
  // System calls that neither libc nor WASI has: the loader answers "not supported", and the node's
  // console says so. Which of them a program of the user's must not ask for: browser_limits.hpp.
  if (import.name.starts_with("__syscall_")) return true;
  return std::find(kLoaderFunctions.begin(), kLoaderFunctions.end(), import.name) !=
         kLoaderFunctions.end();
}

}  // namespace

LinkLine parse_link_line(const std::vector<std::string>& command) {
  LinkLine line;
  for (std::size_t i = 0; i < command.size(); ++i) {
    const std::string& argument = command[i];
    if (i == 0) {
      line.compiler = argument;
    } else if (argument == "-o" && i + 1 < command.size()) {
      line.output = command[++i];
    } else if (!is_dropped(argument)) {
      line.arguments.push_back(argument);
    }
  }
  return line;
}

std::vector<std::string> split_response_file(std::string_view text) {
  std::vector<std::string> result;
  std::string current;
  bool inside = false;
  char quote = '\0';
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\\' && i + 1 < text.size()) {
      current.push_back(text[++i]);
      inside = true;
    } else if (quote != '\0') {
      if (c == quote) {
        quote = '\0';
      } else {
        current.push_back(c);
      }
    } else if (c == '"' || c == '\'') {
      quote = c;
      inside = true;
    } else if (c == ' ' || c == '\n' || c == '\t' || c == '\r') {
      if (inside) result.push_back(std::move(current));
      current.clear();
      inside = false;
    } else {
      current.push_back(c);
      inside = true;
    }
  }
  if (inside) result.push_back(std::move(current));
  return result;
}

std::vector<std::string> link_command(const LinkLine& line, LinkKind kind,
                                      const std::string& stem) {
  std::vector<std::string> command = {
      line.compiler, "-O2", "--profiling-funcs", "-fwasm-exceptions", "-sALLOW_MEMORY_GROWTH=1",
      // Functions that the loader calls: the text of an uncaught exception, a thread's stack,
      // files.
      "-Wl,--export-if-defined=__cpp_exception", "-Wl,--export-if-defined=ros2wasm_exception_what",
      "-Wl,--export-if-defined=ros2wasm_thread_stack",
      "-Wl,--export-if-defined=ros2wasm_timed_waits", "-Wl,--export-if-defined=ros2wasm_fd_read",
      "-Wl,--export-if-defined=ros2wasm_fd_write", "-Wl,--export-if-defined=ros2wasm_fd_seek",
      "-Wl,--export-if-defined=ros2wasm_fd_close", "-Wl,--export-if-defined=ros2wasm_fd_is_open",
      "-Wl,--export-if-defined=ros2wasm_files_rest"};
  switch (kind) {
    case LinkKind::kSingle:
      command.insert(command.end(), {"-sSTANDALONE_WASM", "-sERROR_ON_UNDEFINED_SYMBOLS=0",
                                     "-sWARN_ON_UNDEFINED_SYMBOLS=0", "-Wl,--wrap=pthread_create",
                                     stem + kSingleLinkObjectSuffix});
      break;
    case LinkKind::kThreads:
      command.insert(
          command.end(),
          {"-pthread", "-sMAXIMUM_MEMORY=1GB", "-sWASM_BIGINT", "-Wno-pthreads-mem-growth",
           // Run static destructors and flush streams at the end, as on a robot.
           "-sEXIT_RUNTIME=1", "-Wl,--export=fflush",
           // Emscripten's JavaScript step does not know the imports from "ros2wasm".
           "-sERROR_ON_UNDEFINED_SYMBOLS=0", "-sWARN_ON_UNDEFINED_SYMBOLS=0", line.thread_support});
      break;
  }
  command.insert(command.end(), line.arguments.begin(), line.arguments.end());
  command.insert(command.end(), {"-o", stem + (kind == LinkKind::kSingle ? ".wasm" : ".js")});
  return command;
}

ImportFindings classify_imports(const WasmModule& module) {
  ImportFindings findings;
  for (const WasmImport& import : module.imports) {
    if (import.module == "ros2wasm" && import.name == kThreadMarkerImport) {
      findings.needs_threads = true;
    } else if (!loader_supplies(import)) {
      findings.undefined.push_back(import.name);
    }
  }
  std::sort(findings.undefined.begin(), findings.undefined.end());
  return findings;
}

std::string demangled(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  return status == 0 && text ? std::string(text.get()) : symbol;
}

}  // namespace ros2wasm
