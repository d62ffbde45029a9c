// See pid.hpp.
#include "control_toolbox/pid.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace control_toolbox {
namespace {

using Strategy = AntiWindupStrategy;

constexpr std::pair<Strategy::Value, const char*> kNames[] = {
    {Strategy::NONE, "none"},
    {Strategy::LEGACY, "legacy"},
    {Strategy::BACK_CALCULATION, "back_calculation"},
    {Strategy::CONDITIONAL_INTEGRATION, "conditional_integration"}};

Strategy legacy(double i_max, double i_min, bool antiwindup) {
  Strategy strategy;
  strategy.type = Strategy::LEGACY;
  strategy.i_max = i_max;
  strategy.i_min = i_min;
  strategy.legacy_antiwindup = antiwindup;
  return strategy;
}

double not_a_number(const char* what) {
  std::fprintf(stderr, "Received a non-finite %s value\n", what);
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void AntiWindupStrategy::set_type(const std::string& name) {
  for (const auto& [value, its_name] : kNames) {
    if (name != its_name) continue;
    type = value;
    return;
  }
  type = UNDEFINED;
  throw std::invalid_argument("AntiWindupStrategy: Unknown antiwindup strategy : '" + name +
                              "'. Valid strategies are: 'back_calculation', "
                              "'conditional_integration', 'legacy', 'none'.");
}

void AntiWindupStrategy::validate() const {
  if (type == UNDEFINED) {
    throw std::invalid_argument("AntiWindupStrategy is UNDEFINED. Please set a valid type");
  }
  if (type == BACK_CALCULATION &&
      (tracking_time_constant < 0.0 || !std::isfinite(tracking_time_constant))) {
    throw std::invalid_argument(
        "AntiWindupStrategy 'back_calculation' requires a valid positive tracking time constant "
        "(tracking_time_constant)");
  }
  if (i_min > 0 || i_max < 0) {
    throw std::invalid_argument(i_min > 0 ? "PID requires i_min to be smaller or equal to 0"
                                          : "PID requires i_max to be greater or equal to 0");
  }
}

std::string AntiWindupStrategy::to_string() const {
  for (const auto& [value, name] : kNames) {
    if (type == value) return name;
  }
  return "UNDEFINED";
}

Pid::Gains::Gains(double p, double i, double d, double i_max, double i_min, bool antiwindup)
    : p_gain_(p),
      i_gain_(i),
      d_gain_(d),
      i_max_(i_max),
      i_min_(i_min),
      antiwindup_(antiwindup),
      antiwindup_strat_(legacy(i_max, i_min, antiwindup)) {}

Pid::Gains::Gains(double p, double i, double d, double u_max, double u_min,
                  const AntiWindupStrategy& antiwindup_strat)
    : p_gain_(p),
      i_gain_(i),
      d_gain_(d),
      i_max_(antiwindup_strat.i_max),
      i_min_(antiwindup_strat.i_min),
      u_max_(u_max),
      u_min_(u_min),
      antiwindup_(antiwindup_strat.legacy_antiwindup),
      antiwindup_strat_(antiwindup_strat) {}

bool Pid::Gains::validate(std::string& error_msg) const {
  if (std::isnan(u_min_) || std::isnan(u_max_)) {
    error_msg = "Gains: u_min and u_max must not be NaN";
    return false;
  }
  if (u_min_ >= u_max_) {
    error_msg = "Gains: u_min (" + std::to_string(u_min_) + ") must be less than u_max (" +
                std::to_string(u_max_) + ")";
    return false;
  }
  try {
    antiwindup_strat_.validate();
  } catch (const std::invalid_argument& error) {
    error_msg = error.what();
    return false;
  }
  return true;
}

Pid::Pid(double p, double i, double d, double i_max, double i_min, bool antiwindup) {
  if (i_min > i_max) throw std::invalid_argument("received i_min > i_max");
  set_gains(p, i, d, i_max, i_min, antiwindup);
}

Pid::Pid(double p, double i, double d, double u_max, double u_min,
         const AntiWindupStrategy& antiwindup_strat) {
  if (u_min >= u_max) throw std::invalid_argument("received u_min >= u_max");
  set_gains(p, i, d, u_max, u_min, antiwindup_strat);
}

Pid::Pid(const Pid& source) : gains_(source.gains_) {}

Pid& Pid::operator=(const Pid& source) {
  if (this == &source) return *this;
  gains_ = source.gains_;
  reset();
  return *this;
}

bool Pid::initialize(double p, double i, double d, double i_max, double i_min, bool antiwindup) {
  if (!set_gains(p, i, d, i_max, i_min, antiwindup)) return false;
  reset();
  return true;
}

bool Pid::initialize(double p, double i, double d, double u_max, double u_min,
                     const AntiWindupStrategy& antiwindup_strat) {
  if (!set_gains(p, i, d, u_max, u_min, antiwindup_strat)) return false;
  reset();
  return true;
}

void Pid::reset(bool save_i_term) {
  p_error_last_ = p_error_ = d_error_ = cmd_ = 0.0;
  if (!save_i_term) clear_saved_iterm();
}

void Pid::get_gains(double& p, double& i, double& d, double& i_max, double& i_min) const {
  p = gains_.p_gain_;
  i = gains_.i_gain_;
  d = gains_.d_gain_;
  i_max = gains_.i_max_;
  i_min = gains_.i_min_;
}

void Pid::get_gains(double& p, double& i, double& d, double& i_max, double& i_min,
                    bool& antiwindup) const {
  get_gains(p, i, d, i_max, i_min);
  antiwindup = gains_.antiwindup_;
}

bool Pid::set_gains(double p, double i, double d, double i_max, double i_min, bool antiwindup) {
  return set_gains(Gains(p, i, d, i_max, i_min, antiwindup));
}

bool Pid::set_gains(double p, double i, double d, double u_max, double u_min,
                    const AntiWindupStrategy& antiwindup_strat) {
  return set_gains(Gains(p, i, d, u_max, u_min, antiwindup_strat));
}

bool Pid::set_gains(const Gains& gains) {
  std::string why;
  if (!gains.validate(why)) {
    std::fprintf(stderr, "PID: Invalid gains: %s. Skipping new gains.\n", why.c_str());
    return false;
  }
  gains_ = gains;
  Strategy& strategy = gains_.antiwindup_strat_;
  if (strategy == Strategy::BACK_CALCULATION && is_zero(strategy.tracking_time_constant) &&
      !is_zero(gains_.i_gain_)) {
    // As long as the controller itself takes.
    strategy.tracking_time_constant = is_zero(gains_.d_gain_)
                                          ? gains_.p_gain_ / gains_.i_gain_
                                          : std::sqrt(gains_.d_gain_ / gains_.i_gain_);
  }
  return true;
}

bool Pid::has_passed(double dt_s) {
  if (dt_s < 0.0 && !is_zero(dt_s)) throw std::invalid_argument("Pid is called with negative dt");
  return !is_zero(dt_s);
}

double Pid::compute_command(double error, const double& dt_s) {
  if (!has_passed(dt_s)) return cmd_;
  if (!std::isfinite(error)) return cmd_ = not_a_number("error");
  const double error_dot = (error - p_error_last_) / dt_s;
  p_error_last_ = error;
  return compute_command(error, error_dot, dt_s);
}

double Pid::compute_command(double error, double error_dot, const double& dt_s) {
  if (!has_passed(dt_s)) return cmd_;
  p_error_ = error;
  d_error_ = error_dot;
  if (!std::isfinite(error) || !std::isfinite(error_dot)) {
    return cmd_ = not_a_number("error/error_dot");
  }
  const Strategy& strategy = gains_.antiwindup_strat_;
  if (strategy == Strategy::UNDEFINED) {
    throw std::runtime_error(
        "PID: Antiwindup strategy cannot be UNDEFINED. Please set a valid antiwindup strategy.");
  }
  const bool counts = !is_zero(error, strategy.error_deadband);
  double integral = i_term_;
  if (strategy == Strategy::LEGACY) {
    if (counts) i_term_ += gains_.i_gain_ * dt_s * error;
    integral = std::clamp(i_term_, gains_.i_min_, gains_.i_max_);
    if (strategy.legacy_antiwindup) i_term_ = integral;
  }
  cmd_unsat_ = gains_.p_gain_ * error + integral + gains_.d_gain_ * error_dot;
  cmd_ = std::clamp(cmd_unsat_, gains_.u_min_, gains_.u_max_);
  if (counts) add_up(dt_s);
  i_term_ = std::clamp(i_term_, strategy.i_min, strategy.i_max);
  return cmd_;
}

void Pid::add_up(double dt_s) {
  const Strategy& strategy = gains_.antiwindup_strat_;
  const double step = dt_s * gains_.i_gain_ * p_error_;
  if (strategy == Strategy::NONE) i_term_ += step;
  if (strategy == Strategy::CONDITIONAL_INTEGRATION) {
    const bool leads_further = !is_zero(cmd_unsat_ - cmd_) && p_error_ * cmd_unsat_ > 0;
    if (!leads_further) i_term_ += step;
  }
  if (strategy == Strategy::BACK_CALCULATION && !is_zero(gains_.i_gain_)) {
    i_term_ += step + dt_s * (cmd_ - cmd_unsat_) / strategy.tracking_time_constant;
  }
}

void Pid::get_current_pid_errors(double& pe, double& ie, double& de) const {
  pe = p_error_;
  ie = i_term_;
  de = d_error_;
}

}  // namespace control_toolbox
