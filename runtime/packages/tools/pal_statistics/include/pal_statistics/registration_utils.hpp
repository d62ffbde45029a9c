// customRegister(): user code specialises it for its own types.
#pragma once

#include <functional>
#include <string>

#include "pal_statistics/pal_statistics.hpp"

namespace pal_statistics {

template <typename T>
inline IdType customRegister(StatisticsRegistry& registry, const std::string& name,
                             const T* variable, RegistrationsRAII* bookkeeping = nullptr,
                             bool enabled = true) {
  return registry.registerFunction(
      name, [variable] { return static_cast<double>(*variable); }, bookkeeping, enabled);
}

template <typename T>
inline IdType customRegister(StatisticsRegistry& registry, const std::string& name,
                             const std::function<T()>& funct,
                             RegistrationsRAII* bookkeeping = nullptr, bool enabled = true) {
  return registry.registerFunction(
      name, [funct] { return static_cast<double>(funct()); }, bookkeeping, enabled);
}

}  // namespace pal_statistics
