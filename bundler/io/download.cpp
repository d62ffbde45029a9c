// See download.hpp.
#include "bundler/io/download.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <random>

#include "bundler/io/files.hpp"
#include "workspace_schema/base/secret_text.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kLongestPauseMs = 20'000;
constexpr std::size_t kMostAtOnce = 32;

Diagnostic network_error(DiagnosticCode code, std::string message, const std::string& why) {
  return Diagnostic{.code = code,
                    .kind = FailureKind::kEnvironment,
                    .message = std::move(message),
                    .why = {with_masked_secrets(why)}};
}

bool try_later(int status) {
  return status == 408 || status == 425 || status == 429 || status >= 500;
}

std::uint64_t size_of(const fs::path& file) {
  std::error_code error;
  const std::uint64_t size = fs::file_size(file, error);
  return error ? 0 : size;
}

/// Empties the file. Removed, it would be another file under the name that somebody holds the lock
/// of.
void start_over(const fs::path& file) {
  std::error_code ignored;
  fs::resize_file(file, 0, ignored);
}

/// Where one download stands.
struct Task {
  Download download;
  std::size_t source = 0;
  int attempts = 0;           ///< in a row without progress, at this source
  bool wrong_before = false;  ///< a whole file was refused at this source
  std::uint64_t size_before = 0;
  std::uint64_t furthest = 0;  ///< the most bytes of the file that there ever were
  bool running = false;
  Clock::time_point not_before;
};

}  // namespace

struct Downloader::State {
  DownloadSettings settings;
  Cancellation cancellation;
  HttpClient client;
  std::map<std::size_t, Task> tasks;
  std::mt19937 random{std::random_device{}()};
  std::uint64_t ended_bytes = 0;
  std::uint64_t total_bytes = 0;
  bool total_known = true;
  std::size_t ended_files = 0;

  State(DownloadSettings given, Cancellation stop)
      : settings(std::move(given)), cancellation(stop), client(settings.http) {}

  void start(std::size_t id, Task& task) {
    const DownloadSource& source = task.download.sources[task.source];
    if (!task.download.resume) start_over(task.download.file);
    task.size_before = size_of(task.download.file);
    // More bytes than there should be cannot be the beginning of the file.
    if (task.download.size != 0 && task.size_before >= task.download.size) {
      start_over(task.download.file);
      task.size_before = 0;
    }
    task.running = true;
    ++task.attempts;
    client.start(id, {.url = source.url,
                      .headers = task.download.headers,
                      .user_info = source.user_info,
                      .bearer = source.bearer,
                      .file = task.download.file,
                      .resume_at = task.size_before,
                      .limit_bytes = task.download.limit_bytes,
                      .asked_header = task.download.asked_header});
  }

  /// Starts what may start now; how long until the next may, or `timeout_ms`.
  int start_due(int timeout_ms) {
    const Clock::time_point now = Clock::now();
    for (auto& [id, task] : tasks) {
      if (task.running) continue;
      if (client.active() >= kMostAtOnce) break;
      if (task.not_before <= now) {
        start(id, task);
        continue;
      }
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(task.not_before - now).count() + 1;
      timeout_ms = static_cast<int>(std::min<std::int64_t>(timeout_ms, left));
    }
    return timeout_ms;
  }

  int pause_ms(int attempts) {
    const int base =
        std::min(kLongestPauseMs, settings.pause_ms << std::min(std::max(attempts - 1, 0), 8));
    return base + std::uniform_int_distribution<int>(0, std::max(base / 2, 1))(random);
  }

  /// True when the same source is asked again after a pause.
  bool again(Task& task, const TransferAnswer& answer) {
    const std::uint64_t size = size_of(task.download.file);
    if (task.download.resume && size > task.furthest) {  // else it would go on for ever
      task.furthest = size;
      task.attempts = std::min(task.attempts, 1);
    }
    const bool last = task.source + 1 == task.download.sources.size();
    if (task.attempts > (last ? settings.retries : std::min(settings.retries, 1))) return false;
    int pause = pause_ms(task.attempts);
    if (answer.retry_after_seconds) {
      if (*answer.retry_after_seconds > settings.longest_wait_s) return false;
      pause += *answer.retry_after_seconds * 1000;
    }
    task.not_before = Clock::now() + std::chrono::milliseconds(pause);
    return true;
  }

  bool next_source(Task& task) {
    if (task.source + 1 >= task.download.sources.size()) return false;
    ++task.source;
    task.attempts = 0;
    task.wrong_before = false;
    return true;
  }

  static Diagnostic failed(const Task& task, const TransferAnswer& answer) {
    const std::string at = "`" + task.download.sources[task.source].shown_url + "`";
    switch (answer.failure) {
      case HttpFailure::kUntrusted: {
        Diagnostic error = network_error(
            "R2W0235", "the certificate of the server of " + at + " is not trusted", answer.reason);
        error.why.push_back("SSL_CERT_FILE may name a file with further certificates to trust");
        return error;
      }
      case HttpFailure::kRedirects:
        return network_error("R2W0236", at + " leads to too many or to other kinds of addresses",
                             answer.reason);
      case HttpFailure::kAddress:
        return network_error("R2W0203", at + " is not an http(s) URL", answer.reason);
      case HttpFailure::kDisk:
        return cannot_write(task.download.file, answer.disk_errno);
      case HttpFailure::kTooLarge:
        return network_error(
            "R2W0220", at + " is larger than its channel says",
            "more than " + std::to_string(task.download.limit_bytes) + " bytes came");
      case HttpFailure::kTransient:
        return network_error("R2W0233", at + " could not be downloaded",
                             answer.reason + " (" + std::to_string(task.attempts) + " attempts)");
      case HttpFailure::kNone:
        break;
    }
    Diagnostic error = network_error(
        "R2W0234", "the server of " + at + " answered with status " + std::to_string(answer.status),
        answer.status == 429 ? "it says that too much is asked of it"
                             : "it does not give the file");
    if (answer.retry_after_seconds)
      error.why.push_back("it asks to come back in " + std::to_string(*answer.retry_after_seconds) +
                          " s");
    return error;
  }

  /// Some servers promise more than there is; then the connection ends too early, but nothing is
  /// missing.
  static bool is_all_there(const Download& download) {
    return download.size != 0 && size_of(download.file) == download.size && download.fault &&
           !download.fault(download.file);
  }

  /// The outcome when the download has ended, nothing when it goes on.
  std::optional<Outcome<Downloaded>> judge(Task& task, const TransferAnswer& answer) {
    const bool whole = answer.failure == HttpFailure::kNone;
    if (whole && (answer.status == 200 || answer.status == 206)) {
      auto fault = task.download.fault ? task.download.fault(task.download.file) : std::nullopt;
      if (!fault) {
        return Downloaded{.status = 200,
                          .etag = answer.etag,
                          .last_modified = answer.last_modified,
                          .asked_header = answer.asked_header};
      }
      start_over(task.download.file);
      // Once more from the beginning: what was there before may have been of another file.
      if (!std::exchange(task.wrong_before, true) || next_source(task)) return std::nullopt;
      return Outcome<Downloaded>(std::move(*fault));
    }
    if (whole && answer.status == 304)
      return Downloaded{.status = 304, .etag = answer.etag, .last_modified = answer.last_modified};
    if (whole && answer.status == 416 && task.size_before != 0) {
      start_over(task.download.file);
      if (again(task, answer)) return std::nullopt;
    }
    if (answer.failure == HttpFailure::kTransient && is_all_there(task.download)) {
      return Downloaded{.status = 200, .etag = answer.etag, .last_modified = answer.last_modified};
    }
    if (answer.failure == HttpFailure::kTransient || (whole && try_later(answer.status))) {
      if (again(task, answer)) return std::nullopt;
    }
    if (answer.failure == HttpFailure::kDisk) return Outcome<Downloaded>(failed(task, answer));
    Diagnostic error = failed(task, answer);
    const bool absent = whole && (answer.status == 404 || answer.status == 410 ||
                                  answer.status == 401 || answer.status == 403);
    if (next_source(task)) return std::nullopt;
    if (absent) return Downloaded{.status = answer.status, .etag = {}, .last_modified = {}};
    return Outcome<Downloaded>(std::move(error));
  }
};

Downloader::Downloader(DownloadSettings settings, Cancellation cancellation)
    : state_(std::make_unique<State>(std::move(settings), cancellation)) {}
Downloader::~Downloader() = default;
Downloader::Downloader(Downloader&&) noexcept = default;
Downloader& Downloader::operator=(Downloader&&) noexcept = default;

void Downloader::add(std::size_t id, Download download) {
  state_->total_bytes += download.size;
  if (download.size == 0) state_->total_known = false;
  state_->tasks.insert_or_assign(id, Task{.download = std::move(download)});
}

bool Downloader::idle() const {
  return state_->tasks.empty();
}

DownloadProgress Downloader::progress() const {
  std::uint64_t bytes = state_->ended_bytes;
  for (const auto& [id, task] : state_->tasks) {
    if (task.running) bytes += task.size_before + state_->client.arrived(id);
  }
  return {.bytes = bytes,
          .total = state_->total_known ? state_->total_bytes : 0,
          .files = state_->ended_files};
}

std::vector<Downloader::End> Downloader::wait(int timeout_ms) {
  std::vector<End> ends;
  if (state_->cancellation.requested()) {
    for (auto& [id, task] : state_->tasks) ends.push_back({.id = id, .outcome = interrupted()});
    state_->tasks.clear();
    return ends;
  }
  timeout_ms = state_->start_due(timeout_ms);
  for (const TransferAnswer& answer :
       state_->client.wait(timeout_ms, state_->cancellation.wake_fd())) {
    const auto found = state_->tasks.find(answer.id);
    if (found == state_->tasks.end()) continue;
    found->second.running = false;
    auto outcome = state_->judge(found->second, answer);
    if (!outcome) continue;
    if (*outcome && (*outcome)->status == 200) {
      state_->ended_bytes += found->second.download.size != 0
                                 ? found->second.download.size
                                 : size_of(found->second.download.file);
    }
    ++state_->ended_files;
    ends.push_back({.id = answer.id, .outcome = std::move(*outcome)});
    state_->tasks.erase(found);
  }
  return ends;
}

void Downloader::wake() {
  state_->client.wake();
}

std::vector<Outcome<Downloaded>> download_all(
    const DownloadSettings& settings, std::vector<Download> downloads,
    const Cancellation& cancellation,
    const std::function<void(const DownloadProgress&)>& progress) {
  std::vector<Outcome<Downloaded>> outcomes(downloads.size(), Outcome<Downloaded>(interrupted()));
  if (downloads.empty()) return outcomes;
  Downloader downloader(settings, cancellation);
  for (std::size_t i = 0; i < downloads.size(); ++i) downloader.add(i, std::move(downloads[i]));
  while (!downloader.idle()) {
    for (Downloader::End& end : downloader.wait(100)) outcomes[end.id] = std::move(end.outcome);
    if (progress) progress(downloader.progress());
  }
  return outcomes;
}

}  // namespace ros2wasm
