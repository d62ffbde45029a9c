// Brings files over HTTP: tries again with growing pauses, goes on where a transfer broke off,
// falls back to mirrors. What a file must be is judged by the caller's check.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bundler/io/http_client.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct DownloadSettings {
  HttpSettings http;
  int retries = 4;          ///< after the first attempt, per address, without progress in between
  int pause_ms = 400;       ///< before the second attempt; doubles, with a random part
  int longest_wait_s = 60;  ///< a Retry-After beyond that is an error
};

/// One address of a file, with what the server wants to know.
struct DownloadSource {
  std::string url;        ///< as it is asked for: may hold a token
  std::string shown_url;  ///< for messages
  std::string user_info;
  std::string bearer;
};

struct Download {
  std::vector<DownloadSource> sources;  ///< tried in this order
  std::vector<std::string> headers;
  std::filesystem::path file;
  bool resume = false;            ///< bytes that are in the file already are the beginning of it
  std::uint64_t size = 0;         ///< expected, for progress; 0: not known
  std::uint64_t limit_bytes = 0;  ///< more are refused; 0: no limit
  std::string asked_header = {};  ///< as in TransferRequest
  /// Why the whole file is not the right one; empty when it is.
  std::function<std::optional<Diagnostic>(const std::filesystem::path&)> fault;
};

/// The server's status for a file: 200 it was fetched, 304 it has not changed, 404 or 410 it does
/// not exist. 401 and 403 are returned too: some servers send them for missing files.
struct Downloaded {
  int status = 0;
  std::string etag;
  std::string last_modified;
  std::string asked_header = {};
};

struct DownloadProgress {
  std::uint64_t bytes = 0;
  std::uint64_t total = 0;  ///< 0: not known
  std::size_t files = 0;    ///< that have ended
};

/// The downloads of one step. Not for many threads, but wake() is.
class Downloader {
 public:
  Downloader(DownloadSettings settings, Cancellation cancellation);
  ~Downloader();
  Downloader(Downloader&&) noexcept;
  Downloader& operator=(Downloader&&) noexcept;

  /// `id` comes back with the end.
  void add(std::size_t id, Download download);
  [[nodiscard]] bool idle() const;
  [[nodiscard]] DownloadProgress progress() const;

  struct End {
    std::size_t id = 0;
    Outcome<Downloaded> outcome;
  };
  /// Waits for ends at most `timeout_ms`; may return none. R2W0233 no answer or a broken one,
  /// R2W0234 the server refuses, R2W0235 its certificate, R2W0236 its redirects, R2W0211 the disk,
  /// R2W0903 interrupted, and what `fault` says.
  [[nodiscard]] std::vector<End> wait(int timeout_ms);
  /// Ends a wait() at once; from any thread.
  void wake();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The simple use: all of them, in the order given.
[[nodiscard]] std::vector<Outcome<Downloaded>> download_all(
    const DownloadSettings& settings, std::vector<Download> downloads,
    const Cancellation& cancellation,
    const std::function<void(const DownloadProgress&)>& progress = {});

}  // namespace ros2wasm
