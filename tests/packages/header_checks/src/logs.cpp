// Compatibility, works: spdlog (`spdlog`, `spdlog_vendor`, `find_package(spdlog)`), headers only
// and with fmt, range-v3
// (`range-v3`), nanoflann (`libnanoflann-dev`, `find_package(nanoflann)`)

#include <spdlog/logger.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <sstream>

#include "expect.hpp"

void check_logs(Expectations& expectations) {
  std::ostringstream text;
  spdlog::logger logger("arm", std::make_shared<spdlog::sinks::ostream_sink_mt>(text));
  logger.set_pattern("[%n] %l: %v");
  logger.info("joint {} at {:.2f}", 3, 0.5);
  logger.debug("not shown");
  logger.set_level(spdlog::level::debug);
  logger.debug("shown");
  EXPECT(text.str() == "[arm] info: joint 3 at 0.50\n[arm] debug: shown\n");
  EXPECT(spdlog::level::from_str("warning") == spdlog::level::warn);
}
