// The command lines of the spawners.
#include "arguments.hpp"

#include <functional>
#include <map>
#include <sstream>

namespace controller_manager {
namespace {

/// Options of one program by name: what a value does, or what the mere presence does.
class Options {
 public:
  explicit Options(std::string program, std::string names)
      : program_(std::move(program)), names_(std::move(names)) {}

  void flag(const std::string& name, const std::function<void()>& action) {
    table_[name] = {false, [action](const std::string&) { action(); }};
    order_.push_back("[" + name + "]");
  }
  void text(const std::vector<std::string>& names,
            const std::function<void(const std::string&)>& action) {
    for (const std::string& name : names) {
      table_[name] = {true, action};
    }
    order_.push_back("[" + names.back() + " " + upper(names.back()) + "]");
  }
  void number(const std::string& name, double& into) {
    text({name}, [this, name, &into](const std::string& value) {
      char* end = nullptr;
      into = std::strtod(value.c_str(), &end);
      if (value.empty() || *end != '\0') {
        throw usage("argument " + name + ": invalid float value: '" + value + "'");
      }
    });
  }

  /// Returns the arguments that are not options.
  std::vector<std::string> read(const std::vector<std::string>& arguments) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const std::string& argument = arguments[i];
      if (argument == "-h" || argument == "--help") {
        throw UsageError{usage_line(), 0};
      }
      if (argument.size() < 2 || argument[0] != '-') {
        // A substitution of a launch file may leave an empty argument.
        if (!argument.empty()) {
          names.push_back(argument);
        }
        continue;
      }
      const bool is_long = argument.rfind("--", 0) == 0;
      const std::size_t equals = is_long ? argument.find('=') : std::string::npos;
      const std::string name = argument.substr(0, equals);
      const auto found = table_.find(name);
      if (found == table_.end()) {
        throw usage("unrecognized arguments: " + argument);
      }
      if (!found->second.takes_value) {
        found->second.action("");
      } else if (equals != std::string::npos) {
        found->second.action(argument.substr(equals + 1));
      } else if (i + 1 < arguments.size()) {
        found->second.action(arguments[++i]);
      } else {
        throw usage("argument " + name + ": expected one argument");
      }
    }
    return names;
  }

  UsageError usage(const std::string& problem) const {
    return {usage_line() + program_ + ": error: " + problem + "\n", 2};
  }

 private:
  struct Row {
    bool takes_value = false;
    std::function<void(const std::string&)> action;
  };

  static std::string upper(const std::string& name) {
    std::string result;
    for (const char letter : name.substr(name.find_first_not_of('-'))) {
      result += letter == '-' ? '_' : static_cast<char>(letter >= 'a' ? letter - 32 : letter);
    }
    return result;
  }
  std::string usage_line() const {
    std::string line = "usage: " + program_ + " [-h]";
    for (const std::string& one : order_) {
      line += " " + one;
    }
    return line + " " + names_ + " [" + names_ + " ...]\n";
  }

  std::string program_;
  std::string names_;
  std::map<std::string, Row> table_;
  std::vector<std::string> order_;
};

void add_common(Options& options, SpawnerOptions& result) {
  options.text({"-c", "--controller-manager"},
               [&result](const std::string& text) { result.controller_manager = text; });
  options.text({"-n", "--namespace"},
               [&result](const std::string& text) { result.name_space = text; });
  options.flag("-u", [&result] { result.unload_on_kill = true; });
  options.flag("--unload-on-kill", [&result] { result.unload_on_kill = true; });
  options.number("--controller-manager-timeout", result.controller_manager_timeout);
  options.number("--switch-timeout", result.switch_timeout);
  options.number("--service-call-timeout", result.service_call_timeout);
  options.flag("--activate-as-group", [&result] { result.activate_as_group = true; });
  options.flag("--switch-asap", [&result] { result.switch_asap = true; });
  options.flag("--no-switch-asap", [&result] { result.switch_asap = false; });
}

void add_of_controller(Options& options, const std::function<ControllerOptions&()>& current) {
  options.text({"-p", "--param-file"},
               [current](const std::string& text) { current().param_files.push_back(text); });
  options.flag("--load-only", [current] { current().load_only = true; });
  options.flag("--inactive", [current] { current().inactive = true; });
  options.text({"--controller-ros-args"}, [current](const std::string& text) {
    std::istringstream words(text);
    for (std::string word; words >> word;) {
      current().ros_args.push_back(word);
    }
  });
}

}  // namespace

SpawnerOptions read_spawner_arguments(const std::vector<std::string>& arguments) {
  SpawnerOptions result;
  bool is_advanced = false;
  for (const std::string& argument : arguments) {
    is_advanced = is_advanced || argument == "--controller";
  }
  result.switch_asap = !is_advanced;
  Options options("spawner", "controller_names");
  ControllerOptions shared;
  add_common(options, result);
  add_of_controller(options, [&]() -> ControllerOptions& {
    return result.controllers.empty() ? shared : result.controllers.back();
  });
  if (is_advanced) {
    options.text({"--controller"}, [&result](const std::string& name) {
      result.controllers.emplace_back();
      result.controllers.back().name = name;
    });
    options.read(arguments);
    return result;
  }
  for (const std::string& name : options.read(arguments)) {
    result.controllers.push_back(shared);
    result.controllers.back().name = name;
  }
  if (result.controllers.empty()) {
    throw options.usage("the following arguments are required: controller_names");
  }
  for (ControllerOptions& controller : result.controllers) {
    const std::string name = controller.name;
    controller = shared;
    controller.name = name;
  }
  return result;
}

UnspawnerOptions read_unspawner_arguments(const std::vector<std::string>& arguments) {
  UnspawnerOptions result;
  Options options("unspawner", "controller_names");
  options.text({"-c", "--controller-manager"},
               [&result](const std::string& text) { result.controller_manager = text; });
  options.number("--switch-timeout", result.switch_timeout);
  result.controllers = options.read(arguments);
  if (result.controllers.empty()) {
    throw options.usage("the following arguments are required: controller_names");
  }
  return result;
}

HardwareSpawnerOptions read_hardware_spawner_arguments(const std::vector<std::string>& arguments) {
  HardwareSpawnerOptions result;
  bool configure = false;
  Options options("hardware_spawner", "hardware_component_names");
  options.text({"-c", "--controller-manager"},
               [&result](const std::string& text) { result.controller_manager = text; });
  options.number("--controller-manager-timeout", result.controller_manager_timeout);
  options.flag("--activate", [&result] { result.activate = true; });
  options.flag("--configure", [&configure] { configure = true; });
  result.components = options.read(arguments);
  if (result.activate && configure) {
    throw options.usage("argument --configure: not allowed with argument --activate");
  }
  if (!result.activate && !configure) {
    throw options.usage("one of the arguments --activate --configure is required");
  }
  if (result.components.empty()) {
    throw options.usage("the following arguments are required: hardware_component_names");
  }
  return result;
}

}  // namespace controller_manager
