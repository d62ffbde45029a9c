// Made from runtime/protocol/constants.json by generate.mjs; change that file instead.

/** Version of SPEC.md; a site refuses a node of another version. */
export const protocolVersion = 1;
/** Version of the imports that a program gets in module "ros2wasm". */
export const abiVersion = 1;
/** Bytes of SampleInfo in front of every payload. */
export const frameHeaderSize = 64;
/** Bytes of an endpoint's global id. */
export const gidSize = 16;
/** Bytes of a node, topic, service or type name. */
export const maxNameLength = 255;
/** Bytes of a type hash. */
export const maxHashLength = 79;
/** Samples a keep_all history holds before the writer waits (or drops, when it may not wait). */
export const keepAllLimit = 4096;
/** Requests or replies that wait for one slow reader before the oldest is dropped. */
export const serviceLimit = 16384;
/** Bytes of one payload at most. */
export const maxSampleLength = 1073741824;
/** EndpointDesc.flags: no match with endpoints of the same participant. */
export const flagIgnoreLocal = 1;
/** EndpointDesc.flags: not shown in the graph (stdin and other plumbing). */
export const flagHidden = 2;

/** What an endpoint is. */
export const EndpointKind = {
  publisher: 1,
  subscription: 2,
  client: 3,
  server: 4,
} as const;
export type EndpointKind = (typeof EndpointKind)[keyof typeof EndpointKind];

/** rmw's numbers. */
export const Reliability = {
  reliable: 1,
  bestEffort: 2,
} as const;
export type Reliability = (typeof Reliability)[keyof typeof Reliability];

/** rmw's numbers. */
export const Durability = {
  transientLocal: 1,
  volatile: 2,
} as const;
export type Durability = (typeof Durability)[keyof typeof Durability];

/** rmw's numbers. */
export const History = {
  keepLast: 1,
  keepAll: 2,
} as const;
export type History = (typeof History)[keyof typeof History];

/** rmw's numbers. */
export const Liveliness = {
  automatic: 1,
  manualByTopic: 3,
} as const;
export type Liveliness = (typeof Liveliness)[keyof typeof Liveliness];

/** Negative results of the imports. */
export const ErrorCode = {
  nothing: -1,
  invalidArgument: -2,
  badHandle: -3,
  outOfMemory: -4,
  tableFull: -5,
  tooLarge: -6,
  stopped: -7,
  invalidName: -8,
  unsupported: -9,
  wouldBlock: -10,
} as const;
export type ErrorCode = (typeof ErrorCode)[keyof typeof ErrorCode];

/** Result of wait and sleep (sleep: woken means slept). */
export const WaitResult = {
  woken: 0,
  timeout: 1,
  stop: 2,
} as const;
export type WaitResult = (typeof WaitResult)[keyof typeof WaitResult];

/** Argument of endpoint_status; rmw_event_type_t's numbers. */
export const StatusKind = {
  livelinessChanged: 0,
  requestedDeadlineMissed: 1,
  requestedQosIncompatible: 2,
  messageLost: 3,
  subscriptionIncompatibleType: 4,
  subscriptionMatched: 5,
  livelinessLost: 6,
  offeredDeadlineMissed: 7,
  offeredQosIncompatible: 8,
  publisherIncompatibleType: 9,
  publicationMatched: 10,
} as const;
export type StatusKind = (typeof StatusKind)[keyof typeof StatusKind];

/** EndpointStatus.last_policy; rmw_qos_policy_kind_t's numbers. */
export const PolicyKind = {
  none: 0,
  invalid: 1,
  durability: 2,
  deadline: 4,
  liveliness: 8,
  reliability: 16,
  history: 32,
  lifespan: 64,
  depth: 128,
  livelinessLease: 256,
} as const;
export type PolicyKind = (typeof PolicyKind)[keyof typeof PolicyKind];

/** Byte offsets. What travels with a payload; also the frame header on both links. Little endian. */
export const SampleInfoLayout = {
  size: 64,
  length: 0,
  flags: 4,
  sequence: 8,
  sourceTimestampNs: 16,
  relatedSequence: 24,
  relatedGid: 32,
  writerGid: 48,
} as const;

/** Byte offsets. Argument of endpoint_create; pointers are addresses in the program's memory. */
export const EndpointDescLayout = {
  size: 112,
  kind: 0,
  node: 4,
  name: 8,
  nameLen: 12,
  type: 16,
  typeLen: 20,
  hash: 24,
  hashLen: 28,
  reliability: 32,
  durability: 36,
  history: 40,
  depth: 44,
  liveliness: 48,
  flags: 52,
  reserved0: 56,
  reserved1: 60,
  deadlineNs: 64,
  lifespanNs: 72,
  leaseNs: 80,
  reserved2: 88,
  reserved3: 96,
  reserved4: 104,
} as const;

/** Byte offsets. Counters of one event of one endpoint; a change counts since the last reading. */
export const EndpointStatusLayout = {
  size: 32,
  totalCount: 0,
  totalChange: 4,
  currentCount: 8,
  currentChange: 12,
  lastPolicy: 16,
  reserved0: 20,
  reserved1: 24,
  reserved2: 28,
} as const;
