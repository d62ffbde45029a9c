// The evaluation of launch files as a WebAssembly module: the native half's own code behind two
// functions. JSON in, JSON out (bundler/launch/launch_start.hpp); no file, clock or network.
#include <emscripten.h>

#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>

#include "bundler/launch/launch_start.hpp"

namespace {

/// The last answer, until the next question.
std::string& answer() {
  static std::string text;
  return text;
}

}  // namespace

extern "C" {

/// Room for a question of so many bytes; evaluate() frees it.
EMSCRIPTEN_KEEPALIVE char* ros2wasm_question(std::size_t size) {
  return static_cast<char*>(std::malloc(size + 1));
}

/// Answers; returns how many bytes the answer has, which stands at ros2wasm_answer().
EMSCRIPTEN_KEEPALIVE std::size_t ros2wasm_evaluate(char* question, std::size_t size) {
  answer() = ros2wasm::evaluate_packed_launch(std::string_view(question, size));
  std::free(question);
  return answer().size();
}

EMSCRIPTEN_KEEPALIVE const char* ros2wasm_answer() {
  return answer().data();
}

}  // extern "C"
