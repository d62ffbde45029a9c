// Why a Python module that people ask for is in no site, and what to do instead; and what modules
// of Python itself cannot do there. Facts. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

/// A hint for a top-level module that no site has. Empty when there is none.
[[nodiscard]] std::string hint_for_module(std::string_view top_level);

/// A module of Python that can be imported, and fails when it is used.
struct FailingModule {
  std::string_view name;     ///< "subprocess", "urllib.request"
  std::string_view fails;    ///< what does not work
  std::string_view instead;  ///< what to do
};

/// The one that is meant by this module, or by a module in it: "http.server" by "http.server.x".
[[nodiscard]] std::optional<FailingModule> failing_module(std::string_view module);

}  // namespace ros2wasm
