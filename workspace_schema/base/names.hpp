// The names of ROS 2 and of the site, as strong types whose only door is parse(), and the rules
// behind them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Why a text is not a name of the wanted kind.
struct NameFault {
  std::string why;         ///< e.g. "`-` is not allowed"
  std::size_t offset = 0;  ///< of the first wrong byte; the text's size when something is missing
  std::size_t length = 0;  ///< bytes that are wrong
  std::string rule;        ///< the whole rule, one line
  std::optional<std::string> better;  ///< a near name that does pass
};

// Nothing when the name is good. The rules are those of rmw and rcl (node, namespace, topic), REP
// 144 as catkin_pkg applies it (package), and of file systems and URLs (workspace name).
[[nodiscard]] std::optional<NameFault> node_name_fault(std::string_view text);
[[nodiscard]] std::optional<NameFault> namespace_fault(std::string_view text);
/// A topic or service name as users write it: absolute, relative, `~/private`, with `{node}`
/// substitutions.
[[nodiscard]] std::optional<NameFault> topic_name_fault(std::string_view text);
[[nodiscard]] std::optional<NameFault> package_name_fault(std::string_view text);
/// A package of a conda channel, as CEP 26 has it.
[[nodiscard]] std::optional<NameFault> channel_package_name_fault(std::string_view text);
/// The file name of a program or component library in lib/<package>.
[[nodiscard]] std::optional<NameFault> executable_name_fault(std::string_view text);
[[nodiscard]] std::optional<NameFault> workspace_name_fault(std::string_view text);
/// One parameter's name, dots between the parts.
[[nodiscard]] std::optional<NameFault> parameter_name_fault(std::string_view text);

/// The name of a namespace or a node with a slash before it.
[[nodiscard]] std::string absolute_name(std::string_view name);

/// A text that passed `Fault`. R2W0104 from parse() otherwise, without a place: callers that know
/// one set it.
template <std::optional<NameFault> (*Fault)(std::string_view)>
class CheckedName {
 public:
  [[nodiscard]] static Outcome<CheckedName> parse(std::string_view text) {
    const auto fault = Fault(text);
    if (!fault) return CheckedName(std::string(text));
    Diagnostic error{.code = "R2W0104",
                     .message = "`" + std::string(text) + "` is not a valid name: " + fault->why,
                     .why = {fault->rule}};
    if (fault->better) error.fix.push_back("write `" + *fault->better + "`");
    return error;
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  auto operator<=>(const CheckedName&) const = default;

 private:
  explicit CheckedName(std::string text) : text_(std::move(text)) {}
  std::string text_;
};

using PackageName = CheckedName<package_name_fault>;
using NodeName = CheckedName<node_name_fault>;
using NodeNamespace = CheckedName<namespace_fault>;
using TopicName = CheckedName<topic_name_fault>;

}  // namespace ros2wasm
