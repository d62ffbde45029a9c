// Lists of lists of numbers in a parameter, such as a footprint.
#pragma once

#include <string>
#include <vector>

namespace nav2_util {

/// Reads `[[1.0, 2.0], [3.3, 4.4, 5.5]]`. `error_return` is empty when all went well; otherwise the
/// result is what was read up to the mistake.
std::vector<std::vector<float>> parseVVF(const std::string& input, std::string& error_return);

}  // namespace nav2_util
