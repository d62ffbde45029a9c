// See channel_writer.hpp.
#include "bundler/channel/channel_writer.hpp"

#include <algorithm>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/known_archives.hpp"
#include "bundler/channel/repodata_record.hpp"
#include "bundler/io/files.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/conda/record_rules.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr int kCompressionLevel = 19;

Diagnostic misplaced(const fs::path& archive, const std::string& why) {
  return Diagnostic{.code = "R2W0205",
                    .message = "`" + archive.string() + "` cannot go into the channel's index",
                    .why = {why}};
}

void field_strings(JsonWriter& json, std::string_view name,
                   const std::vector<std::string>& values) {
  json.key(name).begin_array();
  for (const std::string& value : values) json.string(value);
  json.end_array();
}

/// One record, keys in the order of their names.
std::string record_json(const PackageRecord& record) {
  JsonWriter json;
  json.begin_object().field("build", record.build);
  json.key("build_number").unsigned_integer(record.build_number);
  field_strings(json, "constrains", record.constrains);
  field_strings(json, "depends", record.depends);
  json.field("license", record.license);
  if (!record.md5.empty()) json.field("md5", record.md5);
  json.field("name", record.name);
  if (record.noarch != NoarchKind::kNo) {
    json.field("noarch", record.noarch == NoarchKind::kPython ? "python" : "generic");
  }
  if (!record.sha256.empty()) json.field("sha256", record.sha256);
  json.key("size").unsigned_integer(record.size);
  json.field("subdir", record.subdir);
  if (record.timestamp_ms != 0) json.field_integer("timestamp", record.timestamp_ms);
  if (!record.track_features.empty()) {
    std::string features;
    for (const std::string& feature : record.track_features)
      features += (features.empty() ? "" : " ") + feature;
    json.field("track_features", features);
  }
  json.field("version", record.version).end_object();
  return json.text();
}

Outcome<PackageRecord> record_of(const fs::path& archive, const std::string& subdir,
                                 const KnownArchive& known) {
  const std::string file_name = archive.filename().string();
  const auto json = parse_json(known.index_json, archive.string() + ":info/index.json", "R2W0205");
  if (!json) return json.errors();
  SpecTable specs;
  auto parsed = parse_record(raw_record(*json), file_name,
                             {.channel = {}, .subdir = subdir, .base_url = {}}, specs);
  if (const auto* fault = std::get_if<std::string>(&parsed)) return misplaced(archive, *fault);
  PackageRecord record = std::get<PackageRecord>(std::move(parsed));
  if (record.subdir != subdir) return misplaced(archive, "it is made for `" + record.subdir + "`");
  if (distribution_name(record) != archive_stem(file_name)) {
    return misplaced(archive, "by its metadata it is `" + distribution_name(record) + "`");
  }
  record.sha256 = known.hashes.sha256;
  record.md5 = known.hashes.md5;
  record.size = known.hashes.size;
  return record;
}

/// `removed` is empty: it names archives that can still be fetched but must not be chosen, and of
/// those that are gone nothing is left to fetch. One record a line, so that two indexes can be
/// compared by eye.
std::string repodata_text(const std::string& subdir, const std::vector<PackageRecord>& records) {
  std::string conda;
  std::string tar;
  for (const PackageRecord& record : records) {
    std::string& part = record.file_name.ends_with(".conda") ? conda : tar;
    part +=
        (part.empty() ? "\n" : ",\n") + json_quoted(record.file_name) + ":" + record_json(record);
  }
  return "{\"info\":{\"subdir\":" + json_quoted(subdir) + "},\n\"packages\":{" + tar +
         "},\n\"packages.conda\":{" + conda + "},\n\"removed\":[],\n\"repodata_version\":1}\n";
}

Outcome<Done> index_subdir(const fs::path& folder, const std::string& subdir, Reading reading,
                           ChannelSummary& summary) {
  std::vector<fs::path> archives;
  std::error_code error;
  if (fs::is_directory(folder, error)) {
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
      if (!archive_stem(it->path().filename().string()).empty()) archives.push_back(it->path());
    }
    if (error) return cannot_read(folder, error.value());
  }
  std::sort(archives.begin(), archives.end());
  KnownArchives known = reading == Reading::kChanged ? KnownArchives::of(folder) : KnownArchives();
  std::vector<PackageRecord> records;
  Diagnostics errors;
  for (const fs::path& archive : archives) {
    const auto there = known.look_at(archive);
    auto record = there ? record_of(archive, subdir, *there) : there.errors();
    if (record) {
      records.push_back(std::move(*record));
    } else {
      for (Diagnostic& fault : std::move(record).errors()) errors.push_back(std::move(fault));
    }
  }
  if (!errors.empty()) return errors;
  const std::vector<IndexPart> parts = index_parts(subdir, records);
  for (const IndexPart& part : parts) {
    if (auto done = write_file(folder / part.path, part.bytes); !done)
      return std::move(done).errors();
  }
  remove_stale_shards(folder, parts);
  summary.packages += records.size();
  summary.read += known.read_count();
  // Where that cannot be written, the next run reads everything.
  (void)known.keep(folder);
  return Done{};
}

}  // namespace

std::vector<IndexPart> index_parts(const std::string& subdir,
                                   const std::vector<PackageRecord>& records) {
  std::string text = repodata_text(subdir, records);
  std::vector<IndexPart> parts = shard_parts(subdir, records);
  parts.push_back({.path = "repodata.json.zst", .bytes = zstd_compressed(text, kCompressionLevel)});
  parts.push_back({.path = "repodata.json", .bytes = std::move(text)});
  return parts;
}

Outcome<fs::path> add_to_channel(const fs::path& channel, const CondaPackage& package,
                                 const fs::path& staged_prefix) {
  const auto bytes = write_conda(package, staged_prefix);
  if (!bytes) return bytes.errors();
  fs::path archive = channel / package.subdir / conda_file_name(package);
  if (auto done = write_file(archive, *bytes); !done) return std::move(done).errors();
  return archive;
}

Outcome<fs::path> copy_to_channel(const fs::path& channel, const fs::path& archive) {
  const auto there = KnownArchives().look_at(archive);
  if (!there) return there.errors();
  const auto json = parse_json(there->index_json, archive.string() + ":info/index.json", "R2W0205");
  if (!json) return json.errors();
  const std::string subdir = json->text_of("subdir");
  if (!is_subdir(subdir)) return misplaced(archive, "it does not say which platform it is for");
  if (const auto record = record_of(archive, subdir, *there); !record) return record.errors();
  const auto bytes = read_file(archive, kMostOfData);
  if (!bytes) return bytes.errors();
  fs::path place = channel / subdir / archive.filename();
  if (auto done = write_file(place, *bytes); !done) return std::move(done).errors();
  return place;
}

Outcome<ChannelSummary> index_channel(const fs::path& channel, Reading reading) {
  ChannelSummary summary;
  summary.subdirs.emplace_back("noarch");  // must be there, even empty (CEP 26)
  std::error_code error;
  fs::directory_iterator it(channel, error);
  if (error) return cannot_read(channel, error.value());
  for (const fs::directory_iterator end; it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name != "noarch" && is_subdir(name) && it->is_directory(error))
      summary.subdirs.push_back(name);
    if (error) return cannot_read(channel, error.value());
  }
  std::sort(summary.subdirs.begin(), summary.subdirs.end());
  for (const std::string& subdir : summary.subdirs) {
    if (auto done = index_subdir(channel / subdir, subdir, reading, summary); !done)
      return std::move(done).errors();
  }
  return summary;
}

}  // namespace ros2wasm
