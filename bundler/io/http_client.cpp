// See http_client.hpp. libcurl is known here only.
#include "bundler/io/http_client.hpp"

#include <curl/curl.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <map>
#include <string_view>

namespace ros2wasm {
namespace {

constexpr long kSlowBytesPerSecond = 100;

/// libcurl's own preparation, once per process.
bool library_ready() {
  static const bool kReady = curl_global_init(CURL_GLOBAL_DEFAULT) == CURLE_OK;
  return kReady;
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// The value when the line is the header `name` (in lower case).
std::optional<std::string> header_value(std::string_view line, std::string_view name) {
  if (line.size() <= name.size() || line[name.size()] != ':') return std::nullopt;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (lower(line[i]) != name[i]) return std::nullopt;
  }
  line.remove_prefix(name.size() + 1);
  while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
  while (!line.empty() && static_cast<unsigned char>(line.back()) <= ' ') line.remove_suffix(1);
  return std::string(line);
}

/// One transfer; its address is known to libcurl until it ends.
struct Transfer {
  std::size_t id = 0;
  CURL* easy = nullptr;
  curl_slist* headers = nullptr;
  int fd = -1;
  std::filesystem::path file;
  std::uint64_t resume_at = 0;
  std::uint64_t limit_bytes = 0;
  std::string asked_header;
  std::uint64_t in_file = 0;  ///< bytes of the body in the file, older ones included
  std::uint64_t arrived = 0;
  bool body_begun = false;
  bool wrong_range = false;
  bool too_large = false;
  std::optional<std::uint64_t> range_begin;
  int disk_errno = 0;
  TransferAnswer answer;
  std::array<char, CURL_ERROR_SIZE> error{};

  Transfer() = default;
  Transfer(const Transfer&) = delete;
  Transfer& operator=(const Transfer&) = delete;
  ~Transfer() {
    if (easy != nullptr) curl_easy_cleanup(easy);
    curl_slist_free_all(headers);
    if (fd >= 0) ::close(fd);
  }

  long status() {
    long code = 0;
    curl_easy_getinfo(easy, CURLINFO_RESPONSE_CODE, &code);
    return code;
  }

  /// Opens the file where the body goes on. False: see the flags.
  bool begin_body() {
    body_begun = true;
    const bool continues = status() == 206;
    if (continues && range_begin != resume_at) {
      wrong_range = true;
      return false;
    }
    fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    in_file = continues ? resume_at : 0;
    if (fd < 0 || ::ftruncate(fd, static_cast<off_t>(in_file)) != 0 ||
        ::lseek(fd, static_cast<off_t>(in_file), SEEK_SET) < 0) {
      disk_errno = errno;
      return false;
    }
    return true;
  }

  bool take(std::string_view bytes) {
    const long code = status();
    if (code != 200 && code != 206) return true;  // the text of an error page
    if (!body_begun && !begin_body()) return false;
    if (limit_bytes != 0 && in_file + bytes.size() > limit_bytes) {
      too_large = true;
      return false;
    }
    arrived += bytes.size();
    in_file += bytes.size();
    while (!bytes.empty()) {
      const ssize_t written = ::write(fd, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) {
        disk_errno = errno;
        return false;
      }
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }

  void header(std::string_view line) {
    if (line.starts_with("HTTP/")) {  // a new answer: after a redirect
      answer.etag.clear();
      answer.last_modified.clear();
      range_begin.reset();
    } else if (auto etag = header_value(line, "etag")) {
      answer.etag = *etag;
    } else if (auto date = header_value(line, "last-modified")) {
      answer.last_modified = *date;
    } else if (auto range = header_value(line, "content-range");
               range && range->starts_with("bytes ")) {
      std::uint64_t begin = 0;
      const char* first = range->data() + std::string_view("bytes ").size();
      if (std::from_chars(first, range->data() + range->size(), begin).ec == std::errc())
        range_begin = begin;
    } else if (asked_header.empty()) {
      return;
    } else if (auto asked = header_value(line, asked_header)) {
      answer.asked_header = *asked;
    }
  }
};

std::size_t on_body(char* bytes, std::size_t, std::size_t count, void* user) {
  return static_cast<Transfer*>(user)->take({bytes, count}) ? count : CURL_WRITEFUNC_ERROR;
}

std::size_t on_header(char* bytes, std::size_t, std::size_t count, void* user) {
  static_cast<Transfer*>(user)->header({bytes, count});
  return count;
}

HttpFailure failure_of(CURLcode code, int status, const Transfer& transfer) {
  if (transfer.disk_errno != 0) return HttpFailure::kDisk;
  if (transfer.too_large) return HttpFailure::kTooLarge;
  switch (code) {
    case CURLE_OK:
      return HttpFailure::kNone;
    case CURLE_PEER_FAILED_VERIFICATION:
    case CURLE_SSL_CACERT_BADFILE:
    case CURLE_SSL_ISSUER_ERROR:
    case CURLE_SSL_INVALIDCERTSTATUS:
      return HttpFailure::kUntrusted;
    case CURLE_TOO_MANY_REDIRECTS:
      return HttpFailure::kRedirects;
    case CURLE_UNSUPPORTED_PROTOCOL:  // also said of answers that are no HTTP at all
      return status >= 300 && status < 400 ? HttpFailure::kRedirects : HttpFailure::kTransient;
    case CURLE_URL_MALFORMAT:
      return HttpFailure::kAddress;
    case CURLE_FILESIZE_EXCEEDED:
      return HttpFailure::kTooLarge;
    default:
      return HttpFailure::kTransient;
  }
}

}  // namespace

struct HttpClient::State {
  HttpSettings settings;
  CURLM* multi = nullptr;
  std::map<CURL*, std::unique_ptr<Transfer>> transfers;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    for (const auto& [easy, transfer] : transfers) curl_multi_remove_handle(multi, easy);
    transfers.clear();
    if (multi != nullptr) curl_multi_cleanup(multi);
  }

  void finish(Transfer& transfer, CURLcode code, std::vector<TransferAnswer>& answers) {
    TransferAnswer& answer = transfer.answer;
    answer.id = transfer.id;
    answer.status = static_cast<int>(transfer.status());
    // An empty body never reached take().
    if (code == CURLE_OK && answer.status == 200 && !transfer.body_begun && !transfer.begin_body())
      code = CURLE_WRITE_ERROR;
    answer.failure = failure_of(code, answer.status, transfer);
    answer.disk_errno = transfer.disk_errno;
    if (answer.failure != HttpFailure::kNone) {
      answer.reason = transfer.wrong_range ? "the server sent another part of the file than asked"
                      : transfer.error[0] != '\0' ? transfer.error.data()
                                                  : curl_easy_strerror(code);
    }
    curl_off_t seconds = 0;
    if (curl_easy_getinfo(transfer.easy, CURLINFO_RETRY_AFTER, &seconds) == CURLE_OK && seconds > 0)
      answer.retry_after_seconds = static_cast<int>(std::min<curl_off_t>(seconds, 1'000'000));
    answers.push_back(std::move(answer));
  }
};

HttpClient::HttpClient(HttpSettings settings) : state_(std::make_unique<State>()) {
  state_->settings = std::move(settings);
  if (!library_ready()) return;
  state_->multi = curl_multi_init();
  curl_multi_setopt(state_->multi, CURLMOPT_PIPELINING, CURLPIPE_MULTIPLEX);
  curl_multi_setopt(state_->multi, CURLMOPT_MAX_HOST_CONNECTIONS,
                    static_cast<long>(state_->settings.per_host));
}
HttpClient::~HttpClient() = default;
HttpClient::HttpClient(HttpClient&&) noexcept = default;
HttpClient& HttpClient::operator=(HttpClient&&) noexcept = default;

void HttpClient::start(std::size_t id, const TransferRequest& request) {
  auto transfer = std::make_unique<Transfer>();
  const HttpSettings& settings = state_->settings;
  transfer->id = id;
  transfer->file = request.file;
  transfer->resume_at = request.resume_at;
  transfer->limit_bytes = request.limit_bytes;
  transfer->asked_header = request.asked_header;
  CURL* easy = curl_easy_init();
  transfer->easy = easy;
  for (const std::string& header : request.headers)
    transfer->headers = curl_slist_append(transfer->headers, header.c_str());
  const bool secure = request.url.starts_with("https:");
  curl_easy_setopt(easy, CURLOPT_URL, request.url.c_str());
  curl_easy_setopt(easy, CURLOPT_HTTPHEADER, transfer->headers);
  curl_easy_setopt(easy, CURLOPT_USERAGENT, "ros2wasm/" ROS2WASM_VERSION);
  curl_easy_setopt(easy, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(easy, CURLOPT_REDIR_PROTOCOLS_STR, secure ? "https" : "http,https");
  curl_easy_setopt(easy, CURLOPT_FOLLOWLOCATION, 1L);
  curl_easy_setopt(easy, CURLOPT_MAXREDIRS, static_cast<long>(settings.redirects));
  curl_easy_setopt(easy, CURLOPT_HTTP_VERSION, static_cast<long>(CURL_HTTP_VERSION_2TLS));
  curl_easy_setopt(easy, CURLOPT_PIPEWAIT, secure ? 1L : 0L);
  curl_easy_setopt(easy, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(easy, CURLOPT_CONNECTTIMEOUT, static_cast<long>(settings.connect_seconds));
  curl_easy_setopt(easy, CURLOPT_LOW_SPEED_LIMIT, kSlowBytesPerSecond);
  curl_easy_setopt(easy, CURLOPT_LOW_SPEED_TIME, static_cast<long>(settings.stall_seconds));
  curl_easy_setopt(easy, CURLOPT_NETRC, static_cast<long>(CURL_NETRC_OPTIONAL));
  if (!settings.netrc_file.empty())
    curl_easy_setopt(easy, CURLOPT_NETRC_FILE, settings.netrc_file.c_str());
  if (!settings.certificates.empty())
    curl_easy_setopt(easy, CURLOPT_CAINFO, settings.certificates.c_str());
  if (!request.user_info.empty()) {
    const std::string& both = request.user_info;
    const std::size_t colon = std::min(both.find(':'), both.size());
    const auto decoded = [](const std::string& text) {
      int length = 0;
      char* bytes =
          curl_easy_unescape(nullptr, text.c_str(), static_cast<int>(text.size()), &length);
      std::string out(bytes == nullptr ? "" : bytes, static_cast<std::size_t>(length));
      curl_free(bytes);
      return out;
    };
    curl_easy_setopt(easy, CURLOPT_USERNAME, decoded(both.substr(0, colon)).c_str());
    curl_easy_setopt(easy, CURLOPT_PASSWORD,
                     decoded(colon < both.size() ? both.substr(colon + 1) : "").c_str());
  } else if (!request.bearer.empty()) {
    curl_easy_setopt(easy, CURLOPT_HTTPAUTH, static_cast<long>(CURLAUTH_BEARER));
    curl_easy_setopt(easy, CURLOPT_XOAUTH2_BEARER, request.bearer.c_str());
  }
  // Not CURLOPT_RESUME_FROM: that fails when a server sends the whole file, which is fine here.
  if (request.resume_at != 0)
    curl_easy_setopt(easy, CURLOPT_RANGE, (std::to_string(request.resume_at) + "-").c_str());
  curl_easy_setopt(easy, CURLOPT_WRITEFUNCTION, on_body);
  curl_easy_setopt(easy, CURLOPT_WRITEDATA, transfer.get());
  curl_easy_setopt(easy, CURLOPT_HEADERFUNCTION, on_header);
  curl_easy_setopt(easy, CURLOPT_HEADERDATA, transfer.get());
  curl_easy_setopt(easy, CURLOPT_ERRORBUFFER, transfer->error.data());
  curl_easy_setopt(easy, CURLOPT_BUFFERSIZE, 256L * 1024L);
  curl_multi_add_handle(state_->multi, easy);
  state_->transfers.emplace(easy, std::move(transfer));
}

std::size_t HttpClient::active() const {
  return state_->transfers.size();
}

std::uint64_t HttpClient::arrived(std::size_t id) const {
  for (const auto& [easy, transfer] : state_->transfers) {
    if (transfer->id == id) return transfer->arrived;
  }
  return 0;
}

std::vector<TransferAnswer> HttpClient::wait(int timeout_ms, int wake_fd) {
  std::vector<TransferAnswer> answers;
  const auto collect = [&] {
    int running = 0;
    curl_multi_perform(state_->multi, &running);
    int left = 0;
    while (CURLMsg* message = curl_multi_info_read(state_->multi, &left)) {
      if (message->msg != CURLMSG_DONE) continue;
      const auto found = state_->transfers.find(message->easy_handle);
      state_->finish(*found->second, message->data.result, answers);
      curl_multi_remove_handle(state_->multi, found->first);
      state_->transfers.erase(found);
    }
  };
  collect();
  if (!answers.empty()) return answers;
  curl_waitfd extra{.fd = wake_fd, .events = CURL_WAIT_POLLIN, .revents = 0};
  curl_multi_poll(state_->multi, wake_fd < 0 ? nullptr : &extra, wake_fd < 0 ? 0U : 1U, timeout_ms,
                  nullptr);
  collect();
  return answers;
}

void HttpClient::wake() {
  curl_multi_wakeup(state_->multi);
}

}  // namespace ros2wasm
