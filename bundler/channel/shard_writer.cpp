// See shard_writer.hpp. A shard stands before the index that names it, and goes after it, so that a
// reader at any moment finds all that its index names.
#include "bundler/channel/shard_writer.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/msgpack_writer.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr int kCompressionLevel = 19;
constexpr std::string_view kEnding = ".msgpack.zst";

std::string from_hex(std::string_view hex) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(digit(hex[i]) * 16 + digit(hex[i + 1]));
  return bytes;
}

void put_texts(MsgpackWriter& out, const std::vector<std::string>& texts) {
  out.array(texts.size());
  for (const std::string& text : texts) out.text(text);
}

void put_record(MsgpackWriter& out, const PackageRecord& record) {
  std::string features;
  for (const std::string& feature : record.track_features)
    features += (features.empty() ? "" : " ") + feature;
  const bool noarch = record.noarch != NoarchKind::kNo;
  const bool dated = record.timestamp_ms > 0;
  out.map(9U + (record.md5.empty() ? 0U : 1U) + (record.sha256.empty() ? 0U : 1U) +
          (noarch ? 1U : 0U) + (dated ? 1U : 0U) + (features.empty() ? 0U : 1U));
  out.text("build").text(record.build).text("build_number").number(record.build_number);
  put_texts(out.text("constrains"), record.constrains);
  put_texts(out.text("depends"), record.depends);
  out.text("license").text(record.license);
  if (!record.md5.empty()) out.text("md5").bytes(from_hex(record.md5));
  out.text("name").text(record.name);
  if (noarch) out.text("noarch").text(record.noarch == NoarchKind::kPython ? "python" : "generic");
  if (!record.sha256.empty()) out.text("sha256").bytes(from_hex(record.sha256));
  out.text("size").number(record.size);
  out.text("subdir").text(record.subdir);
  if (dated) out.text("timestamp").number(static_cast<std::uint64_t>(record.timestamp_ms));
  if (!features.empty()) out.text("track_features").text(features);
  out.text("version").text(record.version);
}

using Records = std::vector<const PackageRecord*>;

std::string shard_of(const Records& records) {
  MsgpackWriter out;
  out.map(3);
  for (const char* key : {"packages", "packages.conda"}) {
    Records part;
    const bool conda = std::string_view(key) == "packages.conda";
    std::copy_if(
        records.begin(), records.end(), std::back_inserter(part),
        [conda](const PackageRecord* one) { return one->file_name.ends_with(".conda") == conda; });
    out.text(key).map(part.size());
    for (const PackageRecord* one : part) put_record(out.text(one->file_name), *one);
  }
  out.text("removed").array(0);
  return zstd_compressed(out.data(), kCompressionLevel);
}

bool is_shard_name(const std::string& name) {
  constexpr std::size_t kDigits = 64;
  return name.size() == kDigits + kEnding.size() && name.ends_with(kEnding) &&
         name.find_first_not_of("0123456789abcdef") == kDigits;
}

}  // namespace

std::vector<IndexPart> shard_parts(const std::string& subdir,
                                   const std::vector<PackageRecord>& records) {
  std::map<std::string, Records> by_name;
  for (const PackageRecord& record : records) by_name[record.name].push_back(&record);
  MsgpackWriter index;
  index.map(3).text("info").map(3).text("base_url").text("").text("shards_base_url");
  index.text("shards/").text("subdir").text(subdir).text("shards").map(by_name.size());
  std::vector<IndexPart> parts;
  for (const auto& [name, of_name] : by_name) {
    std::string shard = shard_of(of_name);
    const std::string hash = sha256_hex(shard);
    index.text(name).bytes(from_hex(hash));
    parts.push_back({.path = "shards/" + hash + std::string(kEnding), .bytes = std::move(shard)});
  }
  index.text("version").number(1);
  parts.push_back({.path = "repodata_shards.msgpack.zst",
                   .bytes = zstd_compressed(index.data(), kCompressionLevel)});
  return parts;
}

void remove_stale_shards(const fs::path& folder, const std::vector<IndexPart>& parts) {
  std::set<std::string> kept;
  for (const IndexPart& part : parts) kept.insert(part.path);
  std::error_code error;
  std::vector<fs::path> stale;
  for (fs::directory_iterator it(folder / "shards", error), end; !error && it != end;
       it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (is_shard_name(name) && !kept.contains("shards/" + name)) stale.push_back(it->path());
  }
  for (const fs::path& one : stale) fs::remove(one, error);
}

}  // namespace ros2wasm
