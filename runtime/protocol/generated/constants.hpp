// Made from runtime/protocol/constants.json by generate.mjs; change that file instead.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ros2wasm::protocol
{

/// Version of SPEC.md; a site refuses a node of another version.
inline constexpr int32_t kProtocolVersion = 1;
/// Version of the imports that a program gets in module "ros2wasm".
inline constexpr int32_t kAbiVersion = 1;
/// Bytes of SampleInfo in front of every payload.
inline constexpr int32_t kFrameHeaderSize = 64;
/// Bytes of an endpoint's global id.
inline constexpr int32_t kGidSize = 16;
/// Bytes of a node, topic, service or type name.
inline constexpr int32_t kMaxNameLength = 255;
/// Bytes of a type hash.
inline constexpr int32_t kMaxHashLength = 79;
/// Samples a keep_all history holds before the writer waits (or drops, when it may not wait).
inline constexpr int32_t kKeepAllLimit = 4096;
/// Requests or replies that wait for one slow reader before the oldest is dropped.
inline constexpr int32_t kServiceLimit = 16384;
/// Bytes of one payload at most.
inline constexpr int32_t kMaxSampleLength = 1073741824;
/// BusTime.rate at which site time runs as fast as real time.
inline constexpr int32_t kTimeRateOne = 1000000;
/// EndpointDesc.flags: no match with endpoints of the same participant.
inline constexpr int32_t kFlagIgnoreLocal = 1;
/// EndpointDesc.flags: not shown in the graph (stdin and other plumbing).
inline constexpr int32_t kFlagHidden = 2;
/// EndpointDesc.flags: stands for an endpoint of another tab; two of them never match.
inline constexpr int32_t kFlagMirror = 4;

/// The kinds of endpoints.
enum class EndpointKind : int32_t
{
  kPublisher = 1,
  kSubscription = 2,
  kClient = 3,
  kServer = 4,
};

/// rmw's numbers.
enum class Reliability : int32_t
{
  kReliable = 1,
  kBestEffort = 2,
};

/// rmw's numbers.
enum class Durability : int32_t
{
  kTransientLocal = 1,
  kVolatile = 2,
};

/// rmw's numbers.
enum class History : int32_t
{
  kKeepLast = 1,
  kKeepAll = 2,
};

/// rmw's numbers.
enum class Liveliness : int32_t
{
  kAutomatic = 1,
  kManualByTopic = 3,
};

/// Negative results of the imports.
enum class ErrorCode : int32_t
{
  kNothing = -1,
  kInvalidArgument = -2,
  kBadHandle = -3,
  kOutOfMemory = -4,
  kTableFull = -5,
  kTooLarge = -6,
  kStopped = -7,
  kInvalidName = -8,
  kUnsupported = -9,
  kWouldBlock = -10,
};

/// Result of wait and sleep (sleep: woken means slept).
enum class WaitResult : int32_t
{
  kWoken = 0,
  kTimeout = 1,
  kStop = 2,
};

/// Argument of terminal_mode. cooked: lines; cbreak: each key at once, Ctrl-C is a signal; raw: all keys.
enum class TerminalMode : int32_t
{
  kCooked = 0,
  kCbreak = 1,
  kRaw = 2,
};

/// Argument of endpoint_status; rmw_event_type_t's numbers.
enum class StatusKind : int32_t
{
  kLivelinessChanged = 0,
  kRequestedDeadlineMissed = 1,
  kRequestedQosIncompatible = 2,
  kMessageLost = 3,
  kSubscriptionIncompatibleType = 4,
  kSubscriptionMatched = 5,
  kLivelinessLost = 6,
  kOfferedDeadlineMissed = 7,
  kOfferedQosIncompatible = 8,
  kPublisherIncompatibleType = 9,
  kPublicationMatched = 10,
};

/// EndpointStatus.last_policy; rmw_qos_policy_kind_t's numbers.
enum class PolicyKind : int32_t
{
  kNone = 0,
  kInvalid = 1,
  kDurability = 2,
  kDeadline = 4,
  kLiveliness = 8,
  kReliability = 16,
  kHistory = 32,
  kLifespan = 64,
  kDepth = 128,
  kLivelinessLease = 256,
};

/// Bytes of the fixed structures of the shared bus.
namespace bus_sizes
{
inline constexpr int32_t kPage = 4096;
inline constexpr int32_t kParticipant = 128;
inline constexpr int32_t kNode = 640;
inline constexpr int32_t kEndpoint = 1088;
inline constexpr int32_t kSlot = 32;
inline constexpr int32_t kRingHeader = 64;
inline constexpr int32_t kAlign = 64;
}  // namespace bus_sizes

/// Int32 words from byte 0. Offsets of tables are in bytes.
namespace bus_header
{
inline constexpr int32_t kMagic = 0;
inline constexpr int32_t kVersion = 1;
inline constexpr int32_t kParticipants = 2;
inline constexpr int32_t kParticipantCount = 3;
inline constexpr int32_t kNodes = 4;
inline constexpr int32_t kNodeCount = 5;
inline constexpr int32_t kEndpoints = 6;
inline constexpr int32_t kEndpointCount = 7;
inline constexpr int32_t kGraphLog = 8;
inline constexpr int32_t kGraphLogSize = 9;
inline constexpr int32_t kPageTable = 10;
inline constexpr int32_t kPageCount = 11;
inline constexpr int32_t kPages = 12;
inline constexpr int32_t kSession0 = 13;
inline constexpr int32_t kSession1 = 14;
inline constexpr int32_t kGrowPages = 15;
inline constexpr int32_t kGraphVersion = 32;
inline constexpr int32_t kEndpointHigh = 33;
inline constexpr int32_t kNodeHigh = 34;
inline constexpr int32_t kOrder = 64;
inline constexpr int32_t kPageHint = 96;
inline constexpr int32_t kObservers = 112;
inline constexpr int32_t kObserverCount = 8;
inline constexpr int32_t kObserving = 120;
inline constexpr int32_t kSiteTime = 128;
inline constexpr int32_t kSize = 1024;
}  // namespace bus_header

/// Int32 words of a participant slot.
namespace bus_participant
{
inline constexpr int32_t kState = 0;
inline constexpr int32_t kGeneration = 1;
inline constexpr int32_t kStop = 2;
inline constexpr int32_t kGraphInterest = 3;
inline constexpr int32_t kWake = 16;
inline constexpr int32_t kSleepers = 17;
inline constexpr int32_t kStatus = 18;
inline constexpr int32_t kRouse = 19;
inline constexpr int32_t kTurn = 20;
inline constexpr int32_t kConsolePosted = 24;
inline constexpr int32_t kConsoleSeen = 25;
}  // namespace bus_participant

/// Values of BusParticipant.state.
namespace bus_participant_state
{
inline constexpr int32_t kFree = 0;
inline constexpr int32_t kLive = 1;
inline constexpr int32_t kEnded = 2;
}  // namespace bus_participant_state

/// Int32 words of a node slot; the strings at byte offsets.
namespace bus_node
{
inline constexpr int32_t kState = 0;
inline constexpr int32_t kGeneration = 1;
inline constexpr int32_t kBorn = 2;
inline constexpr int32_t kNamespaceLength = 3;
inline constexpr int32_t kNameLength = 4;
inline constexpr int32_t kNamespaceBytes = 64;
inline constexpr int32_t kNameBytes = 320;
}  // namespace bus_node

/// Int32 words of an endpoint slot; the strings at byte offsets.
namespace bus_endpoint
{
inline constexpr int32_t kState = 0;
inline constexpr int32_t kGeneration = 1;
inline constexpr int32_t kKind = 2;
inline constexpr int32_t kNode = 3;
inline constexpr int32_t kBorn = 4;
inline constexpr int32_t kGone = 5;
inline constexpr int32_t kFlags = 6;
inline constexpr int32_t kReliability = 7;
inline constexpr int32_t kDurability = 8;
inline constexpr int32_t kHistory = 9;
inline constexpr int32_t kDepth = 10;
inline constexpr int32_t kLiveliness = 11;
inline constexpr int32_t kDeadline = 12;
inline constexpr int32_t kLifespan = 14;
inline constexpr int32_t kLease = 16;
inline constexpr int32_t kGid = 18;
inline constexpr int32_t kNameLength = 22;
inline constexpr int32_t kTypeLength = 23;
inline constexpr int32_t kHashLength = 24;
inline constexpr int32_t kHead = 32;
inline constexpr int32_t kRing = 33;
inline constexpr int32_t kHeadHigh = 34;
inline constexpr int32_t kBytesLow = 35;
inline constexpr int32_t kBytesHigh = 36;
inline constexpr int32_t kBlocked = 37;
inline constexpr int32_t kRoomAt = 38;
inline constexpr int32_t kSignal = 48;
inline constexpr int32_t kDrained = 49;
inline constexpr int32_t kTable = 51;
inline constexpr int32_t kMatchedTotal = 64;
inline constexpr int32_t kMatchedCurrent = 65;
inline constexpr int32_t kMatchedTotalRead = 66;
inline constexpr int32_t kMatchedCurrentRead = 67;
inline constexpr int32_t kIncompatibleTotal = 68;
inline constexpr int32_t kIncompatiblePolicy = 69;
inline constexpr int32_t kIncompatibleRead = 70;
inline constexpr int32_t kWrongTypeTotal = 71;
inline constexpr int32_t kWrongTypeRead = 72;
inline constexpr int32_t kLostTotal = 73;
inline constexpr int32_t kLostRead = 74;
inline constexpr int32_t kActiveAt = 76;
inline constexpr int32_t kAssertedAt = 78;
inline constexpr int32_t kDeadlineTotal = 80;
inline constexpr int32_t kDeadlineRead = 81;
inline constexpr int32_t kLivelinessTotal = 82;
inline constexpr int32_t kLivelinessRead = 83;
inline constexpr int32_t kAliveRead = 84;
inline constexpr int32_t kDied = 85;
inline constexpr int32_t kWatched = 86;
inline constexpr int32_t kHazard = 92;
inline constexpr int32_t kInlineTable = 96;
inline constexpr int32_t kInlineEntries = 8;
inline constexpr int32_t kNameBytes = 448;
inline constexpr int32_t kTypeBytes = 704;
inline constexpr int32_t kHashBytes = 960;
}  // namespace bus_endpoint

/// Values of BusEndpoint.blocked: what a waiting writer is to be told of.
namespace bus_blocked
{
inline constexpr int32_t kNo = 0;
inline constexpr int32_t kRelease = 1;
inline constexpr int32_t kRoom = 2;
}  // namespace bus_blocked

/// Low byte of a node's or endpoint's state; the rest is participant index + 1.
namespace bus_phase
{
inline constexpr int32_t kFree = 0;
inline constexpr int32_t kClaimed = 1;
inline constexpr int32_t kLive = 2;
inline constexpr int32_t kDeparted = 3;
}  // namespace bus_phase

/// Int32 words of one slot of a writer's ring. Units of 64 bytes where it says unit.
namespace bus_slot
{
inline constexpr int32_t kSequence = 0;
inline constexpr int32_t kFrameUnit = 1;
inline constexpr int32_t kLength = 2;
inline constexpr int32_t kOrder = 3;
inline constexpr int32_t kTarget = 4;
inline constexpr int32_t kExtentUnit = 5;
inline constexpr int32_t kExtentPages = 6;
}  // namespace bus_slot

/// Int32 words of the law of time, from BusHeader.site_time. Times are i64, steady, ns.
namespace bus_time
{
inline constexpr int32_t kVersion = 0;
inline constexpr int32_t kRate = 1;
inline constexpr int32_t kReal = 2;
inline constexpr int32_t kSite = 4;
inline constexpr int32_t kLimit = 6;
}  // namespace bus_time

/// Int32 words of the header in front of a ring's slots.
namespace bus_ring
{
inline constexpr int32_t kStride = 0;
inline constexpr int32_t kPages = 1;
}  // namespace bus_ring

/// The metadata of a payload; also the frame header on both links. Little endian.
struct SampleInfo
{
  uint32_t length;  ///< payload bytes
  uint32_t flags;  ///< 0 in version 1
  int64_t sequence;  ///< per writer, from 1
  int64_t source_timestamp_ns;  ///< system clock, ns since 1970; 0 given to write: the link reads the clock
  int64_t related_sequence;  ///< requests and replies; else 0
  uint8_t related_gid[16];  ///< requests: the client; replies: the client that asked
  uint8_t writer_gid[16];  ///< filled by the link
};
static_assert(sizeof(SampleInfo) == 64);
static_assert(offsetof(SampleInfo, length) == 0);
static_assert(offsetof(SampleInfo, flags) == 4);
static_assert(offsetof(SampleInfo, sequence) == 8);
static_assert(offsetof(SampleInfo, source_timestamp_ns) == 16);
static_assert(offsetof(SampleInfo, related_sequence) == 24);
static_assert(offsetof(SampleInfo, related_gid) == 32);
static_assert(offsetof(SampleInfo, writer_gid) == 48);

/// Argument of endpoint_create; pointers are addresses in the program's memory.
struct EndpointDesc
{
  uint32_t kind;  ///< EndpointKind
  uint32_t node;  ///< result of node_create
  uint32_t name;  ///< fully qualified, after remapping
  uint32_t name_len;  ///< bytes
  uint32_t type;  ///< such as std_msgs/msg/String
  uint32_t type_len;  ///< bytes
  uint32_t hash;  ///< RIHS01_... or empty
  uint32_t hash_len;  ///< bytes
  uint32_t reliability;  ///< Reliability
  uint32_t durability;  ///< Durability
  uint32_t history;  ///< History
  uint32_t depth;  ///< samples, for keep_last
  uint32_t liveliness;  ///< Liveliness
  uint32_t flags;  ///< flag_...
  uint32_t reserved0;  ///< 0
  uint32_t reserved1;  ///< 0
  int64_t deadline_ns;  ///< 0: none
  int64_t lifespan_ns;  ///< 0: none
  int64_t lease_ns;  ///< 0: none
  int64_t reserved2;  ///< 0
  int64_t reserved3;  ///< 0
  int64_t reserved4;  ///< 0
};
static_assert(sizeof(EndpointDesc) == 112);
static_assert(offsetof(EndpointDesc, kind) == 0);
static_assert(offsetof(EndpointDesc, node) == 4);
static_assert(offsetof(EndpointDesc, name) == 8);
static_assert(offsetof(EndpointDesc, name_len) == 12);
static_assert(offsetof(EndpointDesc, type) == 16);
static_assert(offsetof(EndpointDesc, type_len) == 20);
static_assert(offsetof(EndpointDesc, hash) == 24);
static_assert(offsetof(EndpointDesc, hash_len) == 28);
static_assert(offsetof(EndpointDesc, reliability) == 32);
static_assert(offsetof(EndpointDesc, durability) == 36);
static_assert(offsetof(EndpointDesc, history) == 40);
static_assert(offsetof(EndpointDesc, depth) == 44);
static_assert(offsetof(EndpointDesc, liveliness) == 48);
static_assert(offsetof(EndpointDesc, flags) == 52);
static_assert(offsetof(EndpointDesc, reserved0) == 56);
static_assert(offsetof(EndpointDesc, reserved1) == 60);
static_assert(offsetof(EndpointDesc, deadline_ns) == 64);
static_assert(offsetof(EndpointDesc, lifespan_ns) == 72);
static_assert(offsetof(EndpointDesc, lease_ns) == 80);
static_assert(offsetof(EndpointDesc, reserved2) == 88);
static_assert(offsetof(EndpointDesc, reserved3) == 96);
static_assert(offsetof(EndpointDesc, reserved4) == 104);

/// Counters of one event of one endpoint; a change counts since the last reading.
struct EndpointStatus
{
  int32_t total_count;  ///< ever
  int32_t total_change;  ///< since the last reading
  int32_t current_count;  ///< now
  int32_t current_change;  ///< since the last reading
  int32_t last_policy;  ///< PolicyKind
  int32_t reserved0;  ///< 0
  int32_t reserved1;  ///< 0
  int32_t reserved2;  ///< 0
};
static_assert(sizeof(EndpointStatus) == 32);
static_assert(offsetof(EndpointStatus, total_count) == 0);
static_assert(offsetof(EndpointStatus, total_change) == 4);
static_assert(offsetof(EndpointStatus, current_count) == 8);
static_assert(offsetof(EndpointStatus, current_change) == 12);
static_assert(offsetof(EndpointStatus, last_policy) == 16);
static_assert(offsetof(EndpointStatus, reserved0) == 20);
static_assert(offsetof(EndpointStatus, reserved1) == 24);
static_assert(offsetof(EndpointStatus, reserved2) == 28);

}  // namespace ros2wasm::protocol
