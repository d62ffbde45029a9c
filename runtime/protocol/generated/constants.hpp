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
/// EndpointDesc.flags: no match with endpoints of the same participant.
inline constexpr int32_t kFlagIgnoreLocal = 1;
/// EndpointDesc.flags: not shown in the graph (stdin and other plumbing).
inline constexpr int32_t kFlagHidden = 2;

/// What an endpoint is.
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

/// What travels with a payload; also the frame header on both links. Little endian.
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
