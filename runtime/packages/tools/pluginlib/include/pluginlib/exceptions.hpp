// Exceptions about plugins.
#pragma once

#include <stdexcept>
#include <string>

namespace pluginlib {

class PluginlibException : public std::runtime_error {
 public:
  explicit PluginlibException(const std::string& error_desc) : std::runtime_error(error_desc) {}
};
class InvalidXMLException : public PluginlibException {
  using PluginlibException::PluginlibException;
};
class LibraryLoadException : public PluginlibException {
  using PluginlibException::PluginlibException;
};
class ClassLoaderException : public PluginlibException {
  using PluginlibException::PluginlibException;
};
class LibraryUnloadException : public PluginlibException {
  using PluginlibException::PluginlibException;
};
class CreateClassException : public PluginlibException {
  using PluginlibException::PluginlibException;
};

}  // namespace pluginlib
