// Loggers, their levels, and the console line, behind the interface of rcutils/logging.h.
// The line is built once and written with one call, so lines of threads do not mix.
#include "rcutils/logging.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "rcutils/allocator.h"
#include "rcutils/strcasecmp.h"
#include "rcutils/time.h"
#include "rcutils/types/char_array.h"

namespace {

enum class Token {
  text,
  severity,
  name,
  message,
  function_name,
  file_name,
  line_number,
  time,
  time_as_nanoseconds,
  date_time_with_ms
};

struct Piece {
  Token token;
  std::string text;
};

struct TokenName {
  std::string_view name;
  Token token;
};

constexpr TokenName kTokenNames[] = {
    {"severity", Token::severity},
    {"name", Token::name},
    {"message", Token::message},
    {"function_name", Token::function_name},
    {"file_name", Token::file_name},
    {"line_number", Token::line_number},
    {"time", Token::time},
    {"time_as_nanoseconds", Token::time_as_nanoseconds},
    {"date_time_with_ms", Token::date_time_with_ms},
};

constexpr char kDefaultFormat[] = "[{severity}] [{time}] [{name}]: {message}";

struct State {
  std::mutex mutex;
  std::map<std::string, int, std::less<>> levels;
  bool has_levels = false;
  int default_level = RCUTILS_DEFAULT_LOGGER_DEFAULT_LEVEL;
  rcutils_logging_output_handler_t handler = nullptr;
  std::vector<Piece> format;
  bool colors = false;
  FILE* stream = stderr;
};

State& state() {
  static State instance;
  return instance;
}

// "\n" and its kin, written with a backslash in the environment variable.
std::string unescape(std::string_view text) {
  constexpr std::string_view kLetters = "abfnrtv\\'\"?";
  constexpr std::string_view kMeanings = "\a\b\f\n\r\t\v\\'\"?";
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    const size_t letter = text[i] == '\\' && i + 1 < text.size() ? kLetters.find(text[i + 1])
                                                                 : std::string_view::npos;
    if (letter == std::string_view::npos) {
      out += text[i];
    } else {
      out += kMeanings[letter];
      ++i;
    }
  }
  return out;
}

std::vector<Piece> parse_format(std::string_view format) {
  std::vector<Piece> pieces;
  std::string text;
  size_t at = 0;
  while (at < format.size()) {
    bool found = false;
    if (format[at] == '{') {
      for (const TokenName& candidate : kTokenNames) {
        const size_t end = at + 1 + candidate.name.size();
        if (format.substr(at + 1, candidate.name.size()) == candidate.name && end < format.size() &&
            format[end] == '}') {
          if (!text.empty()) {
            pieces.push_back({Token::text, unescape(text)});
            text.clear();
          }
          pieces.push_back({candidate.token, {}});
          at = end + 1;
          found = true;
          break;
        }
      }
    }
    if (!found) {
      text += format[at++];
    }
  }
  if (!text.empty()) {
    pieces.push_back({Token::text, unescape(text)});
  }
  return pieces;
}

const char* severity_name(int severity) {
  if (severity < 0 || severity > RCUTILS_LOG_SEVERITY_FATAL ||
      g_rcutils_log_severity_names[severity] == nullptr) {
    return nullptr;
  }
  return g_rcutils_log_severity_names[severity];
}

const char* color_of(int severity) {
  switch (severity) {
    case RCUTILS_LOG_SEVERITY_DEBUG:
      return "\033[32m";
    case RCUTILS_LOG_SEVERITY_WARN:
      return "\033[33m";
    case RCUTILS_LOG_SEVERITY_ERROR:
    case RCUTILS_LOG_SEVERITY_FATAL:
      return "\033[31m";
    default:
      return "\033[0m";
  }
}

// In UTC: a page's programs know no time zone.
std::string date_time_with_ms(rcutils_time_point_value_t stamp) {
  constexpr int64_t kSecond = 1000000000;
  const int64_t seconds = stamp / kSecond;
  const int64_t of_day = seconds % 86400;
  // Days since 1 March of year 0, in eras of 400 years, so that leap days come last.
  const int64_t days = seconds / 86400 + 719468;
  const int64_t era = days / 146097;
  const int64_t of_era = days % 146097;
  const int64_t year_of_era = (of_era - of_era / 1460 + of_era / 36524 - of_era / 146096) / 365;
  const int64_t of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
  const int64_t month_from_march = (5 * of_year + 2) / 153;
  const int day = static_cast<int>(of_year - (153 * month_from_march + 2) / 5 + 1);
  const int month =
      static_cast<int>(month_from_march < 10 ? month_from_march + 3 : month_from_march - 9);
  const int year = static_cast<int>(year_of_era + era * 400 + (month <= 2 ? 1 : 0));
  char text[64];
  std::snprintf(text, sizeof(text), "%04d-%02d-%02d %02d:%02d:%02d.%03d", year, month, day,
                static_cast<int>(of_day / 3600), static_cast<int>(of_day / 60 % 60),
                static_cast<int>(of_day % 60), static_cast<int>(stamp / 1000000 % 1000));
  return text;
}

void append_piece(std::string& line, const Piece& piece, const rcutils_log_location_t* location,
                  int severity, const char* name, rcutils_time_point_value_t stamp,
                  const char* message) {
  char number[64];
  switch (piece.token) {
    case Token::text:
      line += piece.text;
      break;
    case Token::severity:
      line += severity_name(severity);
      break;
    case Token::name:
      line += name == nullptr ? "" : name;
      break;
    case Token::message:
      line += message;
      break;
    case Token::function_name:
      line += location == nullptr ? "\"\"" : location->function_name;
      break;
    case Token::file_name:
      line += location == nullptr ? "\"\"" : location->file_name;
      break;
    case Token::line_number:
      line += std::to_string(location == nullptr ? 0 : location->line_number);
      break;
    case Token::time:
      if (rcutils_time_point_value_as_seconds_string(&stamp, number, sizeof(number)) ==
          RCUTILS_RET_OK) {
        line += number;
      }
      break;
    case Token::time_as_nanoseconds:
      if (rcutils_time_point_value_as_nanoseconds_string(&stamp, number, sizeof(number)) ==
          RCUTILS_RET_OK) {
        line += number;
      }
      break;
    case Token::date_time_with_ms:
      line += date_time_with_ms(stamp);
      break;
  }
}

std::string format_line(const rcutils_log_location_t* location, int severity, const char* name,
                        rcutils_time_point_value_t stamp, const char* message) {
  std::string line;
  for (const Piece& piece : state().format) {
    append_piece(line, piece, location, severity, name, stamp, message);
  }
  return line;
}

std::string format_message(const char* format, va_list* args) {
  va_list copy;
  va_copy(copy, *args);
  char small[512];
  const int length = std::vsnprintf(small, sizeof(small), format, copy);
  va_end(copy);
  if (length < 0) {
    return {};
  }
  if (static_cast<size_t>(length) < sizeof(small)) {
    return std::string(small, static_cast<size_t>(length));
  }
  std::string text(static_cast<size_t>(length), '\0');
  va_copy(copy, *args);
  std::vsnprintf(text.data(), text.size() + 1, format, copy);
  va_end(copy);
  return text;
}

bool is_on(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && std::strcmp(value, "1") == 0;
}

void log_with(const rcutils_log_location_t* location, int severity, const char* name,
              const char* format, va_list* args) {
  rcutils_time_point_value_t now = 0;
  if (rcutils_system_time_now(&now) != RCUTILS_RET_OK) {
    return;
  }
  const rcutils_logging_output_handler_t handler = rcutils_logging_get_output_handler();
  if (handler != nullptr) {
    handler(location, severity, name == nullptr ? "" : name, now, format, args);
  }
}

struct LogCall {
  const rcutils_log_location_t* location;
  int severity;
  const char* name;
};

}  // namespace

extern "C" {

bool g_rcutils_logging_initialized = false;

rcutils_ret_t rcutils_logging_initialize(void) {
  return rcutils_logging_initialize_with_allocator(rcutils_get_default_allocator());
}

rcutils_ret_t rcutils_logging_initialize_with_allocator(rcutils_allocator_t) {
  State& logging = state();
  const std::lock_guard<std::mutex> lock(logging.mutex);
  if (g_rcutils_logging_initialized) {
    return RCUTILS_RET_OK;
  }
  const char* format = std::getenv("RCUTILS_CONSOLE_OUTPUT_FORMAT");
  logging.format = parse_format(format == nullptr || *format == '\0' ? kDefaultFormat : format);
  logging.colors = is_on("RCUTILS_COLORIZED_OUTPUT");
  logging.stream = is_on("RCUTILS_LOGGING_USE_STDOUT") ? stdout : stderr;
  if (logging.handler == nullptr) {
    logging.handler = &rcutils_logging_console_output_handler;
  }
  g_rcutils_logging_initialized = true;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_logging_shutdown(void) {
  State& logging = state();
  const std::lock_guard<std::mutex> lock(logging.mutex);
  logging.levels.clear();
  logging.has_levels = false;
  logging.handler = nullptr;
  g_rcutils_logging_initialized = false;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_logging_severity_level_from_string(const char* severity_string,
                                                         rcutils_allocator_t, int* severity) {
  if (severity_string == nullptr || severity == nullptr) {
    RCUTILS_SET_ERROR_MSG("severity or its string is null");
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  for (int level = 0; level <= RCUTILS_LOG_SEVERITY_FATAL; ++level) {
    if (severity_name(level) != nullptr && strcasecmp(severity_name(level), severity_string) == 0) {
      *severity = level;
      return RCUTILS_RET_OK;
    }
  }
  return RCUTILS_RET_LOGGING_SEVERITY_STRING_INVALID;
}

rcutils_logging_output_handler_t rcutils_logging_get_output_handler(void) {
  RCUTILS_LOGGING_AUTOINIT;
  return state().handler;
}

void rcutils_logging_set_output_handler(rcutils_logging_output_handler_t function) {
  RCUTILS_LOGGING_AUTOINIT;
  state().handler = function;
}

rcutils_ret_t rcutils_logging_format_message(const rcutils_log_location_t* location, int severity,
                                             const char* name, rcutils_time_point_value_t timestamp,
                                             const char* msg,
                                             rcutils_char_array_t* logging_output) {
  const std::string line = format_line(location, severity, name, timestamp, msg);
  return rcutils_char_array_strcat(logging_output, line.c_str());
}

int rcutils_logging_get_default_logger_level(void) {
  RCUTILS_LOGGING_AUTOINIT;
  return state().default_level;
}

void rcutils_logging_set_default_logger_level(int level) {
  RCUTILS_LOGGING_AUTOINIT;
  state().default_level =
      level == RCUTILS_LOG_SEVERITY_UNSET ? RCUTILS_DEFAULT_LOGGER_DEFAULT_LEVEL : level;
}

int rcutils_logging_get_logger_level(const char* name) {
  return name == nullptr ? -1 : rcutils_logging_get_logger_leveln(name, std::strlen(name));
}

int rcutils_logging_get_logger_leveln(const char* name, size_t name_length) {
  RCUTILS_LOGGING_AUTOINIT;
  if (name == nullptr) {
    return -1;
  }
  if (name_length == 0) {
    return state().default_level;
  }
  const std::lock_guard<std::mutex> lock(state().mutex);
  const auto found = state().levels.find(std::string_view(name, name_length));
  return found == state().levels.end() ? static_cast<int>(RCUTILS_LOG_SEVERITY_UNSET)
                                       : found->second;
}

rcutils_ret_t rcutils_logging_set_logger_level(const char* name, int level) {
  RCUTILS_LOGGING_AUTOINIT;
  if (name == nullptr) {
    RCUTILS_SET_ERROR_MSG("Invalid logger name");
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  if (severity_name(level) == nullptr) {
    RCUTILS_SET_ERROR_MSG("Invalid severity level specified for logger");
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  if (*name == '\0') {
    rcutils_logging_set_default_logger_level(level);
    return RCUTILS_RET_OK;
  }
  const std::lock_guard<std::mutex> lock(state().mutex);
  state().levels[name] = level;
  state().has_levels = true;
  return RCUTILS_RET_OK;
}

int rcutils_logging_get_logger_effective_level(const char* name) {
  RCUTILS_LOGGING_AUTOINIT;
  State& logging = state();
  if (name == nullptr) {
    return -1;
  }
  if (logging.has_levels) {
    const std::lock_guard<std::mutex> lock(logging.mutex);
    std::string_view ancestor = name;
    while (!ancestor.empty()) {
      const auto found = logging.levels.find(ancestor);
      if (found != logging.levels.end() && found->second != RCUTILS_LOG_SEVERITY_UNSET) {
        return found->second;
      }
      const size_t dot = ancestor.rfind('.');
      ancestor = dot == std::string_view::npos ? std::string_view() : ancestor.substr(0, dot);
    }
  }
  return logging.default_level;
}

bool rcutils_logging_logger_is_enabled_for(const char* name, int severity) {
  return severity >= rcutils_logging_get_logger_effective_level(name == nullptr ? "" : name);
}

void rcutils_log_internal(const rcutils_log_location_t* location, int severity, const char* name,
                          const char* format, ...) {
  va_list args;
  va_start(args, format);
  log_with(location, severity, name, format, &args);
  va_end(args);
}

void rcutils_log(const rcutils_log_location_t* location, int severity, const char* name,
                 const char* format, ...) {
  RCUTILS_LOGGING_AUTOINIT;
  if (!rcutils_logging_logger_is_enabled_for(name, severity)) {
    return;
  }
  va_list args;
  va_start(args, format);
  log_with(location, severity, name, format, &args);
  va_end(args);
}

#ifdef ROS2WASM_LP64_FORMAT_HPP_
void rcutils_lp64_log(const rcutils_log_location_t* location, int severity, const char* name,
                      bool is_known_to_be_taken, const char* format,
                      const ros2wasm::lp64::Slot* slots, int count) {
  RCUTILS_LOGGING_AUTOINIT;
  if (!is_known_to_be_taken && !rcutils_logging_logger_is_enabled_for(name, severity)) {
    return;
  }
  const LogCall call{location, severity, name};
  ros2wasm_lp64_arguments(
      format, slots, count, false,
      [](void* context, const char* text, va_list args) {
        const LogCall* to = static_cast<const LogCall*>(context);
        log_with(to->location, to->severity, to->name, text, &args);
        return 0;
      },
      const_cast<LogCall*>(&call));
}
#endif

void rcutils_logging_console_output_handler(const rcutils_log_location_t* location, int severity,
                                            const char* name, rcutils_time_point_value_t timestamp,
                                            const char* format, va_list* args) {
  RCUTILS_LOGGING_AUTOINIT;
  if (severity_name(severity) == nullptr) {
    std::fprintf(stderr, "unknown severity level: %d\n", severity);
    return;
  }
  const std::string message = format_message(format, args);
  const State& logging = state();
  std::string line;
  if (logging.colors) {
    line += color_of(severity);
  }
  line += format_line(location, severity, name, timestamp, message.c_str());
  if (logging.colors) {
    line += "\033[0m";
  }
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), logging.stream);
  std::fflush(logging.stream);
}

}  // extern "C"
