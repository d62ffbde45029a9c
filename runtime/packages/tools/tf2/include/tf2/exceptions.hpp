// Why a transform cannot be had.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace tf2 {

enum class TF2Error : std::uint8_t {
  TF2_NO_ERROR = 0,
  TF2_LOOKUP_ERROR = 1,
  TF2_CONNECTIVITY_ERROR = 2,
  TF2_EXTRAPOLATION_ERROR = 3,
  TF2_INVALID_ARGUMENT_ERROR = 4,
  TF2_TIMEOUT_ERROR = 5,
  TF2_TRANSFORM_ERROR = 6,
  TF2_BACKWARD_EXTRAPOLATION_ERROR = 7,
  TF2_FORWARD_EXTRAPOLATION_ERROR = 8,
  TF2_NO_DATA_FOR_EXTRAPOLATION_ERROR = 9,

  NO_ERROR [[deprecated("Use TF2_NO_ERROR instead")]] = 0,
  LOOKUP_ERROR [[deprecated("Use TF2_LOOKUP_ERROR instead")]] = 1,
  CONNECTIVITY_ERROR [[deprecated("Use TF2_CONNECTIVITY_ERROR instead")]] = 2,
  EXTRAPOLATION_ERROR [[deprecated("Use TF2_EXTRAPOLATION_ERROR instead")]] = 3,
  INVALID_ARGUMENT_ERROR [[deprecated("Use TF2_INVALID_ARGUMENT_ERROR instead")]] = 4,
  TIMEOUT_ERROR [[deprecated("Use TF2_TIMEOUT_ERROR instead")]] = 5,
  TRANSFORM_ERROR [[deprecated("Use TF2_TRANSFORM_ERROR instead")]] = 6,
};

class TransformException : public std::runtime_error {
 public:
  explicit TransformException(const std::string& errorDescription)
      : std::runtime_error(errorDescription) {}
};

/// The two frames are in different trees.
class ConnectivityException : public TransformException {
 public:
  using TransformException::TransformException;
};

/// A frame does not exist.
class LookupException : public TransformException {
 public:
  using TransformException::TransformException;
};

/// The time is outside of what the buffer has.
class ExtrapolationException : public TransformException {
 public:
  using TransformException::TransformException;
};

class BackwardExtrapolationException : public ExtrapolationException {
 public:
  using ExtrapolationException::ExtrapolationException;
};

class ForwardExtrapolationException : public ExtrapolationException {
 public:
  using ExtrapolationException::ExtrapolationException;
};

/// Only one transform is there, of another time.
class NoDataForExtrapolationException : public ExtrapolationException {
 public:
  using ExtrapolationException::ExtrapolationException;
};

class InvalidArgumentException : public TransformException {
 public:
  using TransformException::TransformException;
};

class TimeoutException : public TransformException {
 public:
  using TransformException::TransformException;
};

}  // namespace tf2
