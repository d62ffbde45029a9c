// Walks the entities of launch files and does what they say. Its actions are in launch_actions.cpp,
// those that start processes in launch_processes.cpp, those of Python in launch_events.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/launch/launch_description.hpp"
#include "bundler/launch/launch_entity.hpp"
#include "bundler/launch/launch_frontends.hpp"
#include "bundler/launch/launch_python.hpp"
#include "bundler/launch/launch_scope.hpp"

namespace ros2wasm {

/// One kind of action: its attributes, a `!` before those that must be there, and the parts that
/// may stand in it.
struct LaunchActionRow;

class LaunchEvaluator {
 public:
  LaunchEvaluator(const LaunchWorld& world, const std::map<std::string, std::string>& given);
  LaunchEvaluator(const LaunchEvaluator&) = delete;
  LaunchEvaluator& operator=(const LaunchEvaluator&) = delete;

  /// Reads and evaluates a file. `from`: where it is named; the first file is named nowhere.
  void file(const std::string& path, const std::optional<SourceSpan>& from);
  /// Then what events bring.
  void events();
  void finish();

  [[nodiscard]] LaunchDescription& description() { return description_; }
  [[nodiscard]] Diagnostics& errors() { return errors_; }

 private:
  friend struct LaunchActionRow;
  using Entities = std::vector<LaunchEntity>;

  /// The actions to do when a process starts or ends.
  struct EventHandler {
    LaunchEntity entity;
    LaunchFilePlace place;
  };
  /// A process of launch files in Python that no site runs: when it would have started.
  struct PassedOver {
    std::optional<LaunchTrigger> on;
    double after_s = 0;
    bool stays = false;  ///< does not end: the page does its work
  };

  /// Components for a container that is known at the end.
  struct LoadedComponents {
    std::vector<LaunchComponent> components;
    std::int64_t process = -1;  ///< the container, as Python numbers it, or
    std::string target;         ///< its full name
    SourceSpan span;
  };

  void entities_of(LaunchEntity root, const std::string& path, LaunchLanguage language);
  bool comes_later(const std::string& path, const std::optional<SourceSpan>& from);
  void python_file(const std::string& path, const SourceSpan& from);
  void python_actions(Outcome<PythonActions> made);
  [[nodiscard]] PythonMoment moment(const SourceSpan& span);
  void actions(const Entities& entities);
  void action(const LaunchEntity& entity);
  bool applies(const LaunchEntity& entity);
  bool check(const LaunchEntity& entity, const LaunchActionRow& row);
  bool check_part(const LaunchEntity& part);
  bool check_attributes(const LaunchEntity& entity,
                        const std::vector<std::string_view>& attributes);
  void when_printed(const LaunchEntity& entity);
  void end_process(const LaunchEntity& entity);
  void resolve_ends();
  /// For each of the first processes.
  void follow_any(const EventHandler& handler, std::size_t processes);
  void choose_first_starts();
  [[nodiscard]] std::int64_t once_of_several(const LaunchEntity& entity) const;
  /// Whether its process is known by now.
  bool event(const EventHandler& handler);
  void follow(const EventHandler& handler);
  void leave_out(const EventHandler& handler, const std::string& kind);
  bool starts_here(const LaunchEntity& entity, const std::string& what);
  void resolve_transitions();
  void resolve_components();

  // The actions.
  void declare_argument(const LaunchEntity& entity);
  void let(const LaunchEntity& entity);
  void include(const LaunchEntity& entity);
  void group(const LaunchEntity& entity);
  void set_environment(const LaunchEntity& entity);
  void unset_environment(const LaunchEntity& entity);
  void append_environment(const LaunchEntity& entity);
  void reset_environment(const LaunchEntity& entity);
  void reset(const LaunchEntity& entity);
  void timer(const LaunchEntity& entity);
  void log(const LaunchEntity& entity);
  void shutdown(const LaunchEntity& entity);
  void push_namespace(const LaunchEntity& entity);
  void set_parameter(const LaunchEntity& entity);
  void set_parameter_file(const LaunchEntity& entity);
  void set_remap(const LaunchEntity& entity);
  void set_sim_time(const LaunchEntity& entity);
  void ignore(const LaunchEntity& entity);
  void for_each(const LaunchEntity& entity);
  void count(const LaunchEntity& entity);
  void node(const LaunchEntity& entity);
  void container(const LaunchEntity& entity);
  void load_components(const LaunchEntity& entity);
  void executable(const LaunchEntity& entity);
  // Actions of launch files in Python only.
  void python(const LaunchEntity& entity);
  void unset_variable(const LaunchEntity& entity);
  void push_variables(const LaunchEntity& entity);
  void pop_variables(const LaunchEntity& entity);
  void push_environment(const LaunchEntity& entity);
  void pop_environment(const LaunchEntity& entity);
  void on_event(const LaunchEntity& entity);
  void forget_event(const LaunchEntity& entity);
  void pass_over(const LaunchEntity& entity);
  void change_state(const LaunchEntity& entity);
  void lifecycle_node(const LaunchEntity& entity);

  // Processes.
  void add_process(const LaunchEntity& entity, LaunchProcess process);
  std::optional<LaunchProcess> process_of(const LaunchEntity& entity);
  void process_options(const LaunchEntity& entity, LaunchProcess& process);
  void parameters_of(const LaunchEntity& entity, NodeEntry& node);
  void parameter(const LaunchEntity& entity, const std::string& prefix, NodeEntry& node);
  std::optional<std::string> parameter_file(const LaunchEntity& entity, const LaunchAttribute& from,
                                            bool substituted);
  std::optional<std::vector<std::pair<std::string, std::string>>> remappings_of(
      const LaunchEntity& entity);
  std::vector<LaunchComponent> components_of(const LaunchEntity& entity);
  std::optional<std::string> namespace_for(const std::string& own) const;

  // Attributes. What is wrong is noted, and nothing comes back.
  std::optional<std::string> text(const LaunchEntity& entity, std::string_view name);
  std::optional<std::string> needed_text(const LaunchEntity& entity, std::string_view name);
  std::optional<std::string> evaluated(const std::string& text, const SourceSpan& span);
  bool flag(const LaunchEntity& entity, std::string_view name, bool otherwise);
  /// A list, or a text with separators as `<name>_sep` says.
  std::vector<std::string> list(const LaunchEntity& entity, const std::string& name);
  /// The number that Python gave an object; -1 without the attribute.
  static std::int64_t number(const LaunchEntity& entity, std::string_view name);
  double seconds(const LaunchEntity& entity, std::string_view name, double otherwise);
  std::optional<ParameterValue> value(const LaunchAttribute& attribute, const std::string& type,
                                      const std::string& separator);
  std::optional<std::vector<std::string>> command_line(const LaunchEntity& entity,
                                                       std::string_view name);
  void fail(DiagnosticCode code, std::string message, const SourceSpan& span,
            std::vector<std::string> why = {});

  LaunchWorld world_;
  const std::map<std::string, std::string>& given_;
  LaunchDescription description_;
  Diagnostics errors_;
  LaunchScope scope_;
  LaunchFilePlace place_;
  std::vector<std::string> open_files_;  ///< the ones that include the present one, and itself
  std::set<std::string> files_;
  std::optional<LaunchTrigger> trigger_;
  double after_s_ = 0;
  int depth_ = 0;
  std::size_t actions_ = 0;
  std::size_t text_ = 0;                            ///< bytes that were evaluated
  LaunchLanguage language_ = LaunchLanguage::kXml;  ///< of the present file
  std::vector<EventHandler> handlers_;
  std::set<std::int64_t> forgotten_;  ///< handlers, by number
  /// Handlers of several processes that are followed once, by number.
  std::set<std::int64_t> of_several_once_;
  std::map<std::int64_t, std::size_t> processes_;
  std::map<std::int64_t, PassedOver> passed_over_;
  /// By index in the description's ends: the process, as Python numbers it.
  std::vector<std::int64_t> end_targets_;
  /// By index in the description's transitions: the process, as Python numbers it.
  std::map<std::size_t, std::int64_t> transition_targets_;
  std::vector<LoadedComponents> loaded_;
  std::vector<std::map<std::string, std::string>> pushed_variables_;
  std::vector<std::map<std::string, std::string>> pushed_environments_;
};

}  // namespace ros2wasm
