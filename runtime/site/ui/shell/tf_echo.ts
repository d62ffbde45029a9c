// `ros2 run tf2_ros tf2_echo SOURCE TARGET [RATE]`: where the one frame is in the other, at a pace of the site's time.

import type { Session } from '../../contract/session.ts';
import { toRollPitchYaw, rotate } from '../model/transform.ts';
import type { Transform, Vector } from '../model/transform.ts';
import { TransformTree } from '../model/transform_tree.ts';
import type { Lookup } from '../model/transform_tree.ts';
import { followTransforms } from '../parts/follow_transforms.ts';
import { codecOf } from '../parts/message_feed.ts';
import { shellTexts } from '../texts_shell.ts';

const USUAL_RATE_HZ = 1;

export interface EchoedFrames {
  readonly source: string;
  readonly target: string;
  readonly rateHz: number;
}

/** undefined: it is another command. A text says what is wrong. `carried`: the site has the program itself. */
export function readTfEcho(words: readonly string[], carried: boolean): EchoedFrames | string | undefined {
  const [ros2, run, from, program, source, target, rate = String(USUAL_RATE_HZ)] = words;
  if (carried || ros2 !== 'ros2' || run !== 'run' || from !== 'tf2_ros' || program !== 'tf2_echo') return undefined;
  const rateHz = Number(rate);
  if (source === undefined || target === undefined || !(rateHz > 0)) return shellTexts.tf.usage;
  return { source, target, rateHz };
}

/** Without a sign before zero. */
const three = (value: number): string => (Math.abs(value) < 5e-4 ? 0 : value).toFixed(3);
const list = (values: readonly number[]): string => `[${values.map(three).join(', ')}]`;

/** As tf2_echo writes it. `stamp`: seconds. */
export function transformLines({ translation, rotation }: Transform, stamp: number): readonly string[] {
  const angles = toRollPitchYaw(rotation);
  const columns = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as const satisfies readonly Vector[]).map((axis) => rotate(rotation, axis));
  const rows = [0, 1, 2].map((i) => [...columns.map((column) => column[i] ?? 0), translation[i] ?? 0]);
  return [
    `At time ${Number.isNaN(stamp) ? '0.0' : stamp.toFixed(9)}`,
    `- Translation: ${list(translation)}`,
    `- Rotation: in Quaternion (xyzw) ${list(rotation)}`,
    `- Rotation: in RPY (radian) ${list(angles)}`,
    `- Rotation: in RPY (degree) ${list(angles.map((angle) => (angle * 180) / Math.PI))}`,
    '- Matrix:',
    ...[...rows, [0, 0, 0, 1]].map((row) => row.map((value) => three(value).padStart(7)).join('')),
  ];
}

function whyNot(found: Exclude<Lookup, { kind: 'found'; }>, { source, target }: EchoedFrames): string {
  switch (found.kind) {
    case 'unknown':
      return shellTexts.tf.unknown(found.frame, found.frame === source ? 'target_frame' : 'source_frame');
    case 'loop':
      return shellTexts.tf.loop(found.frame);
    case 'apart':
      return shellTexts.tf.apart(source, target);
  }
}

/** Until the signal; gives the exit code. */
export async function runTfEcho(session: Session, frames: EchoedFrames, out: (text: string) => void, signal: AbortSignal): Promise<number> {
  const { source, target, rateHz } = frames;
  const codec = await codecOf(session);
  if (signal.aborted) return 0;
  const tree = new TransformTree();
  let trouble = '';
  const stop = followTransforms(session, codec, tree, { onTransforms: () => undefined, onProblem: (problem) => (trouble = problem) });
  const look = (): void => {
    // As tf2_echo names its arguments: the second frame, seen from the first.
    const found = tree.lookup(source, target);
    const now = session.time.view().now / 1000;
    if (found.kind === 'found') transformLines(found.transform, tree.newest).forEach(out);
    else out(`[INFO] [${now.toFixed(9)}] [tf2_echo]: ${shellTexts.tf.waiting(source, target, trouble === '' ? whyNot(found, frames) : trouble)}`);
  };
  const timer = session.node().timer(1000 / rateHz, look);
  await new Promise<void>((done) => signal.addEventListener('abort', () => done(), { once: true }));
  timer.close();
  stop();
  return 0;
}
