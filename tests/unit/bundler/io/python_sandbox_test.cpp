// Tests of the limits for JavaScript where Pyodide runs code of a workspace, in case that code
// escapes from Python: each test tries one way to read something of this machine, and reports the
// result.
#include "bundler/io/python_sandbox.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>

#include "bundler/run/node_js.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

/// A line each: what was tried, and `got` with what came out, or the refusal's name.
constexpr const char* kProgram = R"(
import { readFileSync, writeFileSync, readdirSync } from 'node:fs';
import { spawnSync } from 'node:child_process';
import { connect } from 'node:net';
import { createSocket } from 'node:dgram';
import { lookup } from 'node:dns/promises';
import { Worker } from 'node:worker_threads';

const [folder, secret, port] = process.argv.slice(2);
const connected = (to) => new Promise((done, fail) => {
  connect(to).once('connect', done).once('error', fail);
});
const sent = () => new Promise((done, fail) => {
  const socket = createSocket('udp4').once('error', fail);
  socket.send('hush', Number(port), '127.0.0.1', (error) => (error ? fail(error) : done()));
});
const doors = {
  own: () => readFileSync(`${folder}/program.mjs`, 'utf8').length > 0,
  file: () => readFileSync(secret, 'utf8'),
  folder: () => readdirSync('/'),
  process: () => readFileSync('/proc/self/environ', 'utf8'),
  write: () => writeFileSync(`${folder}/new`, ''),
  child: () => { const { error } = spawnSync('cat', [secret]); if (error) throw error; },
  worker: () => new Worker('', { eval: true }),
  evaluation: () => eval('1 + 1'),
  construction: () => new Function('return 1')(),
  environment: () => { if (Object.keys(process.env).length === 0) throw new Error('empty'); return process.env; },
  connection: () => connected({ host: '127.0.0.1', port: Number(port) }),
  local: () => connected({ path: `${folder}/socket` }),
  datagram: () => sent(),
  request: () => fetch(`http://127.0.0.1:${port}/`),
  name: () => lookup('localhost', 4),
};
for (const [name, door] of Object.entries(doors)) {
  try {
    console.log(name, 'got', JSON.stringify(await door()));
  } catch (error) {
    console.log(name, 'refused', (error.cause ?? error).code ?? error.message);
  }
}
process.exit(0);
)";

/// Listens on loopback and tells whether somebody came.
class Listener {
 public:
  Listener() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(fd_, reinterpret_cast<sockaddr*>(&address), size), 0);  // NOLINT
    EXPECT_EQ(::listen(fd_, 8), 0);
    EXPECT_EQ(::getsockname(fd_, reinterpret_cast<sockaddr*>(&address), &size), 0);  // NOLINT
    port_ = ntohs(address.sin_port);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  ~Listener() { ::close(fd_); }
  [[nodiscard]] std::string port() const { return std::to_string(port_); }
  [[nodiscard]] bool was_called() const {
    pollfd wait{fd_, POLLIN, 0};
    return ::poll(&wait, 1, 0) > 0;
  }

 private:
  int fd_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  int port_ = 0;
};

TEST(PythonSandbox, GivesNothingAway) {
  const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
  const auto node =
      find_node_js(ROS2WASM_SOURCE_DIR "/build/ros2wasm", path == nullptr ? "" : path, {});
  ASSERT_TRUE(node) << node.errors().front().message;
  const testing::TemporaryTree tree;
  const auto secret = tree.write("outside/id_rsa", "hush");
  const auto program = tree.write("inside/program.mjs", kProgram);
  const Listener listener;
  ::setenv("TOKEN_OF_TEST", "hush", 1);  // NOLINT(concurrency-mt-unsafe)
  ProcessRequest request = python_sandbox(
      *node, {fs::canonical(tree / "inside")},
      {program.string(), (tree / "inside").string(), secret.string(), listener.port()});
  request.time_limit = std::chrono::minutes(2);
  const auto result = run_process(request, {});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->exit_code, 0) << result->error;
  EXPECT_FALSE(listener.was_called());
  for (const char* name :
       {"file", "folder", "process", "write", "child", "worker", "evaluation", "construction",
        "environment", "connection", "local", "datagram", "request", "name"}) {
    EXPECT_NE(result->output.find("\n" + std::string(name) + " refused "), std::string::npos)
        << name << " in:\n"
        << result->output;
  }
  EXPECT_TRUE(result->output.starts_with("own got true\n")) << result->output;
  EXPECT_EQ(result->output.find("hush"), std::string::npos) << result->output;
}

}  // namespace
}  // namespace ros2wasm
