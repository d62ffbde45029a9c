// Sources from real git repositories and archives: what is fetched, cached, refused and noticed.
#include "bundler/store/source_trees.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "bundler/io/sha256.hpp"
#include "bundler/store/cache_care.hpp"
#include "unit/bundler/support/temporary_tree.hpp"
#include "workspace_schema/schema/distribution_file.hpp"
#include "workspace_schema/schema/named_source.hpp"
#include "workspace_schema/schema/repos_file.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

class SourceTrees : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(tree_ / "lab");
    roots_.working_directory = tree_ / "lab";
    roots_.cache = tree_ / "cache";
  }

  /// By a shell in `folder`, as an author would.
  void shell(const std::string& folder, const std::string& script) const {
    const std::string who =
        "export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1 GIT_AUTHOR_NAME=a "
        "GIT_AUTHOR_EMAIL=a@example.org GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@example.org "
        "GIT_ALLOW_PROTOCOL=file; unset GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE; set -e; cd '" +
        (tree_ / folder).string() + "'; ";
    ASSERT_EQ(std::system(("exec >/dev/null 2>&1; " + who + script).c_str()), 0)  // NOLINT
        << script;
  }

  /// A repository with a file, and a tag `1.0` of it.
  void make_repository(const std::string& folder) const {
    fs::create_directories(tree_ / folder);
    tree_.write(folder + "/arm/package.xml", "<package/>");
    tree_.write(folder + "/arm/run.sh", "#!/bin/sh\n");
    shell(folder,
          "chmod +x arm/run.sh; ln -s run.sh arm/start; git init -q -b main; "
          "git add -A; git commit -qm one; git tag -a -m one 1.0");
  }

  NamedSource git(const std::string& place, const std::string& revision = {}) const {
    return {.kind = SourceKind::kGit,
            .place = place,
            .revision = revision,
            .sha256 = {},
            .name = source_name(place),
            .repos = {},
            .packages = {},
            .package_places = {},
            .span = {}};
  }

  Outcome<std::vector<SourceTree>> bring(const std::vector<NamedSource>& entries,
                                         std::vector<LockedSource> locked = {},
                                         bool must_be_locked = false) const {
    return bring_source_trees(
        {.entries = entries, .locked = std::move(locked), .must_be_locked = must_be_locked}, roots_,
        limits_, {}, {});
  }

  std::string codes(const Outcome<std::vector<SourceTree>>& trees) const {
    std::string text;
    if (trees) return "none";
    for (const Diagnostic& one : trees.errors())
      text += (text.empty() ? "" : " ") + std::string(one.code);
    return text;
  }

  static std::string read(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  testing::TemporaryTree tree_;
  ChannelRoots roots_;
  ExtractLimits limits_;
};

TEST_F(SourceTrees, ATagIsFetchedOnceAndLockedByItsCommit) {
  make_repository("upstream");
  const auto first = bring({git("../upstream", "1.0")});
  ASSERT_TRUE(first.ok()) << first.errors()[0].message;
  const SourceTree& tree = first->front();
  EXPECT_TRUE(tree.is_new);
  EXPECT_EQ(tree.locked.revision, "1.0");
  EXPECT_EQ(tree.locked.commit.size(), 40U);
  EXPECT_EQ(tree.locked.tree.size(), 40U);
  EXPECT_EQ(read(tree.folder / "arm/package.xml"), "<package/>");
  EXPECT_NE(fs::status(tree.folder / "arm/run.sh").permissions() & fs::perms::owner_exec,
            fs::perms::none);
  EXPECT_EQ(fs::read_symlink(tree.folder / "arm/start"), "run.sh");
  EXPECT_FALSE(fs::exists(tree.folder / ".git"));

  // A tag that moves changes nothing while the lock has its commit; without the lock it counts.
  shell("upstream", "echo new >arm/new; git add -A; git commit -qm two; git tag -f -a -m two 1.0");
  const auto second = bring({git("../upstream", "1.0")}, {tree.locked}, true);
  ASSERT_TRUE(second.ok());
  EXPECT_FALSE(second->front().is_new);
  EXPECT_FALSE(fs::exists(second->front().folder / "arm/new"));
  const auto third = bring({git("../upstream", "1.0")});
  ASSERT_TRUE(third.ok());
  EXPECT_TRUE(fs::exists(third->front().folder / "arm/new"));
  EXPECT_NE(third->front().locked.commit, tree.locked.commit);
}

TEST_F(SourceTrees, TheDefaultBranchABranchAndACommitAreRevisions) {
  make_repository("upstream");
  shell("upstream",
        "git checkout -qb rooms/big; echo 2 >arm/rooms; git add -A; git commit -qm two; "
        "git checkout -q main");
  const auto trees = bring({git("../upstream"), git("../upstream", "rooms/big")});
  ASSERT_TRUE(trees.ok()) << trees.errors()[0].message;
  EXPECT_FALSE(fs::exists((*trees)[0].folder / "arm/rooms"));
  EXPECT_TRUE(fs::exists((*trees)[1].folder / "arm/rooms"));
  const std::string commit = (*trees)[1].locked.commit;
  fs::remove_all(roots_.cache);
  const auto again = bring({git("../upstream", commit)});
  ASSERT_TRUE(again.ok()) << again.errors()[0].message;
  EXPECT_EQ(again->front().locked.commit, commit);
  EXPECT_TRUE(fs::exists(again->front().folder / "arm/rooms"));
}

TEST_F(SourceTrees, WhatCannotBeHadIsNamed) {
  make_repository("upstream");
  auto trees = bring({git("../upstream", "1.O"), git("../nothing")});
  ASSERT_EQ(codes(trees), "R2W0252 R2W0251");
  EXPECT_EQ(trees.errors()[0].fix, std::vector<std::string>{"write `revision: 1.0`"});
  EXPECT_EQ(codes(bring({git("../upstream", std::string(40, 'a'))})), "R2W0252");
  EXPECT_EQ(codes(bring({git("../upstream", "1.0")}, {}, true)), "R2W0311");
  // A locked commit that the repository has lost is not taken from its tag.
  auto first = bring({git("../upstream", "1.0")});
  ASSERT_TRUE(first.ok());
  fs::remove_all(roots_.cache);
  shell("upstream",
        "git commit -q --amend -m other; git tag -f -a -m x 1.0; "
        "git reflog expire --expire=now --all; git gc -q --prune=now");
  trees = bring({git("../upstream", "1.0")}, {first->front().locked});
  ASSERT_EQ(codes(trees), "R2W0252");
  EXPECT_EQ(trees.errors()[0].fix, std::vector<std::string>{"ros2wasm lock --update upstream"});
}

TEST_F(SourceTrees, OfflineOnlyWhatIsHereIsTaken) {
  make_repository("upstream");
  const auto first = bring({git("file://" + (tree_ / "upstream").string(), "1.0")});
  ASSERT_TRUE(first.ok()) << first.errors()[0].message;
  LockedSource locked = first->front().locked;
  locked.git = "https://example.org/upstream.git";
  roots_.network.offline = true;
  EXPECT_TRUE(bring({git(locked.git, "1.0")}, {locked}).ok());
  EXPECT_EQ(codes(bring({git(locked.git, "1.1")})), "R2W0253");
}

// Guarantee, robust: sources in the cache whose files were changed are noticed and fetched again
TEST_F(SourceTrees, ChangedFilesOfTheCacheAreNoticed) {
  make_repository("upstream");
  const auto first = bring({git("../upstream", "1.0")});
  ASSERT_TRUE(first.ok());
  const fs::path file = first->front().folder / "arm/package.xml";
  std::ofstream(file) << "<package/>\n<!-- changed -->";
  const auto check = check_cache(roots_.cache, {});
  ASSERT_TRUE(check.ok());
  ASSERT_EQ(check->faults.size(), 1U);
  EXPECT_EQ(check->faults[0].reason, "its files are not those that were fetched");
  const auto second = bring({git("../upstream", "1.0")}, {first->front().locked});
  ASSERT_TRUE(second.ok());
  EXPECT_TRUE(second->front().is_new);
  EXPECT_EQ(read(file), "<package/>");
  EXPECT_TRUE(check_cache(roots_.cache, {})->faults.empty());
}

TEST_F(SourceTrees, ADamagedStampIsRepaired) {
  make_repository("upstream");
  const auto first = bring({git("../upstream", "1.0")});
  ASSERT_TRUE(first.ok());
  const LockedSource locked = first->front().locked;
  std::ofstream(source_place(roots_.cache, locked.commit) / ".ros2wasm-complete")
      << locked.commit << " " << std::string(40, 'b');
  EXPECT_EQ(check_cache(roots_.cache, {})->faults.size(), 1U);
  const auto second = bring({git("../upstream", locked.commit)});
  ASSERT_TRUE(second.ok());
  EXPECT_EQ(second->front().locked.tree, locked.tree);
  EXPECT_TRUE(check_cache(roots_.cache, {})->faults.empty());
  EXPECT_FALSE(bring({git("../upstream", "1.0")}, {locked})->front().is_new);
}

TEST_F(SourceTrees, CarriedFilesCountOnlyWhereASiteIsMadeOnceMore) {
  make_repository("upstream");
  const auto first = bring({git("../upstream", "1.0")});
  ASSERT_TRUE(first.ok());
  const LockedSource locked = first->front().locked;
  tree_.write("lab/ros2wasm_sources/" + locked.commit + "/arm/package.xml", "<other/>");
  EXPECT_FALSE(bring({git("../upstream", "1.0")}, {locked})->front().is_carried);
  const auto carried = bring_source_trees({.entries = {git("../upstream", "1.0")},
                                           .locked = {locked},
                                           .must_be_locked = true,
                                           .takes_carried = true},
                                          roots_, limits_, {}, {});
  ASSERT_TRUE(carried.ok());
  EXPECT_TRUE(carried->front().is_carried);
  EXPECT_EQ(read(carried->front().folder / "arm/package.xml"), "<other/>");
}

TEST_F(SourceTrees, SettingsOfASurroundingGitDoNotCount) {
  make_repository("upstream");
  for (const auto& [name, value] :
       {std::pair<const char*, const char*>{"GIT_DEFAULT_HASH", "sha256"},
        {"GIT_DIR", "/nowhere"},
        {"GIT_INDEX_FILE", "/nowhere/index"},
        {"GIT_CONFIG_COUNT", "1"}}) {
    ::setenv(name, value, 1);  // NOLINT(concurrency-mt-unsafe)
    fs::remove_all(roots_.cache);
    const auto trees = bring({git("../upstream", "1.0")});
    ::unsetenv(name);  // NOLINT(concurrency-mt-unsafe)
    ASSERT_TRUE(trees.ok()) << name << ": " << trees.errors()[0].message;
  }
}

TEST_F(SourceTrees, SubmodulesComeAtTheirCommits) {
  make_repository("parts");
  make_repository("upstream");
  shell("upstream",
        "git submodule add -q ../parts external/parts; git commit -qm sub; git tag 2.0");
  shell("parts", "echo later >arm/later; git add -A; git commit -qm later");
  const auto trees = bring({git("../upstream", "2.0")});
  ASSERT_TRUE(trees.ok()) << trees.errors()[0].message << trees.errors()[0].why[0];
  EXPECT_EQ(read(trees->front().folder / "external/parts/arm/package.xml"), "<package/>");
  EXPECT_FALSE(fs::exists(trees->front().folder / "external/parts/arm/later"));
}

// Guarantee, hostile input: git repositories of `sources:` with hooks and filters: nothing of them
// is started
TEST_F(SourceTrees, HooksAndFiltersOfTheUsersSettingsAreNotStarted) {
  make_repository("upstream");
  const std::string made = (tree_ / "started").string();
  tree_.write("upstream/.gitattributes", "* filter=start\n");
  shell("upstream", "git add -A; git commit -qm filter");
  const std::string start = "#!/bin/sh\ntouch " + made + "\n";
  for (const char* hook : {"post-checkout", "post-index-change", "reference-transaction"}) {
    tree_.write(std::string("hooks/") + hook, start);
    fs::permissions(tree_ / (std::string("hooks/") + hook), fs::perms::owner_all);
  }
  const std::string settings = "[core]\n\thooksPath = " + (tree_ / "hooks").string() +
                               "\n[filter \"start\"]\n\tsmudge = touch " + made + "; cat\n";
  tree_.write("home/.gitconfig", settings);
  const std::string home = (tree_ / "home").string();
  const char* before = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe)
  const std::string old = before == nullptr ? "" : before;
  ::setenv("HOME", home.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  // The settings do start something: git itself shows it.
  shell("upstream", "unset GIT_CONFIG_GLOBAL; git clone -q . ../control");
  EXPECT_TRUE(fs::exists(made));
  fs::remove(made);
  const auto trees = bring({git("../upstream")});
  ::setenv("HOME", old.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  ASSERT_TRUE(trees.ok()) << trees.errors()[0].message;
  EXPECT_EQ(read(trees->front().folder / "arm/package.xml"), "<package/>");
  EXPECT_FALSE(fs::exists(made));
}

TEST_F(SourceTrees, LinksOutOfARepositoryAreRemoved) {
  make_repository("upstream");
  shell("upstream",
        "ln -s /etc/passwd arm/users; ln -s ../../.. up; mkdir -p a/b/c; ln -s ../.. a/b/c/top; "
        "ln -s a/b/c/top/../.. chain; ln -s round arm/round; git add -A; git commit -qm out");
  const auto trees = bring({git("../upstream")});
  ASSERT_TRUE(trees.ok());
  EXPECT_FALSE(fs::exists(fs::symlink_status(trees->front().folder / "arm/users")));
  EXPECT_FALSE(fs::exists(fs::symlink_status(trees->front().folder / "up")));
  // Each part of the chain stays inside by its name; together they lead out.
  EXPECT_FALSE(fs::exists(fs::symlink_status(trees->front().folder / "chain")));
  EXPECT_TRUE(fs::is_symlink(trees->front().folder / "a/b/c/top"));
  EXPECT_EQ(trees->front().left_out, (std::vector<std::string>{"arm/users", "chain", "up"}));
}

TEST_F(SourceTrees, TreesBeyondTheLimitsAreRefusedBeforeTheyAreWritten) {
  make_repository("upstream");
  shell("upstream", "head -c 3000000 /dev/zero >zeros; git add -A; git commit -qm zeros");
  limits_.total_bytes = 2'000'000;
  EXPECT_EQ(codes(bring({git("../upstream")})), "R2W0254");
  limits_ = {};
  limits_.members = 2;
  EXPECT_EQ(codes(bring({git("../upstream")})), "R2W0254");
  // Also a server that sends more than that is cut off.
  limits_ = {};
  limits_.total_bytes = 100'000;
  shell("upstream", "head -c 300000 /dev/urandom >noise; git add -A; git commit -qm noise");
  EXPECT_EQ(codes(bring({git("../upstream")})), "R2W0251");
  EXPECT_FALSE(fs::exists(source_place(roots_.cache, "x").parent_path()));
}

// Guarantee, hostile input: git repositories of `sources:` with names that lead outside, links out,
// trees beyond the limits, and submodules that lead to this machine
TEST_F(SourceTrees, HostileTreesWriteNothingOutside) {
  make_repository("upstream");
  const std::string plant =
      "blob=$(echo planted | git hash-object -w --stdin); "
      "tree=$(printf '100644 blob %s\\t%s\\n' $blob NAME | git mktree --missing); "
      "commit=$(git commit-tree -m x $tree); git update-ref refs/heads/bad $commit";
  for (const std::string name : {"..", ".git", "a\\001b"}) {
    std::string script = plant;
    script.replace(script.find("NAME"), 4, "$(printf '" + name + "')");
    shell("upstream", script);
    const std::string found = codes(bring({git("../upstream", "bad")}));
    EXPECT_TRUE(found == "R2W0251" || found == "R2W0254") << name << ": " << found;
  }
}

TEST_F(SourceTrees, AddressesOfSubmodulesAreNotOptionsOfGit) {
  EXPECT_EQ(git_address_fault("ext::sh -c touch% x"),
            "an address begins with https://, http://, ssh:// or file://");
  make_repository("secret");
  make_repository("upstream");
  tree_.write("upstream/.gitmodules",
              "[submodule \"s\"]\n\tpath = s\n\turl = --upload-pack=touch\n");
  shell("upstream",
        "git update-index --add --cacheinfo 160000,$(git -C ../secret rev-parse HEAD),s; "
        "git add .gitmodules; git commit -qm sub");
  // git's own check of what comes refuses it.
  const auto trees = bring({git("../upstream")});
  ASSERT_EQ(codes(trees), "R2W0251");
  EXPECT_NE(trees.errors()[0].why[0].find("gitmodules"), std::string::npos)
      << trees.errors()[0].why[0];
}

TEST_F(SourceTrees, ArchivesAreUnpackedByTheirHash) {
  fs::create_directories(tree_ / "lab/stage/arm");
  tree_.write("lab/stage/arm/package.xml", "<package/>");
  // By Python, which has all these forms on every machine.
  for (const auto& [file, form] : {std::pair<std::string, std::string>{"a.tar.gz", "gztar"},
                                   {"a.tar.bz2", "bztar"},
                                   {"a.tar.xz", "xztar"},
                                   {"a.zip", "zip"}}) {
    shell("lab",
          "python3 -c \"import shutil; shutil.make_archive('a', '" + form + "', '.', 'stage')\"");
    NamedSource entry = git(file);
    entry.kind = SourceKind::kArchive;
    const auto first = bring({entry});
    ASSERT_TRUE(first.ok()) << file << ": " << first.errors()[0].message;
    EXPECT_EQ(read(first->front().folder / "stage/arm/package.xml"), "<package/>") << file;
    const LockedSource locked = first->front().locked;
    EXPECT_EQ(locked.sha256, hash_file(tree_ / ("lab/" + file))->sha256);
    EXPECT_TRUE(bring({entry}, {locked}, true).ok());
    entry.sha256 = std::string(64, '0');
    EXPECT_EQ(codes(bring({entry})), "R2W0220");
  }
  // Another file under the same name is not what the lock has.
  NamedSource entry = git("a.zip");
  entry.kind = SourceKind::kArchive;
  const LockedSource locked = bring({entry})->front().locked;
  shell("lab",
        "echo more >stage/more; python3 -c \"import shutil; "
        "shutil.make_archive('a', 'zip', '.', 'stage')\"");
  EXPECT_EQ(codes(bring({entry}, {locked}, true)), "R2W0311");
}

// Guarantee, hostile input: archives of `sources:` with names or links that lead outside, and pipes
TEST_F(SourceTrees, HostileArchivesWriteNothing) {
  shell("lab",
        "python3 - <<'END'\nimport io, tarfile\n"
        "def tar(name, *members):\n"
        "    with tarfile.open(name, 'w:gz') as out:\n"
        "        for path, kind, target in members:\n"
        "            one = tarfile.TarInfo(path)\n"
        "            one.type = kind\n"
        "            one.linkname = target\n"
        "            out.addfile(one, io.BytesIO(b''))\n"
        "tar('up.tar.gz', ('../out', tarfile.REGTYPE, ''))\n"
        "tar('link.tar.gz', ('a', tarfile.SYMTYPE, '/etc'), ('a/b', tarfile.REGTYPE, ''))\n"
        "tar('pipe.tar.gz', ('a', tarfile.FIFOTYPE, ''))\n"
        "END\nprintf 'not an archive' >text.tar.gz");
  const auto of = [&](const std::string& file) {
    NamedSource entry = git(file);
    entry.kind = SourceKind::kArchive;
    return codes(bring({entry}));
  };
  EXPECT_EQ(of("up.tar.gz"), "R2W0222");
  EXPECT_EQ(of("link.tar.gz"), "R2W0223");
  EXPECT_EQ(of("pipe.tar.gz"), "R2W0222");
  EXPECT_EQ(of("text.tar.gz"), "R2W0221");
  EXPECT_FALSE(fs::exists(tree_ / "cache/sources/out"));
}

TEST_F(SourceTrees, AReposFileNamesSeveral) {
  make_repository("upstream");
  tree_.write(
      "lab/course.repos",
      "repositories:\n  group/arm:\n    type: git\n    url: ../upstream\n    version: 1.0\n");
  NamedSource entry = git("course.repos");
  entry.kind = SourceKind::kRepos;
  const auto trees = bring({entry});
  ASSERT_TRUE(trees.ok()) << trees.errors()[0].message;
  EXPECT_EQ(trees->front().entry.name, "upstream");
  EXPECT_EQ(trees->front().entry.revision, "1.0");
  // Nothing but a hash becomes a name in the cache.
  const std::string climbing = "../../../../../../../../../../../../../../../../../../../../../x";
  for (const std::string bad :
       {"type: hg, url: https://example.org/a", "type: tar, url: file:///etc/a.tar, sha256: a",
        "type: tar, url: /etc/a.tar", "type: tar, url: 'https://me:secret@example.org/a.tar'"}) {
    tree_.write("lab/course.repos", "repositories:\n  a: {" + bad + "}\n");
    EXPECT_EQ(codes(bring({entry})), "R2W0250") << bad;
  }
  ASSERT_EQ(climbing.size(), 64U);
  tree_.write("lab/course.repos",
              "repositories:\n  a: {type: tar, url: 'https://example.org/a.tar', "
              "sha256: '" +
                  climbing + "'}\n");
  EXPECT_EQ(codes(bring({entry})), "R2W0250");
  tree_.write("lab/course.repos", "repositories:\n  a: {type: hg, url: https://example.org/a}\n");
  EXPECT_EQ(codes(bring({entry})), "R2W0250");
}

TEST(NamedSource, AddressesThatGitIsNotGiven) {
  for (const char* good :
       {"https://example.org/a.git", "http://127.0.0.1:80/a", "ssh://git@example.org:2222/a.git",
        "file:///srv/a", "git@example.org:group/a.git", "../a", "a"})
    EXPECT_EQ(git_address_fault(good), "") << good;
  for (const char* bad :
       {"-a", "--upload-pack=touch", "ext::sh", "git://example.org/a", "ssh://-oProxyCommand=x/a",
        "ssh://a@-oProxyCommand=x/a", "a@-o:b", "https://me:secret@example.org/a", "a\nb"})
    EXPECT_NE(git_address_fault(bad), "") << bad;
  EXPECT_EQ(reach_of("https://example.org/a.git"), Reach::kWeb);
  EXPECT_EQ(reach_of("git@example.org:a.git"), Reach::kSsh);
  EXPECT_EQ(reach_of("example.org:a.git"), Reach::kSsh);
  EXPECT_EQ(reach_of("ssh://example.org/a.git"), Reach::kSsh);
  EXPECT_EQ(reach_of("file:///a.git"), Reach::kMachine);
  EXPECT_EQ(reach_of("../a"), Reach::kMachine);
  EXPECT_EQ(file_place_fault("https://example.org/a.tar.gz"), "");
  EXPECT_EQ(file_place_fault("files/a:b.tar.gz"), "");
  for (const char* bad : {"/etc/a.tar", "~/a.tar", "file:///a.tar", "ftp://a/b.tar",
                          "https://me:secret@example.org/a.tar"})
    EXPECT_NE(file_place_fault(bad), "") << bad;
  for (const char* good : {"1.0", "main", "feature/rooms", "v2-rc1", ""})
    EXPECT_EQ(git_revision_fault(good), "") << good;
  for (const char* bad : {"--all", "a..b", "a b", "a:b", "main~1", "@{1}", "a^", "a\tb"})
    EXPECT_NE(git_revision_fault(bad), "") << bad;
  EXPECT_EQ(source_name("https://example.org/ros/navigation2.git"), "navigation2");
  EXPECT_EQ(source_name("git@example.org:arm.git/"), "arm");
  EXPECT_EQ(source_name("https://example.org/models-2.1.tar.gz"), "models-2.1");
  EXPECT_EQ(source_name("../.."), "source");
}

TEST(ReposFile, MistakesHaveTheirPlaces) {
  const auto read = read_repos_file(
      "repositories:\n"
      "  a: {type: svn, url: https://example.org/a}\n"
      "  b: {type: git}\n"
      "  c: {type: git, url: -x}\n"
      "  d: {type: tar, url: https://example.org/d.tar.gz}\n"
      "  e: {url: https://example.org/e.git}\n"
      "  f: {type: git, url: https://example.org/f.git, version: --all}\n",
      "course.repos");
  ASSERT_FALSE(read.ok());
  std::vector<std::uint32_t> lines;
  for (const Diagnostic& one : read.errors()) {
    EXPECT_EQ(one.code, "R2W0250");
    lines.push_back(one.span->line);
  }
  EXPECT_EQ(lines, (std::vector<std::uint32_t>{2, 3, 4, 5, 6, 7}));
  EXPECT_FALSE(read_repos_file("a: [", "x").ok());
  EXPECT_FALSE(read_repos_file("- a", "x").ok());
  const auto good = read_repos_file(
      "repositories:\n  x/a:\n    type: git\n    url: https://example.org/a.git\n    version: 2\n",
      "x");
  ASSERT_TRUE(good.ok());
  EXPECT_EQ(good->front().revision, "2");
}

TEST(DistributionFile, ReleasesAreReadAndOthersSkipped) {
  const auto read = read_distribution_file(
      "%YAML 1.1\n---\ntype: distribution\nversion: 2\nrepositories:\n"
      "  nav:\n    release:\n      packages: [nav_map, nav_amcl]\n"
      "      tags: {release: 'release/jazzy/{package}/{version}'}\n"
      "      url: https://example.org/nav-release.git\n      version: 1.3.7-1\n"
      "  joy:\n    release:\n      tags: {release: 'release/jazzy/{package}/{version}'}\n"
      "      url: https://example.org/joy-release.git\n      version: 3.0.0-2\n"
      "  waiting:\n    release: {tags: {release: 'a'}, url: https://example.org/w.git}\n"
      "  source_only:\n    source: {type: git, url: https://example.org/s.git}\n"
      "  hostile:\n    release:\n      packages: ['../x', y, 7]\n"
      "      tags: {release: '--upload-pack={package}'}\n"
      "      url: https://example.org/h.git\n      version: 1.0.0\n"
      "  path:\n    release:\n      tags: {release: 'a'}\n      url: ../secret\n"
      "      version: 1.0.0\n"
      "  transport:\n    release:\n      tags: {release: 'a'}\n"
      "      url: 'ext::sh -c touch'\n      version: 1.0.0\n",
      "distribution.yaml");
  ASSERT_TRUE(read.ok()) << read.errors()[0].message;
  ASSERT_EQ(read->size(), 3U);
  EXPECT_EQ(read->at("nav_amcl").tag, "release/jazzy/nav_amcl/1.3.7-1");
  EXPECT_EQ(read->at("nav_map").url, "https://example.org/nav-release.git");
  EXPECT_EQ(read->at("joy").tag, "release/jazzy/joy/3.0.0-2");
}

/// The files of today's distributions have some 900 repositories and 17,000 lines.
TEST(DistributionFile, WholeDistributionsFitTheLimits) {
  std::string text = "repositories:\n";
  for (int i = 0; i < 1500; ++i) {
    const std::string name = "repository_" + std::to_string(i);
    text += "  " + name + ":\n    doc:\n      type: git\n      url: https://example.org/" + name +
            ".git\n      version: main\n    release:\n      packages:\n";
    for (int k = 0; k < 3; ++k) text += "      - " + name + "_" + std::to_string(k) + "\n";
    text +=
        "      tags:\n        release: release/jazzy/{package}/{version}\n"
        "      url: https://example.org/" +
        name +
        "-release.git\n      version: 1.0.0-1\n"
        "    source:\n      test_pull_requests: true\n      type: git\n"
        "      url: https://example.org/" +
        name +
        ".git\n      version: main\n"
        "    status: maintained\n";
  }
  text += "type: distribution\nversion: 2\n";
  const auto read = read_distribution_file(text, "distribution.yaml");
  ASSERT_TRUE(read.ok()) << read.errors()[0].message;
  EXPECT_EQ(read->size(), 4500U);
}

TEST(DistributionFile, LongTextsAreNotCopiedForEachPackage) {
  std::string text = "type: distribution\nrepositories:\n  a:\n    release:\n      packages: [";
  for (int i = 0; i < 1000; ++i) text += "p" + std::to_string(i) + ", ";
  text += "q]\n      tags: {release: '" + std::string(100'000, 'a') +
          "'}\n      url: https://example.org/a.git\n      version: 1.0.0\n";
  const auto read = read_distribution_file(text, "x.yaml");
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE(read->empty());
}

TEST(DistributionFile, OtherFilesAreRefused) {
  for (const char* text : {"", "a: [", "- a", "type: index\nrepositories: {}\n",
                           "type: distribution\nrepositories: [a]\n"}) {
    const auto read = read_distribution_file(text, "x.yaml");
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.errors()[0].code, "R2W0256");
  }
}

}  // namespace
}  // namespace ros2wasm
