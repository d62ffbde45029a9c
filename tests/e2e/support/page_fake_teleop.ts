// The scene "teleop" of page_fake.tsx: nodes on a real graph that wait to be driven, /turtle1 by Twist and /robot by
// TwistStamped. `globalThis.driven` has what they heard, and `arrive` lets one more come.

import { createCodec } from '../../../runtime/site/decode/codec.ts';
import { EndpointKind } from '../../../runtime/protocol/generated/constants.ts';
import { FakeSession } from '../../unit/ui/fake_session.ts';
import { GraphPeer } from '../../unit/site/graph_peer.ts';
import { followGraph } from './page_fake_graph.ts';

export interface Heard {
  readonly topic: string;
  readonly linear: number;
  readonly angular: number;
  /** Set for a TwistStamped only. */
  readonly frame?: string;
  readonly sec?: number;
}

interface Twist {
  readonly linear: { readonly x: number; };
  readonly angular: { readonly z: number; };
}

export async function teleop(): Promise<FakeSession> {
  const fake = new FakeSession({
    nodes: [{ executable: 'turtlesim' }],
    interfaces: new Map([
      ['builtin_interfaces/msg/Time', 'int32 sec\nuint32 nanosec\n'],
      ['std_msgs/msg/Header', 'builtin_interfaces/Time stamp\nstring frame_id\n'],
      ['geometry_msgs/msg/Vector3', 'float64 x\nfloat64 y\nfloat64 z\n'],
      ['geometry_msgs/msg/Twist', 'Vector3 linear\nVector3 angular\n'],
      ['geometry_msgs/msg/TwistStamped', 'std_msgs/Header header\nTwist twist\n'],
    ]),
  });
  const codec = createCodec(await fake.interfaces());
  const peer = new GraphPeer(fake.broker);
  const driven: Heard[] = [];
  const listen = (node: string, topic: string, type: string): void => {
    const handle = peer.make(EndpointKind.subscription, node, topic, type, { depth: 100 });
    const work = async (): Promise<void> => {
      for (;;) {
        const { bytes } = await peer.next(handle);
        const decoded = codec.decode(type, bytes);
        if (decoded.kind === 'failed') throw new Error(decoded.reason);
        const value = decoded.value as Twist & {
          readonly twist?: Twist;
          readonly header?: { readonly frame_id: string; readonly stamp: { readonly sec: number; }; };
        };
        const { linear, angular } = value.twist ?? value;
        driven.push({
          topic,
          linear: linear.x,
          angular: angular.z,
          ...(value.header === undefined ? {} : { frame: value.header.frame_id, sec: value.header.stamp.sec }),
        });
      }
    };
    void work();
  };
  listen('turtlesim', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist');
  listen('robot', '/z/cmd_vel', 'geometry_msgs/msg/TwistStamped');
  followGraph(fake);
  Object.assign(globalThis, { driven, arrive: listen });
  return fake;
}
