// A small HTTP/1.1 server for the local machine. The HTTP library ends in http_server.cpp; what is
// answered is decided by the handler, which knows nothing of sockets.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct HttpRequest {
  std::string method;
  std::string target;  ///< as sent: percent-encoded, with its query
  /// Looks a header up, in any letter case.
  std::function<std::optional<std::string>(const std::string& name)> header;
};

/// A part of an open file; closes it with the last copy.
struct FileSlice {
  std::shared_ptr<const int> descriptor;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

/// A response that goes on: called on its own thread until it returns nothing or the client left.
/// Must return within about a second; an empty text only asks whether the client is still there.
using TextStream = std::function<std::optional<std::string>()>;

struct HttpResponse {
  int status = 200;
  std::vector<std::pair<std::string, std::string>> headers;
  std::string content_type;  ///< empty: no body
  std::variant<std::string, FileSlice, TextStream> body;
};

/// Called on several threads at once. HEAD is answered by what GET would send, without its body.
using HttpHandler = std::function<HttpResponse(const HttpRequest&)>;

/// Listens from the moment it is made until it is destroyed.
class HttpServer {
 public:
  /// `port` 0 takes any free one. R2W0610 the port is in use, R2W0611 the address cannot be had.
  [[nodiscard]] static Outcome<HttpServer> start(const std::string& host, int port,
                                                 HttpHandler handler);
  HttpServer(HttpServer&&) noexcept;
  HttpServer& operator=(HttpServer&&) noexcept;
  ~HttpServer();

  [[nodiscard]] int port() const;

 private:
  struct State;
  explicit HttpServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace ros2wasm
