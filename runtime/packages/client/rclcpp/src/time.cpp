// Time and Duration: checked arithmetic on nanoseconds.
#include "rclcpp/time.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace rclcpp {
namespace {

constexpr int64_t kSecond = 1000000000;

int64_t checked_add(int64_t a, int64_t b, const char* what) {
  int64_t sum = 0;
  if (__builtin_add_overflow(a, b, &sum)) {
    if (a > 0) {
      throw std::overflow_error(std::string(what) + " leads to int64_t overflow");
    }
    throw std::underflow_error(std::string(what) + " leads to int64_t underflow");
  }
  return sum;
}

int64_t checked_subtract(int64_t a, int64_t b, const char* what) {
  int64_t difference = 0;
  if (__builtin_sub_overflow(a, b, &difference)) {
    if (a >= 0) {
      throw std::overflow_error(std::string(what) + " leads to int64_t overflow");
    }
    throw std::underflow_error(std::string(what) + " leads to int64_t underflow");
  }
  return difference;
}

template <typename MessageT>
MessageT to_message(int64_t nanoseconds) {
  MessageT message;
  int64_t seconds = nanoseconds / kSecond;
  int64_t rest = nanoseconds % kSecond;
  if (rest < 0) {
    seconds -= 1;
    rest += kSecond;
  }
  if (seconds > std::numeric_limits<int32_t>::max()) {
    message.sec = std::numeric_limits<int32_t>::max();
    message.nanosec = std::numeric_limits<uint32_t>::max();
  } else if (seconds < std::numeric_limits<int32_t>::min()) {
    message.sec = std::numeric_limits<int32_t>::min();
    message.nanosec = 0;
  } else {
    message.sec = static_cast<int32_t>(seconds);
    message.nanosec = static_cast<uint32_t>(rest);
  }
  return message;
}

void require_same_clock(const rcl_time_point_t& left, const Time& right) {
  if (left.clock_type != right.get_clock_type()) {
    throw std::runtime_error("can't compare times with different time sources");
  }
}

int64_t require_positive(int64_t nanoseconds) {
  if (nanoseconds < 0) {
    throw std::runtime_error("cannot store a negative time point in rclcpp::Time");
  }
  return nanoseconds;
}

}  // namespace

Duration::Duration(int32_t seconds, uint32_t nanoseconds)
    : nanoseconds_(static_cast<int64_t>(seconds) * kSecond + nanoseconds) {}
Duration::Duration(std::chrono::nanoseconds nanoseconds) : nanoseconds_(nanoseconds.count()) {}
Duration::Duration(const builtin_interfaces::msg::Duration& duration_msg)
    : Duration(duration_msg.sec, duration_msg.nanosec) {}
Duration::Duration(const rcl_duration_t& duration) : nanoseconds_(duration.nanoseconds) {}

Duration::operator builtin_interfaces::msg::Duration() const {
  return to_message<builtin_interfaces::msg::Duration>(nanoseconds_);
}

Duration& Duration::operator=(const builtin_interfaces::msg::Duration& duration_msg) {
  return *this = Duration(duration_msg);
}

bool Duration::operator==(const Duration& rhs) const {
  return nanoseconds_ == rhs.nanoseconds_;
}
bool Duration::operator!=(const Duration& rhs) const {
  return nanoseconds_ != rhs.nanoseconds_;
}
bool Duration::operator<(const Duration& rhs) const {
  return nanoseconds_ < rhs.nanoseconds_;
}
bool Duration::operator<=(const Duration& rhs) const {
  return nanoseconds_ <= rhs.nanoseconds_;
}
bool Duration::operator>=(const Duration& rhs) const {
  return nanoseconds_ >= rhs.nanoseconds_;
}
bool Duration::operator>(const Duration& rhs) const {
  return nanoseconds_ > rhs.nanoseconds_;
}

Duration Duration::operator+(const Duration& rhs) const {
  return from_nanoseconds(checked_add(nanoseconds_, rhs.nanoseconds_, "addition"));
}
Duration& Duration::operator+=(const Duration& rhs) {
  return *this = *this + rhs;
}
Duration Duration::operator-(const Duration& rhs) const {
  return from_nanoseconds(checked_subtract(nanoseconds_, rhs.nanoseconds_, "duration subtraction"));
}
Duration& Duration::operator-=(const Duration& rhs) {
  return *this = *this - rhs;
}

Duration Duration::operator*(double scale) const {
  if (!std::isfinite(scale)) {
    throw std::runtime_error("abnormal scale in rclcpp::Duration");
  }
  const long double scaled = static_cast<long double>(nanoseconds_) * scale;
  if (scaled >= static_cast<long double>(std::numeric_limits<int64_t>::max())) {
    throw std::overflow_error("duration scaling leads to int64_t overflow");
  }
  if (scaled <= static_cast<long double>(std::numeric_limits<int64_t>::min())) {
    throw std::underflow_error("duration scaling leads to int64_t underflow");
  }
  return from_nanoseconds(static_cast<int64_t>(scaled));
}
Duration& Duration::operator*=(double scale) {
  return *this = *this * scale;
}

Duration Duration::max() {
  return from_nanoseconds(std::numeric_limits<int64_t>::max());
}
double Duration::seconds() const {
  return static_cast<double>(nanoseconds_) * 1e-9;
}
Duration Duration::from_seconds(double seconds) {
  return from_nanoseconds(static_cast<int64_t>(seconds * 1e9));
}
Duration Duration::from_nanoseconds(rcl_duration_value_t nanoseconds) {
  Duration duration;
  duration.nanoseconds_ = nanoseconds;
  return duration;
}
Duration Duration::from_rmw_time(rmw_time_t duration) {
  return from_nanoseconds(rmw_time_total_nsec(duration));
}
rmw_time_t Duration::to_rmw_time() const {
  if (nanoseconds_ < 0) {
    throw std::runtime_error("rmw_time_t cannot be negative");
  }
  return rmw_time_from_nsec(nanoseconds_);
}

Time::Time(int32_t seconds, uint32_t nanoseconds, rcl_clock_type_t clock_type)
    : time_{static_cast<int64_t>(seconds) * kSecond + nanoseconds, clock_type} {
  require_positive(seconds);
}
Time::Time(int64_t nanoseconds, rcl_clock_type_t clock_type) : time_{nanoseconds, clock_type} {}
Time::Time(const builtin_interfaces::msg::Time& time_msg, rcl_clock_type_t clock_type)
    : Time(time_msg.sec, time_msg.nanosec, clock_type) {}
Time::Time(const rcl_time_point_t& time_point) : time_(time_point) {}

Time::operator builtin_interfaces::msg::Time() const {
  return convert_rcl_time_to_sec_nanos(time_.nanoseconds);
}
Time& Time::operator=(const builtin_interfaces::msg::Time& time_msg) {
  return *this = Time(time_msg);
}

bool Time::operator==(const Time& rhs) const {
  require_same_clock(time_, rhs);
  return nanoseconds() == rhs.nanoseconds();
}
bool Time::operator!=(const Time& rhs) const {
  return !(*this == rhs);
}
bool Time::operator<(const Time& rhs) const {
  require_same_clock(time_, rhs);
  return nanoseconds() < rhs.nanoseconds();
}
bool Time::operator<=(const Time& rhs) const {
  return !(*this > rhs);
}
bool Time::operator>=(const Time& rhs) const {
  return !(*this < rhs);
}
bool Time::operator>(const Time& rhs) const {
  require_same_clock(time_, rhs);
  return nanoseconds() > rhs.nanoseconds();
}

Time Time::operator+(const Duration& rhs) const {
  return Time(checked_add(nanoseconds(), rhs.nanoseconds(), "addition"), time_.clock_type);
}
Duration Time::operator-(const Time& rhs) const {
  if (time_.clock_type != rhs.time_.clock_type) {
    throw std::runtime_error("can't subtract times with different time sources [" +
                             std::to_string(time_.clock_type) +
                             " != " + std::to_string(rhs.time_.clock_type) + "]");
  }
  return Duration::from_nanoseconds(
      checked_subtract(nanoseconds(), rhs.nanoseconds(), "time subtraction"));
}
Time Time::operator-(const Duration& rhs) const {
  return Time(checked_subtract(nanoseconds(), rhs.nanoseconds(), "time subtraction"),
              time_.clock_type);
}
Time& Time::operator+=(const Duration& rhs) {
  time_.nanoseconds = require_positive(checked_add(nanoseconds(), rhs.nanoseconds(), "addition"));
  return *this;
}
Time& Time::operator-=(const Duration& rhs) {
  time_.nanoseconds =
      require_positive(checked_subtract(nanoseconds(), rhs.nanoseconds(), "time subtraction"));
  return *this;
}

Time Time::max(rcl_clock_type_t clock_type) {
  return Time(std::numeric_limits<int64_t>::max(), clock_type);
}
double Time::seconds() const {
  return static_cast<double>(time_.nanoseconds) * 1e-9;
}

Time operator+(const Duration& lhs, const Time& rhs) {
  return rhs + lhs;
}

builtin_interfaces::msg::Time operator+(const builtin_interfaces::msg::Time& lhs,
                                        const Duration& rhs) {
  return Time(lhs) + rhs;
}

builtin_interfaces::msg::Time operator-(const builtin_interfaces::msg::Time& lhs,
                                        const Duration& rhs) {
  return Time(lhs) - rhs;
}

builtin_interfaces::msg::Time convert_rcl_time_to_sec_nanos(rcl_time_point_value_t nanoseconds) {
  return to_message<builtin_interfaces::msg::Time>(nanoseconds);
}

}  // namespace rclcpp
