// Looks into installed prefixes: which packages there are, their programs, their interface
// definitions. An edge: reads folders and files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ros2wasm {

/// The kinds of programs that a site can run.
enum class ProgramKind {
  kNone,     ///< a script or data that is not a program of a site
  kWasm,     ///< a WebAssembly program
  kPython,   ///< a Python script
  kCommand,  ///< a command of `ros2`, which has no program file
};

/// A file in lib/<package>/ of an installed tree that a node entry can name.
struct InstalledProgram {
  std::string package;
  std::string executable;  ///< name without `.wasm`
  std::filesystem::path file;
  ProgramKind kind = ProgramKind::kNone;
  std::string left_out;         ///< the library without which it was not built; mostly empty
  bool may_not_be_run = false;  ///< a Python script that is not executable
};

struct InstalledPackage {
  std::string name;
  std::string version;                     ///< as package.xml or the channel says; may be empty
  std::filesystem::path prefix;            ///< share/<name> is below
  std::vector<InstalledProgram> programs;  ///< sorted by executable
  std::vector<std::string> in_bin = {};    ///< programs where ROS does not look, sorted
};

/// Interface definitions by type: "std_msgs/msg/String" -> text.
using InterfaceTexts = std::map<std::string, std::string>;

/// Is it a file, and not by a link that leads out of `prefix`? `path`: below it.
[[nodiscard]] bool is_installed_file(const std::filesystem::path& prefix,
                                     const std::filesystem::path& path);

/// The text after the path of a file for which is_installed_file() is false.
inline constexpr const char* kLeadsElsewhere =
    ", a link to a folder or out of the installed packages";

/// The programs that `package` installed into lib/<package>/ of `prefix`, sorted by name. Names
/// files (.names) and links that lead out do not count.
[[nodiscard]] std::vector<InstalledProgram> installed_programs(const std::filesystem::path& prefix,
                                                               const std::string& package);

/// Programs that a package with a prefix of its own put into bin/, where ROS does not look; sorted.
[[nodiscard]] std::vector<std::string> programs_in_bin(const std::filesystem::path& prefix);

/// The packages in share/ of `prefix` (those with a package.xml), sorted, with their programs.
[[nodiscard]] std::vector<InstalledPackage> installed_packages(const std::filesystem::path& prefix);

/// Adds the .msg, .srv and .action files in share/<package>/ of `prefix`; a type that is known
/// stays.
void collect_interfaces(const std::filesystem::path& prefix, const std::string& package,
                        InterfaceTexts& into);

}  // namespace ros2wasm
