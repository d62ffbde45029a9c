// The list of registered classes.
#include "class_loader/class_loader.hpp"

namespace class_loader {
namespace impl {
namespace {

std::vector<RegisteredClass>& classes() {
  static std::vector<RegisteredClass> all;
  return all;
}

}  // namespace

void register_class(RegisteredClass registered) {
  classes().push_back(std::move(registered));
}

std::vector<std::string> class_names(const std::string& base) {
  std::vector<std::string> names;
  for (const RegisteredClass& registered : classes()) {
    if (registered.base == base) {
      names.push_back(registered.name);
    }
  }
  return names;
}

void* make_object(const std::string& name, const std::string& base) {
  for (const RegisteredClass& registered : classes()) {
    if (registered.base == base && registered.name == name) {
      return registered.make();
    }
  }
  throw CreateClassException("Could not create instance of type " + name);
}

}  // namespace impl
}  // namespace class_loader
