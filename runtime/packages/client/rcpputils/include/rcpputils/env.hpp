// Environment variables.
#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace rcpputils {

/// Empty when it is not set.
inline std::string get_env_var(const char* env_var) {
  if (env_var == nullptr) {
    throw std::runtime_error("argument env_name is null");
  }
  const char* value = std::getenv(env_var);
  return value == nullptr ? "" : value;
}

inline bool set_env_var(const char* env_var, const char* env_value) {
  if (env_var == nullptr) {
    throw std::runtime_error("env_name is null");
  }
  return (env_value == nullptr ? unsetenv(env_var) : setenv(env_var, env_value, 1)) == 0;
}

}  // namespace rcpputils
