// See index_fault.hpp.
#include "bundler/channel/index_fault.hpp"

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/index_files.hpp"
#include "bundler/channel/repodata_index.hpp"
#include "bundler/channel/repodata_scan.hpp"
#include "bundler/channel/shard_format.hpp"
#include "bundler/io/mapped_file.hpp"

namespace ros2wasm {
namespace {

constexpr std::uint64_t kLargestText = 4ULL << 30U;

}  // namespace

std::optional<Diagnostic> index_fault(const std::filesystem::path& file, const std::string& url) {
  // Distribution files come the same way; who reads one judges it.
  if (url.ends_with(".yaml") || url.ends_with(".yml")) return std::nullopt;
  const auto mapped = MappedFile::open(file);
  if (!mapped) return mapped.errors().front();
  if (url.ends_with(".msgpack.zst")) {
    const auto list = read_shard_list(mapped->bytes(), url);
    return list ? std::nullopt : std::optional(list.errors().front());
  }
  RepodataScanner scanner([](const FoundRecord&) {});
  const auto scan = [&](std::string_view piece) -> Outcome<Done> {
    if (auto fault = scanner.feed(piece)) return no_index(url, *fault);
    return Done{};
  };
  Outcome<Done> scanned = Done{};
  if (url.ends_with(".zst")) {
    scanned = zstd_decompress(mapped->bytes(), kLargestText, url, scan);
  } else if (url.ends_with(".bz2")) {
    const auto text = bzip2_text(file, url);
    scanned = text ? scan(*text) : Outcome<Done>(text.errors());
  } else {
    scanned = scan(mapped->bytes());
  }
  if (!scanned) return scanned.errors().front();
  if (auto fault = scanner.finish()) return no_index(url, *fault);
  return std::nullopt;
}

}  // namespace ros2wasm
