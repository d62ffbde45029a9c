// Exceptions about libraries and classes.
#pragma once

#include <stdexcept>
#include <string>

namespace class_loader {

class ClassLoaderException : public std::runtime_error {
 public:
  explicit ClassLoaderException(const std::string& error_desc) : std::runtime_error(error_desc) {}
};
class LibraryLoadException : public ClassLoaderException {
  using ClassLoaderException::ClassLoaderException;
};
class LibraryUnloadException : public ClassLoaderException {
  using ClassLoaderException::ClassLoaderException;
};
class CreateClassException : public ClassLoaderException {
  using ClassLoaderException::ClassLoaderException;
};
class NoClassLoaderExistsException : public ClassLoaderException {
  using ClassLoaderException::ClassLoaderException;
};

}  // namespace class_loader
