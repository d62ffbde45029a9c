// A status that is easier to fill: summaries that merge, values of any type.
#pragma once

#include <cstdarg>
#include <sstream>
#include <string>

#include "diagnostic_msgs/msg/diagnostic_status.hpp"
#include "diagnostic_msgs/msg/key_value.hpp"

namespace diagnostic_updater {

class DiagnosticStatusWrapper : public diagnostic_msgs::msg::DiagnosticStatus {
 public:
  void summary(unsigned char lvl, const std::string s) {
    level = lvl;
    message = s;
  }
  void summary(const diagnostic_msgs::msg::DiagnosticStatus& src) {
    summary(src.level, src.message);
  }
  void summaryf(unsigned char lvl, const char* format, ...) __attribute__((format(printf, 3, 4)));
  /// The worse level wins; messages stand beside each other when both are OK or neither is.
  void mergeSummary(unsigned char lvl, const std::string s);
  void mergeSummary(const diagnostic_msgs::msg::DiagnosticStatus& src) {
    mergeSummary(src.level, src.message);
  }
  void mergeSummaryf(unsigned char lvl, const char* format, ...)
      __attribute__((format(printf, 3, 4)));
  void clearSummary() { summary(OK, ""); }

  template <class T>
  void add(const std::string& key, const T& val) {
    std::ostringstream text;
    text << val;
    add(key, text.str());
  }
  void add(const std::string& key, const std::string& val);
  void add(const std::string& key, const char* val) { add(key, std::string(val)); }
  void add(const std::string& key, bool val) { add(key, val ? "True" : "False"); }
  void addf(const std::string& key, const char* format, ...) __attribute__((format(printf, 3, 4)));
  void clear() { values.clear(); }
};

}  // namespace diagnostic_updater
