// See filter_report.hpp.
#include "node/filter_report.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace robot_localization {
namespace {

constexpr const char* kNames[kStateSize] = {"X",
                                            "Y",
                                            "Z",
                                            "ROLL",
                                            "PITCH",
                                            "YAW",
                                            "X_VELOCITY",
                                            "Y_VELOCITY",
                                            "Z_VELOCITY",
                                            "ROLL_VELOCITY",
                                            "PITCH_VELOCITY",
                                            "YAW_VELOCITY",
                                            "X_ACCELERATION",
                                            "Y_ACCELERATION",
                                            "Z_ACCELERATION"};

constexpr double kHugeCovariance = 1e3;

/// How many inputs measure each variable.
std::array<int, kStateSize> counted(const FilterParameters& parameters) {
  std::array<int, kStateSize> counts{};
  for (const auto* inputs :
       {&parameters.odoms, &parameters.poses, &parameters.twists, &parameters.imus}) {
    for (const InputParameters& input : *inputs) {
      for (int i = 0; i < kStateSize; ++i) {
        if (!input.config[i]) continue;
        ++counts[i < kPoseSize && input.is_differential ? i + kVx : i];
      }
    }
  }
  return counts;
}

bool is_in_plane(int pose_member) {
  return pose_member == kX || pose_member == kY || pose_member == kYaw;
}

std::string summary_of(uint8_t level) {
  if (level == FilterReport::Status::OK) {
    return "The robot_localization state estimation node appears to be functioning properly.";
  }
  const std::string what =
      level == FilterReport::Status::ERROR ? "Erroneous" : "Potentially erroneous";
  return what + " data or settings detected for a robot_localization state estimation node.";
}

}  // namespace

void FilterReport::add_setting(uint8_t level, const std::string& key, const std::string& text) {
  if (!is_wanted_) return;
  settings_[key] = text;
  setting_level_ = std::max(setting_level_, level);
}

void FilterReport::warn(const std::string& key, const std::string& text) {
  if (!is_wanted_) return;
  messages_[key] = text;
  message_level_ = std::max<uint8_t>(message_level_, Status::WARN);
}

void FilterReport::check_settings(const FilterParameters& parameters) {
  for (const InputParameters& input : parameters.odoms) {
    if (input.config.any()) continue;
    add_setting(Status::WARN, input.topic + "_configuration",
                input.topic + " is listed as an input topic, but all update variables are false");
  }
  const std::array<int, kStateSize> counts = counted(parameters);
  for (int i = 0; i < kPoseSize; ++i) {
    const std::string name = kNames[i];
    if (counts[i] > 1) {
      add_setting(Status::WARN, name + "_configuration",
                  std::to_string(counts[i]) + " absolute pose inputs detected for " + name +
                      ". This may result in oscillations. Please ensure that your variances for "
                      "each measured variable are set appropriately.");
    } else if (counts[i] == 0 && counts[i + kVx] == 0 && (is_in_plane(i) || !parameters.is_two_d)) {
      add_setting(Status::ERROR, name + "_configuration",
                  "Neither " + name +
                      " nor its velocity is being measured. This will result in "
                      "unbounded error growth and erratic filter behavior.");
    }
  }
}

void FilterReport::check_entry(const std::string& source, double value, int row, int column,
                               int position, const Variables& update) {
  const bool is_variance = row == column;
  const bool is_huge = value > kHugeCovariance && (update[row] || update[column]);
  if (!is_huge && (!is_variance || !update[row] || value > 0.0)) return;
  const std::string row_name = kNames[row];
  const std::string both =
      is_variance ? row_name + " variance" : row_name + " and " + kNames[column] + " covariance";
  std::ostringstream text;
  text << "The covariance at position (" << position << "), which corresponds to " << both;
  if (is_huge) {
    text << ", the value is extremely large (" << value << "), but the update vector for "
         << (is_variance ? row_name : row_name + " and/or " + kNames[column])
         << " is set to true. This may produce undesirable results.";
  } else {
    text << (value < 0.0 ? ", was negative" : ", was zero")
         << ". This will be replaced with a small positive value to maintain filter stability, "
            "but should be corrected at the message origin node.";
  }
  warn(source + "_covariance", text.str());
}

void FilterReport::fill(diagnostic_updater::DiagnosticStatusWrapper& status) {
  status.clear();
  const uint8_t level = std::max(setting_level_, message_level_);
  status.summary(level, summary_of(level));
  for (const auto& [key, text] : settings_) status.add(key, text);
  for (const auto& [key, text] : messages_) status.add(key, text);
  messages_.clear();
  message_level_ = Status::OK;
}

}  // namespace robot_localization
