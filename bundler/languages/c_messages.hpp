// The C headers of messages (`geometry_msgs/msg/transform_stamped.h`), for packages that include
// them: made for each such package from the definitions that its dependencies install.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "bundler/languages/language.hpp"

namespace ros2wasm {

/// `PACKAGE/KIND/name` of each such header that a text of C or C++ includes.
[[nodiscard]] std::set<std::string> c_message_headers(std::string_view text);

/// Those that the package includes, itself or by headers of what it needs from the workspace, and
/// that nobody installs and the package does not have among its sources. Also of its own messages.
[[nodiscard]] Outcome<std::set<std::string>> included_c_messages(const PackageBuild& request);

/// The include folder of the headers that are made.
[[nodiscard]] std::filesystem::path c_messages_folder(const PackageBuild& request);

/// Whether some are of the package's own messages, which nobody has installed yet.
[[nodiscard]] bool has_own_c_messages(const std::set<std::string>& headers,
                                      const PackageBuild& request);

/// Makes them, and the headers of the messages in their fields. R2W0506.
Outcome<Done> make_c_messages(const std::set<std::string>& headers, const PackageBuild& request,
                              const BuildTools& tools, const Cancellation& cancellation);

}  // namespace ros2wasm
