// A controller that adds what an error is, was and will be.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "rclcpp/rclcpp.hpp"

namespace control_toolbox {

/// The method that stops the integral from growing while the command is at its limit.
struct AntiWindupStrategy {
  enum Value : int8_t {
    UNDEFINED = -1,
    NONE,
    LEGACY,                  ///< limits of the integral alone
    BACK_CALCULATION,        ///< the integral is led back by how far the command is over its limit
    CONDITIONAL_INTEGRATION  ///< an error that leads further over the limit is not added
  };

  /// By the name that parameters have. Throws std::invalid_argument.
  void set_type(const std::string& name);
  /// Throws std::invalid_argument when the values do not go together.
  void validate() const;
  [[nodiscard]] std::string to_string() const;
  operator std::string() const { return to_string(); }
  bool operator==(Value other) const { return type == other; }
  bool operator!=(Value other) const { return type != other; }

  Value type = UNDEFINED;
  double i_min = -std::numeric_limits<double>::infinity();
  double i_max = std::numeric_limits<double>::infinity();
  bool legacy_antiwindup = false;  ///< of LEGACY: is the integral itself kept within its limits?
  double tracking_time_constant = 0.0;                             ///< [s]
  double error_deadband = std::numeric_limits<double>::epsilon();  ///< smaller errors are not added
};

template <typename T>
bool is_zero(T value, T tolerance = std::numeric_limits<T>::epsilon()) {
  return std::abs(value) <= tolerance;
}

class Pid {
 public:
  struct Gains {
    Gains() = default;
    Gains(double p, double i, double d, double i_max, double i_min, bool antiwindup = false);
    Gains(double p, double i, double d, double u_max, double u_min,
          const AntiWindupStrategy& antiwindup_strat);
    /// False, with the reason.
    bool validate(std::string& error_msg) const;

    double p_gain_ = 0.0;
    double i_gain_ = 0.0;
    double d_gain_ = 0.0;
    double i_max_ = std::numeric_limits<double>::infinity();
    double i_min_ = -std::numeric_limits<double>::infinity();
    double u_max_ = std::numeric_limits<double>::infinity();
    double u_min_ = -std::numeric_limits<double>::infinity();
    bool antiwindup_ = false;
    AntiWindupStrategy antiwindup_strat_;
  };

  /// Throws std::invalid_argument for limits that are the wrong way round, as the next one.
  explicit Pid(double p = 0.0, double i = 0.0, double d = 0.0,
               double i_max = std::numeric_limits<double>::infinity(),
               double i_min = -std::numeric_limits<double>::infinity(), bool antiwindup = false);
  Pid(double p, double i, double d, double u_max, double u_min,
      const AntiWindupStrategy& antiwindup_strat);
  /// The gains, not what has been added up.
  Pid(const Pid& source);
  Pid& operator=(const Pid& source);

  /// Gains, and nothing added up; false when they are wrong, and all stays as it was.
  bool initialize(double p, double i, double d, double i_max, double i_min,
                  bool antiwindup = false);
  bool initialize(double p, double i, double d, double u_max, double u_min,
                  const AntiWindupStrategy& antiwindup_strat);
  void initPid(double p, double i, double d, double i_max, double i_min, bool antiwindup = false) {
    initialize(p, i, d, i_max, i_min, antiwindup);
  }
  void reset() { reset(false); }
  void reset(bool save_i_term);
  void clear_saved_iterm() { i_term_ = 0.0; }

  void get_gains(double& p, double& i, double& d, double& i_max, double& i_min) const;
  void get_gains(double& p, double& i, double& d, double& i_max, double& i_min,
                 bool& antiwindup) const;
  [[nodiscard]] Gains get_gains() const { return gains_; }
  [[nodiscard]] Gains getGains() const { return gains_; }
  bool set_gains(double p, double i, double d, double i_max, double i_min, bool antiwindup = false);
  bool set_gains(double p, double i, double d, double u_max, double u_min,
                 const AntiWindupStrategy& antiwindup_strat);
  bool set_gains(const Gains& gains);
  void setGains(double p, double i, double d, double i_max, double i_min, bool antiwindup = false) {
    set_gains(p, i, d, i_max, i_min, antiwindup);
  }
  void setGains(const Gains& gains) { set_gains(gains); }

  /// For an error, and the time since the last one [s]; NaN for an error that is not a number.
  /// Throws std::invalid_argument for a time before the last one.
  [[nodiscard]] double compute_command(double error, const double& dt_s);
  [[nodiscard]] double compute_command(double error, double error_dot, const double& dt_s);
  [[nodiscard]] double compute_command(double error, const int64_t& dt_ns) {
    return compute_command(error, static_cast<double>(dt_ns) * 1e-9);
  }
  [[nodiscard]] double compute_command(double error, const rclcpp::Duration& dt) {
    return compute_command(error, dt.seconds());
  }
  [[nodiscard]] double compute_command(double error, const std::chrono::nanoseconds& dt) {
    return compute_command(error, std::chrono::duration<double>(dt).count());
  }
  [[nodiscard]] double compute_command(double error, double error_dot, const int64_t& dt_ns) {
    return compute_command(error, error_dot, static_cast<double>(dt_ns) * 1e-9);
  }
  [[nodiscard]] double compute_command(double error, double error_dot, const rclcpp::Duration& dt) {
    return compute_command(error, error_dot, dt.seconds());
  }
  [[nodiscard]] double compute_command(double error, double error_dot,
                                       const std::chrono::nanoseconds& dt) {
    return compute_command(error, error_dot, std::chrono::duration<double>(dt).count());
  }
  [[nodiscard]] double computeCommand(double error, uint64_t dt_ns) {
    return compute_command(error, static_cast<double>(dt_ns) * 1e-9);
  }
  [[nodiscard]] double computeCommand(double error, double error_dot, uint64_t dt_ns) {
    return compute_command(error, error_dot, static_cast<double>(dt_ns) * 1e-9);
  }

  void set_current_cmd(double cmd) { cmd_ = cmd; }
  void setCurrentCmd(double cmd) { cmd_ = cmd; }
  [[nodiscard]] double get_current_cmd() const { return cmd_; }
  [[nodiscard]] double getCurrentCmd() const { return cmd_; }
  void get_current_pid_errors(double& pe, double& ie, double& de) const;
  void getCurrentPIDErrors(double& pe, double& ie, double& de) const {
    get_current_pid_errors(pe, ie, de);
  }

 protected:
  Gains gains_;
  double p_error_last_ = 0;
  double p_error_ = 0;
  double d_error_ = 0;
  double i_term_ = 0;  ///< what has been added up, times its gain
  double cmd_ = 0;
  double cmd_unsat_ = 0;  ///< before its limits

 private:
  /// False when the time is none, so nothing changes.
  static bool has_passed(double dt_s);
  void add_up(double dt_s);
};

}  // namespace control_toolbox
