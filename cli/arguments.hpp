// Declares a command's options and reads the command line. The command line library ends in
// arguments.cpp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "cli/command_table.hpp"
#include "cli/context.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace CLI {
class App;
}

namespace ros2wasm {

/// The options of one command. Targets must live as long as the CommandBody: keep them in a
/// shared_ptr that the body captures. Names are as people type them: "-o,--output". A target keeps
/// its value when the option is not given.
class Arguments {
 public:
  explicit Arguments(CLI::App& app) : app_(app) {}

  void flag(const std::string& names, bool& target, const std::string& help);
  void value(const std::string& names, std::string& target, const std::string& placeholder,
             const std::string& help);
  void value(const std::string& names, std::optional<std::string>& target,
             const std::string& placeholder, const std::string& help);
  /// As value(), which refuses an empty one.
  void text(const std::string& names, std::string& target, const std::string& placeholder,
            const std::string& help);
  void number(const std::string& names, int& target, const std::string& placeholder, int least,
              int most, const std::string& help);
  void number(const std::string& names, std::optional<int>& target, const std::string& placeholder,
              int least, int most, const std::string& help);
  /// One of a fixed set of words.
  void choice(const std::string& names, std::string& target, const std::vector<std::string>& words,
              const std::string& help);
  /// May be given many times, one value each.
  void values(const std::string& names, std::vector<std::string>& target,
              const std::string& placeholder, const std::string& help);

  /// The same; without a value, an empty text is added.
  void values_if_any(const std::string& names, std::vector<std::string>& target,
                     const std::string& placeholder, const std::string& help);

  void required(const std::string& name, std::string& target, const std::string& help);
  void optional(const std::string& name, std::string& target, const std::string& help);
  /// All remaining words; words after `--` are taken as they are, dashes and all.
  void rest(const std::string& name, std::vector<std::string>& target, const std::string& help);

  /// Everything after the named words, options too: it is another program's. Global options come
  /// before the command then.
  void raw_rest(std::vector<std::string>& target);

  /// Shown after the options in --help: examples, one command a line.
  void examples(const std::vector<std::string>& lines);

 private:
  CLI::App& app_;
};

enum class ColorMode { kAuto, kAlways, kNever };

struct GlobalOptions {
  bool quiet = false;
  bool json = false;
  ColorMode color = ColorMode::kAuto;
};

struct Invocation {
  GlobalOptions global;
  std::string command;  ///< empty when only text is to be shown
  CommandBody body;     ///< empty when only text is to be shown
  std::string text;     ///< help or version, for stdout
};

/// The outcome of reading the command line. The global options are what could be read of them even
/// when there are errors (R2W0901 no such command, R2W0902 bad option or argument), so that those
/// are shown as asked.
struct ParsedCommandLine {
  GlobalOptions global;
  Outcome<Invocation> invocation;
};

[[nodiscard]] ParsedCommandLine parse_command_line(const std::vector<std::string>& words,
                                                   std::span<const CommandRow> table);

}  // namespace ros2wasm
