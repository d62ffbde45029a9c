// A thread has the last word.
#include <cstdio>
#include <thread>

int main() {
  std::thread([] {
    std::puts("said by a thread");
    std::fflush(stdout);
  }).join();
}
