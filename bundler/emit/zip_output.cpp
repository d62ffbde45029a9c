// See zip_output.hpp.
#include "bundler/emit/zip_output.hpp"

#include <string_view>

#include "bundler/archive/zip_writer.hpp"
#include "bundler/io/files.hpp"
#include "bundler/site/own_site.hpp"
#include "bundler/site/site_list.hpp"
#include "bundler/site/site_path.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// The limit in bytes for a member and for the archive, with room for the directory, and the limit
/// on the number of members.
constexpr std::uint64_t kMostBytes = 4'000'000'000;
constexpr std::size_t kMostMembers = 65'000;

Diagnostic too_large(const fs::path& file, std::string why) {
  return Diagnostic{.code = "R2W0609",
                    .message = "the site does not fit into the archive `" + file.string() + "`",
                    .why = {std::move(why)},
                    .fix = {"write it as a folder, with a name that does not end in .zip"}};
}

}  // namespace

std::optional<Diagnostic> refuse_zip(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status) && !fs::is_symlink(fs::symlink_status(file, error))) return std::nullopt;
  if (fs::is_regular_file(status) && is_site_archive_of_ours(file)) return std::nullopt;
  return Diagnostic{
      .code = "R2W0601",
      .message = "`" + file.string() + "` exists and is not a site made by ros2wasm",
      .why = {fs::is_regular_file(status)
                  ? "writing a site there would remove it; it does not begin with a site.json that "
                    "ros2wasm wrote"
                  : "it is not a file, and a name that ends in .zip asks for an archive"},
      .fix = {"choose another place with -o"}};
}

std::optional<Diagnostic> refuse_zip_size(const fs::path& file, std::size_t members,
                                          std::uint64_t bytes) {
  if (members > kMostMembers)
    return too_large(file, "it has " + std::to_string(members) + " files");
  if (bytes > kMostBytes) return too_large(file, "it has " + std::to_string(bytes) + " bytes");
  return std::nullopt;
}

Outcome<Done> emit_zip(const SitePlan& plan, const fs::path& file,
                       const Cancellation& cancellation) {
  if (auto refusal = refuse_zip(file)) return *refusal;
  if (auto refusal = refuse_zip_size(file, plan.files.size() + plan.channel.size(),
                                     total_size(plan) + channel_size(plan)))
    return *refusal;
  ZipWriter archive;
  const auto add = [&](const std::string& path, std::string_view bytes) -> Outcome<Done> {
    if (cancellation.requested()) return interrupted();
    if (auto refusal = refuse_site_path(path)) return *refusal;
    archive.member(path, bytes);
    return Done{};
  };
  const auto is_list = [](const PlannedFile& one) { return one.path == kSiteJsonName; };
  for (const bool lists : {true, false}) {
    for (const PlannedFile& one : plan.files) {
      if (is_list(one) != lists) continue;
      std::size_t at = 0;
      std::size_t part = 0;
      for (const std::string& place : places_of(one, plan)) {
        const std::size_t size =
            one.parts.empty() ? one.bytes.size() : static_cast<std::size_t>(one.parts[part++].size);
        if (auto added = add(place, std::string_view(one.bytes).substr(at, size)); !added)
          return added;
        at += size;
      }
    }
  }
  for (const ChannelFile& one : plan.channel) {
    const auto bytes =
        one.copy_of.empty() ? Outcome<std::string>(one.bytes) : read_file(one.copy_of, kMostOfData);
    if (!bytes) return bytes.errors();
    if (auto added = add(one.path, *bytes); !added) return added;
  }
  return write_file(file, archive.finish());
}

}  // namespace ros2wasm
