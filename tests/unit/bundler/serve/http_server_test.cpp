// Ports and addresses. What is answered is tested from outside, in tests/e2e/serve/serve.test.ts.
#include "bundler/serve/http_server.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

HttpResponse hello(const HttpRequest&) {
  return HttpResponse{
      .status = 200, .headers = {}, .content_type = "text/plain", .body = std::string("hello")};
}

TEST(HttpServer, TakesAnyFreePort) {
  const auto first = HttpServer::start("127.0.0.1", 0, hello);
  const auto second = HttpServer::start("127.0.0.1", 0, hello);
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_NE(first->port(), second->port());
  EXPECT_GT(first->port(), 0);
}

TEST(HttpServer, SaysThatAPortIsInUse) {
  const auto first = HttpServer::start("127.0.0.1", 0, hello);
  ASSERT_TRUE(first.ok());
  const auto second = HttpServer::start("127.0.0.1", first->port(), hello);
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.errors().front().code.text(), "R2W0610");
  EXPECT_EQ(second.errors().front().kind, FailureKind::kEnvironment);
}

TEST(HttpServer, FreesItsPort) {
  int port = 0;
  {
    const auto first = HttpServer::start("127.0.0.1", 0, hello);
    ASSERT_TRUE(first.ok());
    port = first->port();
  }
  EXPECT_TRUE(HttpServer::start("127.0.0.1", port, hello).ok());
}

TEST(HttpServer, SaysThatAnAddressIsNotOurs) {
  const auto server = HttpServer::start("192.0.2.1", 0, hello);
  ASSERT_FALSE(server.ok());
  EXPECT_EQ(server.errors().front().code.text(), "R2W0611");
}

}  // namespace
}  // namespace ros2wasm
