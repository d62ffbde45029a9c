// See parameter_sources.hpp.
#include "bundler/launch/host/parameter_sources.hpp"

#include "bundler/io/files.hpp"

namespace ros2wasm {

Diagnostics read_parameter_files(const std::vector<NodeEntry>& entries,
                                 const std::filesystem::path& folder, ParameterFiles& files) {
  Diagnostics errors;
  for (const NodeEntry& node : entries) {
    for (const auto& file : node.parameter_files) {
      auto text = read_file(folder / file.value, kMostOfText);
      if (text) {
        files[file.value] = std::move(text).value();
      } else {
        errors.push_back(
            Diagnostic{.code = "R2W0403",
                       .message = "the parameter file `" + file.value + "` cannot be read",
                       .span = file.span,
                       .why = text.errors().front().why});
      }
    }
  }
  return errors;
}

}  // namespace ros2wasm
