// See arguments.hpp. CLI11 is known here only; its exceptions end here.
#include "cli/arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <map>
#include <memory>

#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

Diagnostic command_line_error(DiagnosticCode code, std::string message) {
  return Diagnostic{.code = code, .kind = FailureKind::kCommandLine, .message = std::move(message)};
}

/// Option names of the command and the program, as people type them.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* level = &app; level != nullptr; level = level->get_parent()) {
    for (const CLI::Option* option : level->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  }
  return names;
}

std::string command_path(const CLI::App& app) {
  return app.get_parent() == nullptr ? "ros2wasm" : "ros2wasm " + app.get_name();
}

Diagnostic unknown_command(const std::string& word, std::span<const CommandRow> table) {
  Diagnostic error = command_line_error("R2W0901", "there is no command `" + word + "`");
  std::vector<std::string> names;
  for (const CommandRow& row : table) {
    if (!row.hidden) names.emplace_back(row.name);
  }
  error.why.push_back("the commands are: " + name_list(names, 20));
  if (const auto near = nearest(word, names)) error.fix.push_back("ros2wasm " + *near);
  return error;
}

Diagnostic unexpected_word(const std::string& word, const CLI::App& command) {
  if (word.size() < 2 || word.front() != '-') {
    Diagnostic error = command_line_error(
        "R2W0902", "`" + command_path(command) + "` does not take the argument `" + word + "`");
    error.why.push_back("`" + command_path(command) + " --help` lists what it takes");
    return error;
  }
  const std::string name = word.substr(0, word.find('='));
  Diagnostic error =
      command_line_error("R2W0902", "`" + command_path(command) + "` has no option `" + name + "`");
  error.why.push_back("`" + command_path(command) + " --help` lists its options");
  if (const auto near = nearest(name, option_names(command)))
    error.fix.push_back("write `" + *near + "`");
  return error;
}

/// CLI11's error about a missing or malformed value, as a diagnostic.
Diagnostic parse_error(const CLI::ParseError& raised, const CLI::App& command) {
  std::string message = raised.what();
  std::replace(message.begin(), message.end(), '\n', ' ');
  Diagnostic error = command_line_error("R2W0902", "`" + command_path(command) + "`: " + message);
  error.why.push_back("`" + command_path(command) + " --help` says what it takes");
  return error;
}

/// The deepest command that was named.
const CLI::App& parsed_command(const CLI::App& root) {
  const auto named = root.get_subcommands();
  return named.empty() ? root : *named.back();
}

/// Checks run on the text, before it is converted, so that all that is wrong with it has the same
/// words.
CLI::Validator whole_number(int least, int most) {
  return {[least, most](const std::string& text) -> std::string {
            int number = 0;
            const auto [end, error] =
                std::from_chars(text.data(), text.data() + text.size(), number);
            const bool whole = error == std::errc() && end == text.data() + text.size();
            if (whole && number >= least && number <= most) return {};
            return "`" + text + "` is not a number from " + std::to_string(least) + " to " +
                   std::to_string(most);
          },
          ""};
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  return {[words](const std::string& text) -> std::string {
            if (std::find(words.begin(), words.end(), text) != words.end()) return {};
            const auto near = nearest(text, words);
            return "`" + text + "` is none of " + name_list(words, 20) +
                   (near ? "; write `" + *near + "`" : "");
          },
          ""};
}

/// An empty value is most often a variable of a script that is not set.
CLI::Validator not_empty() {
  return {[](const std::string& text) -> std::string {
            return text.empty() ? "its value is empty" : "";
          },
          ""};
}

void declare_global(CLI::App& root, GlobalOptions& global) {
  root.add_flag("-q,--quiet", global.quiet, "No remarks and no progress; errors stay");
  root.add_flag("--json", global.json, "Result, diagnostics and progress as JSON");
  root.add_option_function<std::string>(
          "--color",
          [&global](const std::string& word) {
            if (word == "auto") {
              global.color = ColorMode::kAuto;
            } else if (word == "always") {
              global.color = ColorMode::kAlways;
            } else if (word == "never") {
              global.color = ColorMode::kNever;
            } else {
              throw CLI::ValidationError("--color",
                                         "`" + word + "` is none of auto, always, never");
            }
          },
          "auto, always or never; auto heeds NO_COLOR")
      ->option_text("WHEN");
}

}  // namespace

void Arguments::flag(const std::string& names, bool& target, const std::string& help) {
  app_.add_flag(names, target, help);
}

void Arguments::value(const std::string& names, std::string& target, const std::string& placeholder,
                      const std::string& help) {
  app_.add_option(names, target, help)->option_text(placeholder)->check(not_empty());
}

void Arguments::text(const std::string& names, std::string& target, const std::string& placeholder,
                     const std::string& help) {
  app_.add_option(names, target, help)->option_text(placeholder);
}

void Arguments::value(const std::string& names, std::optional<std::string>& target,
                      const std::string& placeholder, const std::string& help) {
  app_.add_option_function<std::string>(
          names, [&target](const std::string& text) { target = text; }, help)
      ->option_text(placeholder)
      ->check(not_empty());
}

void Arguments::number(const std::string& names, int& target, const std::string& placeholder,
                       int least, int most, const std::string& help) {
  app_.add_option(names, target, help)->option_text(placeholder)->check(whole_number(least, most));
}

void Arguments::number(const std::string& names, std::optional<int>& target,
                       const std::string& placeholder, int least, int most,
                       const std::string& help) {
  app_.add_option_function<int>(
          names, [&target](int number) { target = number; }, help)
      ->option_text(placeholder)
      ->check(whole_number(least, most));
}

void Arguments::choice(const std::string& names, std::string& target,
                       const std::vector<std::string>& words, const std::string& help) {
  std::string placeholder;
  for (const std::string& word : words) placeholder += (placeholder.empty() ? "" : "|") + word;
  app_.add_option(names, target, help)->option_text(placeholder)->check(one_of(words));
}

void Arguments::values(const std::string& names, std::vector<std::string>& target,
                       const std::string& placeholder, const std::string& help) {
  app_.add_option(names, target, help)
      ->option_text(placeholder + " ...")
      ->allow_extra_args(false)
      ->take_all();
}

void Arguments::values_if_any(const std::string& names, std::vector<std::string>& target,
                              const std::string& placeholder, const std::string& help) {
  app_.add_option_function<std::vector<std::string>>(
          names, [&target](const std::vector<std::string>& given) { target = given; }, help)
      ->option_text("[" + placeholder + "]")
      ->expected(0, 1)
      ->allow_extra_args(false)
      ->take_all();
}

void Arguments::required(const std::string& name, std::string& target, const std::string& help) {
  app_.add_option(name, target, help)->option_text(" ")->check(not_empty())->required();
}

void Arguments::optional(const std::string& name, std::string& target, const std::string& help) {
  app_.add_option(name, target, help)->option_text(" ")->check(not_empty());
}

void Arguments::rest(const std::string& name, std::vector<std::string>& target,
                     const std::string& help) {
  app_.add_option(name, target, help)->option_text("...");
}

void Arguments::raw_rest(std::vector<std::string>& target) {
  app_.fallthrough(false);
  app_.prefix_command();
  app_.parse_complete_callback([this_app = &app_, &target] { target = this_app->remaining(); });
}

void Arguments::examples(const std::vector<std::string>& lines) {
  std::string text = "Examples:";
  for (const std::string& line : lines) text += "\n  " + line;
  app_.footer(text);
}

ParsedCommandLine parse_command_line(const std::vector<std::string>& words,
                                     std::span<const CommandRow> table) {
  GlobalOptions global;
  // Read the global options first, so that they apply to errors in the other arguments too.
  for (const std::string& word : words) {
    if (word == "--") break;
    if (word == "--json") global.json = true;
    if (word == "--quiet" || word == "-q") global.quiet = true;
  }
  CLI::App root("Packs a ROS 2 workspace into a static site that runs in the browser.", "ros2wasm");
  root.set_help_flag("-h,--help", "Print this help");
  root.set_version_flag("--version", "ros2wasm " ROS2WASM_VERSION, "Print the version");
  root.require_subcommand(0, 1);
  root.footer(
      "Exit codes: 0 done, 1 your input, 2 command line, 3 network, disk or a missing tool, "
      "70 a bug, 130 interrupted.\n`ros2wasm explain CODE` says more about an error.");
  declare_global(root, global);

  std::map<std::string, CommandBody> bodies;
  for (const CommandRow& row : table) {
    CLI::App* command = root.add_subcommand(std::string(row.name), std::string(row.help));
    command->set_help_flag("-h,--help", "Print this help");
    command->fallthrough();
    if (row.hidden) command->group("");
    Arguments arguments(*command);
    bodies[std::string(row.name)] = row.declare(arguments);
  }

  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    root.parse(std::move(reversed));
    const auto named = root.get_subcommands();
    if (named.empty()) {
      Diagnostic error = command_line_error("R2W0901", "no command was given");
      error.why.push_back("`ros2wasm --help` lists the commands");
      return {.global = global, .invocation = error};
    }
    const std::string name = named.front()->get_name();
    return {.global = global,
            .invocation =
                Invocation{.global = global, .command = name, .body = bodies[name], .text = {}}};
  } catch (const CLI::CallForHelp&) {
    return {
        .global = global,
        .invocation = Invocation{.global = global, .command = {}, .body = {}, .text = root.help()}};
  } catch (const CLI::CallForVersion& version) {
    return {.global = global,
            .invocation = Invocation{.global = global,
                                     .command = {},
                                     .body = {},
                                     .text = std::string(version.what()) + "\n"}};
  } catch (const CLI::ExtrasError&) {
    const CLI::App& command = parsed_command(root);
    const std::vector<std::string> extras = root.remaining(true);
    const bool option_before = !extras.empty() && extras.front().starts_with('-');
    if (&command == &root && !extras.empty() && !option_before) {
      return {.global = global, .invocation = unknown_command(extras.front(), table)};
    }
    Diagnostics errors;
    for (const std::string& word : extras) errors.push_back(unexpected_word(word, command));
    if (errors.empty()) errors.push_back(command_line_error("R2W0902", "unexpected argument"));
    return {.global = global, .invocation = errors};
  } catch (const CLI::ParseError& raised) {
    return {.global = global, .invocation = parse_error(raised, parsed_command(root))};
  }
}

}  // namespace ros2wasm
