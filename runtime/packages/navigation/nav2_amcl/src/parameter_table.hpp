// Names, places and meanings of the parameters of amcl: one table for each type.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "nav2_amcl/amcl_parameters.hpp"

namespace nav2_amcl {

template <typename T>
struct ParameterRow {
  const char* name;
  std::function<T&(AmclParameters&)> place;
  /// Set in the Renewal of a change; null when nothing has to be made again.
  bool Renewal::*renews;
  /// False: a change counts at the next configuration only.
  bool is_dynamic;
  const char* description;
};

const std::vector<ParameterRow<double>>& double_parameters();
const std::vector<ParameterRow<int>>& integer_parameters();
const std::vector<ParameterRow<bool>>& bool_parameters();
const std::vector<ParameterRow<std::string>>& string_parameters();

}  // namespace nav2_amcl
