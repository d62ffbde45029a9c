// See known_archives.hpp. The file is a line with the sha256 of the JSON behind it.
#include "bundler/channel/known_archives.hpp"

#include <chrono>
#include <utility>

#include "bundler/archive/package_index.hpp"
#include "bundler/io/files.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFileName = ".ros2wasm-archives.json";
constexpr std::int64_t kClockTickNs = 2'000'000'000;  // of the coarsest file systems
constexpr std::size_t kHashSize = 64;

std::uint64_t number_of(const JsonValue& json, std::string_view key) {
  const JsonValue* value = json.find(key);
  return value == nullptr ? 0 : value->unsigned_integer().value_or(0);
}

std::int64_t now_ns() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

KnownArchive archive_of(const JsonValue& json) {
  const JsonValue* modified = json.find("modified_ns");
  const std::uint64_t size = number_of(json, "size");
  return {.identity = {.size = size,
                       .modified_ns = modified == nullptr ? 0 : modified->integer().value_or(0),
                       .inode = number_of(json, "inode")},
          .hashes = {.sha256 = json.text_of("sha256"), .md5 = json.text_of("md5"), .size = size},
          .index_json = json.text_of("index_json")};
}

}  // namespace

KnownArchives::KnownArchives() : began_ns_(now_ns()) {}

KnownArchives KnownArchives::of(const fs::path& folder) {
  KnownArchives known;
  const auto text = read_file(folder / kFileName, kMostOfList);
  if (!text || text->size() <= kHashSize) return known;
  const std::string_view body = std::string_view(*text).substr(kHashSize + 1);
  if (!text->starts_with(sha256_hex(body))) return known;
  const auto json = parse_json(body, kFileName, "R2W0202");
  if (!json || json->text_of("version") != ROS2WASM_VERSION) return known;
  const JsonValue* archives = json->find("archives");
  if (archives == nullptr) return known;
  for (const auto& [name, archive] : archives->members())
    known.before_.emplace(name, archive_of(archive));
  const JsonValue* began = json->find("began_ns");
  known.began_before_ns_ = began == nullptr ? 0 : began->integer().value_or(0);
  return known;
}

Outcome<KnownArchive> KnownArchives::look_at(const fs::path& archive) {
  const auto identity = identity_of(archive);
  if (!identity) return identity.errors();
  const auto before = before_.find(archive.filename().string());
  const bool is_known = before != before_.end();
  const bool is_older = identity->modified_ns + kClockTickNs < began_before_ns_;
  if (is_known && is_older && before->second.identity == *identity)
    return now_[before->first] = before->second;
  ++read_;
  auto hashes = hash_file(archive, true);
  if (!hashes) return std::move(hashes).errors();
  const bool same = is_known && before->second.hashes.sha256 == hashes->sha256;
  auto index_json = same ? Outcome<std::string>(before->second.index_json)
                         : read_index_json(archive, archive.string());
  if (!index_json) return std::move(index_json).errors();
  return now_[archive.filename().string()] = {.identity = *identity,
                                              .hashes = std::move(*hashes),
                                              .index_json = std::move(*index_json)};
}

Outcome<Done> KnownArchives::keep(const fs::path& folder) const {
  JsonWriter json;
  json.begin_object().field("version", ROS2WASM_VERSION).field_integer("began_ns", began_ns_);
  json.key("archives").begin_object();
  for (const auto& [name, archive] : now_) {
    json.key(name).begin_object().key("size").unsigned_integer(archive.identity.size);
    json.field_integer("modified_ns", archive.identity.modified_ns);
    json.key("inode").unsigned_integer(archive.identity.inode);
    json.field("sha256", archive.hashes.sha256).field("md5", archive.hashes.md5);
    json.field("index_json", archive.index_json).end_object();
  }
  json.end_object().end_object();
  return write_file(folder / kFileName, sha256_hex(json.text()) + "\n" + json.text());
}

}  // namespace ros2wasm
