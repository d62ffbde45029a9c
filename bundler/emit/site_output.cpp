// See site_output.hpp.
#include "bundler/emit/site_output.hpp"

#include "bundler/emit/folder_output.hpp"
#include "bundler/emit/page_output.hpp"
#include "bundler/emit/zip_output.hpp"

namespace ros2wasm {
namespace {

/// A form of output, by how its name ends.
struct Form {
  std::string_view extension;
  std::optional<Diagnostic> (*refuse)(const std::filesystem::path& output);
  Outcome<Done> (*emit)(const SitePlan& plan, const std::filesystem::path& output,
                        const Cancellation& cancellation);
};

constexpr Form kFolder{.extension = {}, .refuse = refuse_folder, .emit = emit_folder};
constexpr Form kFiles[] = {{.extension = ".zip", .refuse = refuse_zip, .emit = emit_zip},
                           {.extension = ".html", .refuse = refuse_page, .emit = emit_page}};

const Form& form_of(const std::filesystem::path& output) {
  for (const Form& form : kFiles) {
    if (output.extension() == form.extension) return form;
  }
  return kFolder;
}

}  // namespace

std::optional<Diagnostic> refuse_output(const std::filesystem::path& output) {
  return form_of(output).refuse(output);
}

Outcome<Done> emit_site(const SitePlan& plan, const std::filesystem::path& output,
                        const Cancellation& cancellation) {
  return form_of(output).emit(plan, output, cancellation);
}

}  // namespace ros2wasm
