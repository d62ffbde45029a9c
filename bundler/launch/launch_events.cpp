// See launch_evaluator.hpp: what launch files in Python say beyond the others, and what is done
// when processes start and end.
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "bundler/launch/launch_evaluator.hpp"
#include "bundler/launch/lifecycle_transitions.hpp"
#include "bundler/launch/node_arguments.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kMostLines = 10'000;

/// Whether a process starts before another one: those of the launch's own start in their order. One
/// that is not known (behind the last) starts after all.
bool starts_before(const std::vector<LaunchProcess>& all, std::size_t a, std::size_t b) {
  const auto key = [&](std::size_t i) {
    const bool is_known = i < all.size();
    return std::tuple(!is_known, is_known && all[i].start_on.has_value(),
                      is_known ? all[i].start_after_s : 0.0, i);
  };
  return key(a) < key(b);
}

}  // namespace

PythonMoment LaunchEvaluator::moment(const SourceSpan& span) {
  return {.scope = scope_,
          .file = place_,
          .world = world_,
          .span = span,
          .said = [this](LaunchLine line) {
            if (description_.lines.size() >= kMostLines) return;
            line.on = trigger_;
            line.after_s = after_s_;
            description_.lines.push_back(std::move(line));
          }};
}

/// Takes over what running some Python changed, and does what it gave back.
void LaunchEvaluator::python_actions(Outcome<PythonActions> made) {
  if (!made) {
    errors_.insert(errors_.end(), made.errors().begin(), made.errors().end());
    return;
  }
  scope_.configurations = std::move(made->configurations);
  for (auto& [name, value] : made->environment) scope_.environment[name] = std::move(value);
  for (const std::string& name : made->unset) scope_.environment.erase(name);
  const LaunchLanguage before = std::exchange(language_, LaunchLanguage::kPython);
  actions(made->root.children);
  language_ = before;
}

void LaunchEvaluator::python_file(const std::string& path, const SourceSpan& from) {
  const LaunchFilePlace before = std::exchange(place_, {.path = path});
  open_files_.push_back(path);
  python_actions(load_python_launch(path, moment(from)));
  open_files_.pop_back();
  place_ = before;
}

void LaunchEvaluator::python(const LaunchEntity& entity) {
  python_actions(call_python_launch(number(entity, "call"), moment(entity.span)));
}

void LaunchEvaluator::unset_variable(const LaunchEntity& entity) {
  if (const auto name = text(entity, "name")) scope_.configurations.erase(*name);
}

void LaunchEvaluator::push_variables(const LaunchEntity&) {
  pushed_variables_.push_back(scope_.configurations);
}

void LaunchEvaluator::pop_variables(const LaunchEntity& entity) {
  if (pushed_variables_.empty()) {
    fail("R2W0410", "PopLaunchConfigurations without PushLaunchConfigurations", entity.span);
    return;
  }
  scope_.configurations = std::move(pushed_variables_.back());
  pushed_variables_.pop_back();
}

void LaunchEvaluator::push_environment(const LaunchEntity&) {
  pushed_environments_.push_back(scope_.environment);
}

void LaunchEvaluator::pop_environment(const LaunchEntity& entity) {
  if (pushed_environments_.empty()) {
    fail("R2W0410", "PopEnvironment without PushEnvironment", entity.span);
    return;
  }
  scope_.environment = std::move(pushed_environments_.back());
  pushed_environments_.pop_back();
}

/// Handlers are looked at when all files are read: what they do, they do later.
void LaunchEvaluator::on_event(const LaunchEntity& entity) {
  handlers_.push_back({.entity = entity, .place = place_});
}

void LaunchEvaluator::forget_event(const LaunchEntity& entity) {
  forgotten_.insert(number(entity, "handler"));
}

void LaunchEvaluator::pass_over(const LaunchEntity& entity) {
  LaunchLeftOut one{.what = text(entity, "what").value_or(""),
                    .instead = text(entity, "why").value_or("a site's launch has nothing like it"),
                    .span = entity.span};
  description_.left_out.push_back(std::move(one));
}

/// Reports a handler as unsupported: a site cannot observe its event, or the event is over before
/// the site runs.
void LaunchEvaluator::leave_out(const EventHandler& handler, const std::string& kind) {
  LaunchLeftOut one{.what = "what follows when ",
                    .instead = "a site's launch follows single processes",
                    .span = handler.entity.span};
  if (kind == "output") {
    one.what += "a process prints";
    one.instead = "the site does not run it";
  } else if (kind == "include") {
    one.what += "a file is included";
    one.instead = "files are included before the site runs";
  } else if (kind == "transition") {
    one.what += "a node changes its state";
    one.instead = "it is not a LifecycleNode that the site runs";
  } else {
    one.what += "another action is done";
  }
  description_.left_out.push_back(std::move(one));
}

/// Does what the handler says, as of `trigger_`.
void LaunchEvaluator::follow(const EventHandler& handler) {
  const LaunchEntity& entity = handler.entity;
  const LaunchFilePlace before = std::exchange(place_, handler.place);
  const LaunchLanguage language_before = std::exchange(language_, LaunchLanguage::kPython);
  if (const std::int64_t called = number(entity, "call"); called >= 0) {
    python_actions(call_python_launch(called, moment(entity.span)));
  } else {
    actions(entity.children);
  }
  language_ = language_before;
  place_ = before;
  trigger_.reset();
  after_s_ = 0;
}

bool LaunchEvaluator::event(const EventHandler& handler) {
  const LaunchEntity& entity = handler.entity;
  if (forgotten_.contains(number(entity, "handler"))) return true;
  const std::string kind = text(entity, "event").value_or("");
  const std::int64_t target = number(entity, "process");
  const bool changes = kind == "transition";
  if (kind == "shutdown") {
    trigger_ = LaunchTrigger{.process = 0, .event = LaunchEvent::kShutdown};
    scope_.event = {{"event.reason", std::string(kShutdownReason)}};
    follow(handler);
    scope_.event.clear();
    return true;
  }
  const bool prints = kind == "output";
  if ((kind != "start" && kind != "exit" && !prints && !changes) || target < 0) {
    leave_out(handler, kind);
    return true;
  }
  const auto started = processes_.find(target);
  const auto passed = passed_over_.find(target);
  if (started == processes_.end() && passed == passed_over_.end()) return false;
  const bool runs = started != processes_.end();
  if ((prints && !runs) ||
      (changes && (!runs || !description_.processes[started->second].node.name))) {
    leave_out(handler, kind);
    return true;
  }
  if (!runs && passed->second.stays && kind == "exit") return true;
  after_s_ = 0;
  if (changes) {
    trigger_ = LaunchTrigger{.process = started->second,
                             .event = LaunchEvent::kTransition,
                             .change = {.transition = text(entity, "transition").value_or(""),
                                        .start_state = text(entity, "start_state").value_or(""),
                                        .goal_state = text(entity, "goal_state").value_or("")},
                             .once = flag(entity, "once", false),
                             .handler = once_of_several(entity)};
  } else if (runs) {
    trigger_ = LaunchTrigger{.process = started->second,
                             .event = prints            ? LaunchEvent::kOutput
                                      : kind == "start" ? LaunchEvent::kStart
                                                        : LaunchEvent::kExit,
                             .once = flag(entity, "once", false),
                             .handler = once_of_several(entity)};
  } else {
    // A process that no site runs ends as soon as it would have started.
    trigger_ = passed->second.on;
    after_s_ = passed->second.after_s;
  }
  follow(handler);
  return true;
}

void LaunchEvaluator::follow_any(const EventHandler& handler, std::size_t processes) {
  const LaunchEvent event =
      text(handler.entity, "event") == "start" ? LaunchEvent::kStart : LaunchEvent::kExit;
  const std::int64_t called = number(handler.entity, "handler");
  if (forgotten_.contains(called) || processes == 0) return;
  const bool once = flag(handler.entity, "once", false);
  std::vector<std::size_t> meant(processes);
  std::iota(meant.begin(), meant.end(), 0U);
  if (once && event == LaunchEvent::kStart)
    meant = {*std::min_element(meant.begin(), meant.end(), [&](std::size_t a, std::size_t b) {
      return starts_before(description_.processes, a, b);
    })};
  for (const std::size_t i : meant) {
    if (!errors_.empty()) break;
    trigger_ = LaunchTrigger{.process = i,
                             .event = event,
                             .once = once,
                             .handler = once && meant.size() > 1 ? called : -1};
    follow(handler);
  }
}

/// The number of a handler that looks at several processes and is followed once, or -1.
std::int64_t LaunchEvaluator::once_of_several(const LaunchEntity& entity) const {
  const std::int64_t called = number(entity, "handler");
  return of_several_once_.contains(called) ? called : -1;
}

/// A handler that runs once may wait for the start of several processes: keep only the one that
/// starts first. Which of several processes ends first is only known at run time.
void LaunchEvaluator::choose_first_starts() {
  std::map<std::int64_t, std::vector<std::size_t>> all;
  for (std::size_t i = 0; i < handlers_.size(); ++i)
    if (flag(handlers_[i].entity, "once", false))
      all[number(handlers_[i].entity, "handler")].push_back(i);
  const auto process_of = [&](std::size_t handler) {
    const auto found = processes_.find(number(handlers_[handler].entity, "process"));
    return found == processes_.end() ? description_.processes.size() : found->second;
  };
  std::set<std::size_t> left_out;
  for (const auto& [called, of_it] : all) {
    if (called < 0 || of_it.size() < 2) continue;
    if (text(handlers_[of_it.front()].entity, "event") != "start") {
      of_several_once_.insert(called);
      continue;
    }
    const auto first =
        *std::min_element(of_it.begin(), of_it.end(), [&](std::size_t a, std::size_t b) {
          return starts_before(description_.processes, process_of(a), process_of(b));
        });
    for (const std::size_t one : of_it)
      if (one != first) left_out.insert(one);
  }
  std::vector<EventHandler> kept;
  for (std::size_t i = 0; i < handlers_.size(); ++i)
    if (!left_out.contains(i)) kept.push_back(std::move(handlers_[i]));
  handlers_ = std::move(kept);
}

/// Adds the actions of a function for printed lines that pass its tests. A test is four values.
void LaunchEvaluator::when_printed(const LaunchEntity& entity) {
  const LaunchAttribute* tests = entity.attribute("tests");
  const auto* values = std::get_if<std::vector<LaunchScalar>>(&tests->value);
  if (!trigger_ || trigger_->event != LaunchEvent::kOutput || values == nullptr) return;
  LaunchOutput output{.stream = text(entity, "stream").value_or(""), .tests = {}};
  for (std::size_t i = 0; i + 3 < values->size(); i += 4) {
    const auto* how = std::get_if<std::string>(&(*values)[i]);
    const auto* wanted = std::get_if<std::string>(&(*values)[i + 1]);
    const bool* case_counts = std::get_if<bool>(&(*values)[i + 2]);
    const bool* holds = std::get_if<bool>(&(*values)[i + 3]);
    if (how == nullptr || wanted == nullptr || case_counts == nullptr || holds == nullptr) return;
    output.tests.push_back(
        {.how = *how, .text = *wanted, .any_case = !*case_counts, .holds = *holds});
  }
  const LaunchOutput before = std::exchange(trigger_->output, std::move(output));
  actions(entity.children);
  if (trigger_) trigger_->output = before;
}

void LaunchEvaluator::end_process(const LaunchEntity& entity) {
  if (trigger_ && trigger_->event == LaunchEvent::kShutdown) return;  // it ends anyway
  end_targets_.push_back(number(entity, "process"));
  description_.ends.push_back({.on = trigger_, .after_s = after_s_, .span = entity.span});
}

/// Drops the ends of processes that no site runs: they are over already.
void LaunchEvaluator::resolve_ends() {
  std::vector<LaunchEnd> known;
  for (std::size_t i = 0; i < description_.ends.size(); ++i) {
    const auto process = processes_.find(end_targets_[i]);
    if (process == processes_.end()) continue;
    description_.ends[i].process = process->second;
    known.push_back(std::move(description_.ends[i]));
  }
  description_.ends = std::move(known);
}

/// Whether a process can start where the evaluation is.
bool LaunchEvaluator::starts_here(const LaunchEntity& entity, const std::string& what) {
  if (!trigger_ || trigger_->event != LaunchEvent::kShutdown) return true;
  description_.left_out.push_back({.what = what,
                                   .instead = "nothing starts any more when the launch ends",
                                   .span = entity.span});
  return false;
}

/// Changes the state of the process that a launch file in Python names by its number, or of nodes
/// by their names.
void LaunchEvaluator::change_state(const LaunchEntity& entity) {
  std::vector<std::int64_t> transitions;
  for (const std::string& one : list(entity, "transition_ids")) {
    const auto known = std::find_if(kTransitions.begin(), kTransitions.end(), [&](const auto& row) {
      return one == row.label || one == std::to_string(row.id);
    });
    if (known != kTransitions.end()) {
      transitions.push_back(known->id);
      continue;
    }
    std::vector<std::string> labels;
    for (const auto& row : kTransitions)
      labels.push_back(std::to_string(row.id) + " (" + std::string(row.label) + ")");
    fail("R2W0410", "managed nodes have no transition `" + one + "`", entity.span,
         {"transitions are: " + name_list(labels, labels.size())});
    return;
  }
  if (transitions.empty()) {
    fail("R2W0410", "`lifecycle_transition` names no transition", entity.span);
    return;
  }
  if (trigger_ && trigger_->event == LaunchEvent::kShutdown) {
    description_.left_out.push_back({.what = "a transition of a managed node",
                                     .instead = "nodes end when the launch ends",
                                     .span = entity.span});
    return;
  }
  LaunchTransitions one{.process = std::nullopt,
                        .node = {},
                        .transitions = std::move(transitions),
                        .on = trigger_,
                        .after_s = after_s_,
                        .span = entity.span};
  if (const std::int64_t target = number(entity, "process"); target >= 0) {
    transition_targets_[description_.transitions.size()] = target;
    description_.transitions.push_back(std::move(one));
    return;
  }
  const std::vector<std::string> names = list(entity, "lifecycle_node_names");
  if (names.empty()) fail("R2W0410", "`lifecycle_transition` names no node", entity.span);
  for (const std::string& name : names) {
    one.node = (name.starts_with('/') ? "" : "/") + name;
    description_.transitions.push_back(one);
  }
}

/// At the end: the nodes may stand behind what changes them.
void LaunchEvaluator::resolve_transitions() {
  std::vector<LaunchTransitions> known;
  for (std::size_t i = 0; i < description_.transitions.size(); ++i) {
    LaunchTransitions& one = description_.transitions[i];
    const auto& processes = description_.processes;
    if (const auto target = transition_targets_.find(i); target != transition_targets_.end()) {
      const auto process = processes_.find(target->second);
      if (process != processes_.end() && processes[process->second].node.name)
        one.process = process->second;
    } else if (!one.process) {
      const auto process =
          std::find_if(processes.begin(), processes.end(), [&](const LaunchProcess& other) {
            return other.node.name && node_label(other.node) == one.node;
          });
      if (process != processes.end())
        one.process = static_cast<std::size_t>(process - processes.begin());
    }
    if (one.process) {
      one.node = node_label(processes[*one.process].node);
      known.push_back(std::move(one));
      continue;
    }
    description_.left_out.push_back(
        {.what = "a transition of " + (one.node.empty() ? "a managed node" : "`" + one.node + "`"),
         .instead = "the launch file starts no node of that name",
         .span = one.span});
  }
  description_.transitions = std::move(known);
}

/// A process that one handler starts may be the target of another, so repeat until nothing changes.
/// A handler whose process never starts, since a condition is false, has no effect.
void LaunchEvaluator::events() {
  choose_first_starts();
  std::vector<EventHandler> of_any;
  for (bool went_on = true; went_on && errors_.empty();) {
    went_on = false;
    std::vector<EventHandler> now;
    now.swap(handlers_);
    for (EventHandler& handler : now) {
      if (!errors_.empty()) break;
      if (handler.entity.attribute("any") != nullptr) {
        of_any.push_back(std::move(handler));
      } else if (event(handler)) {
        went_on = true;
      } else {
        handlers_.push_back(std::move(handler));
      }
    }
  }
  // These handlers do not apply to processes that they start themselves.
  const std::size_t processes = description_.processes.size();
  for (const EventHandler& handler : of_any) follow_any(handler, processes);
}

}  // namespace ros2wasm
