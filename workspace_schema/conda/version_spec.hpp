// The version condition of a dependency: relations joined by `,` (and, binds tighter) and `|` (or),
// with parentheses. Follows conda's VersionSpec.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/conda/version.hpp"

namespace ros2wasm {

class VersionSpec {
 public:
  VersionSpec() = default;  ///< any version
  /// R2W0303 with the reason.
  [[nodiscard]] static Outcome<VersionSpec> parse(std::string_view text);

  [[nodiscard]] bool matches(const Version& version) const;
  [[nodiscard]] bool any() const { return root_ == nullptr; }  ///< says nothing: `*`
  [[nodiscard]] const std::string& text() const { return text_; }

  struct Node;  ///< of the expression; defined where it is parsed

 private:
  std::string text_ = "*";
  std::shared_ptr<const Node> root_;
};

}  // namespace ros2wasm
