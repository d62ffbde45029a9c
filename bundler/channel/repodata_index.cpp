// See repodata_index.hpp.
#include "bundler/channel/repodata_index.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/cached_index.hpp"
#include "bundler/channel/channel_address.hpp"
#include "bundler/channel/in_order.hpp"
#include "bundler/channel/read_in_parts.hpp"
#include "bundler/channel/record_json.hpp"
#include "bundler/io/replaced_file.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/secret_text.hpp"
#include "workspace_schema/conda/record_rules.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kLargestText = 4ULL << 30U;
constexpr std::size_t kPiece = 4U << 20U;
/// Smaller sources are scanned again each time: faster than a look into the cache is not possible.
constexpr std::uint64_t kSmallestKept = 16U << 10U;

using Take = std::function<Outcome<Done>(std::string_view)>;

/// The bytes of an index: mapped from the cache, or made in memory.
struct Bytes {
  MappedFile mapped;
  std::string made;

  [[nodiscard]] std::string_view view() const {
    return made.empty() ? mapped.bytes() : std::string_view(made);
  }
};

/// The decompressed text of an index file, piece by piece.
Outcome<Done> for_each_piece(const RepodataSource& source, std::string_view bytes,
                             const Take& take) {
  if (source.file.extension() == ".zst")
    return zstd_decompress(bytes, kLargestText, source.url, take);
  while (!bytes.empty()) {
    if (auto taken = take(bytes.substr(0, kPiece)); !taken) return taken;
    bytes.remove_prefix(std::min(kPiece, bytes.size()));
  }
  return Done{};
}

/// Scans the whole index and gives its text on to `write`; the table comes out.
struct Scanned {
  std::uint64_t text_size = 0;
  std::string table;
};
Outcome<Scanned> scan(const RepodataSource& source, std::string_view bytes,
                      const Cancellation& cancellation, const Take& write) {
  KeptTable table;
  RepodataScanner scanner([&table](const FoundRecord& found) { table.add(found); });
  Scanned scanned;
  auto done = for_each_piece(source, bytes, [&](std::string_view piece) -> Outcome<Done> {
    if (cancellation.requested()) return interrupted();
    if (auto fault = scanner.feed(piece)) return no_index(source.url, *fault);
    scanned.text_size += piece.size();
    return write(piece);
  });
  if (!done) return std::move(done).errors();
  if (auto fault = scanner.finish()) return no_index(source.url, *fault);
  scanned.table = table.bytes(scanner.info(), scanner.removed());
  return scanned;
}

Outcome<Bytes> made_in_memory(const RepodataSource& source, const FileIdentity& identity,
                              std::string_view bytes, const Cancellation& cancellation) {
  Bytes result;
  result.made.resize(kKeptHeaderSize);
  auto scanned = scan(source, bytes, cancellation, [&result](std::string_view piece) {
    result.made += piece;
    return Outcome<Done>(Done{});
  });
  if (!scanned) return std::move(scanned).errors();
  result.made += scanned->table;
  const std::string header = kept_header(identity, scanned->text_size, scanned->table);
  std::copy(header.begin(), header.end(), result.made.begin());
  return result;
}

/// Nothing when the cache cannot be written: a full disk must not stop the run.
Outcome<std::optional<Bytes>> made_in_cache(const RepodataSource& source, const fs::path& kept,
                                            const FileIdentity& identity, std::string_view bytes,
                                            const Cancellation& cancellation) {
  auto file = ReplacedFile::begin(kept);
  if (!file) return std::optional<Bytes>();
  bool written = file->append(std::string(kKeptHeaderSize, '\0')).ok();
  auto scanned = scan(source, bytes, cancellation, [&](std::string_view piece) {
    written = written && file->append(piece).ok();
    return Outcome<Done>(Done{});
  });
  if (!scanned) return std::move(scanned).errors();
  const std::string header = kept_header(identity, scanned->text_size, scanned->table);
  written = written && file->append(scanned->table).ok() && file->overwrite_front(header).ok() &&
            file->finish().ok();
  if (!written) return std::optional<Bytes>();
  auto mapped = MappedFile::open(kept);
  if (!mapped) return std::optional<Bytes>();
  return std::optional(Bytes{.mapped = std::move(*mapped), .made = {}});
}

class RepodataIndex : public SubdirIndex {
 public:
  RepodataIndex(RepodataSource source, fs::path kept, FileIdentity identity)
      : source_(std::move(source)), kept_(std::move(kept)), identity_(identity) {}

  [[nodiscard]] Outcome<Done> open(const Cancellation& cancellation) {
    if (!kept_.empty()) {
      auto mapped = MappedFile::open(kept_);
      if (mapped && use({.mapped = std::move(*mapped), .made = {}})) return ready();
    }
    return make(cancellation);
  }

  [[nodiscard]] Outcome<Done> open_text(std::string_view text) {
    auto made = made_in_memory(source_, identity_, text, {});
    if (!made) return std::move(made).errors();
    use(std::move(*made));
    return ready();
  }

  [[nodiscard]] std::span<const std::string_view> names() override { return index_.names(); }

  [[nodiscard]] Outcome<Done> read(std::span<const std::string> names, SpecTable& specs,
                                   RepoIndex& into, const Cancellation& cancellation) override {
    std::vector<std::vector<KeptIndex::Record>> found;
    for (const std::string& name : names) {
      if (cancellation.requested()) return interrupted();
      std::size_t place = 0;
      if (!find(name, place)) continue;
      auto records = index_.records(place);
      if (!records) {  // damaged since it was kept
        if (auto made = make(cancellation); !made) return made;
        if (!find(name, place)) continue;
        records = index_.records(place);
        if (!records) return no_index(source_.url, "it changes while it is read");
      }
      found.push_back(std::move(*records));
    }
    return read_in_parts(found.size(), specs, into,
                         [&](std::size_t first, std::size_t last, SpecTable& table,
                             RepoIndex& part) -> Outcome<Done> {
                           RecordJson json;
                           for (std::size_t i = first; i < last; ++i) {
                             if (cancellation.requested()) return interrupted();
                             add(found[i], json, table, part);
                           }
                           return Done{};
                         });
  }

 private:
  bool find(const std::string& name, std::size_t& place) const {
    const auto all = index_.names();
    const auto found = std::lower_bound(all.begin(), all.end(), name);
    place = static_cast<std::size_t>(found - all.begin());
    return found != all.end() && *found == name;
  }

  /// False when the bytes are no index of this source.
  bool use(Bytes bytes) {
    earlier_.push_back(std::make_unique<Bytes>(std::move(bytes)));
    auto index = KeptIndex::open(earlier_.back()->view(), identity_);
    if (!index) {
      earlier_.pop_back();
      return false;
    }
    index_ = std::move(*index);
    return true;
  }

  Outcome<Done> make(const Cancellation& cancellation) {
    auto identity = identity_of(source_.file);
    if (!identity) return std::move(identity).errors();
    identity_ = *identity;
    auto file = MappedFile::open(source_.file);
    if (!file) return std::move(file).errors();
    if (!kept_.empty()) {
      auto made = made_in_cache(source_, kept_, identity_, file->bytes(), cancellation);
      if (!made) return std::move(made).errors();
      if (*made && use(std::move(**made))) return ready();
    }
    auto made = made_in_memory(source_, identity_, file->bytes(), cancellation);
    if (!made) return std::move(made).errors();
    use(std::move(*made));
    return ready();
  }

  /// `info` and `removed`, which concern every record.
  Outcome<Done> ready() {
    place_ = source_.place;
    removed_.clear();
    if (!index_.info().empty()) {
      const auto info = parse_json(index_.info(), source_.url, "R2W0202");
      if (!info) return info.errors();
      place_.base_url =
          with_base_url(without_secrets(info->text_of("base_url")), source_.place.base_url);
    }
    if (!index_.removed().empty()) {
      const auto removed = parse_json(index_.removed(), source_.url, "R2W0202");
      if (!removed) return removed.errors();
      for (const JsonValue& item : removed->items()) {
        if (const std::string* name = item.string()) removed_.insert(*name);
      }
    }
    return Done{};
  }

  void leave_out(std::string file_name, std::string reason, RepoIndex& into) const {
    into.left_out.push_back({.channel = place_.channel,
                             .subdir = place_.subdir,
                             .file_name = std::move(file_name),
                             .reason = std::move(reason)});
  }

  /// Those of one name. A `.tar.bz2` is not needed where the same is there as a good `.conda`.
  void add(const std::vector<KeptIndex::Record>& records, RecordJson& json, SpecTable& specs,
           RepoIndex& into) const {
    std::vector<std::pair<std::string, const KeptIndex::Record*>> by_file;
    bool tar = false;
    for (const KeptIndex::Record& record : records) {
      tar = tar || !record.conda;
      if (auto file_name = file_name_of(record.text)) {
        if (!removed_.contains(*file_name)) by_file.emplace_back(std::move(*file_name), &record);
      } else {
        leave_out(std::string(record.text.substr(0, 80)), "its file name is not JSON", into);
      }
    }
    put_in_order(by_file, [](const auto& entry) { return std::string_view(std::get<0>(entry)); });
    std::set<std::string, std::less<>> stems;
    for (const bool conda : {true, false}) {
      for (const auto& [file_name, record] : by_file) {
        if (record->conda != conda || stems.contains(archive_stem(file_name))) continue;
        const auto raw = json.read(value_of(record->text));
        if (!raw) {
          const Diagnostic& error = raw.errors().front();
          leave_out(file_name, error.why.empty() ? error.message : error.why.front(), into);
          continue;
        }
        auto parsed = parse_record(*raw, file_name, place_, specs);
        if (auto* good = std::get_if<PackageRecord>(&parsed)) {
          if (conda && tar) stems.emplace(archive_stem(file_name));
          into.records.push_back(std::move(*good));
        } else {
          leave_out(file_name, std::move(std::get<std::string>(parsed)), into);
        }
      }
    }
  }

  static std::size_t key_size(std::string_view text) {
    std::size_t end = 1;
    while (text[end] != '"') end += text[end] == '\\' ? 2 : 1;
    return end + 1;
  }

  std::optional<std::string> file_name_of(std::string_view text) const {
    const std::string_view key = text.substr(0, key_size(text));
    if (key.find('\\') == std::string_view::npos) return std::string(key.substr(1, key.size() - 2));
    const auto json = parse_json(key, source_.url, "R2W0202");
    if (!json || json->string() == nullptr) return std::nullopt;
    return *json->string();
  }

  static std::string_view value_of(std::string_view text) {
    return text.substr(text.find(':', key_size(text)) + 1);
  }

  RepodataSource source_;
  fs::path kept_;  ///< empty: not kept
  FileIdentity identity_;
  /// The last one is in use; names() of the others may be in somebody's hands.
  std::vector<std::unique_ptr<Bytes>> earlier_;
  KeptIndex index_;
  RecordPlace place_;
  std::set<std::string, std::less<>> removed_;
};

}  // namespace

fs::path kept_index_place(const fs::path& cache, const fs::path& source) {
  std::error_code error;
  const std::string key = fs::absolute(source, error).string();
  return cache / "index" / (sha256_hex(key).substr(0, 32) + ".index");
}

Diagnostic no_index(const std::string& url, std::string why) {
  return Diagnostic{.code = "R2W0202",
                    .kind = FailureKind::kEnvironment,
                    .message = "`" + url + "` is not an index of a channel",
                    .why = {std::move(why)}};
}

Outcome<std::unique_ptr<SubdirIndex>> open_repodata(RepodataSource source, const fs::path& cache,
                                                    const Cancellation& cancellation) {
  auto identity = identity_of(source.file);
  if (!identity) return std::move(identity).errors();
  fs::path kept;
  if (!cache.empty() && identity->size >= kSmallestKept) {
    kept = kept_index_place(cache, source.file);
  }
  auto index = std::make_unique<RepodataIndex>(std::move(source), std::move(kept), *identity);
  if (auto opened = index->open(cancellation); !opened) return std::move(opened).errors();
  return std::unique_ptr<SubdirIndex>(std::move(index));
}

Outcome<std::unique_ptr<SubdirIndex>> index_repodata(std::string_view text, RepodataSource source) {
  auto index = std::make_unique<RepodataIndex>(std::move(source), fs::path(), FileIdentity{});
  if (auto opened = index->open_text(text); !opened) return std::move(opened).errors();
  return std::unique_ptr<SubdirIndex>(std::move(index));
}

Outcome<RepoIndex> parse_repodata(std::string_view text, const std::string& channel,
                                  const std::string& subdir) {
  const std::string folder_url = channel_base_url(channel) + "/" + subdir;
  auto source = index_repodata(
      text, {.file = {},
             .url = folder_url + "/repodata.json",
             .place = {.channel = channel, .subdir = subdir, .base_url = folder_url}});
  if (!source) return std::move(source).errors();
  const std::vector<std::string> names((*source)->names().begin(), (*source)->names().end());
  RepoIndex index;
  index.channels.push_back(channel);
  index.names = [names] { return names; };
  SpecTable specs;
  auto read = (*source)->read(names, specs, index, {});
  if (!read) return std::move(read).errors();
  return index;
}

}  // namespace ros2wasm
