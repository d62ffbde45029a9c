// See browser_limits.hpp.
#include "bundler/build/browser_limits.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace ros2wasm {
namespace {

constexpr BrowserLimit kSockets{
    .what = "sockets",
    .instead =
        "exchange the data over topics and services; a page around the site can bring it in "
        "and out (docs/page.md, In another page)"};
constexpr BrowserLimit kProcesses{
    .what = "processes of its own",
    .instead = "make the other program a node of the launch file, or call it as a function"};
constexpr BrowserLimit kLoading{
    .what = "libraries that are loaded at run time",
    .instead =
        "link the library to the program, or load it with class_loader or pluginlib, whose "
        "libraries are linked in"};
constexpr BrowserLimit kGraphics{
    .what = "the GPU and windows",
    .instead =
        "publish what it draws as images or markers, which the page shows, and compute on "
        "the processor"};
constexpr BrowserLimit kOpenCv{
    .what = "OpenCV",
    .instead =
        "work on the bytes of sensor_msgs/msg/Image, or give the library's sources to the "
        "workspace as a package; windows are the page's image panel"};
constexpr BrowserLimit kSerial{
    .what = "serial ports",
    .instead = "let a node that simulates the device take its place, or play a bag of its data"};
constexpr BrowserLimit kDevices{
    .what = "devices of the machine",
    .instead = "let a node that simulates the device take its place, or play a bag of its data"};
constexpr BrowserLimit kShared{
    .what = "memory, queues and semaphores that processes share",
    .instead =
        "exchange the data over topics, or use std::mutex and std::condition_variable "
        "between threads"};
constexpr BrowserLimit kDescriptors{
    .what = "waiting on descriptors of Linux",
    .instead =
        "wait with timers, callbacks and guard conditions of rclcpp; poll() and select() "
        "work on standard input"};
constexpr BrowserLimit kRealTime{
    .what = "real-time scheduling and locked memory",
    .instead =
        "the calls for scheduling fail with ENOSYS, and locking memory does nothing: a "
        "browser gives no priorities, no processors of one's own and no deadlines",
    .only_fails = true};
constexpr BrowserLimit kShell{
    .what = "a shell",
    .instead =
        "system() fails with -1 and the node's console says so; make the other program a "
        "node, or write with std::ofstream what the command would write",
    .only_fails = true};

struct Row {
  std::string_view name;
  const BrowserLimit* limit;
};

// Whole names.
constexpr auto kSymbols = std::to_array<Row>({
    {"socket", &kSockets},
    {"socketpair", &kSockets},
    {"connect", &kSockets},
    {"bind", &kSockets},
    {"listen", &kSockets},
    {"accept", &kSockets},
    {"accept4", &kSockets},
    {"send", &kSockets},
    {"sendto", &kSockets},
    {"sendmsg", &kSockets},
    {"recv", &kSockets},
    {"recvfrom", &kSockets},
    {"recvmsg", &kSockets},
    {"setsockopt", &kSockets},
    {"getsockopt", &kSockets},
    {"getsockname", &kSockets},
    {"getpeername", &kSockets},
    {"shutdown", &kSockets},
    {"getaddrinfo", &kSockets},
    {"freeaddrinfo", &kSockets},
    {"getnameinfo", &kSockets},
    {"gethostbyname", &kSockets},
    {"gethostbyaddr", &kSockets},
    {"getifaddrs", &kSockets},
    {"fork", &kProcesses},
    {"vfork", &kProcesses},
    {"execl", &kProcesses},
    {"execle", &kProcesses},
    {"execlp", &kProcesses},
    {"execv", &kProcesses},
    {"execve", &kProcesses},
    {"execvp", &kProcesses},
    {"execvpe", &kProcesses},
    {"fexecve", &kProcesses},
    {"posix_spawn", &kProcesses},
    {"posix_spawnp", &kProcesses},
    {"popen", &kProcesses},
    {"pclose", &kProcesses},
    {"daemon", &kProcesses},
    {"ptrace", &kProcesses},
    {"openpty", &kProcesses},
    {"forkpty", &kProcesses},
    {"dlopen", &kLoading},
    {"dlmopen", &kLoading},
    {"dlsym", &kLoading},
    {"cfsetispeed", &kSerial},
    {"cfsetospeed", &kSerial},
    {"cfsetspeed", &kSerial},
    {"shm_open", &kShared},
    {"shm_unlink", &kShared},
    {"shmget", &kShared},
    {"shmat", &kShared},
    {"msgget", &kShared},
    {"semget", &kShared},
    {"mq_open", &kShared},
    {"sem_open", &kShared},
    {"epoll_create", &kDescriptors},
    {"epoll_create1", &kDescriptors},
    {"inotify_init", &kDescriptors},
    {"inotify_init1", &kDescriptors},
    {"eventfd", &kDescriptors},
    {"timerfd_create", &kDescriptors},
    {"signalfd", &kDescriptors},
    {"mlock", &kRealTime},
    {"mlockall", &kRealTime},
    {"sched_setscheduler", &kRealTime},
    {"sched_setparam", &kRealTime},
    {"sched_setaffinity", &kRealTime},
    {"pthread_setschedparam", &kRealTime},
    {"pthread_setaffinity_np", &kRealTime},
    {"system", &kShell},
});

// Beginnings of names that a capital letter follows, or anything where they end with `_`.
constexpr auto kFamilies = std::to_array<Row>({
    {"gl", &kGraphics},
    {"egl", &kGraphics},
    {"glut", &kGraphics},
    {"glX", &kGraphics},
    {"vk", &kGraphics},
    {"SDL_", &kGraphics},
    {"glfw", &kGraphics},
    {"XOpen", &kGraphics},
    {"cl", &kGraphics},
    {"cuda", &kGraphics},
    {"cu", &kGraphics},
    {"libusb_", &kDevices},
    {"gpiod_", &kDevices},
    {"wiringPi", &kDevices},
    {"gpio", &kDevices},
    {"snd_pcm_", &kDevices},
    {"alc", &kDevices},
});

// Headers: a whole name, or a folder when it ends with `/`.
constexpr auto kHeaders = std::to_array<Row>({
    {"boost/asio.hpp", &kSockets},
    {"boost/asio/", &kSockets},
    {"boost/beast/", &kSockets},
    {"asio.hpp", &kSockets},
    {"asio/", &kSockets},
    {"curl/", &kSockets},
    {"zmq.h", &kSockets},
    {"zmq.hpp", &kSockets},
    {"mosquitto.h", &kSockets},
    {"MQTTClient.h", &kSockets},
    {"websocketpp/", &kSockets},
    {"httplib.h", &kSockets},
    {"boost/process.hpp", &kProcesses},
    {"boost/process/", &kProcesses},
    {"boost/dll.hpp", &kLoading},
    {"boost/dll/", &kLoading},
    {"CL/", &kGraphics},
    {"OpenCL/", &kGraphics},
    {"cuda.h", &kGraphics},
    {"cuda_runtime.h", &kGraphics},
    {"cuda_runtime_api.h", &kGraphics},
    {"cublas_v2.h", &kGraphics},
    {"cudnn.h", &kGraphics},
    {"NvInfer.h", &kGraphics},
    {"vulkan/", &kGraphics},
    {"GL/", &kGraphics},
    {"GLFW/", &kGraphics},
    {"SDL.h", &kGraphics},
    {"SDL2/", &kGraphics},
    {"X11/", &kGraphics},
    {"gtk/", &kGraphics},
    {"QApplication", &kGraphics},
    {"QMainWindow", &kGraphics},
    {"QWidget", &kGraphics},
    {"QtWidgets/", &kGraphics},
    {"QtGui/", &kGraphics},
    {"opencv2/", &kOpenCv},
    {"opencv4/", &kOpenCv},
    {"serial/", &kSerial},
    {"libserial/", &kSerial},
    {"SerialStream.h", &kSerial},
    {"SerialPort.h", &kSerial},
    {"asm/termbits.h", &kSerial},
    {"linux/serial.h", &kSerial},
    {"dynamixel_sdk/", &kSerial},
    {"linux/", &kDevices},
    {"bluetooth/", &kDevices},
    {"alsa/", &kDevices},
    {"libusb-1.0/", &kDevices},
    {"libusb.h", &kDevices},
    {"gpiod.h", &kDevices},
    {"gpiod.hpp", &kDevices},
    {"pigpio.h", &kDevices},
    {"pigpiod_if2.h", &kDevices},
    {"wiringPi.h", &kDevices},
    {"wiringPiI2C.h", &kDevices},
    {"librealsense2/", &kDevices},
    {"sys/epoll.h", &kDescriptors},
    {"sys/inotify.h", &kDescriptors},
    {"sys/eventfd.h", &kDescriptors},
    {"sys/timerfd.h", &kDescriptors},
    {"sys/signalfd.h", &kDescriptors},
    {"mqueue.h", &kShared},
});

bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}

bool is_of_family(std::string_view symbol, std::string_view family) {
  if (!symbol.starts_with(family) || symbol.size() == family.size()) return false;
  return family.ends_with('_') || is_capital(symbol[family.size()]);
}

const BrowserLimit* found(std::span<const Row> rows, auto fits) {
  const auto row = std::find_if(rows.begin(), rows.end(), fits);
  return row == rows.end() ? nullptr : row->limit;
}

}  // namespace

const BrowserLimit* limit_of_symbol(std::string_view symbol) {
  if (const auto* limit = found(kSymbols, [&](const Row& row) { return row.name == symbol; }))
    return limit;
  return found(kFamilies, [&](const Row& row) { return is_of_family(symbol, row.name); });
}

const BrowserLimit* limit_of_header(std::string_view header) {
  return found(kHeaders, [&](const Row& row) {
    return row.name == header || (row.name.ends_with('/') && header.starts_with(row.name));
  });
}

std::vector<std::string> told_of_header(std::string_view header) {
  const BrowserLimit* limit = limit_of_header(header);
  if (limit == nullptr) return {};
  return {"it is for " + std::string(limit->what) + ", which no browser has",
          "instead: " + std::string(limit->instead)};
}

std::vector<std::string_view> limited_symbols() {
  std::vector<std::string_view> result;
  for (const Row& row : kSymbols) result.push_back(row.name);
  return result;
}

}  // namespace ros2wasm
