// How the order of channels counts, with conda's words.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace ros2wasm {

enum class ChannelPriority {
  kStrict,    ///< a name found in one channel hides it in all later ones
  kFlexible,  ///< earlier channels are preferred, later ones allowed
  kDisabled,  ///< only versions count
};

/// The words for them, in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> kChannelPriorityWords{"strict", "flexible",
                                                                       "disabled"};

[[nodiscard]] constexpr std::string_view word_of(ChannelPriority priority) {
  return kChannelPriorityWords.at(static_cast<std::size_t>(priority));
}

/// The priority for one of kChannelPriorityWords; strict for any other text.
[[nodiscard]] constexpr ChannelPriority channel_priority_of(std::string_view word) {
  for (std::size_t i = 0; i < kChannelPriorityWords.size(); ++i) {
    if (word == kChannelPriorityWords.at(i)) return static_cast<ChannelPriority>(i);
  }
  return ChannelPriority::kStrict;
}

}  // namespace ros2wasm
