// See channel_index.hpp.
#include "bundler/channel/channel_index.hpp"

#include <algorithm>
#include <array>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/transport.hpp"
#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace {

constexpr std::array<std::string_view, 2> kSubdirs{"emscripten-wasm32", "noarch"};
constexpr std::uint64_t kLargestIndex = 4ULL << 30U;

/// The text of a subdirectory's index, or nothing when the channel has none.
Outcome<std::optional<std::string>> index_text(const std::string& folder_url,
                                               const ChannelRoots& roots,
                                               const Cancellation& cancellation) {
  for (const std::string_view file_name :
       {std::string_view("repodata.json.zst"), std::string_view("repodata.json")}) {
    const std::string url = folder_url + "/" + std::string(file_name);
    const auto file = bring(url, roots, cancellation);
    if (!file) return file.errors();
    if (!*file) continue;
    auto bytes = read_file(**file);
    if (!bytes) return std::move(bytes).errors();
    if (!file_name.ends_with(".zst")) return std::optional(std::move(*bytes));
    auto text = zstd_decompressed(*bytes, kLargestIndex, url);
    if (!text) return std::move(text).errors();
    return std::optional(std::move(*text));
  }
  return std::optional<std::string>();
}

Diagnostic no_channel(const ChannelSource& source) {
  return Diagnostic{
      .code = "R2W0201",
      .kind = FailureKind::kEnvironment,
      .message = "there is no channel at `" + source.name + "`",
      .span = source.span,
      .label = "no channel here",
      .why = {"it has neither `noarch/repodata.json` nor `emscripten-wasm32/repodata.json` "
              "(nor `.json.zst` of either)"}};
}

Outcome<RepoIndex> load_channel(const ChannelSource& source, const ChannelRoots& roots,
                                const Cancellation& cancellation) {
  RepoIndex whole;
  bool found = false;
  for (const std::string_view subdir : kSubdirs) {
    if (cancellation.requested()) return interrupted();
    const auto text =
        index_text(channel_base_url(source.name) + "/" + std::string(subdir), roots, cancellation);
    if (!text) return text.errors();
    if (!*text) continue;
    found = true;
    auto part = parse_repodata(**text, source.name, std::string(subdir));
    if (!part) return std::move(part).errors();
    std::move(part->records.begin(), part->records.end(), std::back_inserter(whole.records));
    std::move(part->left_out.begin(), part->left_out.end(), std::back_inserter(whole.left_out));
  }
  if (!found) return no_channel(source);
  return whole;
}

}  // namespace

Outcome<RepoIndex> load_channels(std::span<const ChannelSource> channels, const ChannelRoots& roots,
                                 const Cancellation& cancellation, const ProgressSink& progress) {
  RepoIndex index;
  Diagnostics errors;
  for (const ChannelSource& source : channels) {
    if (std::find(index.channels.begin(), index.channels.end(), source.name) !=
        index.channels.end())
      continue;
    if (progress) {
      progress({.step = "index",
                .item = source.name,
                .done = index.channels.size(),
                .total = channels.size(),
                .unit = "channels"});
    }
    index.channels.push_back(source.name);
    auto part = load_channel(source, roots, cancellation);
    if (!part) {
      for (Diagnostic& error : std::move(part).errors()) {
        if (!error.span) error.span = source.span;
        errors.push_back(std::move(error));
      }
      continue;
    }
    std::move(part->records.begin(), part->records.end(), std::back_inserter(index.records));
    std::move(part->left_out.begin(), part->left_out.end(), std::back_inserter(index.left_out));
  }
  if (!errors.empty()) return errors;
  if (progress) {
    progress({.step = "index",
              .item = {},
              .done = channels.size(),
              .total = channels.size(),
              .unit = "channels"});
  }
  return index;
}

Outcome<std::filesystem::path> embedded_channel(const std::filesystem::path& executable) {
  const std::filesystem::path folder = executable.parent_path();
  const std::array<std::filesystem::path, 2> places{
      folder / "channel", (folder / ".." / "share" / "ros2wasm" / "channel").lexically_normal()};
  for (const std::filesystem::path& place : places) {
    std::error_code error;
    if (std::filesystem::is_regular_file(place / "noarch" / "repodata.json", error)) return place;
  }
  return Diagnostic{.code = "R2W0204",
                    .kind = FailureKind::kEnvironment,
                    .message = "the channel that comes with ros2wasm is not there",
                    .why = {"looked for `noarch/repodata.json` in `" + places[0].string() +
                            "` and `" + places[1].string() + "`"}};
}

}  // namespace ros2wasm
