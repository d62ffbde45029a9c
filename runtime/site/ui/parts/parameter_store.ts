// The parameters of all nodes that offer them: read over their services, followed over /parameter_events, set. A node
// that has gone keeps what was known of it; one that comes again is read again.

import type { GraphView, Session, Unsubscribe } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { isHiddenName } from '../../decode/ros_names.ts';
import type { Caller } from '../../ros2cli/calls.ts';
import { descriptorsOf, namesOf, setValue, valuesOf } from '../../ros2cli/parameter_calls.ts';
import type { Descriptor, SetResult } from '../../ros2cli/parameter_calls.ts';
import type { ParameterValue } from '../../ros2cli/parameters.ts';
import { panelTexts } from '../texts_panels.ts';

const EVENTS = '/parameter_events';
const EVENT_TYPE = 'rcl_interfaces/msg/ParameterEvent';
const DEPTH = 1000;
/** How often the names are read again when parameters disappear during the read. */
const TRIES = 3;

export interface KnownParameter {
  readonly value: ParameterValue;
  /** undefined: not read yet, or the node says nothing. */
  readonly descriptor: Descriptor | undefined;
}

export interface NodeParameters {
  /** Fully qualified. */
  readonly name: string;
  /** Does it offer its parameters now? */
  readonly here: boolean;
  readonly reading: boolean;
  /** Why they could not be read; empty: they could. */
  readonly problem: string;
  /** Sorted by name. */
  readonly parameters: ReadonlyMap<string, KnownParameter>;
}

interface Event {
  readonly node: string;
  readonly new_parameters: readonly Parameter[];
  readonly changed_parameters: readonly Parameter[];
  readonly deleted_parameters: readonly Parameter[];
}

interface Parameter {
  readonly name: string;
  readonly value: ParameterValue;
}

interface Entry {
  view: NodeParameters;
  /** The gid of the service that lists them; another gid means another node of that name. */
  gid: string;
  /** Reads that began later have a larger one: what an older one brings is left. */
  turn: number;
  abort: AbortController | undefined;
  /** Events that came during the read: they may be newer than its result. */
  readonly waiting: Event[];
}

export class ParameterStore {
  private readonly session: Session;
  private readonly codec: Codec;
  private readonly changed: () => void;
  private readonly entries = new Map<string, Entry>();
  private readonly stops: Unsubscribe[] = [];
  private readonly abort = new AbortController();

  constructor(session: Session, codec: Codec, changed: () => void) {
    this.session = session;
    this.codec = codec;
    this.changed = changed;
    const events = session.node().subscription(EVENTS, EVENT_TYPE, { depth: DEPTH }, (bytes) => {
      const decoded = codec.decode(EVENT_TYPE, bytes);
      if (decoded.kind === 'value') this.heard(decoded.value as unknown as Event);
    });
    this.stops.push(() => events.close(), session.onGraph((graph) => this.follow(graph)));
    this.follow(session.graph());
  }

  /** Sorted by name; hidden ones only when asked for. */
  nodes(hidden: boolean): readonly NodeParameters[] {
    return [...this.entries.values()]
      .map(({ view }) => view)
      .filter(({ name }) => hidden || !isHiddenName(name))
      .sort((a, b) => (a.name < b.name ? -1 : 1));
  }

  reload(name: string): void {
    const entry = this.entries.get(name);
    if (entry !== undefined) this.read(entry);
  }

  /** Rejects when the node does not answer. Then reads the value back: the node may have changed it. */
  async set(node: string, name: string, value: ParameterValue): Promise<SetResult> {
    const caller = this.caller(this.abort.signal);
    const result = await setValue(caller, node, name, value);
    if (!result.successful) return result;
    const [now] = await valuesOf(caller, node, [name]);
    const entry = this.entries.get(node);
    if (now !== undefined && entry !== undefined) this.put(entry, [{ name, value: now }], []);
    return result;
  }

  close(): void {
    for (const stop of this.stops) stop();
    this.abort.abort();
    for (const { abort } of this.entries.values()) abort?.abort();
  }

  private caller(signal: AbortSignal): Caller {
    return { session: this.session, signal, codec: () => Promise.resolve(this.codec) };
  }

  private follow({ nodes }: GraphView): void {
    const gids = new Map<string, string>();
    for (const { name, services } of nodes) {
      const list = services.find((service) => service.name === `${name}/list_parameters`);
      if (list !== undefined) gids.set(name, list.gid);
    }
    for (const entry of this.entries.values()) {
      if (gids.has(entry.view.name) || !entry.view.here) continue;
      entry.gid = '';
      this.show(entry, { here: false });
    }
    for (const [name, gid] of gids) {
      const known = this.entries.get(name);
      if (known?.gid === gid) continue;
      const entry: Entry = known ?? {
        view: { name, here: true, reading: false, problem: '', parameters: new Map() },
        gid,
        turn: 0,
        abort: undefined,
        waiting: [],
      };
      entry.gid = gid;
      this.entries.set(name, entry);
      this.read(entry);
    }
  }

  private read(entry: Entry): void {
    entry.abort?.abort();
    const abort = new AbortController();
    entry.abort = abort;
    entry.turn += 1;
    entry.waiting.length = 0;
    const { turn } = entry;
    const { name } = entry.view;
    this.show(entry, { here: entry.gid !== '', reading: true });
    this.all(this.caller(abort.signal), name).then(
      (parameters) => {
        if (entry.turn !== turn) return;
        this.show(entry, { reading: false, problem: '', parameters });
        for (const event of entry.waiting.splice(0)) this.heard(event);
      },
      (error: unknown) => {
        if (entry.turn !== turn || this.abort.signal.aborted) return;
        this.show(entry, { reading: false, problem: error instanceof Error ? error.message : String(error) });
      },
    );
  }

  private async all(caller: Caller, node: string): Promise<ReadonlyMap<string, KnownParameter>> {
    for (let left = TRIES; left > 0; left -= 1) {
      const names = await namesOf(caller, node);
      if (names.length === 0) return new Map();
      const values = await valuesOf(caller, node, names);
      // One that has gone since the names were read makes the answer empty.
      if (values.length !== names.length) continue;
      const described = new Map((await descriptorsOf(caller, node, names)).map((each) => [each.name, each]));
      return new Map(names.flatMap((name, at) => {
        const value = values[at];
        return value === undefined ? [] : [[name, { value, descriptor: described.get(name) }] as const];
      }));
    }
    throw new Error(panelTexts.parameters.changing);
  }

  private heard(event: Event): void {
    const entry = this.entries.get(event.node);
    if (entry === undefined) return;
    if (entry.view.reading) {
      if (entry.waiting.length < DEPTH) entry.waiting.push(event);
      return;
    }
    this.put(entry, [...event.new_parameters, ...event.changed_parameters], event.deleted_parameters);
  }

  private put(entry: Entry, values: readonly Parameter[], deleted: readonly Parameter[]): void {
    const parameters = new Map(entry.view.parameters);
    const strange: string[] = [];
    for (const { name, value } of values) {
      const known = parameters.get(name);
      if (known === undefined) strange.push(name);
      parameters.set(name, { value, descriptor: known?.descriptor });
    }
    for (const { name } of deleted) parameters.delete(name);
    const sorted = strange.length === 0 ? parameters : new Map([...parameters].sort(([a], [b]) => (a < b ? -1 : 1)));
    this.show(entry, { parameters: sorted });
    if (strange.length > 0) this.describe(entry, strange);
  }

  /** Without an answer they stay as they are: their values are known. */
  private describe(entry: Entry, names: readonly string[]): void {
    descriptorsOf(this.caller(this.abort.signal), entry.view.name, names).then(
      (descriptors) => {
        const parameters = new Map(entry.view.parameters);
        for (const descriptor of descriptors) {
          const known = parameters.get(descriptor.name);
          if (known !== undefined) parameters.set(descriptor.name, { ...known, descriptor });
        }
        this.show(entry, { parameters });
      },
      () => undefined,
    );
  }

  private show(entry: Entry, next: Partial<NodeParameters>): void {
    entry.view = { ...entry.view, ...next };
    if (!this.abort.signal.aborted) this.changed();
  }
}
