// The page's action clients: goals over three services and two topics, as rclcpp_action has them on the wire. A goal
// that is given up is canceled; what an action client has goes when its last word is said.

import { hexText } from '../bus/graph_view.ts';
import { Client } from './page_endpoints.ts';
import type { GoalOptions, GoalResult, GoalStatus, MessageInfo, PageActionClient, PageGoal, PageNode, PageSubscription } from '../contract/page_node.ts';
import { closedError, guarded, type Participant } from './participant.ts';
import { SiteError } from '../contract/site_error.ts';

const idBytes = 16;
/** Before the body of every message. */
const header = [0, 1, 0, 0] as const;
const statuses: readonly GoalStatus[] = ['unknown', 'accepted', 'executing', 'canceling', 'succeeded', 'canceled', 'aborted'];

function statusOf(byte: number | undefined): GoalStatus {
  return statuses[byte ?? 0] ?? 'unknown';
}

function isOver(status: GoalStatus): boolean {
  return status === 'succeeded' || status === 'canceled' || status === 'aborted';
}

interface Settled<T> {
  readonly promise: Promise<T>;
  readonly resolve: (value: T) => void;
  readonly reject: (error: unknown) => void;
}

/** A rejection that nobody looks at is nobody's loss. */
function settled<T>(): Settled<T> {
  const made = Promise.withResolvers<T>();
  made.promise.catch(() => undefined);
  return made;
}

/** The participant as an action client uses it. */
export interface ActionHost extends Participant, Pick<PageNode, 'subscription'> {
  newClient(service: string, type: string): Client;
}

export class ActionClient implements PageActionClient {
  private readonly page: ActionHost;
  readonly name: string;
  readonly goals = new Map<string, Goal>();
  readonly sending: Client;
  readonly canceling: Client;
  readonly getting: Client;
  private readonly topics: readonly PageSubscription[];
  private closed = false;

  constructor(page: ActionHost, name: string, type: string) {
    this.page = page;
    this.name = name;
    const at = (part: string): string => `${name}/_action/${part}`;
    this.sending = page.newClient(at('send_goal'), `${type}_SendGoal`);
    this.canceling = page.newClient(at('cancel_goal'), 'action_msgs/srv/CancelGoal');
    this.getting = page.newClient(at('get_result'), `${type}_GetResult`);
    this.topics = [
      page.subscription(at('feedback'), `${type}_FeedbackMessage`, {}, (bytes, info) => this.onFeedback(bytes, info)),
      page.subscription(at('status'), 'action_msgs/msg/GoalStatusArray', { depth: 1, durability: 'transient_local' }, (bytes) => this.onStatus(bytes)),
    ];
    // Half of an action is of no use.
    if (this.problem !== undefined) this.end();
  }

  get problem(): SiteError | undefined {
    return this.endpoints().find(({ problem }) => problem !== undefined)?.problem;
  }

  private endpoints(): readonly (Client | PageSubscription)[] {
    return [this.sending, this.canceling, this.getting, ...this.topics];
  }

  ready(): boolean {
    return this.endpoints().every((endpoint) => endpoint.matched() > 0);
  }

  sendGoal(goal: Uint8Array, options: GoalOptions = {}): PageGoal {
    return new Goal(this, goal, options, this.closed ? closedError(this.name) : this.problem);
  }

  /** Nothing more comes of the goal. */
  over(goal: Goal): void {
    this.goals.delete(goal.id);
    if (this.closed && this.goals.size === 0) this.end();
  }

  private onFeedback(bytes: Uint8Array<ArrayBuffer>, info: MessageInfo): void {
    if (bytes.length < header.length + idBytes) return;
    const goal = this.goals.get(hexText(bytes.subarray(header.length, header.length + idBytes)));
    if (goal === undefined) return;
    // The id's 16 bytes are a multiple of every alignment, so what follows it is a message of its own.
    const feedback = new Uint8Array(bytes.length - idBytes);
    feedback.set(bytes.subarray(0, header.length));
    feedback.set(bytes.subarray(header.length + idBytes), header.length);
    goal.feedback(feedback, info);
  }

  /** GoalStatusArray: a count, then id (16 bytes), stamp (two words, aligned) and status (a byte) of each. */
  private onStatus(bytes: Uint8Array<ArrayBuffer>): void {
    const body = bytes.subarray(header.length);
    if (body.length < 4) return;
    const view = new DataView(body.buffer, body.byteOffset, body.length);
    const count = view.getUint32(0, bytes[1] === 1);
    let at = 4;
    for (let i = 0; i < count; i += 1) {
      const stamp = (at + idBytes + 3) & -4;
      const status = body[stamp + 8];
      if (status === undefined) return;
      this.goals.get(hexText(body.subarray(at, at + idBytes)))?.status(statusOf(status));
      at = stamp + 9;
    }
  }

  /** Goals that are under way are canceled; the endpoints stay until the server has been told. */
  close(): void {
    if (this.closed) return;
    this.closed = true;
    if (this.page.ending) {
      for (const goal of [...this.goals.values()]) goal.drop(closedError(this.name));
      this.end();
      return;
    }
    for (const goal of [...this.goals.values()]) goal.close();
    if (this.goals.size === 0) this.end();
  }

  private end(): void {
    this.page.forget(this);
    for (const endpoint of this.endpoints()) endpoint.close();
  }
}

class Goal implements PageGoal {
  readonly id: string;
  private readonly client: ActionClient;
  private readonly uuid: Uint8Array;
  private readonly options: GoalOptions;
  private readonly answer = settled<boolean>();
  private readonly outcome = settled<GoalResult>();
  /** Ends the waiting for a server. */
  private readonly unsent = new AbortController();
  private readonly abandon = (): void => this.close();
  private last: GoalStatus = 'unknown';
  private givenUp = false;
  private finished = false;
  /** Callbacks for feedback and status that arrive before the server accepts the goal; undefined after it has answered. */
  private early: (() => void)[] | undefined = [];

  constructor(client: ActionClient, goal: Uint8Array, options: GoalOptions, problem: SiteError | undefined) {
    this.client = client;
    this.options = options;
    this.uuid = newGoalId();
    this.id = hexText(this.uuid);
    const refused = problem ?? (options.signal?.aborted === true ? closedError(client.name) : undefined);
    if (refused !== undefined) {
      this.drop(refused);
      return;
    }
    client.goals.set(this.id, this);
    options.signal?.addEventListener('abort', this.abandon, { once: true });
    void this.run(goal);
  }

  get accepted(): Promise<boolean> {
    return this.answer.promise;
  }

  get result(): Promise<GoalResult> {
    return this.outcome.promise;
  }

  private async run(goal: Uint8Array): Promise<void> {
    const { client, options } = this;
    try {
      const { timeoutMs } = options;
      const request = Uint8Array.of(...header, ...this.uuid);
      const whole = new Uint8Array(request.length + Math.max(0, goal.length - header.length));
      whole.set(request);
      whole.set(goal.subarray(header.length), request.length);
      const reply = await client.sending.call(whole, {
        signal: this.unsent.signal,
        ...(timeoutMs === undefined ? {} : { timeoutMs }),
      });
      const accepted = reply[header.length] === 1;
      this.answer.resolve(accepted);
      if (!accepted) {
        this.drop(new SiteError('R2W0719', `the server of \`${client.name}\` refused the goal`));
        return;
      }
      if (this.givenUp) {
        await this.cancel().catch(() => undefined);
        this.drop(closedError(client.name));
        return;
      }
      const early = this.early ?? [];
      this.early = undefined;
      this.status('accepted');
      for (const each of early) each();
      const result = await client.getting.call(Uint8Array.of(...header, ...this.uuid), { timeoutMs: Infinity });
      const status = statusOf(result[header.length]);
      this.status(status);
      this.outcome.resolve({ status, bytes: result });
      this.drop(closedError(client.name));
    } catch (error) {
      this.drop(error);
    }
  }

  feedback(bytes: Uint8Array<ArrayBuffer>, info: MessageInfo): void {
    if (this.early !== undefined) this.early.push(() => this.feedback(bytes, info));
    else if (!this.givenUp) guarded(() => this.options.onFeedback?.(bytes, info));
  }

  status(status: GoalStatus): void {
    if (this.early !== undefined) {
      this.early.push(() => this.status(status));
      return;
    }
    // The first words of a goal may come after later ones, on another way.
    const isNews = status !== this.last && !isOver(this.last) && statuses.indexOf(status) > statuses.indexOf(this.last);
    if (this.givenUp || !isNews) return;
    this.last = status;
    guarded(() => this.options.onStatus?.(status));
  }

  async cancel(): Promise<boolean> {
    // The stamp is zero: the request has no condition on time.
    const reply = await this.client.canceling.call(Uint8Array.of(...header, ...this.uuid, ...new Uint8Array(8)));
    const count = reply.length >= 12 ? new DataView(reply.buffer, reply.byteOffset + 8).getUint32(0, reply[1] === 1) : 0;
    return reply[header.length] === 0 && count > 0;
  }

  close(): void {
    if (this.givenUp || this.finished) return;
    this.givenUp = true;
    this.answer.reject(closedError(this.client.name));
    this.outcome.reject(closedError(this.client.name));
    // Until the server has answered it knows of no goal to cancel: run() does it then. One that waits for a server is not sent.
    if (this.last === 'unknown') {
      if (!this.client.sending.ready()) this.unsent.abort();
      return;
    }
    void this.cancel().catch(() => undefined).finally(() => this.drop(closedError(this.client.name)));
  }

  /** It is over, one way or the other. */
  drop(error: unknown): void {
    this.options.signal?.removeEventListener('abort', this.abandon);
    this.finished = true;
    this.answer.reject(error);
    this.outcome.reject(error);
    this.client.over(this);
  }
}

function newGoalId(): Uint8Array {
  const id = crypto.getRandomValues(new Uint8Array(idBytes));
  id[6] = (id[6]! & 0x0f) | 0x40;
  id[8] = (id[8]! & 0x3f) | 0x80;
  return id;
}
