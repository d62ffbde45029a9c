// See http_server.hpp. cpp-httplib is known here only; its exceptions end here.
#include "bundler/serve/http_server.hpp"

#include <httplib.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

namespace ros2wasm {
namespace {

/// Each watching page holds one for its events; a page that loads needs about six.
constexpr std::size_t kThreads = 32;
constexpr std::size_t kPieceBytes = std::size_t{64} * 1024;

HttpRequest request_of(const httplib::Request& request) {
  return HttpRequest{.method = request.method,
                     .target = request.target,
                     .header = [&request](const std::string& name) -> std::optional<std::string> {
                       if (!request.has_header(name)) return std::nullopt;
                       return request.get_header_value(name);
                     }};
}

/// Sends `length` bytes of the file, or gives up when the file is shorter than it was.
bool send_piece(const FileSlice& slice, std::size_t offset, std::size_t length,
                httplib::DataSink& sink) {
  std::array<char, kPieceBytes> piece;
  const auto count = pread(*slice.descriptor, piece.data(), std::min(length, piece.size()),
                           static_cast<off_t>(slice.offset + offset));
  return count > 0 && sink.write(piece.data(), static_cast<std::size_t>(count));
}

bool send_text(const TextStream& next, httplib::DataSink& sink) {
  if (!sink.is_writable()) return false;
  const auto text = next();
  if (!text) {
    sink.done();
    return true;
  }
  return text->empty() || sink.write(text->data(), text->size());
}

void put_response(HttpResponse&& answer, httplib::Response& response) {
  response.status = answer.status;
  for (auto& [name, value] : answer.headers) response.set_header(name, value);
  if (answer.content_type.empty()) return;
  if (const auto* text = std::get_if<std::string>(&answer.body)) {
    response.set_content(*text, answer.content_type);
  } else if (const auto* slice = std::get_if<FileSlice>(&answer.body)) {
    if (slice->length == 0) {
      response.set_content(std::string(), answer.content_type);
      return;
    }
    response.set_content_provider(
        slice->length, answer.content_type,
        [slice = *slice](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
          return send_piece(slice, offset, length, sink);
        });
  } else if (const auto* stream = std::get_if<TextStream>(&answer.body)) {
    response.set_chunked_content_provider(
        answer.content_type,
        [next = *stream](std::size_t, httplib::DataSink& sink) { return send_text(next, sink); });
  }
}

httplib::Server::HandlerResponse handle(const HttpHandler& handler, const httplib::Request& request,
                                        httplib::Response& response) {
  // The library would cut the body by itself and does not check the bounds. The request is its own
  // modifiable object; only this view of it is const.
  const_cast<httplib::Request&>(request).ranges.clear();
  put_response(handler(request_of(request)), response);
  return httplib::Server::HandlerResponse::Handled;
}

/// Why the address cannot be had, found by trying it once more without the library, which keeps the
/// reason to itself.
Diagnostic bind_error(const std::string& host, int port) {
  const std::string place = host + ":" + std::to_string(port);
  Diagnostic error{
      .code = "R2W0611", .kind = FailureKind::kEnvironment, .message = "cannot listen on " + place};
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  const int lookup = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (lookup != 0) {
    error.why.push_back(
        "`" + host + "` is not an address of this machine: " + std::string(gai_strerror(lookup)));
    error.fix.push_back("leave `--host` out, or write `--host 127.0.0.1`");
    return error;
  }
  const int probe = socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int one = 1;
  setsockopt(probe, SOL_SOCKET, SO_REUSEADDR, &one, sizeof one);
  const bool free = bind(probe, found->ai_addr, found->ai_addrlen) == 0 && listen(probe, 1) == 0;
  const int reason = free ? EADDRINUSE : errno;  // free again by now: it was in use before
  close(probe);
  freeaddrinfo(found);
  if (reason == EADDRINUSE) {
    error.code = "R2W0610";
    error.message = "port " + std::to_string(port) + " is in use";
    error.why.push_back("another program, perhaps another `ros2wasm serve`, listens on " + place);
    error.fix.push_back("add `--port 0` to take any free port");
  } else {
    error.why.push_back(std::strerror(reason));
    if (reason == EACCES) error.fix.push_back("choose a port above 1023, or add `--port 0`");
  }
  return error;
}

}  // namespace

struct HttpServer::State {
  httplib::Server server;
  std::thread thread;
  int port = 0;
};

HttpServer::HttpServer(std::unique_ptr<State> state) : state_(std::move(state)) {}
HttpServer::HttpServer(HttpServer&&) noexcept = default;
HttpServer& HttpServer::operator=(HttpServer&&) noexcept = default;

HttpServer::~HttpServer() {
  if (!state_) return;
  state_->server.stop();
  state_->thread.join();
}

Outcome<HttpServer> HttpServer::start(const std::string& host, int port, HttpHandler handler) {
  auto state = std::make_unique<State>();
  httplib::Server& server = state->server;
  server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
  // One request per connection: an idle connection would hold a thread and delay the end.
  server.set_keep_alive_max_count(1);
  server.set_tcp_nodelay(true);
  server.set_payload_max_length(std::size_t{64} * 1024);  // nothing is ever sent to this server
  // Without SO_REUSEPORT, so that a port in use is noticed.
  auto bound = std::make_shared<socket_t>(INVALID_SOCKET);
  server.set_socket_options([bound](socket_t socket) {
    const int one = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &one, sizeof one);
    *bound = socket;
  });
  server.set_pre_routing_handler(
      [handler = std::move(handler)](const httplib::Request& request, httplib::Response& response) {
        return handle(handler, request, response);
      });
  if (port == 0) {
    state->port = server.bind_to_any_port(host);
  } else {
    state->port = server.bind_to_port(host, port) ? port : -1;
  }
  if (state->port <= 0) return bind_error(host, port);
  // The library queues five connections; more at once would wait for the retries of TCP.
  ::listen(*bound, SOMAXCONN);
  state->thread = std::thread([&server] { server.listen_after_bind(); });
  // stop() does nothing before the server runs.
  while (!server.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return HttpServer(std::move(state));
}

int HttpServer::port() const {
  return state_->port;
}

}  // namespace ros2wasm
