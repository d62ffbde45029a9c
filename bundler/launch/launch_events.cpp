// See launch_evaluator.hpp: what launch files in Python say beyond the others, and what is done
// when processes start and end.
#include <utility>

#include "bundler/launch/launch_evaluator.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kMostLines = 10'000;
constexpr const char* kEndProcess = "end_process";
constexpr const char* kTransition = "lifecycle_transition";

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
                    .instead = "a site's launch has nothing like it",
                    .span = entity.span};
  if (entity.tag == kEndProcess) {
    one = {.what = "the end of a node by an event",
           .instead = "nodes are stopped by hand, in the page",
           .span = entity.span};
  } else if (entity.tag == kTransition) {
    one = {.what = "transition " + text(entity, "transition").value_or("") + " of " +
                   text(entity, "name").value_or("a managed node"),
           .instead = "call the node's change_state service in the page",
           .span = entity.span};
  }
  description_.left_out.push_back(std::move(one));
}

bool LaunchEvaluator::event(const EventHandler& handler) {
  const LaunchEntity& entity = handler.entity;
  if (forgotten_.contains(number(entity, "handler"))) return true;
  const std::string kind = text(entity, "event").value_or("");
  const std::int64_t target = number(entity, "process");
  if ((kind != "start" && kind != "exit") || target < 0) {
    description_.left_out.push_back(
        {.what = "what follows when " +
                 std::string(kind == "output"       ? "a process prints"
                             : kind == "shutdown"   ? "the launch ends"
                             : kind == "transition" ? "a managed node changes its state"
                             : kind == "include"    ? "a file is included"
                                                    : "any process starts or ends"),
         .instead = "a site's launch follows the start and the end of single processes",
         .span = entity.span});
    return true;
  }
  if (const auto started = processes_.find(target); started != processes_.end()) {
    trigger_ = LaunchTrigger{.process = started->second,
                             .event = kind == "start" ? LaunchEvent::kStart : LaunchEvent::kExit};
    after_s_ = 0;
  } else if (const auto passed = passed_over_.find(target); passed != passed_over_.end()) {
    // What no site runs is over as soon as it would have begun.
    trigger_ = passed->second.on;
    after_s_ = passed->second.after_s;
  } else {
    return false;
  }
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
  return true;
}

/// What one handler starts may be what another one looks at. Whose process never comes, a condition
/// left out.
void LaunchEvaluator::events() {
  for (bool went_on = true; went_on && errors_.empty();) {
    went_on = false;
    std::vector<EventHandler> now;
    now.swap(handlers_);
    for (EventHandler& handler : now) {
      if (!errors_.empty()) break;
      if (event(handler)) {
        went_on = true;
      } else {
        handlers_.push_back(std::move(handler));
      }
    }
  }
}

}  // namespace ros2wasm
