// Files that a program writes: its own, for as long as it runs.

// Compatibility, differs: files that a node writes -> live in its memory as long as it runs; no other node sees them, and
// the share files of packages are as packed again at its next start; the page gets copies of those below the node's home
// when they are closed (not more often than once a second, and at its end), and of bags. The mode of a file is kept, and
// nobody asks for it

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "checks.hpp"

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("own_files");
  CHECK(fs::current_path() == "/home/user" && std::string(std::getenv("HOME")) == "/home/user");
  CHECK(fs::temp_directory_path() == "/tmp");

  const fs::path logs = fs::path(std::getenv("HOME")) / "logs" / "today";
  CHECK(fs::create_directories(logs) && !fs::create_directory(logs));
  std::ofstream(logs / "run.csv") << "t,x\n0,1.5\n";
  std::ofstream(logs / "run.csv", std::ios::app) << "1,2.5\n";
  CHECK(text_of(logs / "run.csv") == "t,x\n0,1.5\n1,2.5\n");
  std::fstream both(logs / "run.csv", std::ios::in | std::ios::out);
  both.seekp(4);
  both << "9";
  both.close();
  CHECK(text_of(logs / "run.csv") == "t,x\n9,1.5\n1,2.5\n");

  CHECK(chdir("logs") == 0 && fs::current_path() == "/home/user/logs");
  CHECK(text_of("./today/../today/run.csv").size() == 16 && text_of("../logs//today/run.csv").size() == 16);
  fs::rename("today/run.csv", "run.csv");
  CHECK(!fs::exists("today/run.csv") && fs::file_size("run.csv") == 16);
  fs::copy_file("run.csv", "copy.csv");
  fs::resize_file("copy.csv", 3);
  CHECK(text_of("copy.csv") == "t,x" && text_of("run.csv").size() == 16);
  CHECK(fs::canonical("today/../copy.csv") == "/home/user/logs/copy.csv");
  CHECK(std::remove("copy.csv") == 0 && access("copy.csv", F_OK) == -1 && errno == ENOENT);
  CHECK(fs::remove_all("/home/user/logs") == 3 && !fs::exists("/home/user/logs"));

  for (int i = 0; i < 40; ++i) {
    std::ofstream("/tmp/many/" + std::to_string(i)) << i;
  }
  CHECK(!fs::exists("/tmp/many"));
  fs::create_directory("/tmp/many");
  for (int i = 0; i < 40; ++i) {
    std::ofstream("/tmp/many/" + std::to_string(i)) << i;
  }
  CHECK(fs::remove_all("/tmp/many") == 41 && !fs::exists("/tmp/many"));

  std::FILE* const kept = std::fopen("/tmp/kept", "w+");
  CHECK(kept != nullptr && std::remove("/tmp/kept") == 0 && std::fputs("still here", kept) >= 0);
  std::rewind(kept);
  char word[6] = {};
  CHECK(std::fgets(word, 6, kept) != nullptr && std::string(word) == "still");
  std::fclose(kept);

  const std::string block(1 << 20, 'x');
  std::ofstream large("/tmp/large", std::ios::binary);
  for (int i = 0; i < 64; ++i) {
    large << block;
  }
  large.close();
  CHECK(large.good() && fs::file_size("/tmp/large") == 64U << 20U);
  CHECK(truncate("/tmp/large", 0) == 0 && fs::file_size("/tmp/large") == 0);

  struct stat told {};
  CHECK(stat("/tmp/large", &told) == 0 && (told.st_mode & 07777) == 0644);
  const int secret = open("/tmp/secret", O_WRONLY | O_CREAT | O_EXCL, 0666);
  CHECK(secret > 2 && fstat(secret, &told) == 0 && (told.st_mode & 07777) == 0644);
  CHECK(fchmod(secret, 0600) == 0 && close(secret) == 0 && fchmod(secret, 0600) == -1 && errno == EBADF);
  CHECK(fs::status("/tmp/secret").permissions() == fs::perms(0600));
  CHECK(mkdir("/tmp/closed", 0700) == 0 && fs::status("/tmp/closed").permissions() == fs::perms(0700));
  fs::permissions("/tmp/closed", fs::perms::owner_all | fs::perms::others_read);
  CHECK(fs::status("/tmp/closed").permissions() == fs::perms(0704));
  const timespec times[2] = {{1, 0}, {1700000000, 250000000}};
  CHECK(utimensat(AT_FDCWD, "/tmp/secret", times, 0) == 0 && stat("/tmp/secret", &told) == 0);
  CHECK(told.st_mtim.tv_sec == 1700000000 && told.st_mtim.tv_nsec == 250000000);
  CHECK(utimensat(AT_FDCWD, "/tmp/absent", times, 0) == -1 && errno == ENOENT);

  CHECK(fstat(STDOUT_FILENO, &told) == 0 && S_ISCHR(told.st_mode) && (told.st_mode & 07777) == 0666);
  CHECK(fchmod(STDOUT_FILENO, 0600) == 0 && stat("/dev/stdout", &told) == 0 && (told.st_mode & 07777) == 0600);

  const int far = open("/tmp/far", O_RDWR | O_CREAT, 0644);
  CHECK(write(far, "abc", 3) == 3 && lseek(far, INT64_MAX, SEEK_SET) == -1 && errno == EINVAL);
  CHECK(lseek(far, INT64_MAX, SEEK_CUR) == -1 && write(far, "d", 1) == 1 && close(far) == 0);
  CHECK(text_of("/tmp/far") == "abcd");

  // What fails leaves all as it was.
  std::vector<int> opened;
  while (opened.empty() || opened.back() >= 0) {
    opened.push_back(open("/tmp/far", O_RDONLY));
  }
  CHECK(errno == EMFILE && opened.size() > 500);
  CHECK(open("/tmp/far", O_WRONLY | O_TRUNC) == -1 && fs::file_size("/tmp/far") == 4);
  CHECK(open("/tmp/unmade", O_WRONLY | O_CREAT, 0644) == -1 && !fs::exists("/tmp/unmade"));
  opened.pop_back();
  for (const int one : opened) {
    close(one);
  }
  CHECK(open("/tmp/unmade", O_RDONLY | O_CREAT | O_DIRECTORY, 0644) == -1 && !fs::exists("/tmp/unmade"));

  std::ofstream nothing("/dev/null");
  nothing << "gone" << std::flush;
  CHECK(nothing.good());
  CHECK(!std::ofstream("/absent/folder/file"));
  const std::string share = "/opt/ros/jazzy/share/file_checks/config/gains.yaml";
  std::ofstream(share) << "gain: 3\n";
  CHECK(text_of(share) == "gain: 3\n");
  return checks.finish();
}
