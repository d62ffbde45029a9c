// From a plan to a folder: contents of site.json, refusals, and that failures leave the old site
// untouched.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <csignal>

#include "bundler/emit/folder_output.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/plan/plan_site.hpp"
#include "bundler/plan/runtime_assets.hpp"
#include "bundler/plan/site_checks.hpp"
#include "bundler/render/page_html.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace {
using testing::TemporaryTree;

/// The smallest module; with a shared memory when `threads`.
std::string program(bool threads) {
  const std::string header("\0asm\1\0\0\0", 8);
  if (!threads) return header;
  return header + std::string("\2\x10\1\3env\6memory\2\3\1\2", 18);
}

Manifest manifest() {
  Manifest result;
  result.name.value = "lab";
  result.version = "1.0.0";
  result.license = "MIT";
  result.authors = {{.name = "Ada", .email = "", .orcid = "0000-0001", .affiliation = ""}};
  result.ui = {{"autostart", "false"}, {"theme", "dark"}};
  return result;
}

LaunchNode launched(const std::string& id, const std::string& executable) {
  return {.id = id,
          .package = "demo",
          .executable = executable,
          .label = executable,
          .program = "/built/" + executable + ".wasm",
          .arguments = {"--ros-args"},
          .source = {.file = "workspace.yaml", .line = 3, .column = 5}};
}

SitePlan plan_of(const std::string& page = "<p>") {
  const Manifest lab = manifest();
  auto plan = plan_site(
      {.manifest = lab,
       .nodes = {launched("talker-1", "talker"), launched("crowd-2", "crowd"),
                 launched("talker-3", "talker")},
       .programs = {{"/built/talker.wasm", program(false)}, {"/built/crowd.wasm", program(true)}},
       .names = {{"/built/talker.wasm", "names"}},
       .runtime = {{.file = "index.html", .role = "page", .bytes = page},
                   {.file = "headless.js", .role = "headless", .bytes = "x"},
                   {.file = "ros2.js", .role = "headless_ros2", .bytes = "x"}},
       .interfaces = {{"demo/msg/Num", "int64 num\n"}}});
  EXPECT_TRUE(plan);
  return plan ? std::move(plan).value() : SitePlan{};
}

const PlannedFile* file_of(const SitePlan& plan, const std::string& path) {
  for (const PlannedFile& file : plan.files) {
    if (file.path == path) return &file;
  }
  return nullptr;
}

TEST(EmitFolder, APlaceThatTakesNoFilesIsNotSaidToBeFull) {
  const auto done = emit_folder(plan_of(), "/proc/site", Cancellation());
  ASSERT_FALSE(done);
  EXPECT_EQ(done.errors().front().code.text(), "R2W0211");
  EXPECT_EQ(done.errors().front().message, "cannot write `/proc`");
}

TEST(SitePlan, EveryFileHasAReasonAndTheHeadlessEntryStaysOut) {
  const SitePlan plan = plan_of();
  std::vector<std::string> paths;
  for (const PlannedFile& file : plan.files) {
    paths.push_back(file.path);
    EXPECT_FALSE(file.reason.empty()) << file.path;
    EXPECT_EQ(file.sha256, sha256_hex(file.bytes));
  }
  EXPECT_EQ(paths,
            (std::vector<std::string>{"LICENSES.txt", "SHA256SUMS", "index.html", "interfaces.json",
                                      "programs/demo/crowd.wasm", "programs/demo/talker.names",
                                      "programs/demo/talker.wasm", "sbom.spdx.json", "site.json"}));
  EXPECT_EQ(plan.sha256, file_of(plan, "site.json")->sha256);
  EXPECT_NE(file_of(plan, "SHA256SUMS")->bytes.find(plan.sha256 + "  site.json\n"),
            std::string::npos);
  EXPECT_EQ(file_of(plan, "programs/demo/talker.names")->bytes, "names");
  EXPECT_EQ(names_size(plan), 5U);
  EXPECT_EQ(file_of(plan, "programs/demo/talker.wasm")->reason, "program of talker-1, talker-3");
}

TEST(SitePlan, SiteJsonSaysWhatRuns) {
  const auto json = parse_json(file_of(plan_of(), "site.json")->bytes, "site.json", "R2W0605");
  ASSERT_TRUE(json);
  EXPECT_EQ(json->find("schema")->integer(), 1);
  EXPECT_EQ(json->text_of("title"), "lab");
  const auto& nodes = json->find("nodes")->items();
  ASSERT_EQ(nodes.size(), 3U);
  EXPECT_EQ(nodes[0].text_of("program"), "programs/demo/talker.wasm");
  EXPECT_EQ(nodes[0].text_of("names"), "programs/demo/talker.names");
  EXPECT_EQ(nodes[1].find("names"), nullptr);
  EXPECT_EQ(nodes[0].find("threads")->boolean(), false);
  EXPECT_EQ(nodes[1].find("threads")->boolean(), true);
  EXPECT_EQ(nodes[0].find("source")->find("line")->integer(), 3);
  EXPECT_EQ(json->find("files")->items().size(), 7U);
  EXPECT_EQ(json->find("ui")->text_of("theme"), "dark");
  EXPECT_EQ(json->find("ui")->find("autostart")->boolean(), false);
}

TEST(SiteChecks, NodesAreNamedByIdNameOrExecutable) {
  const auto check = [](const std::string& node) {
    return CheckEntry{.span = {.file = "/lab/workspace.yaml", .line = 9, .column = 3},
                      .title = {},
                      .what = ExitCheck{.node = {.value = node, .span = {}}}};
  };
  std::vector<LaunchNode> nodes{launched("talker-1", "talker"), launched("crowd-2", "crowd"),
                                launched("crowd-3", "crowd")};
  nodes[2].label = "/robot1/crowd";
  const auto named =
      site_checks({check("talker"), check("crowd-2"), check("/robot1/crowd")}, nodes);
  ASSERT_TRUE(named);
  std::vector<std::string> ids;
  for (const CheckEntry& entry : *named) ids.push_back(std::get<ExitCheck>(entry.what).node.value);
  EXPECT_EQ(ids, (std::vector<std::string>{"talker-1", "crowd-2", "crowd-3"}));
  EXPECT_EQ(named->front().span.file, "workspace.yaml");

  nodes[2].label = "crowd";
  const auto refused = site_checks({check("talkr"), check("crowd"), check("zzz")}, nodes);
  ASSERT_FALSE(refused.ok());
  ASSERT_EQ(refused.errors().size(), 3U);
  for (const Diagnostic& error : refused.errors()) EXPECT_EQ(error.code, "R2W0430");
  EXPECT_EQ(refused.errors()[0].fix, std::vector<std::string>{"write `node: talker`"});
  EXPECT_EQ(refused.errors()[1].why, std::vector<std::string>{"they are: crowd-2, crowd-3"});
  EXPECT_TRUE(refused.errors()[2].fix.empty());
}

TEST(SitePlan, SiteJsonHasTheChecks) {
  Manifest lab = manifest();
  lab.checks = {{.span = {.file = "workspace.yaml", .line = 9, .column = 3},
                 .title = "it talks",
                 .what = LogCheck{.node = Spanned<std::string>{.value = "talker", .span = {}},
                                  .pattern = "a\\d"},
                 .within_ms = 5000}};
  const auto plan = plan_site({.manifest = lab,
                               .nodes = {launched("talker-1", "talker")},
                               .programs = {{"/built/talker.wasm", program(false)}},
                               .names = {},
                               .runtime = {},
                               .interfaces = {}});
  ASSERT_TRUE(plan);
  EXPECT_NE(
      file_of(*plan, "site.json")
          ->bytes.find(
              R"("checks":[{"title":"it talks","kind":"log","node":"talker-1","log":"a\\d",)"
              R"("within_ms":5000,"source":{"file":"workspace.yaml","line":9,"column":3}}],"ui":)"),
      std::string::npos);
  EXPECT_EQ(file_of(plan_of(), "site.json")->bytes.find("\"checks\""), std::string::npos);
  lab.checks.front().what =
      LogCheck{.node = Spanned<std::string>{.value = "nobody", .span = {}}, .pattern = "a"};
  const auto refused = plan_site({.manifest = lab,
                                  .nodes = {launched("talker-1", "talker")},
                                  .programs = {{"/built/talker.wasm", program(false)}},
                                  .names = {},
                                  .runtime = {},
                                  .interfaces = {}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.errors().front().code.text(), "R2W0430");
}

TEST(SitePlan, SiteJsonHasTheTasks) {
  Manifest lab = manifest();
  lab.tasks = {{.span = {},
                .title = {.value = "Listen", .span = {}},
                .text = "To **it**.",
                .checks = {{.span = {.file = "/lab/workspace.yaml", .line = 9, .column = 3},
                            .title = {},
                            .what = ExitCheck{.node = {.value = "talker", .span = {}}}}},
                .hint = {},
                .solution = "`ros2`"}};
  const PlanInput input{.manifest = lab,
                        .nodes = {launched("talker-1", "talker")},
                        .programs = {{"/built/talker.wasm", program(false)}},
                        .names = {},
                        .runtime = {},
                        .interfaces = {}};
  const auto plan = plan_site(input);
  ASSERT_TRUE(plan);
  EXPECT_NE(
      file_of(*plan, "site.json")
          ->bytes.find(R"("tasks":[{"title":"Listen","text":"To **it**.","solution":"`ros2`",)"
                       R"("checks":[{"kind":"exit_code","node":"talker-1","exit_code":0,)"
                       R"("source":{"file":"workspace.yaml","line":9,"column":3}}]}],"ui":)"),
      std::string::npos);
  EXPECT_EQ(file_of(plan_of(), "site.json")->bytes.find("\"tasks\""), std::string::npos);
  // The plan's input refers to the manifest.
  std::get<ExitCheck>(lab.tasks.front().checks.front().what).node.value = "nobody";
  const auto refused = plan_site(input);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.errors().front().code.text(), "R2W0430");
}

TEST(PageHtml, HasTheTitleAndHintsAndNothingUnescaped) {
  const std::string page = "<head><title>ros2wasm</title></head><body></body>";
  EXPECT_EQ(page_html(page, "A & <b>", "auto", {"programs/demo/talker.wasm"}),
            "<head><title>A &amp; &lt;b&gt;</title><link rel=\"preload\" "
            "href=\"programs/demo/talker.wasm\" "
            "as=\"fetch\" crossorigin>\n</head><body></body>");
  EXPECT_EQ(page_html("<p>", "t", "dark", {"x"}), "<p>");
  EXPECT_EQ(
      page_html("<head><meta><link></head>", "t", "auto", {"x"}),
      "<head><meta><link rel=\"preload\" href=\"x\" as=\"fetch\" crossorigin>\n<link></head>");
}

TEST(PageHtml, TheAuthorsThemeIsThereBeforeAnythingIsDrawn) {
  EXPECT_EQ(page_html("<html lang=\"en\">", "", "dark", {}),
            "<html data-theme=\"dark\" lang=\"en\">");
  EXPECT_EQ(page_html("<html>", "", "light", {}), "<html data-theme=\"light\">");
  EXPECT_EQ(page_html("<html>", "", "auto", {}), "<html>");
  EXPECT_NE(file_of(plan_of("<html>"), "index.html")->bytes.find("data-theme=\"dark\""),
            std::string::npos);
}

TEST(SitePlan, TheSameInputGivesTheSameBytes) {
  const SitePlan first = plan_of();
  const SitePlan second = plan_of();
  ASSERT_EQ(first.files.size(), second.files.size());
  for (std::size_t i = 0; i < first.files.size(); ++i)
    EXPECT_EQ(first.files[i].bytes, second.files[i].bytes);
}

TEST(SitePlan, AProgramMustBeAModule) {
  const Manifest lab = manifest();
  const auto plan = plan_site({.manifest = lab,
                               .nodes = {launched("talker-1", "talker")},
                               .programs = {{"/built/talker.wasm", "#!/bin/sh"}},
                               .runtime = {},
                               .interfaces = {}});
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.errors().front().code.text(), "R2W0606");
}

TEST(EmitFolder, WritesAndReplaces) {
  const TemporaryTree tree;
  ASSERT_TRUE(emit_folder(plan_of("<p>one"), tree / "deep/site", {}));
  EXPECT_EQ(tree.read("deep/site/index.html"), "<p>one");
  tree.write("deep/site/left-over.txt", "old");
  ASSERT_TRUE(emit_folder(plan_of("<p>two"), tree / "deep/site", {}));
  EXPECT_EQ(tree.read("deep/site/index.html"), "<p>two");
  EXPECT_FALSE(std::filesystem::exists(tree / "deep/site/left-over.txt"));
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(tree / "deep"))
    ++entries;
  EXPECT_EQ(entries, 1U) << "nothing is left beside the site";
}

TEST(EmitFolder, WritesThroughALink) {
  const TemporaryTree tree;
  std::filesystem::create_directories(tree / "www");
  std::filesystem::create_directory_symlink("www", tree / "out");
  for (const char* page : {"<p>one", "<p>two"}) {
    ASSERT_TRUE(emit_folder(plan_of(page), tree / "out", {}));
    EXPECT_EQ(tree.read("www/index.html"), page);
    EXPECT_TRUE(std::filesystem::is_symlink(tree / "out"));
  }
}

TEST(EmitFolder, RefusesWhatIsNotASite) {
  const TemporaryTree tree;
  tree.write("home/letters.txt", "dear");
  tree.write("other/site.json", "{\"generator\":\"something else 1\"}");
  tree.write("file", "x");
  std::filesystem::create_directory(tree / "empty");
  EXPECT_EQ(refuse_folder(tree / "home")->code, "R2W0601");
  EXPECT_EQ(refuse_folder(tree / "other")->code, "R2W0601");
  EXPECT_EQ(refuse_folder(tree / "file")->code, "R2W0601");
  EXPECT_FALSE(refuse_folder(tree / "empty"));
  EXPECT_FALSE(refuse_folder(tree / "new"));
  std::filesystem::create_symlink("nowhere", tree / "dangling");
  EXPECT_EQ(refuse_folder(tree / "dangling")->code, "R2W0601");
  ASSERT_FALSE(emit_folder(plan_of(), tree / "home", {}));
  EXPECT_EQ(tree.read("home/letters.txt"), "dear");
}

// Guarantee, hostile input: nothing is written outside the site, whatever names packages bring
TEST(EmitFolder, NothingIsWrittenOutsideTheSite) {
  const TemporaryTree tree;
  for (const std::string path : {"../evil", "channel/../../evil", "channel/noarch/..", ""}) {
    SitePlan plan = plan_of();
    plan.channel.push_back({.path = path, .bytes = "x", .size = 1});
    const auto emitted = emit_folder(plan, tree / "deep/site", {});
    ASSERT_FALSE(emitted) << path;
    EXPECT_EQ(emitted.errors().front().code.text(), "R2W0608");
    plan = plan_of();
    plan.files.push_back({.path = (tree / "evil").string(), .bytes = "x"});
    EXPECT_FALSE(emit_folder(plan, tree / "deep/site", {}));
  }
  EXPECT_FALSE(std::filesystem::exists(tree / "deep/evil"));
  EXPECT_FALSE(std::filesystem::exists(tree / "evil"));
  EXPECT_FALSE(std::filesystem::exists(tree / "deep/site"));
}

TEST(EmitFolder, AFailingDiskLeavesTheOldSite) {
  const TemporaryTree tree;
  ASSERT_TRUE(emit_folder(plan_of("<p>old"), tree / "site", {}));
  // Files may not grow beyond 100 bytes from here on: writing fails as it does on a full disk.
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  getrlimit(RLIMIT_FSIZE, &old_limit);
  rlimit tight = old_limit;
  tight.rlim_cur = 100;
  setrlimit(RLIMIT_FSIZE, &tight);
  const auto emitted = emit_folder(plan_of("<p>new" + std::string(5000, ' ')), tree / "site", {});
  setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);
  ASSERT_FALSE(emitted);
  EXPECT_EQ(emitted.errors().front().kind, FailureKind::kEnvironment);
  EXPECT_EQ(tree.read("site/index.html"), "<p>old");
}

TEST(EmitFolder, AnInterruptLeavesTheOldSite) {
  const TemporaryTree tree;
  ASSERT_TRUE(emit_folder(plan_of("<p>old"), tree / "site", {}));
  const std::atomic<bool> stop = true;
  const auto emitted = emit_folder(plan_of("<p>new"), tree / "site", Cancellation(stop));
  ASSERT_FALSE(emitted);
  EXPECT_EQ(emitted.errors().front().kind, FailureKind::kInterrupted);
  EXPECT_EQ(tree.read("site/index.html"), "<p>old");
}

TEST(EmitFolder, TooLittleSpaceIsSaidBeforeWriting) {
  EXPECT_FALSE(refuse_size("/site", 100, 100));
  EXPECT_EQ(refuse_size("/site", 2'790'001, 2'790'000)->why.front(),
            "the site needs 2.8 MB, the disk has 2.7 MB left");
  const auto refusal = refuse_size("/site", 3'000'000, 1'000'000);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->code, "R2W0602");
  EXPECT_EQ(refusal->why.front(), "the site needs 3.0 MB, the disk has 1.0 MB left");
}

TEST(RuntimeAssets, AreChecked) {
  const TemporaryTree tree;
  tree.write("index.html", "<p>");
  const auto list = [&](const std::string& hash) {
    return tree.write("runtime_assets.json",
                      "{\"schema\":1,\"assets\":[{\"file\":\"index.html\",\"role\":\"page\","
                      "\"size\":3,\"sha256\":\"" +
                          hash + "\"}]}");
  };
  const auto good = read_runtime_assets(list(sha256_hex("<p>")));
  ASSERT_TRUE(good);
  EXPECT_EQ(good->front().bytes, "<p>");
  const auto bad = read_runtime_assets(list(sha256_hex("other")));
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.errors().front().code.text(), "R2W0604");
  EXPECT_FALSE(read_runtime_assets(tree.write("runtime_assets.json", "{}")));
}

}  // namespace
}  // namespace ros2wasm
