// See index_cache.hpp.
#include "bundler/channel/index_cache.hpp"

#include <chrono>

#include "bundler/channel/index_fault.hpp"
#include "bundler/io/download.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kAbsentForSeconds = std::int64_t{7} * 24 * 3600;

std::int64_t now_s() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::seconds>(now).count();
}

/// One index file and its copy.
struct Copy {
  std::string url;
  fs::path folder;
  std::optional<IndexCopyState> state;  ///< of a copy that is whole

  [[nodiscard]] fs::path file_of(const std::string& sha256) const {
    return index_copy_place(folder, {.url = url, .sha256 = sha256});
  }
  /// The channel had no such file when it was asked, and that is not long ago.
  [[nodiscard]] bool absent() const {
    return state && state->sha256.empty() && now_s() - state->checked_s < kAbsentForSeconds;
  }
  [[nodiscard]] bool present() const { return state && !state->sha256.empty(); }
};

Copy copy_of(const std::string& url, const ChannelRoots& roots) {
  Copy copy{
      .url = url, .folder = roots.cache / "index" / sha256_hex(url).substr(0, 32), .state = {}};
  const auto text = read_file(copy.folder / "state.json", kMostOfText);
  if (!text) return copy;
  auto state = read_copy_state(*text);
  if (!state || state->url != url) return copy;
  if (!state->sha256.empty()) {
    const auto hashes = hash_file(copy.file_of(state->sha256));
    if (!hashes || hashes->sha256 != state->sha256) return copy;
  }
  copy.state = std::move(state);
  return copy;
}

Outcome<Done> keep_state(const Copy& copy, const Downloaded& answer, const std::string& sha256) {
  return write_file(copy.folder / "state.json",
                    write_copy_state({.url = copy.url,
                                      .etag = answer.etag,
                                      .last_modified = answer.last_modified,
                                      .sha256 = sha256,
                                      .checked_s = now_s()}));
}

Download download_of(const Copy& copy, const fs::path& file, const ChannelRoots& roots) {
  Download download{
      .sources = {source_of(copy.url, roots.network)},
      .headers = {},
      .file = file,
      .fault = [url = copy.url](const fs::path& brought) { return index_fault(brought, url); }};
  if (!copy.present()) return download;
  if (!copy.state->etag.empty()) download.headers.push_back("If-None-Match: " + copy.state->etag);
  if (!copy.state->last_modified.empty())
    download.headers.push_back("If-Modified-Since: " + copy.state->last_modified);
  return download;
}

/// Makes the new bytes the copy, or says that the old one still is.
Outcome<LocalFile> settled(const Copy& copy, const fs::path& file, const Outcome<Downloaded>& end) {
  if (!end) {
    Diagnostics errors = end.errors();
    if (copy.present())
      errors.front().why.push_back("--offline uses the copy that was made before");
    return errors;
  }
  switch (end->status) {
    case 304: {
      if (!copy.present()) break;
      Downloaded answer = *end;
      if (answer.etag.empty()) answer.etag = copy.state->etag;
      if (answer.last_modified.empty()) answer.last_modified = copy.state->last_modified;
      if (auto kept = keep_state(copy, answer, copy.state->sha256); !kept)
        return std::move(kept).errors();
      return LocalFile(copy.file_of(copy.state->sha256));
    }
    case 200: {
      const auto hashes = hash_file(file);
      if (!hashes) return hashes.errors();
      const fs::path place = copy.file_of(hashes->sha256);
      std::error_code error;
      fs::rename(file, place, error);
      if (error) return cannot_write(place, error.value());
      if (auto kept = keep_state(copy, *end, hashes->sha256); !kept)
        return std::move(kept).errors();
      return LocalFile(place);
    }
    case 404:
    case 410:
      return LocalFile();
    case 401:
    case 403:  // storage services say so of files that are not there
      if (!copy.url.ends_with("/repodata.json")) return LocalFile();
      break;
    default:
      break;
  }
  return Diagnostic{.code = "R2W0234",
                    .kind = FailureKind::kEnvironment,
                    .message = "the server of `" + copy.url + "` answered with status " +
                               std::to_string(end->status),
                    .why = {end->status == 401 || end->status == 403
                                ? "it wants credentials: netrc, ROS2WASM_AUTH_<HOST> (for https), "
                                  "or in the channel's "
                                  "address"
                                : "that is not an answer to what was asked"}};
}

}  // namespace

std::string write_copy_state(const IndexCopyState& state) {
  JsonWriter json;
  json.begin_object().field("url", state.url).field("etag", state.etag);
  json.field("last_modified", state.last_modified).field("sha256", state.sha256);
  json.key("checked").unsigned_integer(static_cast<std::uint64_t>(state.checked_s));
  json.end_object();
  return json.text() + "\n";
}

std::optional<IndexCopyState> read_copy_state(std::string_view text) {
  const auto json = parse_json(text, "state.json", "R2W0202");
  if (!json || !json->is_object()) return std::nullopt;
  IndexCopyState state{.url = json->text_of("url"),
                       .etag = json->text_of("etag"),
                       .last_modified = json->text_of("last_modified"),
                       .sha256 = json->text_of("sha256")};
  const JsonValue* checked = json->find("checked");
  if (checked == nullptr || (!state.sha256.empty() && state.sha256.size() != 64))
    return std::nullopt;
  state.checked_s = checked->integer().value_or(0);
  return state;
}

fs::path index_copy_place(const fs::path& folder, const IndexCopyState& state) {
  return folder / (state.sha256.substr(0, 16) + "-" + fs::path(state.url).filename().string());
}

std::vector<Outcome<LocalFile>> bring_indexes(std::span<const std::string> urls,
                                              const ChannelRoots& roots,
                                              const Cancellation& cancellation) {
  std::vector<Outcome<LocalFile>> files(urls.size(), Outcome<LocalFile>(LocalFile()));
  std::vector<Copy> copies;
  std::vector<std::size_t> asked;  // positions in `urls`
  std::vector<Download> downloads;
  auto beside = roots.network.offline
                    ? Outcome<TemporaryDirectory>(interrupted())
                    : TemporaryDirectory::make(roots.cache / "index" / "unfinished", "index.");
  if (!roots.network.offline && !beside) {
    files.assign(urls.size(), Outcome<LocalFile>(beside.errors()));
    return files;
  }
  for (std::size_t i = 0; i < urls.size(); ++i) {
    Copy copy = copy_of(urls[i], roots);
    if (roots.network.offline || copy.absent()) {
      if (copy.present()) files[i] = LocalFile(copy.file_of(copy.state->sha256));
      continue;
    }
    if (auto made = make_directories(copy.folder); !made) {
      files[i] = std::move(made).errors();
      continue;
    }
    downloads.push_back(download_of(copy, beside->path() / std::to_string(i), roots));
    asked.push_back(i);
    copies.push_back(std::move(copy));
  }
  const auto ends = download_all(roots.network.download, downloads, cancellation);
  for (std::size_t k = 0; k < asked.size(); ++k)
    files[asked[k]] = settled(copies[k], downloads[k].file, ends[k]);
  return files;
}

void remember_absent(const std::string& url, const ChannelRoots& roots) {
  const Copy copy = copy_of(url, roots);
  // Without it the server is asked again, no more.
  if (!copy.absent()) (void)keep_state(copy, {}, {});
}

}  // namespace ros2wasm
