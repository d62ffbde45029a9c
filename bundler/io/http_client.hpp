// Transfers over HTTP and HTTPS, many at once. libcurl ends in http_client.cpp. One attempt each:
// whether to try again is decided in download.cpp. Certificates are always checked.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ros2wasm {

struct HttpSettings {
  int connect_seconds = 20;
  int stall_seconds = 30;  ///< a transfer that is slower than 100 bytes/s for so long has failed
  int per_host = 6;        ///< connections; one of HTTP/2 carries many transfers
  int redirects = 10;
  std::string netrc_file;    ///< empty: ~/.netrc
  std::string certificates;  ///< a PEM file of trusted ones; empty: those of the system
};

struct TransferRequest {
  std::string url;
  std::vector<std::string> headers;  ///< "If-None-Match: x"
  std::string user_info;             ///< "user:password" as an address has it; empty: from netrc
  std::string bearer;                ///< token of an Authorization header
  std::filesystem::path file;        ///< gets the body of a 200 or 206
  std::uint64_t resume_at = 0;       ///< the file has so many bytes already: ask for the rest only
  std::uint64_t limit_bytes = 0;     ///< of the file; 0: none
  std::string asked_header;          ///< in lower case: TransferAnswer has its value; empty: none
};

enum class HttpFailure {
  kNone,       ///< `status` and the body are whole
  kTransient,  ///< no connection, reset, too slow, too short: another attempt may succeed
  kUntrusted,  ///< the server's certificate
  kRedirects,  ///< too many, or away from HTTP(S), or from HTTPS to HTTP
  kTooLarge,   ///< more than `limit_bytes`
  kDisk,       ///< the file cannot be written
  kAddress,    ///< the address makes no sense
};

struct TransferAnswer {
  std::size_t id = 0;
  int status = 0;
  HttpFailure failure = HttpFailure::kNone;
  std::string reason;  ///< of a failure, one line
  std::string etag;
  std::string last_modified;
  std::string asked_header;  ///< of the last answer that had it, redirects included
  std::optional<int> retry_after_seconds;
  int disk_errno = 0;
};

class HttpClient {
 public:
  explicit HttpClient(HttpSettings settings);
  ~HttpClient();
  HttpClient(HttpClient&&) noexcept;
  HttpClient& operator=(HttpClient&&) noexcept;

  /// `id` comes back with the answer.
  void start(std::size_t id, const TransferRequest& request);
  [[nodiscard]] std::size_t active() const;
  /// Bytes that arrived for the transfer of this id so far, this attempt.
  [[nodiscard]] std::uint64_t arrived(std::size_t id) const;
  /// Waits until a transfer ends, wake() is called, `wake_fd` can be read (-1: none), or
  /// `timeout_ms` are over.
  [[nodiscard]] std::vector<TransferAnswer> wait(int timeout_ms, int wake_fd);
  /// Ends a wait() at once; from any thread.
  void wake();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ros2wasm
