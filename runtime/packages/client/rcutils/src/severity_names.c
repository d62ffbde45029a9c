/* The names of the severities, indexed by their numbers. */
#include "rcutils/logging.h"

const char* const g_rcutils_log_severity_names[RCUTILS_LOG_SEVERITY_FATAL + 1] = {
    [RCUTILS_LOG_SEVERITY_UNSET] = "UNSET", [RCUTILS_LOG_SEVERITY_DEBUG] = "DEBUG",
    [RCUTILS_LOG_SEVERITY_INFO] = "INFO",   [RCUTILS_LOG_SEVERITY_WARN] = "WARN",
    [RCUTILS_LOG_SEVERITY_ERROR] = "ERROR", [RCUTILS_LOG_SEVERITY_FATAL] = "FATAL"};
