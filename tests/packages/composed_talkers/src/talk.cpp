// See talk.hpp.
#include "talk.hpp"

namespace composed_talkers {

const char* const kTopic = "count";

}  // namespace composed_talkers
