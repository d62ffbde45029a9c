// Writes files in the ways that programs of courses do: closed, kept open to the end, line by line, one in another's place.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#ifdef IN_A_THREAD
#include <thread>
#endif

namespace fs = std::filesystem;

namespace {

struct Farewell {
  ~Farewell() { std::puts("farewell"); }
} at_the_end;

void write_all() {
  fs::create_directories("logs");
  // Nobody closes it.
  std::FILE* const kept_open = std::fopen("logs/kept_open.csv", "w");
  std::fputs("time,x\r\n", kept_open);
  for (int count = 0; count < 500; ++count) {
    std::ofstream("often.csv", std::ios::app) << count << '\n';
  }
  std::ofstream("/home/user/map.pgm", std::ios::binary) << "P5 1 1 255\n\x7f";
  std::ofstream("poses.new") << "at home";
  fs::rename("poses.new", "poses.txt");
  for (const char* elsewhere : {"/tmp/elsewhere.txt", ".hidden", "other.mcap"}) {
    std::ofstream(elsewhere) << "nobody sees it";
  }
  std::ofstream gone("gone.txt");
  gone << "nobody sees it";
  fs::remove("gone.txt");
  gone.close();
  std::ofstream("read_later.txt") << "not yet";
  std::ofstream("read_later.txt", std::ios::app) << ", but now";
  std::ifstream("often.csv").get();
  std::ofstream large("large.bin", std::ios::binary);
  const std::string part(1 << 20, '\0');
  for (int i = 0; i < 65; ++i) {
    large << part;
  }
  large.close();
}

}  // namespace

int main() {
#ifdef IN_A_THREAD
  // It waits for ever: that keeps nobody from ending.
  std::thread([] { std::getchar(); }).detach();
  std::thread(write_all).join();
#else
  write_all();
#endif
  std::puts("written");
}
