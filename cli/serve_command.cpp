// `ros2wasm serve SITE`: the site on this machine, with the headers that a good host sends; with
// --watch, packed again and reloaded when its workspace changes.
#include <poll.h>

#include <memory>

#include "bundler/io/files.hpp"
#include "bundler/serve/request_rules.hpp"
#include "bundler/serve/site_responder.hpp"
#include "bundler/site/site_list.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/interrupt.hpp"
#include "cli/watched_pack.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr int kUsualPort =
    8000;  // always the same, so that the browser keeps what it knows of a site

struct Options {
  std::string site;
  std::optional<int> port;
  std::string host = "127.0.0.1";
  bool no_isolation = false;
  std::optional<std::string> watch;
};

std::string link_to(const std::string& host, int port) {
  const bool any = host == "0.0.0.0" || host == "::";
  const std::string name = any ? "localhost" : host;
  const bool literal6 = name.find(':') != std::string::npos;
  return "http://" + (literal6 ? "[" + name + "]" : name) + ":" + std::to_string(port) + "/";
}

/// Returns after this time (-1: never), or when the program should end.
void wait_for_stop(const Cancellation& cancellation, int timeout_ms) {
  pollfd wake{.fd = cancellation.wake_fd(), .events = POLLIN, .revents = 0};
  poll(&wake, 1, timeout_ms);
}

void say_what_is_served(Context& context, const Options& options, int port,
                        const std::string& site) {
  Console& console = context.console;
  const std::string link = link_to(options.host, port) + site;
  console.result(link);
  console.remark("Serving " + options.site + ". Open the link; Ctrl-C ends the server.");
  if (options.no_isolation)
    console.remark("Without the isolation headers, as on a host that cannot send them.");
  if (!is_loopback(options.host))
    console.remark("Other machines can reach it too, because of --host " + options.host + ".");
}

/// The usual port is a wish, a port that was asked for is not.
Outcome<HttpServer> start_server(const Options& options, const HttpHandler& handler) {
  if (options.port) return HttpServer::start(options.host, *options.port, handler);
  auto usual = HttpServer::start(options.host, kUsualPort, handler);
  if (usual || usual.errors().front().code != "R2W0610") return usual;
  return HttpServer::start(options.host, 0, handler);
}

int serve(Context& context, const Options& options) {
  std::optional<WatchedPack> watched;
  int failure = 0;
  if (options.watch) {
    // Packed first, so that the site is of the workspace as it is.
    watched.emplace(context, *options.watch, options.site);
    failure = watched->pack_now();
    if (context.cancellation.requested()) return static_cast<int>(FailureKind::kInterrupted);
    context.console.remark("Watching " + *options.watch + " for changes.");
  }
  if (const auto site = check_site(options.site, CourseToo::kYes); !site)
    return failure != 0 ? failure : context.console.fail(site.errors());
  std::error_code error;
  const fs::path folder = fs::absolute(options.site, error);
  if (error) return context.console.fail(cannot_read(options.site, error.value()));
  const ServedPlace place = served_place(folder);
  if (place.warning) context.console.report(*place.warning);
  SiteServing serving{.place = place,
                      .isolation = !options.no_isolation,
                      .only_local_hosts = is_loopback(options.host),
                      .reload = std::nullopt};
  if (watched) serving.reload = watched->pages();
  const auto server = start_server(
      options, [serving](const HttpRequest& request) { return site_response(serving, request); });
  if (!server) return context.console.fail(server.errors());
  say_what_is_served(context, options, server->port(), percent_encoded(place.address));
  while (!context.cancellation.requested()) {
    wait_for_stop(context.cancellation, watched ? watched->interval_ms() : -1);
    if (watched && !context.cancellation.requested()) watched->look();
  }
  if (watched) watched->close();
  return asked_to_end() ? 0 : static_cast<int>(FailureKind::kInterrupted);
}

}  // namespace

CommandBody serve_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.required("SITE", options->site, "the folder that `ros2wasm pack` wrote");
  arguments.number("-p,--port", options->port, "N", 0, 65535,
                   "0 takes any free port [8000, or any when that is in use]");
  arguments.value("--host", options->host, "ADDRESS", "0.0.0.0 lets other machines in [127.0.0.1]");
  arguments.flag("--no-isolation", options->no_isolation,
                 "leave out COOP and COEP, as hosts do that cannot send headers");
  arguments.value("--watch", options->watch, "WORKSPACE",
                  "pack this workspace to SITE, and again when it changes; pages reload");
  arguments.examples({"ros2wasm serve site", "ros2wasm serve site --port 0",
                      "ros2wasm serve site --watch workspace.yaml"});
  return [options](Context& context) { return serve(context, *options); };
}

}  // namespace ros2wasm
