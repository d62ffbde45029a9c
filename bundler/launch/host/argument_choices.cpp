// See argument_choices.hpp.
#include "bundler/launch/host/argument_choices.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace ros2wasm {
namespace {

struct Others {
  std::string name;
  std::vector<std::string> values;  ///< besides the present one
};

std::vector<std::string> other_values(const LaunchArgument& argument) {
  std::vector<std::string> values = argument.choices;
  if (values.empty()) {
    if (argument.value == "true" || argument.value == "false") values = {"true", "false"};
    if (argument.value == "True" || argument.value == "False") values = {"True", "False"};
  }
  std::set<std::string> seen{argument.value};
  std::vector<std::string> result;
  for (std::string& value : values)
    if (seen.insert(value).second) result.push_back(std::move(value));
  return result;
}

/// Adds all ways to change `count` more arguments, from the one at `begin` on; false: too many.
bool add_trials(const std::vector<Others>& others, std::size_t begin, std::size_t count,
                std::map<std::string, std::string>& chosen, std::size_t most,
                ArgumentTrials& result) {
  if (count == 0) {
    if (result.trials.size() == most) return false;
    result.trials.push_back(chosen);
    return true;
  }
  for (std::size_t i = begin; i + count <= others.size(); ++i) {
    for (const std::string& value : others[i].values) {
      chosen[others[i].name] = value;
      if (!add_trials(others, i + 1, count - 1, chosen, most, result)) return false;
    }
    chosen.erase(others[i].name);
  }
  return true;
}

}  // namespace

ArgumentTrials argument_trials(const std::vector<LaunchArgument>& arguments, std::size_t most) {
  std::vector<Others> others;
  std::set<std::string> names;
  for (const LaunchArgument& one : arguments) {
    std::vector<std::string> values = other_values(one);
    if (!values.empty() && names.insert(one.name).second)
      others.push_back({one.name, std::move(values)});
  }
  ArgumentTrials result;
  std::size_t alone = 0;  // trials of one argument come first, in this order
  for (const Others& one : others) {
    alone += one.values.size();
    if (alone <= most) result.names.push_back(one.name);
  }
  for (std::size_t count = 1; count <= others.size() && result.is_complete; ++count) {
    std::map<std::string, std::string> chosen;
    result.is_complete = add_trials(others, 0, count, chosen, most, result);
  }
  return result;
}

}  // namespace ros2wasm
