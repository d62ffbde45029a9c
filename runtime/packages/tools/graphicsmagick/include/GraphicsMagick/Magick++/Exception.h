// Exceptions of Magick++: an Error ends a call, a Warning leaves a result.
#pragma once

#include <exception>
#include <string>
#include <utility>

namespace Magick {

class Exception : public std::exception {
 public:
  explicit Exception(std::string what) : what_(std::move(what)) {}
  const char* what() const noexcept override { return what_.c_str(); }

 private:
  std::string what_;
};

class Warning : public Exception {
  using Exception::Exception;
};
class Error : public Exception {
  using Exception::Exception;
};

class ErrorBlob : public Error {
  using Error::Error;
};
class ErrorCoder : public Error {
  using Error::Error;
};
class ErrorCorruptImage : public Error {
  using Error::Error;
};
class ErrorFileOpen : public Error {
  using Error::Error;
};
class ErrorMissingDelegate : public Error {
  using Error::Error;
};
class ErrorOption : public Error {
  using Error::Error;
};
class ErrorResourceLimit : public Error {
  using Error::Error;
};
class WarningOption : public Warning {
  using Warning::Warning;
};

}  // namespace Magick
