// .repos files, as `vcs import` reads them: repositories by the path that they get. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/named_source.hpp"

namespace ros2wasm {

/// One entry for each repository, in the order of the file. `packages` of `asked` holds for all of
/// them together, so none has any here. R2W0250: not such a file, or a repository of a kind that is
/// not read (hg, svn), each with its place; `file` is for messages.
[[nodiscard]] Outcome<std::vector<NamedSource>> read_repos_file(std::string_view text,
                                                                const std::string& file);

}  // namespace ros2wasm
