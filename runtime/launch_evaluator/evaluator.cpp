// The evaluation of launch files as a WebAssembly module: the native half's own code behind few
// functions. JSON in, JSON out (bundler/render/launch_start.hpp); of the world only what the
// functions that it imports bring.
#include <emscripten.h>

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "bundler/render/launch_start.hpp"

#define ROS2WASM_IMPORT(name) __attribute__((import_module("ros2wasm_launch"), import_name(name)))

extern "C" {

/// Both give text in room that ros2wasm_question() made, with a 0 at its end; or null.
/// Asks Python, which may call ros2wasm_reply() meanwhile.
ROS2WASM_IMPORT("python") char* ros2wasm_launch_python(const char* request, std::size_t size);
/// A file of the site.
ROS2WASM_IMPORT("file") char* ros2wasm_launch_file(const char* path, std::size_t size);

}  // extern "C"

namespace {

using Reply = std::function<std::string(const std::string&)>;

/// The last answer, until the next question.
std::string& answer() {
  static std::string text;
  return text;
}

/// The last reply, until the next one.
std::string& reply_text() {
  static std::string text;
  return text;
}

/// The reply function of the request that Python handles now.
const Reply*& current_reply() {
  static const Reply* reply = nullptr;
  return reply;
}

std::optional<std::string> taken(char* text) {
  const std::unique_ptr<char, decltype(&std::free)> held(text, &std::free);
  return held == nullptr ? std::nullopt : std::optional<std::string>(held.get());
}

ros2wasm::Outcome<std::string> ask_python(const std::string& request, const Reply& reply) {
  const Reply* before = current_reply();
  current_reply() = &reply;
  auto told = taken(ros2wasm_launch_python(request.data(), request.size()));
  current_reply() = before;
  if (told) return std::move(*told);
  return ros2wasm::Diagnostic{.code = "R2W0416",
                              .message = "Python ended while it read a launch file"};
}

ros2wasm::LaunchPlace place() {
  return {.python = ask_python, .file = [](const std::string& path) {
            return taken(ros2wasm_launch_file(path.data(), path.size()));
          }};
}

}  // namespace

extern "C" {

/// Room for so many bytes of a question; ros2wasm_evaluate() and ros2wasm_reply() free it.
EMSCRIPTEN_KEEPALIVE char* ros2wasm_question(std::size_t size) {
  return static_cast<char*>(std::calloc(size + 1, 1));
}

/// Answers a question; returns the size of the answer in bytes. The text is at ros2wasm_answer().
EMSCRIPTEN_KEEPALIVE std::size_t ros2wasm_evaluate(char* question, std::size_t size, int is_live) {
  answer() = ros2wasm::evaluate_packed_launch(std::string_view(question, size),
                                              is_live != 0 ? place() : ros2wasm::LaunchPlace{});
  std::free(question);
  return answer().size();
}

EMSCRIPTEN_KEEPALIVE const char* ros2wasm_answer() {
  return answer().data();
}

/// Replies to a question of Python; returns the size of the reply in bytes. The text is at
/// ros2wasm_reply_text().
EMSCRIPTEN_KEEPALIVE std::size_t ros2wasm_reply(char* asked, std::size_t size) {
  const std::string text(asked, size);
  std::free(asked);
  reply_text() = current_reply() == nullptr ? "{}" : (*current_reply())(text);
  return reply_text().size();
}

EMSCRIPTEN_KEEPALIVE const char* ros2wasm_reply_text() {
  return reply_text().data();
}

}  // extern "C"
