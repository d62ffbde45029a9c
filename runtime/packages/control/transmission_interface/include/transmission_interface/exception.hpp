// The exception of transmissions.
#pragma once

#include <exception>
#include <string>

namespace transmission_interface {

class Exception : public std::exception {
 public:
  explicit Exception(const char* message) : text_(message) {}
  explicit Exception(const std::string& message) : text_(message) {}
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

}  // namespace transmission_interface
