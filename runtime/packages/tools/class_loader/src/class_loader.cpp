// The list of registered classes.
#include "class_loader/class_loader.hpp"

namespace class_loader {
namespace impl {
namespace {

std::vector<RegisteredClass>& classes() {
  static std::vector<RegisteredClass> all;
  return all;
}

/// `/opt/ros/lib/libtalker_component.so` is the library `libtalker_component.so`.
std::string file_name(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

bool is_of(const RegisteredClass& registered, const std::string& library) {
  return library.empty() || registered.library == file_name(library);
}

}  // namespace

void register_class(RegisteredClass registered) {
  classes().push_back(std::move(registered));
}

void require_library(const std::string& path) {
  for (const RegisteredClass& registered : classes()) {
    if (is_of(registered, path)) {
      return;
    }
  }
  if (!path.empty()) {
    throw LibraryLoadException("Could not load library " + path +
                               ": the program was linked without it");
  }
}

std::vector<std::string> class_names(const std::string& base, const std::string& library) {
  std::vector<std::string> names;
  for (const RegisteredClass& registered : classes()) {
    if (registered.base == base && is_of(registered, library)) {
      names.push_back(registered.name);
    }
  }
  return names;
}

std::vector<std::pair<std::string, std::string>> classes_and_libraries(const std::string& base) {
  std::vector<std::pair<std::string, std::string>> found;
  for (const RegisteredClass& registered : classes()) {
    if (registered.base == base) {
      found.emplace_back(registered.name, registered.library);
    }
  }
  return found;
}

void* make_object(const std::string& name, const std::string& base, const std::string& library) {
  for (const RegisteredClass& registered : classes()) {
    if (registered.base == base && registered.name == name && is_of(registered, library)) {
      return registered.make();
    }
  }
  throw CreateClassException("Could not create instance of type " + name);
}

}  // namespace impl
}  // namespace class_loader
