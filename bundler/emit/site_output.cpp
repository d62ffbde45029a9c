// See site_output.hpp.
#include "bundler/emit/site_output.hpp"

#include "bundler/emit/folder_output.hpp"
#include "bundler/emit/zip_output.hpp"

namespace ros2wasm {
namespace {

bool is_archive(const std::filesystem::path& output) {
  return output.extension() == ".zip";
}

}  // namespace

std::optional<Diagnostic> refuse_output(const std::filesystem::path& output) {
  return is_archive(output) ? refuse_zip(output) : refuse_folder(output);
}

Outcome<Done> emit_site(const SitePlan& plan, const std::filesystem::path& output,
                        const Cancellation& cancellation) {
  return is_archive(output) ? emit_zip(plan, output, cancellation)
                            : emit_folder(plan, output, cancellation);
}

}  // namespace ros2wasm
