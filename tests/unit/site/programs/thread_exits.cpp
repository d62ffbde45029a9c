// A thread ends the whole program; another throws when it is told to.
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

int main(int argc, char** argv) {
  const bool throws = argc > 1 && std::strcmp(argv[1], "throw") == 0;
  std::thread([throws] {
    if (throws) throw std::runtime_error("from a thread");
    std::exit(5);
  }).join();
}
