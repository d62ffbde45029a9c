// See manifest_tasks.hpp.
#include "workspace_schema/schema/manifest_tasks.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "workspace_schema/schema/manifest_checks.hpp"

namespace ros2wasm {
namespace {

const std::vector<KeyRow>& task_keys() {
  static const std::vector<KeyRow> kKeys{
      {"title", {"name", "task"}},
      {"text", {"description", "body", "instructions"}},
      {"checks", {"check", "tests", "expect"}},
      {"hint", {"hints", "tip"}},
      {"solution", {"answer", "solutions"}},
  };
  return kKeys;
}

std::optional<TaskEntry> read_task(Binder& binder, const YamlNode& node) {
  if (!binder.mapping(node, "a task", task_keys())) {
    binder.wrong_type(node, "an item of `tasks`", "a task")
        .why.emplace_back("a task is a mapping with `title` and `checks`");
    return std::nullopt;
  }
  TaskEntry task;
  task.span = binder.span(node);
  const YamlNode* title = value_of(node, "title");
  if (title == nullptr) {
    binder.missing(node, "a task", "title");
  } else if (auto line = binder.line(*title, "title")) {
    task.title = *std::move(line);
  }
  for (const auto& [key, target] : {std::pair("text", &task.text), std::pair("hint", &task.hint),
                                    std::pair("solution", &task.solution)}) {
    const YamlNode* value = value_of(node, key);
    if (value == nullptr) continue;
    if (auto text = binder.text(*value, key)) *target = std::move(text->value);
  }
  const YamlNode* checks = value_of(node, "checks");
  if (checks == nullptr || (checks->kind == YamlKind::kSequence && checks->items.empty())) {
    if (Diagnostic* missing = binder.missing(node, "a task", "checks"))
      missing->why.emplace_back(
          "a task is done when all its checks have passed: it has one or more");
    return std::nullopt;
  }
  binder.list(*checks, "checks", [&](const YamlNode& item) {
    if (auto check = read_check(binder, item, CheckPlace::kTask))
      task.checks.push_back(*std::move(check));
  });
  if (task.title.value.empty()) return std::nullopt;
  return task;
}

}  // namespace

std::vector<TaskEntry> read_tasks(Binder& binder, const YamlNode& node) {
  std::vector<TaskEntry> tasks;
  std::map<std::string, std::uint32_t> lines;
  binder.list(node, "tasks", [&](const YamlNode& item) {
    auto task = read_task(binder, item);
    if (!task) return;
    const auto [known, fresh] = lines.try_emplace(task->title.value, task->title.span.line);
    if (!fresh) {
      Diagnostic& equal =
          binder.error("R2W0126", "two tasks have the title `" + task->title.value + "`",
                       value_of(item, "title")->range,
                       "the other one is in line " + std::to_string(known->second));
      equal.why.emplace_back("the page keeps what a student has done by the task's title");
      return;
    }
    tasks.push_back(*std::move(task));
  });
  return tasks;
}

}  // namespace ros2wasm
