// The report of a filter on /diagnostics: odd settings in each, odd messages in one.
#pragma once

#include <map>
#include <string>

#include "diagnostic_updater/diagnostic_updater.hpp"
#include "node/filter_parameters.hpp"

namespace robot_localization {

class FilterReport {
 public:
  using Status = diagnostic_msgs::msg::DiagnosticStatus;

  /// Nothing is stored when no report is wanted.
  explicit FilterReport(bool is_wanted) : is_wanted_(is_wanted) {}

  bool is_wanted() const { return is_wanted_; }
  /// Variables that two inputs measure, or none.
  void check_settings(const FilterParameters& parameters);
  /// Stays until the next report.
  void warn(const std::string& key, const std::string& text);
  /// Variances that are zero, negative or huge. `begin` is the variable of the first row.
  template <typename Matrix>
  void check_covariance(const std::string& source, const Matrix& covariance, int begin,
                        const Variables& update) {
    if (!is_wanted_) return;
    for (int i = 0; i < static_cast<int>(covariance.rows()); ++i) {
      for (int j = 0; j < static_cast<int>(covariance.cols()); ++j) {
        check_entry(source, covariance(i, j), begin + i, begin + j,
                    static_cast<int>(covariance.cols()) * i + j, update);
      }
    }
  }
  void fill(diagnostic_updater::DiagnosticStatusWrapper& status);

 private:
  void check_entry(const std::string& source, double value, int row, int column, int position,
                   const Variables& update);
  void add_setting(uint8_t level, const std::string& key, const std::string& text);

  bool is_wanted_;
  uint8_t setting_level_ = Status::OK;
  uint8_t message_level_ = Status::OK;
  std::map<std::string, std::string> settings_;
  std::map<std::string, std::string> messages_;
};

}  // namespace robot_localization
