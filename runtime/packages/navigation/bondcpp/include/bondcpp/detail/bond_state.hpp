// The states of one end of a bond. Knows no node and no clock.
#pragma once

namespace bond {
namespace detail {

enum class BondState { kWaitingForSister, kAlive, kAwaitSisterDeath, kDead };

/// "Sister" is the other end.
enum class BondEvent {
  kSisterAlive,
  kSisterDead,
  kConnectTimeout,
  kHeartbeatTimeout,
  kDisconnectTimeout,
  kDie,
};

/// The state after an event, and what the end does on the way there.
struct BondStep {
  BondState state;
  bool forms = false;         ///< the callback of a formed bond is due
  bool breaks = false;        ///< the callback of a broken bond is due
  bool hears_beat = false;    ///< the time without a heartbeat begins anew
  bool starts_dying = false;  ///< dead statuses go out until the sister answers
  bool sister_left = false;   ///< the sister was the first to leave, and waits for an answer
};

/// The first status of the sister forms the bond; the heartbeat timeout begins with the second. An
/// event that means nothing in a state changes nothing.
constexpr BondStep next_step(BondState state, BondEvent event) {
  BondStep step{state};
  switch (state) {
    case BondState::kWaitingForSister:
      if (event == BondEvent::kSisterAlive) {
        step.state = BondState::kAlive;
        step.forms = true;
      } else if (event == BondEvent::kSisterDead) {
        step.state = BondState::kDead;
        step.forms = true;
        step.breaks = true;
        step.sister_left = true;
      } else if (event == BondEvent::kConnectTimeout || event == BondEvent::kDie) {
        step.state = BondState::kDead;
        step.breaks = true;
      }
      break;
    case BondState::kAlive:
      if (event == BondEvent::kSisterAlive) {
        step.hears_beat = true;
      } else if (event == BondEvent::kSisterDead) {
        step.state = BondState::kDead;
        step.breaks = true;
        step.sister_left = true;
      } else if (event == BondEvent::kHeartbeatTimeout) {
        step.state = BondState::kDead;
        step.breaks = true;
      } else if (event == BondEvent::kDie) {
        step.state = BondState::kAwaitSisterDeath;
        step.starts_dying = true;
      }
      break;
    case BondState::kAwaitSisterDeath:
      if (event == BondEvent::kSisterDead || event == BondEvent::kDisconnectTimeout) {
        step.state = BondState::kDead;
        step.breaks = true;
      }
      break;
    case BondState::kDead:
      break;
  }
  return step;
}

}  // namespace detail
}  // namespace bond
