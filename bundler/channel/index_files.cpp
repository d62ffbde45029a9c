// See index_files.hpp.
#include "bundler/channel/index_files.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "bundler/archive/archive_library.hpp"
#include "bundler/channel/channel_network.hpp"
#include "bundler/channel/index_cache.hpp"
#include "bundler/channel/repodata_index.hpp"
#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace {

constexpr std::uint64_t kLargestIndex = 4ULL << 30U;

struct FormatRow {
  IndexFormat format;
  std::string_view file_name;
};

/// In the order in which they are asked for.
constexpr auto kFormats = std::to_array<FormatRow>({
    {.format = IndexFormat::kShards, .file_name = "repodata_shards.msgpack.zst"},
    {.format = IndexFormat::kZstd, .file_name = "repodata.json.zst"},
    {.format = IndexFormat::kBzip2, .file_name = "repodata.json.bz2"},
    {.format = IndexFormat::kPlain, .file_name = "repodata.json"},
});

/// "https://host/channel" of "https://host/channel/noarch".
std::string_view channel_of(std::string_view folder_url) {
  return folder_url.substr(0, folder_url.rfind('/'));
}

using FoundIndex = Outcome<std::optional<IndexFile>>;

std::string_view subdir_of(std::string_view folder_url) {
  return folder_url.substr(folder_url.rfind('/') + 1);
}

/// Remembers the forms of the index that a channel lacks, but only when the channel has some index:
/// an address may become a channel at any time. The plain form, which every channel has, is always
/// requested.
void remember_missing_forms(std::span<const std::string> folder_urls,
                            const std::vector<FoundIndex>& found, const ChannelRoots& roots) {
  std::set<std::string_view> channels;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i] && *found[i]) channels.insert(channel_of(folder_urls[i]));
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i] || !is_network_url(folder_urls[i]) ||
        !channels.contains(channel_of(folder_urls[i])))
      continue;
    for (const FormatRow& row : kFormats) {
      if (row.format == IndexFormat::kPlain || (*found[i] && (*found[i])->format == row.format))
        break;
      remember_absent(folder_urls[i] + "/" + std::string(row.file_name), roots);
    }
  }
}

/// In the best form that each has.
std::vector<FoundIndex> bring_best_forms(std::span<const std::string> folder_urls,
                                         const ChannelRoots& roots,
                                         const Cancellation& cancellation) {
  std::vector<FoundIndex> found(folder_urls.size(), FoundIndex(std::optional<IndexFile>()));
  std::vector<std::size_t> open(folder_urls.size());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = i;
  for (const FormatRow& row : kFormats) {
    std::vector<std::string> urls;
    for (const std::size_t i : open)
      urls.push_back(folder_urls[i] + "/" + std::string(row.file_name));
    auto files = bring_all(urls, roots, cancellation);
    std::vector<std::size_t> still_open;
    for (std::size_t k = 0; k < open.size(); ++k) {
      if (!files[k]) {
        found[open[k]] = std::move(files[k]).errors();
      } else if (*files[k]) {
        found[open[k]] =
            std::optional(IndexFile{.url = urls[k], .file = **files[k], .format = row.format});
      } else {
        still_open.push_back(open[k]);
      }
    }
    open = std::move(still_open);
  }
  if (!roots.network.offline) remember_missing_forms(folder_urls, found, roots);
  return found;
}

/// One channel: what is asked of it, and where it can be asked.
struct Asked {
  std::vector<std::size_t> folders;  ///< places in the question
  std::vector<std::string> places;   ///< its mirrors, then itself
};

std::vector<Asked> by_channel(std::span<const std::string> folder_urls,
                              const ChannelNetwork& network) {
  std::map<std::string_view, Asked> channels;
  for (std::size_t i = 0; i < folder_urls.size(); ++i) {
    Asked& asked = channels[channel_of(folder_urls[i])];
    asked.folders.push_back(i);
    if (asked.folders.size() > 1) continue;
    const std::string channel(channel_of(folder_urls[i]));
    asked.places = at_mirrors(channel, network);
    asked.places.push_back(channel);
  }
  std::vector<Asked> all;
  for (auto& [name, asked] : channels) all.push_back(std::move(asked));
  return all;
}

/// The channel is here, whole.
bool answered(const Asked& asked, const std::vector<FoundIndex>& found) {
  const auto is = [&](auto what) {
    return [&found, what](std::size_t i) { return what(found[i]); };
  };
  return std::all_of(asked.folders.begin(), asked.folders.end(),
                     is([](const FoundIndex& one) { return one.ok(); })) &&
         std::any_of(asked.folders.begin(), asked.folders.end(),
                     is([](const FoundIndex& one) { return one.ok() && one->has_value(); }));
}

}  // namespace

std::vector<Outcome<std::optional<IndexFile>>> bring_index_files(
    std::span<const std::string> folder_urls, const ChannelRoots& roots,
    const Cancellation& cancellation) {
  std::vector<FoundIndex> found(folder_urls.size(), FoundIndex(std::optional<IndexFile>()));
  std::vector<Asked> open = by_channel(folder_urls, roots.network);
  // All channels come to their own address in the last round; before it, somebody else can be
  // asked.
  std::size_t rounds = 0;
  for (const Asked& asked : open) rounds = std::max(rounds, asked.places.size());
  for (std::size_t left = rounds; left > 0; --left) {
    std::vector<std::string> urls;
    std::vector<std::size_t> positions;
    for (const Asked& asked : open) {
      if (asked.places.size() < left) continue;
      const std::string& place = asked.places[asked.places.size() - left];
      for (const std::size_t i : asked.folders) {
        urls.push_back(place + "/" + std::string(subdir_of(folder_urls[i])));
        positions.push_back(i);
      }
    }
    ChannelRoots patient = roots;
    if (left > 1) patient.network.download.retries = std::min(roots.network.download.retries, 1);
    auto files = bring_best_forms(urls, patient, cancellation);
    for (std::size_t k = 0; k < files.size(); ++k) found[positions[k]] = std::move(files[k]);
    std::erase_if(open, [&](const Asked& asked) { return answered(asked, found); });
  }
  return found;
}

Outcome<std::string> bzip2_text(const std::filesystem::path& file, const std::string& url) {
  auto bytes = read_file(file, kMostOfData);
  if (!bytes) return bytes;
  return bzip2_decompressed(*bytes, kLargestIndex, url);
}

}  // namespace ros2wasm
