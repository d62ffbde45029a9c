// See site_output.hpp.
#include "bundler/emit/site_output.hpp"

#include "bundler/emit/folder_output.hpp"
#include "bundler/emit/page_output.hpp"
#include "bundler/emit/zip_output.hpp"
#include "bundler/io/files.hpp"

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

/// R2W0614.
Outcome<std::string> store_address(const std::filesystem::path& output,
                                   const std::filesystem::path& store) {
  namespace fs = std::filesystem;
  const auto cannot = [&](std::string why) {
    return Diagnostic{
        .code = "R2W0614",
        .message =
            "the site `" + output.string() + "` cannot share the store `" + store.string() + "`",
        .why = {std::move(why)},
        .fix = {"put the store beside the site: `-o course/lab --store course/objects`"}};
  };
  if (&form_of(output) != &kFolder)
    return cannot("an archive or a page has all its files in it, and can be anywhere");
  const auto site = real_path(output);
  if (!site) return site.errors();
  const auto objects = real_path(store);
  if (!objects) return objects.errors();
  std::error_code error;
  if (fs::exists(*objects, error) && !fs::is_directory(*objects, error))
    return cannot("it is not a folder");
  const std::string address = (*objects / "")
                                  .lexically_normal()
                                  .lexically_relative((*site / "").lexically_normal().parent_path())
                                  .generic_string();
  if (!is_store_address(address)) {
    return cannot(
        "seen from the site it is `" + address +
        "`; a store must be outside of its sites and they outside of it, in folders whose "
        "names have letters, digits, `.`, `_` and `-`");
  }
  return address;
}

}  // namespace

std::optional<Diagnostic> refuse_output(const std::filesystem::path& output) {
  return form_of(output).refuse(output);
}

Outcome<std::string> may_write(const std::filesystem::path& output,
                               const std::filesystem::path& store, bool plan_only) {
  if (!plan_only) {
    if (auto refusal = refuse_output(output)) return *refusal;
  }
  return store.empty() ? std::string() : store_address(output, store);
}

Outcome<Done> emit_site(const SitePlan& plan, const std::filesystem::path& output,
                        const Cancellation& cancellation) {
  return form_of(output).emit(plan, output, cancellation);
}

}  // namespace ros2wasm
