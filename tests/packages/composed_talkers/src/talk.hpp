// What the components talk of.
#pragma once

namespace composed_talkers {

extern const char* const kTopic;

}  // namespace composed_talkers
