// Tests of the limits of browsers that the linker's trace of a program shows.
#include "bundler/build/link_trace.hpp"

#include <gtest/gtest.h>

#include "bundler/build/browser_limits.hpp"

namespace ros2wasm {
namespace {

const std::string kLibc = "/em/cache/sysroot/lib/wasm32-emscripten/libc.a";

LinkTrace trace(const std::string& lines) {
  return read_link_trace(lines);
}

Diagnostics findings(const LinkTrace& trace, const std::vector<std::string>& undefined = {}) {
  return limit_findings({.shown = "`udp` of package `net`",
                         .trace = trace,
                         .undefined = undefined,
                         .channel_prefix = "/cache/env"});
}

TEST(LinkTrace, TellsWhichSourcesRefer) {
  const auto found =
      findings(trace("CMakeFiles/udp.dir/src/udp.cpp.o: reference to socket\n"
                     "CMakeFiles/udp.dir/src/udp.cpp.o: reference to connect\n"
                     "libnet.a(lookup.cpp.o): reference to connect\n" +
                     kLibc + "(socket.o): definition of socket\n"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "R2W0523");
  EXPECT_EQ(found[0].severity, Severity::kError);
  EXPECT_EQ(found[0].message, "`udp` of package `net` needs sockets, which no browser has");
  EXPECT_EQ(found[0].why[0], "lookup.cpp of libnet.a refers to `connect`");
  EXPECT_EQ(found[0].why[1], "src/udp.cpp refers to `connect`, `socket`");
  EXPECT_EQ(need_of(found[0]), "sockets (lookup.cpp of libnet.a refers to `connect`)");
  const Diagnostic left_out = left_out_for_limit(found[0]);
  EXPECT_EQ(left_out.severity, Severity::kWarning);
  EXPECT_EQ(left_out.message,
            "`udp` of package `net` is skipped: it needs sockets, which no browser has");
}

TEST(LinkTrace, WhatOthersReferToCountsForNothing) {
  EXPECT_TRUE(findings(trace(kLibc + "(res_send.o): reference to socket\n"
                                     "/cache/env/lib/libthird.a(x.o): reference to dlopen\n"))
                  .empty());
  // A function of the program's own that has such a name.
  EXPECT_TRUE(findings(trace("a.dir/main.cpp.o: reference to connect\n"
                             "a.dir/board.c.o: definition of connect\n"))
                  .empty());
  // The same in a library of the workspace is the user's.
  EXPECT_EQ(findings(trace("/cache/built/net-1/lib/libnet.a(x.o): reference to dlopen\n")).size(),
            1U);
}

TEST(LinkTrace, CallsThatOnlyFailAreWarningsUnlessNothingDefinesThem) {
  const auto real_time = trace("rt.dir/rt.cpp.o: reference to mlockall\n");
  EXPECT_EQ(findings(real_time).at(0).code, "R2W0524");
  EXPECT_EQ(findings(real_time).at(0).severity, Severity::kWarning);
  EXPECT_EQ(findings(real_time, {"mlockall"}).at(0).code, "R2W0523");
}

TEST(LinkTrace, NamesWhatNothingDefinesToo) {
  const auto found = findings(trace("gl.dir/gl.cpp.o: reference to glClear\n"),
                              {"glClear", "_ZN3far4awayEi", "glossary"});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].label, "the GPU and windows");
}

TEST(LinkTrace, IsNoPartOfWhatTheLinkerSays) {
  EXPECT_EQ(without_trace("a.o: reference to fork\nwasm-ld: error: no\n" + kLibc +
                          ": lazy definition of fork\n"),
            "wasm-ld: error: no\n");
}

TEST(BrowserLimits, KnowSymbolsAndHeaders) {
  for (const std::string symbol : {"socket", "fork", "dlopen", "glDrawArrays", "eglGetDisplay",
                                   "cudaMalloc", "clCreateContext", "SDL_Init", "libusb_open",
                                   "cfsetispeed", "shm_open", "epoll_create1", "gpioInitialise"})
    EXPECT_NE(limit_of_symbol(symbol), nullptr) << symbol;
  for (const std::string symbol : {"tcsetattr", "poll", "select", "mmap", "open", "globbing",
                                   "clock_gettime", "close", "cube", "eglantine", "SDL"})
    EXPECT_EQ(limit_of_symbol(symbol), nullptr) << symbol;
  for (const std::string header : {"boost/asio/ip/tcp.hpp", "CL/cl.h", "cuda_runtime.h",
                                   "opencv2/highgui.hpp", "linux/i2c-dev.h", "sys/epoll.h"}) {
    ASSERT_NE(limit_of_header(header), nullptr) << header;
    EXPECT_EQ(told_of_header(header).size(), 2U);
  }
  EXPECT_EQ(limit_of_header("webthing/server.h"), nullptr);
  EXPECT_TRUE(told_of_header("vector").empty());
}

}  // namespace
}  // namespace ros2wasm
