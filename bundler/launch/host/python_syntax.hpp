// Which texts are not valid Python, as the interpreter of sites compiles them. An edge: starts a
// process, and remembers its answers in the cache.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "bundler/launch/host/python_host.hpp"

namespace ros2wasm {

/// The first mistake of a text.
struct PythonMistake {
  std::size_t text = 0;      ///< its place among those that were asked about
  std::uint32_t line = 0;    ///< from 1
  std::uint32_t column = 0;  ///< from 1, in characters; 0: unknown
  std::uint32_t length = 1;
  std::string why;  ///< as Python words it
};

/// In the order of the texts. Nothing of them runs. `find_tools` is called when an answer is not
/// cached in `kept`, a folder. R2W0910, R2W0912, and those of `find_tools`.
[[nodiscard]] Outcome<std::vector<PythonMistake>> python_mistakes(
    const std::vector<std::string>& texts, const std::filesystem::path& kept,
    const std::function<Outcome<PythonTools>()>& find_tools, const Cancellation& cancellation);

/// R2W0528: `file` is not valid Python. `text`: all of it.
[[nodiscard]] Diagnostic invalid_python(const PythonMistake& mistake, const std::string& file,
                                        const std::string& text);

}  // namespace ros2wasm
