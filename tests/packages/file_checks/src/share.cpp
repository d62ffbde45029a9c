// What a package installed into share/, found and read as on any machine.

// Compatibility, works: share files of packages at their usual place (ament_index_cpp, AMENT_PREFIX_PATH), read with
// streams, stdio, POSIX calls and std::filesystem

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "ament_index_cpp/get_package_prefix.hpp"
#include "ament_index_cpp/get_package_share_directory.hpp"
#include "ament_index_cpp/get_packages_with_prefixes.hpp"
#include "ament_index_cpp/get_resource.hpp"
#include "ament_index_cpp/get_resources.hpp"
#include "ament_index_cpp/has_resource.hpp"
#include "checks.hpp"

namespace fs = std::filesystem;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("share");
  const std::string share = ament_index_cpp::get_package_share_directory("file_checks");
  CHECK(share == "/opt/ros/jazzy/share/file_checks");
  CHECK(ament_index_cpp::get_package_prefix("file_checks") == "/opt/ros/jazzy");
  CHECK_THROWS(ament_index_cpp::PackageNotFoundError,
               ament_index_cpp::get_package_prefix("absent_package"));
  CHECK(ament_index_cpp::get_packages_with_prefixes().count("file_checks") == 1);
  std::string content;
  CHECK(ament_index_cpp::get_resource("robots", "file_checks", content) && content == "two arms");
  CHECK(ament_index_cpp::get_resources("robots").size() == 1);
  CHECK(!ament_index_cpp::has_resource("robots", "absent_package"));

  std::ifstream gains(share + "/config/gains.yaml");
  std::string line;
  CHECK(std::getline(gains, line) && line == "gain: 2.5");
  CHECK(std::getline(gains, line) && line == "name: \"arm #1\"" && !std::getline(gains, line));
  CHECK(!std::ifstream(share + "/config/absent.yaml"));
  gains.clear();
  gains.seekg(6);
  double gain = 0;
  CHECK(gains >> gain && gain == 2.5);

  const fs::path rooms = fs::path(share) / "maps" / "rooms";
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(rooms)) {
    names.insert(entry.path().filename().string());
  }
  CHECK((names == std::set<std::string>{"empty.txt", "room 1#ä.txt"}));
  CHECK(fs::file_size(rooms / "room 1#ä.txt") == 15 && fs::is_empty(rooms / "empty.txt"));
  CHECK(fs::is_directory(rooms) && !fs::exists(rooms / "absent"));
  std::ifstream room(rooms / "room 1#ä.txt");
  CHECK(std::string(std::istreambuf_iterator<char>(room), {}) == "the first room\n");

  std::FILE* const file = std::fopen((share + "/config/gains.yaml").c_str(), "r");
  char word[6] = {};
  CHECK(file != nullptr && std::fread(word, 1, 4, file) == 4 && std::string(word) == "gain");
  CHECK(std::fseek(file, -9, SEEK_END) == 0 && std::fgets(word, 6, file) != nullptr);
  CHECK(std::string(word) == "\"arm " && std::fclose(file) == 0);

  const int fd = open((share + "/config/gains.yaml").c_str(), O_RDONLY);
  struct stat told {};
  CHECK(fd > 2 && fstat(fd, &told) == 0 && S_ISREG(told.st_mode) && told.st_size == 25);
  CHECK(lseek(fd, 0, SEEK_END) == 25 && read(fd, word, 1) == 0 && close(fd) == 0);
  CHECK(close(fd) == -1 && errno == EBADF);
  CHECK((told.st_mode & 07777) == 0644);
  CHECK(open("/opt/ros", O_WRONLY) == -1 && errno == EISDIR);
  CHECK(open("/opt/ros", O_RDONLY | O_CREAT, 0644) == -1 && errno == EISDIR);
  CHECK(open((share + "/config/gains.yaml/x").c_str(), O_RDONLY) == -1 && errno == ENOTDIR);
  CHECK(rmdir("/opt/ros") == -1 && errno == ENOTEMPTY);
  return checks.finish();
}
