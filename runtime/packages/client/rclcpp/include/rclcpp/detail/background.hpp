// Work that is done whenever the program waits, whoever waits: /clock and the time source's
// events. So a blocked program still gets its time.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

namespace rclcpp {
namespace detail {

/// `work` runs when endpoint `endpoint_id` has data, for as long as the handle lives.
std::shared_ptr<void> add_background(int32_t endpoint_id, std::function<void()> work);
/// Runs what is due. Called with the ids that have data, or asks for them itself and lets the
/// listeners look too.
void run_background();
void run_background(uint32_t endpoint_id);

/// Sends log lines to the console (if asked) and to the rosout publishers (if asked).
void install_log_handler(bool console, bool rosout);

}  // namespace detail
}  // namespace rclcpp
