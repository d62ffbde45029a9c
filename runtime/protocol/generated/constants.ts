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
/** BusTime.rate at which site time runs as fast as real time. */
export const timeRateOne = 1000000;
/** EndpointDesc.flags: no match with endpoints of the same participant. */
export const flagIgnoreLocal = 1;
/** EndpointDesc.flags: not shown in the graph (stdin and other plumbing). */
export const flagHidden = 2;
/** EndpointDesc.flags: stands for an endpoint of another tab; two of them never match. */
export const flagMirror = 4;

/** The kinds of endpoints. */
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

/** Argument of terminal_mode. cooked: lines; cbreak: each key at once, Ctrl-C is a signal; raw: all keys. */
export const TerminalMode = {
  cooked: 0,
  cbreak: 1,
  raw: 2,
} as const;
export type TerminalMode = (typeof TerminalMode)[keyof typeof TerminalMode];

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

/** Bytes of the fixed structures of the shared bus. */
export const BusSizes = {
  page: 4096,
  participant: 128,
  node: 640,
  endpoint: 1088,
  slot: 32,
  ringHeader: 64,
  align: 64,
} as const;

/** Int32 words from byte 0. Offsets of tables are in bytes. */
export const BusHeader = {
  magic: 0,
  version: 1,
  participants: 2,
  participantCount: 3,
  nodes: 4,
  nodeCount: 5,
  endpoints: 6,
  endpointCount: 7,
  graphLog: 8,
  graphLogSize: 9,
  pageTable: 10,
  pageCount: 11,
  pages: 12,
  session0: 13,
  session1: 14,
  growPages: 15,
  graphVersion: 32,
  endpointHigh: 33,
  nodeHigh: 34,
  order: 64,
  pageHint: 96,
  observers: 112,
  observerCount: 8,
  observing: 120,
  siteTime: 128,
  size: 1024,
} as const;

/** Int32 words of a participant slot. */
export const BusParticipant = {
  state: 0,
  generation: 1,
  stop: 2,
  graphInterest: 3,
  wake: 16,
  sleepers: 17,
  status: 18,
  rouse: 19,
  turn: 20,
  consolePosted: 24,
  consoleSeen: 25,
} as const;

/** Values of BusParticipant.state. */
export const BusParticipantState = {
  free: 0,
  live: 1,
  ended: 2,
} as const;

/** Int32 words of a node slot; the strings at byte offsets. */
export const BusNode = {
  state: 0,
  generation: 1,
  born: 2,
  namespaceLength: 3,
  nameLength: 4,
  namespaceBytes: 64,
  nameBytes: 320,
} as const;

/** Int32 words of an endpoint slot; the strings at byte offsets. */
export const BusEndpoint = {
  state: 0,
  generation: 1,
  kind: 2,
  node: 3,
  born: 4,
  gone: 5,
  flags: 6,
  reliability: 7,
  durability: 8,
  history: 9,
  depth: 10,
  liveliness: 11,
  deadline: 12,
  lifespan: 14,
  lease: 16,
  gid: 18,
  nameLength: 22,
  typeLength: 23,
  hashLength: 24,
  head: 32,
  ring: 33,
  headHigh: 34,
  bytesLow: 35,
  bytesHigh: 36,
  blocked: 37,
  roomAt: 38,
  signal: 48,
  drained: 49,
  table: 51,
  matchedTotal: 64,
  matchedCurrent: 65,
  matchedTotalRead: 66,
  matchedCurrentRead: 67,
  incompatibleTotal: 68,
  incompatiblePolicy: 69,
  incompatibleRead: 70,
  wrongTypeTotal: 71,
  wrongTypeRead: 72,
  lostTotal: 73,
  lostRead: 74,
  activeAt: 76,
  assertedAt: 78,
  deadlineTotal: 80,
  deadlineRead: 81,
  livelinessTotal: 82,
  livelinessRead: 83,
  aliveRead: 84,
  died: 85,
  watched: 86,
  hazard: 92,
  inlineTable: 96,
  inlineEntries: 8,
  nameBytes: 448,
  typeBytes: 704,
  hashBytes: 960,
} as const;

/** Values of BusEndpoint.blocked: what a waiting writer is to be told of. */
export const BusBlocked = {
  no: 0,
  release: 1,
  room: 2,
} as const;

/** Low byte of a node's or endpoint's state; the rest is participant index + 1. */
export const BusPhase = {
  free: 0,
  claimed: 1,
  live: 2,
  departed: 3,
} as const;

/** Int32 words of one slot of a writer's ring. Units of 64 bytes where it says unit. */
export const BusSlot = {
  sequence: 0,
  frameUnit: 1,
  length: 2,
  order: 3,
  target: 4,
  extentUnit: 5,
  extentPages: 6,
} as const;

/** Int32 words of the law of time, from BusHeader.site_time. Times are i64, steady, ns. */
export const BusTime = {
  version: 0,
  rate: 1,
  real: 2,
  site: 4,
  limit: 6,
} as const;

/** Int32 words of the header in front of a ring's slots. */
export const BusRing = {
  stride: 0,
  pages: 1,
} as const;

/** Byte offsets. The metadata of a payload; also the frame header on both links. Little endian. */
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
