// See link_driver.hpp. Each link happens in a folder beside the output and ends with a rename.
#include "bundler/build/link_driver.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "bundler/build/browser_limits.hpp"
#include "bundler/build/compile_errors.hpp"
#include "bundler/build/direct_link.hpp"
#include "bundler/build/interposition.hpp"
#include "bundler/build/link_kit.hpp"
#include "bundler/build/link_trace.hpp"
#include "bundler/build/single_link_object.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/process.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/replaced_text.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Response files (@name) replaced by their arguments.
std::vector<std::string> expanded(const std::vector<std::string>& command) {
  std::vector<std::string> result;
  for (const std::string& argument : command) {
    const bool is_file = argument.starts_with('@');
    const auto text =
        is_file ? read_file(argument.substr(1), kMostOfData) : Outcome<std::string>(argument);
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
    const auto object =
        is_object ? read_file(argument, kMostOfData) : Outcome<std::string>(std::string());
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

/// Those of symbols that nothing defines, from one more link. Only when a link failed already, so
/// its cost does not matter.
LinkTrace trace_of(const LinkRequest& request, const LinkLine& line,
                   const std::vector<std::string>& symbols, const std::string& stem,
                   const Cancellation& cancellation) {
  LinkLine traced = line;
  for (std::string& option : trace_options(symbols)) traced.arguments.push_back(std::move(option));
  traced.arguments.emplace_back("-O0");
  const std::string aside = stem + ".trace";  // the program itself may be good
  std::error_code ignored;
  fs::copy_file(stem + kSingleLinkObjectSuffix, aside + kSingleLinkObjectSuffix, ignored);
  const auto result = run_process({.arguments = link_command(traced, LinkKind::kSingle, aside),
                                   .environment = request.environment},
                                  cancellation);
  return read_link_trace(result ? result->output : std::string());
}

/// The linker says who refers to what no browser has.
LinkLine traced_line(LinkLine line) {
  const std::vector<std::string_view> limited = limited_symbols();
  for (std::string& option : trace_options({limited.begin(), limited.end()}))
    line.arguments.push_back(std::move(option));
  return line;
}

/// `is_limited`: what only the compiler's own libraries need of these is told already, as what no
/// browser has.
Diagnostics undefined_symbols(const LinkRequest& request, const LinkLine& line,
                              const std::vector<std::string>& symbols, const LinkTrace& trace,
                              bool is_limited) {
  Diagnostics result;
  for (const std::string& symbol : symbols) {
    if (limit_of_symbol(symbol) != nullptr) continue;
    const auto found = trace.references.find(symbol);
    const auto objects = found == trace.references.end() ? std::set<std::string>() : found->second;
    if (is_limited && std::all_of(objects.begin(), objects.end(), [](const std::string& object) {
          return is_given_object(object, {});
        }))
      continue;
    Diagnostic diagnostic{.code = "R2W0504",
                          .message = "nothing defines `" + demangled(symbol) + "`, which " +
                                     described(request, line) + " needs"};
    for (const std::string& object : objects)
      diagnostic.why.push_back("`" + fs::path(object).filename().string() + "` refers to it");
    diagnostic.why.emplace_back("no object and no library on the link line has it");
    result.push_back(std::move(diagnostic));
  }
  return result;
}

/// The symbols of the program that no browser has or that nothing defines. When all are warnings,
/// the program can run.
Diagnostics findings_of(const LinkRequest& request, const LinkLine& line,
                        const std::vector<std::string>& undefined, const std::string& printed,
                        const std::string& stem, const Cancellation& cancellation) {
  LinkTrace trace = read_link_trace(printed);
  LinkTrace more =
      undefined.empty() ? LinkTrace() : trace_of(request, line, undefined, stem, cancellation);
  trace.references.merge(more.references);
  Diagnostics result = limit_findings({.shown = described(request, line),
                                       .trace = trace,
                                       .undefined = undefined,
                                       .channel_prefix = request.channel_prefix});
  const bool is_limited = has_error(result);
  append(result, undefined_symbols(request, line, undefined, trace, is_limited));
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
  const auto whole = absolute_path(line.output);
  if (!whole) return whole.errors();
  const fs::path& output = *whole;
  const auto folder =
      TemporaryDirectory::make(output.parent_path(), output.stem().string() + ".link-");
  if (!folder) return folder.errors();
  const std::string stem = (folder->path() / "program").string();
  const LinkLine asked = line;
  std::map<std::string, std::string> copies;  // of libraries, by interposition.hpp
  const auto named = [&](std::string text) {
    for (const auto& [copy, original] : copies) text = with_replaced(text, copy, original);
    return text;
  };
  const auto the_long_way = [&](LinkKind kind) -> Outcome<ProcessResult> {
    const LinkLine linked = kind == LinkKind::kSingle ? traced_line(line) : line;
    auto result = run_process(
        {.arguments = link_command(linked, kind, stem), .environment = request.environment},
        cancellation);
    if (result) result->output = named(result->output);
    return result;
  };
  const auto directly = [&](const LinkLine& linked, LinkKind kind) {
    return DirectLink{.line = linked,
                      .kind = kind,
                      .stem = stem,
                      .kept = request.tool_calls,
                      .environment = request.environment};
  };
  bool is_optimized = false;
  const auto link = [&](LinkKind kind) -> Outcome<ProcessResult> {
    const LinkLine linked = kind == LinkKind::kSingle ? traced_line(line) : line;
    is_optimized = request.tool_calls.empty();
    if (!is_optimized) {
      const auto printed = link_directly(directly(linked, kind), cancellation);
      if (printed) return ProcessResult{.exit_code = 0, .output = named(*printed)};
      is_optimized = true;
    }
    return the_long_way(kind);
  };

  const auto object =
      write_file(stem + kSingleLinkObjectSuffix, single_link_object(tls_base_of(line)));
  if (!object) return object.errors();
  auto linked = link(LinkKind::kSingle);
  if (linked && linked->exit_code != 0 && has_duplicates(linked->output)) {
    auto interposed = with_interposition(line, folder->path() / "libraries", copies);
    if (!interposed) return std::move(interposed).errors();
    line = std::move(*interposed);
    if (!copies.empty()) linked = link(LinkKind::kSingle);
  }
  if (!linked) return std::move(linked).errors();
  if (linked->exit_code != 0) return link_failed(request, line, without_trace(linked->output));
  const std::string printed = linked->output;
  const auto bytes = read_file(stem + ".wasm", kMostOfData);
  const auto module = bytes ? read_wasm_module(*bytes) : std::nullopt;
  if (!module) return link_failed(request, line, "the linker wrote no WebAssembly module");

  ImportFindings findings = classify_imports(*module);
  LinkReport report{.program = line.output};
  if (findings.needs_threads) {
    report.kind = LinkKind::kThreads;
    linked = link(LinkKind::kThreads);
    if (!linked) return std::move(linked).errors();
    if (linked->exit_code != 0) return link_failed(request, line, linked->output);
    const auto threaded = read_file(stem + ".wasm", kMostOfData);
    const auto found = threaded ? read_wasm_module(*threaded) : std::nullopt;
    if (!found) return link_failed(request, line, "the linker wrote no WebAssembly module");
    // The C library for threads has functions that the other one lacks, of scheduling for example.
    std::erase_if(findings.undefined, [&](const std::string& symbol) {
      return std::none_of(found->imports.begin(), found->imports.end(),
                          [&](const WasmImport& import) { return import.name == symbol; });
    });
  }
  report.warnings = findings_of(request, line, findings.undefined, printed, stem, cancellation);
  if (has_error(report.warnings)) return std::move(report.warnings);
  // At the end, since what is linked again or refused needs it not.
  if (!is_optimized && !request.quick &&
      !optimize_directly(directly(line, report.kind), cancellation)) {
    linked = the_long_way(report.kind);
    if (!linked) return std::move(linked).errors();
    if (linked->exit_code != 0) return link_failed(request, line, without_trace(linked->output));
  }
  std::error_code error;
  fs::rename(stem + ".wasm", output, error);
  if (error) return link_failed(request, line, error.message());
  if (!request.kits.empty())
    if (auto kept = keep_link_kit(request.kits, asked); !kept) return std::move(kept).errors();
  return report;
}

}  // namespace ros2wasm
