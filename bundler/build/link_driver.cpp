// See link_driver.hpp. Each link happens in a folder beside the output and ends with a rename.
#include "bundler/build/link_driver.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "bundler/build/compile_errors.hpp"
#include "bundler/build/link_kit.hpp"
#include "bundler/build/quick_link.hpp"
#include "bundler/build/single_link_object.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/process.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Response files (@name) replaced by their arguments.
std::vector<std::string> expanded(const std::vector<std::string>& command) {
  std::vector<std::string> result;
  for (const std::string& argument : command) {
    const bool is_file = argument.starts_with('@');
    const auto text = is_file ? read_file(argument.substr(1)) : Outcome<std::string>(argument);
    if (is_file && text) {
      for (std::string& inner : split_response_file(*text)) result.push_back(std::move(inner));
    } else {
      result.push_back(argument);
    }
  }
  return result;
}

std::string target_of(const LinkLine& line) {
  return fs::path(line.output).stem().string();
}

/// The compiler stands in the objects that it wrote; they come from one compiler.
TlsBase tls_base_of(const LinkLine& line) {
  for (const std::string& argument : line.arguments) {
    const bool is_object = argument.ends_with(".o") || argument.ends_with(".obj");
    const auto object = is_object ? read_file(argument) : Outcome<std::string>(std::string());
    if (is_object && object) return tls_base_for(*object);
  }
  return TlsBase::kZero;
}

std::string described(const LinkRequest& request, const LinkLine& line) {
  const std::string target = "`" + target_of(line) + "`";
  return request.package.empty() ? target : target + " of package `" + request.package + "`";
}

Diagnostic link_failed(const LinkRequest& request, const LinkLine& line,
                       const std::string& output) {
  std::string what = "cannot link " + described(request, line);
  if (std::string reason = lack_of_memory(output); !reason.empty())
    return out_of_memory(std::move(what), std::move(reason));
  return Diagnostic{
      .code = "R2W0505", .message = std::move(what), .detail = without_wrapper_lines(output)};
}

/// Which objects refer to each symbol, from the linker's own trace. Only when a link failed
/// already, so its cost does not matter.
std::map<std::string, std::set<std::string>> references(const LinkRequest& request,
                                                        const LinkLine& line,
                                                        const std::vector<std::string>& symbols,
                                                        const std::string& stem,
                                                        const Cancellation& cancellation) {
  constexpr std::string_view kMark = ": reference to ";
  LinkLine traced = line;
  for (const std::string& symbol : symbols)
    traced.arguments.push_back("-Wl,--trace-symbol=" + symbol);
  traced.arguments.emplace_back("-O0");
  const auto result = run_process({.arguments = link_command(traced, LinkKind::kSingle, stem),
                                   .environment = request.environment},
                                  cancellation);
  std::map<std::string, std::set<std::string>> found;
  std::istringstream text(result ? result->output : std::string());
  for (std::string one; std::getline(text, one);) {
    const auto at = one.find(kMark);
    if (at == std::string::npos) continue;
    found[one.substr(at + kMark.size())].insert(fs::path(one.substr(0, at)).filename().string());
  }
  return found;
}

Diagnostics undefined_symbols(const LinkRequest& request, const LinkLine& line,
                              const std::vector<std::string>& symbols, const std::string& stem,
                              const Cancellation& cancellation) {
  const auto who = references(request, line, symbols, stem, cancellation);
  Diagnostics result;
  for (const std::string& symbol : symbols) {
    Diagnostic diagnostic{.code = "R2W0504",
                          .message = "nothing defines `" + demangled(symbol) + "`, which " +
                                     described(request, line) + " needs"};
    const auto objects = who.find(symbol);
    if (objects != who.end()) {
      for (const std::string& object : objects->second) {
        diagnostic.why.push_back("`" + object + "` refers to it");
      }
    }
    diagnostic.why.emplace_back("no object and no library on the link line has it");
    result.push_back(std::move(diagnostic));
  }
  return result;
}

}  // namespace

Outcome<LinkReport> link_program(const LinkRequest& request, const Cancellation& cancellation) {
  LinkLine line = parse_link_line(expanded(request.command));
  line.thread_support = request.thread_support;
  if (plugins_of(line)) {
    if (!request.kits.empty())
      if (auto kept = keep_link_kit(request.kits, line); !kept) return std::move(kept).errors();
    if (auto made = write_file(line.output, ""); !made) return std::move(made).errors();
    return LinkReport{.program = line.output};
  }
  const fs::path output = fs::absolute(line.output);
  const auto folder =
      TemporaryDirectory::make(output.parent_path(), output.stem().string() + ".link-");
  if (!folder) return folder.errors();
  const std::string stem = (folder->path() / "program").string();
  const auto link = [&](LinkKind kind) -> Outcome<ProcessResult> {
    const bool done =
        !request.quick_folder.empty() && link_quickly({.line = line,
                                                       .kind = kind,
                                                       .stem = stem,
                                                       .kept = request.quick_folder,
                                                       .environment = request.environment},
                                                      cancellation);
    if (done) return ProcessResult{};
    return run_process(
        {.arguments = link_command(line, kind, stem), .environment = request.environment},
        cancellation);
  };

  const auto object =
      write_file(stem + kSingleLinkObjectSuffix, single_link_object(tls_base_of(line)));
  if (!object) return object.errors();
  auto linked = link(LinkKind::kSingle);
  if (!linked) return std::move(linked).errors();
  if (linked->exit_code != 0) return link_failed(request, line, linked->output);
  const auto bytes = read_file(stem + ".wasm");
  const auto module = bytes ? read_wasm_module(*bytes) : std::nullopt;
  if (!module) return link_failed(request, line, "the linker wrote no WebAssembly module");

  ImportFindings findings = classify_imports(*module);
  LinkReport report{.program = line.output};
  if (findings.needs_threads) {
    report.kind = LinkKind::kThreads;
    linked = link(LinkKind::kThreads);
    if (!linked) return std::move(linked).errors();
    if (linked->exit_code != 0) return link_failed(request, line, linked->output);
    const auto threaded = read_file(stem + ".wasm");
    const auto found = threaded ? read_wasm_module(*threaded) : std::nullopt;
    if (!found) return link_failed(request, line, "the linker wrote no WebAssembly module");
    // The C library for threads has functions that the other one lacks, of scheduling for example.
    std::erase_if(findings.undefined, [&](const std::string& symbol) {
      return std::none_of(found->imports.begin(), found->imports.end(),
                          [&](const WasmImport& import) { return import.name == symbol; });
    });
  }
  if (!findings.undefined.empty()) {
    return undefined_symbols(request, line, findings.undefined, stem, cancellation);
  }
  std::error_code error;
  fs::rename(stem + ".wasm", output, error);
  if (error) return link_failed(request, line, error.message());
  if (!request.kits.empty())
    if (auto kept = keep_link_kit(request.kits, line); !kept) return std::move(kept).errors();
  return report;
}

}  // namespace ros2wasm
