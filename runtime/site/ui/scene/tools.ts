// The tools of a scene: what a press in the picture does, and the messages that some of them publish, as RViz's tools do.

import type { PagePublisher, Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { stampOf } from '../model/draft_value.ts';
import type { PoseVariance, SceneOptions } from '../model/scene_options.ts';
import { fromRollPitchYaw } from '../model/transform.ts';
import type { Vector } from '../model/transform.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import { sceneTexts } from '../texts_scene.ts';
import type { GroundPose } from './camera_control.ts';

export type SceneTool = 'goal' | 'estimate' | 'point' | 'inspect' | 'measure';

export const AIMS: Readonly<Record<SceneTool, 'pose' | 'point'>> = {
  goal: 'pose',
  estimate: 'pose',
  point: 'point',
  inspect: 'point',
  measure: 'point',
};

/** The topic to which a tool publishes. */
export interface Outlet {
  readonly topic: string;
  readonly type: string;
}

export function outletOf(tool: SceneTool | null, { goal, estimate, point }: SceneOptions): Outlet | null {
  switch (tool) {
    case 'goal':
      return { topic: goal, type: 'geometry_msgs/msg/PoseStamped' };
    case 'estimate':
      return { topic: estimate, type: 'geometry_msgs/msg/PoseWithCovarianceStamped' };
    case 'point':
      return { topic: point, type: 'geometry_msgs/msg/PointStamped' };
    default:
      return null;
  }
}

export function poseValue({ place: [x, y], heading }: GroundPose): unknown {
  const [qx, qy, qz, qw] = fromRollPitchYaw(0, 0, heading);
  return { position: { x, y, z: 0 }, orientation: { x: qx, y: qy, z: qz, w: qw } };
}

/** A pose with RViz's covariance: x, y and the heading vary by themselves. */
export function estimateValue(pose: GroundPose, variance: PoseVariance): unknown {
  const covariance = new Array<number>(36).fill(0);
  [covariance[0], covariance[7], covariance[35]] = [variance.x, variance.y, variance.yaw];
  return { pose: poseValue(pose), covariance };
}

export function pointValue([x, y, z]: Vector): unknown {
  return { x, y, z };
}

/** Publishes with a header; says why it did not, or `sent`. */
export function publishStamped(
  session: Session,
  codec: Codec | string | null,
  publisher: PagePublisher | null,
  { type }: Outlet,
  frame: string,
  body: Readonly<Record<string, unknown>>,
  sent: string,
): string {
  if (frame === '') return sceneTexts.tools.noFrame;
  if (codec === null || typeof codec === 'string' || publisher === null) return texts.topics.decoding;
  const encoded = codec.encode(type, { header: { stamp: stampOf(session.time.view().now), frame_id: frame }, ...body });
  if (encoded.kind !== 'bytes') return panelTexts.text.failed(encoded.reason);
  const problem = publisher.problem ?? publisher.publish(encoded.bytes);
  return problem === undefined ? sent : panelTexts.text.failed(problem.message);
}
