// Loads, configures and activates controllers. Upstream's is a Python program of the same name;
// this one starts in milliseconds and needs no Python in the site.
#include <sys/stat.h>

#include <cstdio>

#include "arguments.hpp"
#include "manager_client.hpp"
#include "param_files.hpp"

namespace controller_manager {
namespace {

std::vector<std::string> params_files_of(int argc, char** argv) {
  std::vector<std::string> files;
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::string(argv[i]) == "--params-file") {
      files.emplace_back(argv[i + 1]);
    }
  }
  return files;
}

/// False, with a line on standard error, when a file of parameters does not exist.
bool files_exist(const std::vector<ControllerOptions>& controllers) {
  for (const ControllerOptions& controller : controllers) {
    for (const std::string& file : controller.param_files) {
      struct stat status {};
      if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) {
        std::fprintf(stderr, "FileNotFoundError: [Errno 2] No such file or directory: '%s'\n",
                     file.c_str());
        return false;
      }
    }
  }
  return true;
}

class Spawner {
 public:
  /// `arguments` are those of the program.
  Spawner(rclcpp::Node::SharedPtr node, const SpawnerOptions& options,
          const std::vector<std::string>& arguments)
      : node_(node),
        options_(options),
        arguments_(arguments),
        namespace_(options.name_space.empty() ? node->get_namespace() : options.name_space),
        client_(node, full_manager_name(options.controller_manager, slashed(namespace_)),
                options.controller_manager_timeout, options.service_call_timeout) {
    namespace_ = slashed(namespace_);
  }

  int run() {
    std::vector<std::string> group;
    for (const ControllerOptions& controller : options_.controllers) {
      if (!load(controller) || (!controller.load_only && !start(controller, group))) {
        return 1;
      }
    }
    if (!group.empty()) {
      if (!switch_on(group)) {
        RCLCPP_ERROR(node_->get_logger(), "Failed to activate the parsed controllers list : %s",
                     listed(group).c_str());
        return 1;
      }
      RCLCPP_INFO(node_->get_logger(),
                  "Configured and activated all the parsed controllers list : %s!",
                  listed(group).c_str());
    }
    return options_.unload_on_kill ? unload_when_killed() : 0;
  }

 private:
  static std::string slashed(const std::string& name) {
    return !name.empty() && name.front() == '/' ? name : "/" + name;
  }

  bool switch_on(const std::vector<std::string>& names) {
    return client_.switch_controllers({}, names, options_.switch_asap, options_.switch_timeout);
  }

  bool load(const ControllerOptions& controller) {
    if (client_.is_loaded(controller.name)) {
      RCLCPP_WARN(node_->get_logger(), "Controller already loaded, skipping load_controller");
      return true;
    }
    const ControllerArgumentFacts own =
        read_param_arguments(controller.name, namespace_, arguments_);
    std::vector<std::string> ros_args = controller.ros_args;
    ros_args.insert(ros_args.end(), own.ros_args.begin(), own.ros_args.end());
    if (!ros_args.empty() && !client_.set_controller_parameter(controller.name, "node_options_args",
                                                               rclcpp::ParameterValue(ros_args))) {
      return false;
    }
    if (!set_type(controller, own.type, own.fallbacks) ||
        (!controller.param_files.empty() && !set_facts(controller))) {
      return false;
    }
    if (!client_.load(controller.name)) {
      RCLCPP_FATAL(node_->get_logger(), "Failed loading controller %s", controller.name.c_str());
      return false;
    }
    RCLCPP_INFO(node_->get_logger(), "Loaded %s", controller.name.c_str());
    return true;
  }

  bool set_facts(const ControllerOptions& controller) {
    const ControllerFileFacts facts =
        read_param_files(controller.name, namespace_, controller.param_files);
    if (facts.lacks_namespace) {
      RCLCPP_FATAL(node_->get_logger(),
                   "Missing namespace : %s or wildcard in parameter file for controller : %s",
                   namespace_.c_str(), controller.name.c_str());
    }
    if (facts.files.empty()) {
      return true;
    }
    client_.set_controller_parameter(controller.name, "params_file",
                                     rclcpp::ParameterValue(facts.files));
    return set_type(controller, facts.type, facts.fallbacks);
  }

  bool set_type(const ControllerOptions& controller, const std::string& type,
                const std::vector<std::string>& fallbacks) {
    return (type.empty() || client_.set_controller_parameter(controller.name, "type",
                                                             rclcpp::ParameterValue(type))) &&
           (fallbacks.empty() ||
            client_.set_controller_parameter(controller.name, "fallback_controllers",
                                             rclcpp::ParameterValue(fallbacks)));
  }

  bool start(const ControllerOptions& controller, std::vector<std::string>& group) {
    const char* const name = controller.name.c_str();
    if (!client_.configure(controller.name)) {
      RCLCPP_ERROR(node_->get_logger(), "Failed to configure controller");
      return false;
    }
    if (controller.inactive) {
      return true;
    }
    if (options_.activate_as_group) {
      group.push_back(controller.name);
      return true;
    }
    if (!switch_on({controller.name})) {
      RCLCPP_ERROR(node_->get_logger(), "Failed to activate controller : %s", name);
      return false;
    }
    RCLCPP_INFO(node_->get_logger(), "Configured and activated %s", name);
    return true;
  }

  int unload_when_killed() {
    RCLCPP_INFO(node_->get_logger(), "Waiting until interrupt to unload controllers");
    std::vector<std::string> names;
    for (const ControllerOptions& controller : options_.controllers) {
      if (!controller.inactive) {
        names.push_back(controller.name);
      }
    }
    int exit_code = 0;
    // Services can be called until the context is shut down, so the work is done before that.
    const auto context = node_->get_node_base_interface()->get_context();
    const auto handle = context->add_pre_shutdown_callback([this, &names, &exit_code] {
      RCLCPP_INFO(node_->get_logger(), "KeyboardInterrupt successfully captured!");
      exit_code = names.empty() || unload(names) ? 0 : 1;
    });
    // The node stays free of executors: the calls above spin it.
    while (rclcpp::sleep_for(std::chrono::hours(1))) {
    }
    context->remove_pre_shutdown_callback(handle);
    return exit_code;
  }

  bool unload(const std::vector<std::string>& names) {
    RCLCPP_INFO(node_->get_logger(), "Deactivating and unloading controllers...");
    if (!client_.switch_controllers(names, {}, options_.switch_asap, options_.switch_timeout)) {
      RCLCPP_ERROR(node_->get_logger(), "Failed to deactivate controller");
      return false;
    }
    RCLCPP_INFO(node_->get_logger(), "Successfully deactivated controllers : %s",
                listed(names).c_str());
    bool done = true;
    for (const std::string& name : names) {
      const bool unloaded = client_.unload(name);
      done = done && unloaded;
      if (!unloaded) {
        RCLCPP_ERROR(node_->get_logger(), "Failed to unload controller : %s", name.c_str());
      }
    }
    if (done) {
      RCLCPP_INFO(node_->get_logger(), "Successfully unloaded controllers : %s",
                  listed(names).c_str());
    }
    return done;
  }

  rclcpp::Node::SharedPtr node_;
  const SpawnerOptions& options_;
  const std::vector<std::string>& arguments_;
  std::string namespace_;
  ManagerClient client_;
};

int run(int argc, char** argv) {
  const std::vector<std::string> arguments(argv, argv + argc);
  const std::vector<std::string> rest = rclcpp::init_and_remove_ros_arguments(argc, argv);
  SpawnerOptions options = read_spawner_arguments({rest.begin() + 1, rest.end()});
  for (ControllerOptions& controller : options.controllers) {
    for (const std::string& file : params_files_of(argc, argv)) {
      controller.param_files.push_back(file);
    }
  }
  if (!files_exist(options.controllers)) {
    return 1;
  }
  const std::string name = "spawner_" + options.controllers.front().name;
  try {
    // A controller's name may not be one that a node can have.
    const auto node = std::make_shared<rclcpp::Node>(name);
    return Spawner(node, options, arguments).run();
  } catch (const ServiceNotFound& error) {
    RCLCPP_FATAL(rclcpp::get_logger(name), "%s", error.what());
  } catch (const Interrupted&) {
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "RuntimeError: %s\n", error.what());
  }
  return 1;
}

}  // namespace
}  // namespace controller_manager

int main(int argc, char** argv) {
  try {
    const int exit_code = controller_manager::run(argc, argv);
    rclcpp::shutdown();
    return exit_code;
  } catch (const controller_manager::UsageError& error) {
    std::fputs(error.text.c_str(), error.exit_code == 0 ? stdout : stderr);
    return error.exit_code;
  }
}
