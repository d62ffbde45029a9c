// Which objects refer to symbols, from the linker's own trace of a link; and what of that no
// browser has. Pure.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct LinkTrace {
  std::map<std::string, std::set<std::string>> references;   ///< symbol -> paths of objects
  std::map<std::string, std::set<std::string>> definitions;  ///< likewise
};

/// The linker's options that make it print the trace of these symbols.
[[nodiscard]] std::vector<std::string> trace_options(const std::vector<std::string>& symbols);

[[nodiscard]] LinkTrace read_link_trace(std::string_view printed);

/// The rest of the output, without the trace.
[[nodiscard]] std::string without_trace(std::string_view printed);

/// "src/udp.cpp" for "CMakeFiles/udp.dir/src/udp.cpp.o", "udp.cpp of libnet.a" for a member of an
/// archive.
[[nodiscard]] std::string shown_object(const std::string& path);

/// Is it the compiler's, or of the channels?
[[nodiscard]] bool is_given_object(const std::string& path, const std::string& channel_prefix);

/// A program as messages name it, and what its link said.
struct TracedProgram {
  std::string shown;  ///< "`udp` of package `course`"
  const LinkTrace& trace;
  const std::vector<std::string>& undefined;  ///< what nothing defines
  std::string channel_prefix;                 ///< of the libraries of the channels; may be empty
};

/// R2W0523, an error for each thing that no browser has and that objects of the user's refer to, or
/// that nothing defines; R2W0524, a warning, for calls that only fail. The label is that thing.
[[nodiscard]] Diagnostics limit_findings(const TracedProgram& program);

/// "sockets (src/udp.cpp refers to `socket`)": what a program that is skipped needs.
[[nodiscard]] std::string need_of(const Diagnostic& limit);

/// The same finding as the warning that a program was skipped for it.
[[nodiscard]] Diagnostic left_out_for_limit(Diagnostic limit);

}  // namespace ros2wasm
