// Content types that browsers insist on: modules, wasm, the manifest of an installable page.
#include "bundler/serve/mime_types.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

TEST(MimeTypes, KnowTheFilesOfASite) {
  EXPECT_EQ(mime_type("index.html"), "text/html; charset=utf-8");
  EXPECT_EQ(mime_type("main.js"), "text/javascript; charset=utf-8");
  EXPECT_EQ(mime_type("worker.mjs"), "text/javascript; charset=utf-8");
  EXPECT_EQ(mime_type("styles.css"), "text/css; charset=utf-8");
  EXPECT_EQ(mime_type("site.json"), "application/json");
  EXPECT_EQ(mime_type("main.js.map"), "application/json");
  EXPECT_EQ(mime_type("talker.wasm"), "application/wasm");
  EXPECT_EQ(mime_type("icon.svg"), "image/svg+xml");
  EXPECT_EQ(mime_type("app.webmanifest"), "application/manifest+json");
  EXPECT_EQ(mime_type("source.zip"), "application/zip");
  EXPECT_EQ(mime_type("README.md"), "text/markdown; charset=utf-8");
}

TEST(MimeTypes, TakeTheLastEndingInAnyLetterCase) {
  EXPECT_EQ(mime_type("PHOTO.JPG"), "image/jpeg");
  EXPECT_EQ(mime_type("a.html.wasm"), "application/wasm");
}

TEST(MimeTypes, CallTheRestBytes) {
  EXPECT_EQ(mime_type("LICENSE"), "application/octet-stream");
  EXPECT_EQ(mime_type("data."), "application/octet-stream");
  EXPECT_EQ(mime_type("data.xyz"), "application/octet-stream");
}

}  // namespace
}  // namespace ros2wasm
