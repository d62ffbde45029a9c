// See verified_files.hpp.
#include "bundler/channel/verified_files.hpp"

#include <map>

#include "bundler/io/files.hpp"
#include "bundler/io/part_file.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace {

constexpr int kTickMs = 100;
constexpr std::uint64_t kLargestUnknown = 16ULL << 30U;

Diagnostic wrong_file(const WantedFile& wanted, std::string why) {
  return Diagnostic{.code = "R2W0220",
                    .kind = FailureKind::kEnvironment,
                    .message = wanted.what + " is not the one that was asked for",
                    .why = {std::move(why), "it is at " + wanted.url}};
}

Diagnostic absent(const std::string& what, std::string place, int status) {
  return Diagnostic{
      .code = "R2W0228",
      .kind = FailureKind::kEnvironment,
      .message = what + " is not there",
      .why = {std::move(place), "its server answered with status " + std::to_string(status)}};
}

Diagnostic offline(const std::string& what) {
  return Diagnostic{.code = "R2W0232",
                    .kind = FailureKind::kEnvironment,
                    .message = what + " is not on this machine",
                    .why = {"--offline uses only what was downloaded before"}};
}

/// A mirror may be a folder: a copy of the file from there, when it is the right one.
bool copied_from_folder(const WantedFile& wanted, const ChannelNetwork& network,
                        const std::filesystem::path& part) {
  for (const std::string& place : at_mirrors(wanted.url, network)) {
    std::error_code error;
    if (is_network_url(place) || !std::filesystem::is_regular_file(place, error)) continue;
    std::filesystem::copy_file(place, part, std::filesystem::copy_options::overwrite_existing,
                               error);
    if (!error && !file_fault(wanted, part)) return true;
    std::filesystem::permissions(part, std::filesystem::perms::owner_write,
                                 std::filesystem::perm_options::add, error);
    std::filesystem::resize_file(part, 0, error);
  }
  return false;
}

}  // namespace

std::optional<Diagnostic> file_fault(const WantedFile& wanted, const std::filesystem::path& file) {
  if (wanted.sha256.empty() && wanted.md5.empty())
    return wrong_file(wanted, "its channel gives no hash, so this cannot be checked");
  const auto hashes = hash_file(file, wanted.sha256.empty());
  if (!hashes) return hashes.errors().front();
  if (wanted.size != 0 && hashes->size != wanted.size) {
    return wrong_file(wanted, "it has " + std::to_string(hashes->size) + " bytes instead of " +
                                  std::to_string(wanted.size));
  }
  if (!wanted.sha256.empty() && hashes->sha256 != wanted.sha256)
    return wrong_file(wanted, "its sha256 is " + hashes->sha256 + " instead of " + wanted.sha256);
  if (wanted.sha256.empty() && hashes->md5 != wanted.md5)
    return wrong_file(wanted, "its md5 is " + hashes->md5 + " instead of " + wanted.md5);
  return std::nullopt;
}

void bring_verified(const std::vector<WantedFile>& wanted, const ChannelNetwork& network,
                    const Cancellation& cancellation,
                    const std::function<void(std::size_t, Outcome<Done>)>& done,
                    const std::function<void(const DownloadProgress&)>& tick) {
  Downloader downloader(network.download, cancellation);
  std::map<std::size_t, PartFile> parts;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const WantedFile& one = wanted[i];
    std::error_code error;
    if (std::filesystem::is_regular_file(one.place, error)) {
      if (!file_fault(one, one.place)) {
        done(i, Done{});
        continue;
      }
      std::filesystem::remove(one.place, error);
    }
    auto part = PartFile::open(one.place);
    if (!part) {
      done(i, std::move(part).errors());
      continue;
    }
    if (copied_from_folder(one, network, part->path())) {
      done(i, part->finish(one.place));
      continue;
    }
    if (network.offline) {
      done(i, offline(one.what));
      continue;
    }
    downloader.add(
        i, {.sources = sources_of(one.url, network),
            .headers = {},
            .file = part->path(),
            .resume = part->resumable(),
            .size = one.size,
            .limit_bytes = one.size != 0 ? one.size : kLargestUnknown,
            .fault = [&one](const std::filesystem::path& file) { return file_fault(one, file); }});
    parts.emplace(i, std::move(*part));
  }
  while (!downloader.idle()) {
    for (Downloader::End& end : downloader.wait(kTickMs)) {
      const auto part = parts.find(end.id);
      Outcome<Done> outcome = Done{};
      if (!end.outcome) {
        outcome = std::move(end.outcome).errors();
      } else if (end.outcome->status == 200) {
        outcome = part->second.finish(wanted[end.id].place);
      } else {
        outcome = absent(wanted[end.id].what, "the channel lists it at " + wanted[end.id].url,
                         end.outcome->status);
      }
      parts.erase(part);
      done(end.id, std::move(outcome));
    }
    if (tick) tick(downloader.progress());
  }
}

Outcome<std::string> bring_new(const NewFile& wanted, const ChannelNetwork& network,
                               const Cancellation& cancellation) {
  std::error_code error;
  for (const std::string& place : at_mirrors(wanted.url, network)) {
    if (is_network_url(place) || !std::filesystem::is_regular_file(place, error)) continue;
    if (std::filesystem::file_size(place, error) > wanted.limit_bytes || error) continue;
    if (std::filesystem::copy_file(place, wanted.place, error)) return std::string();
  }
  if (network.offline) return offline(wanted.what);
  std::vector<Download> downloads;
  downloads.push_back({.sources = sources_of(wanted.url, network),
                       .headers = {},
                       .file = wanted.place,
                       .limit_bytes = wanted.limit_bytes,
                       .asked_header = wanted.asked_header,
                       .fault = {}});
  auto ends = download_all(network.download, std::move(downloads), cancellation);
  if (!ends.front()) return std::move(ends.front()).errors();
  if (ends.front()->status != 200)
    return absent(wanted.what, "it was looked for at " + wanted.url, ends.front()->status);
  return ends.front()->asked_header;
}

}  // namespace ros2wasm
