// Threads of one program share its files.

// Compatibility, works: threads of a program see the same files

#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "checks.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("threads_write");
  std::ofstream opened_here("/tmp/opened_here");
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([i] { std::ofstream("/tmp/" + std::to_string(i)) << std::string(100000, '.'); });
  }
  threads.emplace_back([&opened_here] { opened_here << "written there" << std::flush; });
  std::string gain;
  threads.emplace_back([&gain] {
    std::ifstream file("/opt/ros/jazzy/share/file_checks/config/gains.yaml");
    std::getline(file, gain);
  });
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (int i = 0; i < 3; ++i) {
    CHECK(std::filesystem::file_size("/tmp/" + std::to_string(i)) == 100000);
  }
  std::ifstream written("/tmp/opened_here");
  CHECK(std::string(std::istreambuf_iterator<char>(written), {}) == "written there");
  CHECK(gain == "gain: 2.5");
  return checks.finish();
}
