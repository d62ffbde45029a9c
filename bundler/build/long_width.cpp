// See long_width.hpp.
#include "bundler/build/long_width.hpp"

#include <regex>

namespace ros2wasm {
namespace {

constexpr const char* kWidth = "`long` has 32 bits in a site, and 64 natively";

bool ends_with_flag(const std::string& message, std::string_view flag) {
  return message.ends_with("[-W" + std::string(flag) + "]") ||
         message.ends_with("[-Werror,-W" + std::string(flag) + "]");
}

/// The type a conversion leads to is `long`, under a name that is not one of sizes.
bool leads_to_long(const std::string& message) {
  static const std::regex kTarget(R"rx( to '([^']+)'(?: \(aka '([^']+)'\))? )rx");
  static const std::regex kSize(
      R"((?:^|::)(?:size_t|ssize_t|ptrdiff_t|size_type|difference_type|streamsize)$)");
  static const std::regex kLong(R"((?:const |volatile )*(?:unsigned )?long)");
  std::smatch target;
  if (!std::regex_search(message, target, kTarget)) return false;
  const std::string name = target[1];
  return !std::regex_search(name, kSize) &&
         std::regex_match(target[2].matched ? target[2].str() : name, kLong);
}

}  // namespace

bool is_worth_saying(const std::string& message) {
  return !ends_with_flag(message, "shorten-64-to-32") || leads_to_long(message);
}

void explain_long_width(Diagnostic& diagnostic) {
  const std::string& message = diagnostic.message;
  if (ends_with_flag(message, "shorten-64-to-32") ||
      (ends_with_flag(message, "constant-conversion") && leads_to_long(message))) {
    diagnostic.why.emplace_back(kWidth);
    diagnostic.fix.emplace_back("write `int64_t` (or `auto`) instead of `long`");
  } else if (ends_with_flag(message, "format") && message.find("long") != std::string::npos) {
    diagnostic.why.emplace_back(kWidth);
    diagnostic.why.emplace_back(
        "in C, and in functions of your own with `...`, the argument is read in the width of the "
        "site");
    diagnostic.fix.emplace_back("write `%\" PRId64 \"` of <inttypes.h>, which is right on both");
  } else if (ends_with_flag(message, "format-nonliteral")) {
    diagnostic.why.emplace_back(
        "a 64-bit argument of this function would be read by half for `%ld`, as `long` has 32 bits "
        "in a site");
    diagnostic.fix.emplace_back(
        "declare the function with `__attribute__((format(printf, ...)))`, and its calls are "
        "checked");
  }
}

}  // namespace ros2wasm
