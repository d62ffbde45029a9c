// The page (or a command) as a participant of the graph. Messages are bytes here; runtime/site/decode makes and reads
// them. Types only. All times are the site's: they stand still while it is held. Nothing here throws: an
// endpoint that cannot be made says so by `problem`, calls that come to nothing reject with a SiteError.

import type { SiteError } from './site_error.ts';

export interface QosView {
  readonly reliability: 'reliable' | 'best_effort';
  readonly durability: 'transient_local' | 'volatile';
  readonly history: 'keep_last' | 'keep_all';
  readonly depth: number;
}

/** Durations in ns; 0 means none. */
export interface EndpointQosView extends QosView {
  readonly liveliness: 'automatic' | 'manual_by_topic';
  readonly deadlineNs: number;
  readonly lifespanNs: number;
  readonly leaseNs: number;
}

/** Members that are omitted have the ROS 2 defaults: reliable, volatile, the last 10. */
export type QosRequest = Partial<EndpointQosView>;

export interface SubscriptionRequest extends QosRequest {
  /** Begin with what publishers still hold, whatever their durability, where the link between the nodes has it. */
  readonly past?: boolean;
}

export interface GraphEndpointView {
  /** Fully qualified. */
  readonly name: string;
  readonly type: string;
  /** The hash of the type, `RIHS01_...`; empty when the endpoint did not report one. */
  readonly hash: string;
  readonly qos: EndpointQosView;
  /** 32 hexadecimal digits. */
  readonly gid: string;
}

/** Seen by its endpoints: `name`/_action/send_goal and the others. */
export interface GraphActionView {
  readonly name: string;
  readonly type: string;
}

export interface GraphNodeView {
  /** Fully qualified. Several nodes may have the same. */
  readonly name: string;
  /** Id of the site's node that runs it; undefined: the page itself, or another tab. */
  readonly process: string | undefined;
  /** Endpoints of actions are among these four, under their hidden names. */
  readonly publishers: readonly GraphEndpointView[];
  readonly subscriptions: readonly GraphEndpointView[];
  readonly services: readonly GraphEndpointView[];
  readonly clients: readonly GraphEndpointView[];
  readonly actionServers: readonly GraphActionView[];
  readonly actionClients: readonly GraphActionView[];
}

/** All nodes, hidden ones too; sorted by name, as the endpoints within them. */
export interface GraphView {
  readonly nodes: readonly GraphNodeView[];
}

interface PageEndpoint {
  /** Why it could not be made, or has ended by itself; undefined while it lives. */
  readonly problem: SiteError | undefined;
  /** Matched endpoints of others. */
  matched(): number;
  close(): void;
}

export interface PagePublisher extends PageEndpoint {
  /**
   * Returns the error that kept the message from being sent; undefined: no error. May be called after close(), too.
   * A message that waits for room may still fail: the next call then returns that error and does not send its own message.
   */
  publish(bytes: Uint8Array): SiteError | undefined;
}

export interface MessageInfo {
  /** ms since 1970, by the site's time. */
  readonly publishedAt: number;
  readonly receivedAt: number;
  /** The publisher's gid; 32 hexadecimal digits. */
  readonly gid: string;
}

/** `bytes` are the listener's own. */
export type MessageListener = (bytes: Uint8Array<ArrayBuffer>, info: MessageInfo) => void;

export type PageSubscription = PageEndpoint;

export interface CallOptions {
  /** The limit in ms of site time for a server to appear and to answer; 10 s when omitted, Infinity: no limit. */
  readonly timeoutMs?: number;
  readonly signal?: AbortSignal;
}

export interface PageClient extends PageEndpoint {
  /** Is a server there? */
  ready(): boolean;
  /**
   * Waits for a server, asks it, and resolves with its reply. Rejects with a SiteError: R2W0716 no server, or the one
   * that was asked has gone; R2W0717 no answer in time; R2W0718 the client was closed; R2W0715 it could not be made.
   */
  call(request: Uint8Array, options?: CallOptions): Promise<Uint8Array<ArrayBuffer>>;
}

/** As in action_msgs/msg/GoalStatus. */
export type GoalStatus = 'unknown' | 'accepted' | 'executing' | 'canceling' | 'succeeded' | 'canceled' | 'aborted';

export interface GoalResult {
  readonly status: GoalStatus;
  /** A message of type `ACTION_TYPE_GetResult_Response`: fields `status` and `result`. */
  readonly bytes: Uint8Array<ArrayBuffer>;
}

export interface GoalOptions extends CallOptions {
  /** Called with messages of type `ACTION_TYPE_Feedback`. `timeoutMs` is that of the server's yes or no. */
  readonly onFeedback?: (bytes: Uint8Array<ArrayBuffer>, info: MessageInfo) => void;
  readonly onStatus?: (status: GoalStatus) => void;
}

export interface PageGoal {
  /** 32 hexadecimal digits. */
  readonly id: string;
  /** Has the server taken the goal? */
  readonly accepted: Promise<boolean>;
  /** Rejects when the goal was refused (R2W0719), the server is gone (R2W0716), or the goal was given up (R2W0718). */
  readonly result: Promise<GoalResult>;
  /** Asks the server to stop; resolves with its answer: is the goal being canceled? */
  cancel(): Promise<boolean>;
  /** Gives the goal up: it is canceled when it is not over, and nothing more is heard of it. */
  close(): void;
}

export interface PageActionClient {
  readonly problem: SiteError | undefined;
  /** Is a whole action server there? */
  ready(): boolean;
  /** `goal`: a message of type `ACTION_TYPE_Goal`. */
  sendGoal(goal: Uint8Array, options?: GoalOptions): PageGoal;
  /** Gives up goals that are not over. */
  close(): void;
}

export interface PageTimer {
  close(): void;
}

/** The page's node. Each call makes an endpoint of its own. Names may be relative; types are full names. */
export interface PageNode {
  /** Fully qualified: `/_ros2wasm_page`, which is hidden as that of the `ros2` command. */
  readonly name: string;
  publisher(topic: string, type: string, qos?: QosRequest): PagePublisher;
  /** The listener is called as messages come, never within another call. */
  /** With an empty `type`: messages of all types, for somebody who is not counted among the subscriptions. */
  subscription(topic: string, type: string, request: SubscriptionRequest, listener: MessageListener): PageSubscription;
  client(service: string, type: string): PageClient;
  actionClient(action: string, type: string): PageActionClient;
  /** Calls `ring` each time that `periodMs` of the site's time have passed. */
  timer(periodMs: number, ring: () => void): PageTimer;
}
