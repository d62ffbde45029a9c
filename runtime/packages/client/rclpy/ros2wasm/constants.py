"""Made from runtime/protocol/constants.json by generate.mjs; change that file instead."""

from enum import IntEnum

#: Version of SPEC.md; a site refuses a node of another version.
PROTOCOL_VERSION = 1
#: Version of the imports that a program gets in module "ros2wasm".
ABI_VERSION = 1
#: Bytes of SampleInfo in front of every payload.
FRAME_HEADER_SIZE = 64
#: Bytes of an endpoint's global id.
GID_SIZE = 16
#: Bytes of a node, topic, service or type name.
MAX_NAME_LENGTH = 255
#: Bytes of a type hash.
MAX_HASH_LENGTH = 79
#: Samples a keep_all history holds before the writer waits (or drops, when it may not wait).
KEEP_ALL_LIMIT = 4096
#: Requests or replies that wait for one slow reader before the oldest is dropped.
SERVICE_LIMIT = 16384
#: Bytes of one payload at most.
MAX_SAMPLE_LENGTH = 1073741824
#: BusTime.rate at which site time runs as fast as real time.
TIME_RATE_ONE = 1000000
#: EndpointDesc.flags: no match with endpoints of the same participant.
FLAG_IGNORE_LOCAL = 1
#: EndpointDesc.flags: not shown in the graph (stdin and other plumbing).
FLAG_HIDDEN = 2
#: EndpointDesc.flags: stands for an endpoint of another tab; two of them never match.
FLAG_MIRROR = 4


class EndpointKind(IntEnum):
    """The kinds of endpoints."""

    PUBLISHER = 1
    SUBSCRIPTION = 2
    CLIENT = 3
    SERVER = 4


class Reliability(IntEnum):
    """rmw's numbers."""

    RELIABLE = 1
    BEST_EFFORT = 2


class Durability(IntEnum):
    """rmw's numbers."""

    TRANSIENT_LOCAL = 1
    VOLATILE = 2


class History(IntEnum):
    """rmw's numbers."""

    KEEP_LAST = 1
    KEEP_ALL = 2


class Liveliness(IntEnum):
    """rmw's numbers."""

    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3


class ErrorCode(IntEnum):
    """Negative results of the imports."""

    NOTHING = -1
    INVALID_ARGUMENT = -2
    BAD_HANDLE = -3
    OUT_OF_MEMORY = -4
    TABLE_FULL = -5
    TOO_LARGE = -6
    STOPPED = -7
    INVALID_NAME = -8
    UNSUPPORTED = -9
    WOULD_BLOCK = -10


class WaitResult(IntEnum):
    """Result of wait and sleep (sleep: woken means slept)."""

    WOKEN = 0
    TIMEOUT = 1
    STOP = 2


class TerminalMode(IntEnum):
    """Argument of terminal_mode. cooked: lines; cbreak: each key at once, Ctrl-C is a signal; raw: all keys."""

    COOKED = 0
    CBREAK = 1
    RAW = 2


class StatusKind(IntEnum):
    """Argument of endpoint_status; rmw_event_type_t's numbers."""

    LIVELINESS_CHANGED = 0
    REQUESTED_DEADLINE_MISSED = 1
    REQUESTED_QOS_INCOMPATIBLE = 2
    MESSAGE_LOST = 3
    SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    SUBSCRIPTION_MATCHED = 5
    LIVELINESS_LOST = 6
    OFFERED_DEADLINE_MISSED = 7
    OFFERED_QOS_INCOMPATIBLE = 8
    PUBLISHER_INCOMPATIBLE_TYPE = 9
    PUBLICATION_MATCHED = 10


class PolicyKind(IntEnum):
    """EndpointStatus.last_policy; rmw_qos_policy_kind_t's numbers."""

    NONE = 0
    INVALID = 1
    DURABILITY = 2
    DEADLINE = 4
    LIVELINESS = 8
    RELIABILITY = 16
    HISTORY = 32
    LIFESPAN = 64
    DEPTH = 128
    LIVELINESS_LEASE = 256


#: struct format. The metadata of a payload; also the frame header on both links. Little endian.
SAMPLE_INFO_FORMAT = "<IIqqq16s16s"

#: struct format. Argument of endpoint_create; pointers are addresses in the program's memory.
ENDPOINT_DESC_FORMAT = "<IIIIIIIIIIIIIIIIqqqqqq"

#: struct format. Counters of one event of one endpoint; a change counts since the last reading.
ENDPOINT_STATUS_FORMAT = "<iiiiiiii"
