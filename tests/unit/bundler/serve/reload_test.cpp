// Tests of the messages to pages in watch mode, and of the place of the script.
#include "bundler/serve/reload.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace ros2wasm {
namespace {

TEST(ReloadHub, TellsTheStateFirstAndThenEachChange) {
  ReloadHub hub;
  hub.set({.version = "1", .problems = {}});
  auto events = hub.events();
  EXPECT_EQ(events(), "data: {\"version\":\"1\",\"problems\":\"\"}\n\n");
  hub.set({.version = "1", .problems = "a \"b\"\nc"});
  EXPECT_EQ(events(), "data: {\"version\":\"1\",\"problems\":\"a \\\"b\\\"\\nc\"}\n\n");
}

TEST(ReloadHub, WakesAWaitingStream) {
  ReloadHub hub;
  auto events = hub.events();
  (void)events();
  std::thread writer([&] { hub.set({.version = "2", .problems = {}}); });
  std::string heard;
  while (heard.find("\"2\"") == std::string::npos) heard += events().value_or("ended \"2\"");
  writer.join();
  EXPECT_NE(heard.find("data: "), std::string::npos);
}

TEST(ReloadHub, EndsAllStreamsWhenClosed) {
  ReloadHub hub;
  auto events = hub.events();
  (void)events();
  hub.close();
  EXPECT_EQ(events(), std::nullopt);
  EXPECT_EQ(hub.events()(), std::nullopt);
}

TEST(WithReloadScript, GoesIntoTheHead) {
  EXPECT_EQ(with_reload_script("<html><head><title>t</title></head><body></body></html>", "7"),
            "<html><head><title>t</title><script type=\"module\" src=\".ros2wasm/reload.js?7\">"
            "</script></head><body></body></html>");
  EXPECT_EQ(with_reload_script("text", "7"),
            "<script type=\"module\" src=\".ros2wasm/reload.js?7\"></script>text");
}

TEST(WithPageHash, NamesThePageThatIsServed) {
  // printf 'page' | sha256sum, printf 'served' | sha256sum
  const std::string packed = "3660315a9af3df255d8f19ab077e4797822b41488a0e2a04bc6af71213c23274";
  const std::string served = "8fe88bf015b53b37b5fa84dc726cd93aacca97f601185be11f5fb74fa3d77802";
  EXPECT_EQ(with_page_hash("{\"sha256\":\"" + packed + "\"}", "page", "served"),
            "{\"sha256\":\"" + served + "\"}");
  EXPECT_EQ(with_page_hash("{}", "page", "served"), "{}");
}

}  // namespace
}  // namespace ros2wasm
