// See import_hints.hpp.
#include "bundler/launch/host/import_hints.hpp"

#include <algorithm>
#include <array>

namespace ros2wasm {
namespace {

struct Hint {
  std::string_view module;
  std::string_view why;
};

constexpr std::string_view kHardware = "a browser reaches no hardware of this kind";
constexpr std::string_view kKeys =
    "a page gives nodes no keys of the machine: a node reads its standard input, which the page's "
    "console writes, or a topic of the page's teleoperation panel";
constexpr std::string_view kNoWindows = "a node has no window: its output is its console";
constexpr std::string_view kNoTkinter =
    "a node has no window: a page shows pictures of `cv2.imshow`, `matplotlib.pyplot` and "
    "`PIL.Image.show` in panels, and parameters of nodes are set in the panel Parameters";
constexpr std::string_view kNoWidgets =
    "a node has no window: what it shows goes to a topic, which the page's panels show, and what "
    "it asks for is a parameter, a topic or its standard input";
constexpr std::string_view kCompiled =
    "it is compiled code, which has no build for the Python of sites; numpy is there, for what "
    "can be done by hand";
constexpr std::string_view kNoSockets =
    "a page has no sockets: it is not a server, and nodes of a site reach each other by topics and "
    "services";
constexpr std::string_view kNoRequests =
    "a page has no sockets, and nothing leaves it: what a node reads can be a file of its package "
    "(`data_files` of setup.py), found by `ament_index_python`";
constexpr std::string_view kLaunch =
    "launch files are read when the site is packed (`launch:` of workspace.yaml); a node starts no "
    "others";
constexpr std::string_view kCommands =
    "the commands of `ros2` are the page's terminal; a node asks the graph by `rclpy` "
    "(`get_topic_names_and_types()`), and for types `rosidl_runtime_py.utilities`";
constexpr std::string_view kRos1 =
    "it is of ROS 1; in ROS 2 nodes import `rclpy`, and for transforms `tf2_ros`";
constexpr std::string_view kKdl =
    "Orocos KDL is compiled code, which has no build for the Python of sites; frames are "
    "transformed by `tf2_geometry_msgs`, turns by `tf_transformations` or `transforms3d`";

/// Modules that people import and that no site can have.
constexpr auto kHints = std::to_array<Hint>({
    {"Adafruit_GPIO", kHardware},
    {"Adafruit_PCA9685", kHardware},
    {"PyKDL", kKdl},
    {"PyQt5", kNoWidgets},
    {"PyQt6", kNoWidgets},
    {"PySide2", kNoWidgets},
    {"PySide6", kNoWidgets},
    {"PySimpleGUI", kNoWidgets},
    {"RPi", kHardware},
    {"aiohttp", kNoRequests},
    {"busio", kHardware},
    {"curses",
     "a node's console has no cursor that could be moved; `termios`, `tty` and `select` read "
     "single keys, and what is printed is shown line by line"},
    {"dynamixel_sdk", kHardware},
    {"evdev", kHardware},
    {"face_recognition", kCompiled},
    {"fastapi", kNoSockets},
    {"flask", kNoSockets},
    {"gpiozero", kHardware},
    {"httpx", kNoRequests},
    {"keyboard", kKeys},
    {"launch", kLaunch},
    {"launch_ros", kLaunch},
    {"mediapipe", kCompiled},
    {"numba",
     "it compiles at run time, which Python in a browser cannot do; the functions run "
     "without its decorators, in numpy where they are vectorised"},
    {"open3d", kCompiled},
    {"paho", kNoSockets},
    {"psutil", "a browser tells nothing of the machine's processes, memory and load"},
    {"pygame", kNoWindows},
    {"pymavlink", kNoSockets},
    {"pynput", kKeys},
    {"pyrealsense2", kHardware},
    {"python_qt_binding", kNoWidgets},
    {"qt_gui", kNoWidgets},
    {"quaternion",
     "numpy-quaternion is compiled code, which has no build for the Python of sites; "
     "`tf_transformations` and `transforms3d` turn with quaternions"},
    {"requests", kNoRequests},
    {"ros2action", kCommands},
    {"ros2cli", kCommands},
    {"ros2interface", kCommands},
    {"ros2node", kCommands},
    {"ros2param", kCommands},
    {"ros2pkg", kCommands},
    {"ros2run", kCommands},
    {"ros2service", kCommands},
    {"ros2topic", kCommands},
    {"rosidl_parser",
     "it reads what rosidl's generators write, which no site has; the types of a site are classes "
     "(`rosidl_runtime_py.utilities.get_message`) that tell their fields"},
    {"roslib", kRos1},
    {"rospy", kRos1},
    {"rqt_gui", kNoWidgets},
    {"rqt_gui_py", kNoWidgets},
    {"serial", kHardware},
    {"smbus", kHardware},
    {"smbus2", kHardware},
    {"spidev", kHardware},
    {"tensorflow", kCompiled},
    {"tf", kRos1},
    {"tf2_kdl", kKdl},
    {"tkinter", kNoTkinter},
    {"torch", kCompiled},
    {"turtle", kNoWindows},
    {"ultralytics", kCompiled},
    {"urllib3", kNoRequests},
    {"uvicorn", kNoSockets},
    {"websockets", kNoSockets},
    {"xacro",
     "descriptions are expanded when the site is packed: let the launch file give a node the "
     "parameter `robot_description` with `Command(['xacro ...'])`"},
    {"zmq", kNoSockets},
});

constexpr std::string_view kNoConnection =
    "a page has no sockets: nothing connects and nothing listens";
constexpr std::string_view kTopics =
    "nodes of a site reach each other by topics, services and actions; data can be a file of the "
    "package";

constexpr auto kFailing = std::to_array<FailingModule>({
    {"ctypes",
     "no shared library of a machine can be loaded (`CDLL` raises OSError); its types work",
     "a library's work can be done in Python with numpy, or by a node in C++ in the same site"},
    {"ftplib", kNoConnection, kTopics},
    {"http.client", kNoConnection, kTopics},
    {"http.server", kNoConnection, kTopics},
    {"multiprocessing",
     "a browser starts no processes: `Process`, `Pool`, `Queue` and its locks raise an error",
     "`threading` and `concurrent.futures.ThreadPoolExecutor` have the same calls; what shall run "
     "beside it can be a node of its own"},
    {"smtplib", kNoConnection, kTopics},
    {"socket", kNoConnection, kTopics},
    {"socketserver", kNoConnection, kTopics},
    {"subprocess", "a browser starts no programs: `run` and `Popen` raise OSError",
     "a program of the workspace can be a node of the launch file; `ros2` commands have services "
     "and topics that a node can use itself"},
    {"urllib.request", kNoConnection, kTopics},
    {"xmlrpc", kNoConnection, kTopics},
    {"zoneinfo",
     "Python in a browser has no time zones of its own, and no package of the site has `tzdata`: "
     "`ZoneInfo` raises ZoneInfoNotFoundError",
     "`<exec_depend>python3-tzdata</exec_depend>` in package.xml brings them from the embedded "
     "channel, and so does an import at the top of the module"},
});

}  // namespace

std::string hint_for_module(std::string_view top_level) {
  const auto found = std::find_if(kHints.begin(), kHints.end(),
                                  [&](const Hint& row) { return row.module == top_level; });
  return found == kHints.end() ? std::string() : std::string(found->why);
}

std::optional<FailingModule> failing_module(std::string_view module) {
  const auto found = std::find_if(kFailing.begin(), kFailing.end(), [&](const FailingModule& row) {
    return module == row.name || (module.starts_with(row.name) && module[row.name.size()] == '.');
  });
  if (found == kFailing.end()) return std::nullopt;
  return *found;
}

}  // namespace ros2wasm
