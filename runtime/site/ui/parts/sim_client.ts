// The requests of a panel to the simulator: its services below /_gz/world/NAME, and the hand of the visitor.

import type { GraphView, PagePublisher, Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { refusal } from '../model/draft_value.ts';
import { flagMember } from '../model/json.ts';
import { problemOf } from '../model/problem.ts';
import type { Vector } from '../model/transform.ts';

const FEEDBACK = 'visualization_msgs/msg/InteractiveMarkerFeedback';
const HAND = '/_gz/hand';
/** As visualization_msgs/msg/InteractiveMarkerFeedback numbers them. */
const Event = { hold: 1, push: 3, letGo: 5 } as const;
/** As ros_gz_interfaces/msg/Entity numbers them. */
const MODEL = 2;

/** The name of the world that a simulator of the graph offers; undefined: there is none yet. */
export function worldOf({ nodes }: GraphView): string | undefined {
  for (const { services } of nodes)
    for (const { name } of services) {
      const [, world] = /^\/_gz\/world\/([^/]+)\/control$/.exec(name) ?? [];
      if (world !== undefined) return world;
    }
  return undefined;
}

/** Members of ros_gz_interfaces/msg/WorldControl. */
export type WorldControl =
  | { readonly pause: boolean; }
  | { readonly pause: boolean; readonly multi_step: number; }
  | { readonly pause: boolean; readonly reset: { readonly all: boolean; }; };

export class SimClient {
  private readonly session: Session;
  private readonly codec: Codec;
  private readonly world: string;
  private readonly hand: PagePublisher;

  constructor(session: Session, codec: Codec, world: string) {
    this.session = session;
    this.codec = codec;
    this.world = world;
    this.hand = session.node().publisher(HAND, FEEDBACK);
  }

  /** Resolves with why it was not done; empty: it was. */
  control(control: WorldControl): Promise<string> {
    return this.call('control', 'ros_gz_interfaces/srv/ControlWorld', { world_control: control });
  }

  create(name: string, sdf: string, [x, y, z]: Vector): Promise<string> {
    return this.call('create', 'ros_gz_interfaces/srv/SpawnEntity', {
      entity_factory: { name, allow_renaming: true, sdf, pose: { position: { x, y, z }, orientation: { x: 0, y: 0, z: 0, w: 1 } } },
    });
  }

  remove(name: string): Promise<string> {
    return this.call('remove', 'ros_gz_interfaces/srv/DeleteEntity', { entity: { name, type: MODEL } });
  }

  /** Draws `point`, in the link, to `target`, in the world. Said again as long as it is held: the hand lets go after a second. */
  hold(frame: string, point: Vector, target: Vector): void {
    this.feed(Event.hold, frame, point, target);
  }

  letGo(frame: string): void {
    this.feed(Event.letGo, frame, [0, 0, 0], [0, 0, 0]);
  }

  /** `velocity`: the change, in metres per second along the axes of the world. */
  push(frame: string, point: Vector, velocity: Vector): void {
    this.feed(Event.push, frame, point, velocity);
  }

  close(): void {
    this.hand.close();
  }

  private feed(event: number, frame: string, [x, y, z]: Vector, [tx, ty, tz]: Vector): void {
    const encoded = this.codec.encode(FEEDBACK, {
      marker_name: frame,
      event_type: event,
      pose: { position: { x, y, z }, orientation: { x: 0, y: 0, z: 0, w: 1 } },
      mouse_point: { x: tx, y: ty, z: tz },
      mouse_point_valid: true,
    });
    if (encoded.kind === 'bytes') this.hand.publish(encoded.bytes);
  }

  private async call(name: string, type: string, request: unknown): Promise<string> {
    const encoded = this.codec.encode(`${type}_Request`, request);
    if (encoded.kind !== 'bytes') return refusal(encoded);
    const client = this.session.node().client(`/_gz/world/${this.world}/${name}`, type);
    try {
      const decoded = this.codec.decode(`${type}_Response`, await client.call(encoded.bytes));
      return decoded.kind === 'value' && flagMember(decoded.value, 'success', false) ? '' : name;
    } catch (error) {
      return problemOf(error).what;
    } finally {
      client.close();
    }
  }
}
