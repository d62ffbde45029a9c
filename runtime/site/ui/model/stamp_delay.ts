// How long after the stamp in their header messages came, as `ros2 topic delay` tells it: over the newest ones that were
// looked at. A message without a header, or with a stamp that nobody has set, has no delay. Pure.

import { isMessage } from '../../decode/yaml.ts';
import type { Decoded } from '../../decode/decoder.ts';
import { asNumber } from './field_path.ts';

const MOST = 100;

/** All in ms. */
export interface StampDelay {
  readonly mean: number;
  readonly least: number;
  readonly most: number;
}

/** ms; undefined: it has none. */
export function delayOf(message: Decoded, receivedAt: number): number | undefined {
  if (message.kind !== 'value' || !isMessage(message.value)) return undefined;
  const [first] = message.shape;
  if (first?.type !== 'std_msgs/msg/Header' || first.isArray) return undefined;
  const header = message.value[first.name];
  const stamp = isMessage(header) ? header['stamp'] : undefined;
  if (!isMessage(stamp)) return undefined;
  const ms = asNumber(stamp['sec']) * 1000 + asNumber(stamp['nanosec']) / 1e6;
  return ms === 0 ? undefined : receivedAt - ms;
}

export class DelayWindow {
  private readonly delays: number[] = [];

  add(delay: number | undefined): void {
    if (delay === undefined) return;
    this.delays.push(delay);
    if (this.delays.length > MOST) this.delays.shift();
  }

  /** undefined: nothing has one. */
  get(): StampDelay | undefined {
    const { delays } = this;
    if (delays.length === 0) return undefined;
    const mean = delays.reduce((sum, delay) => sum + delay, 0) / delays.length;
    return { mean, least: Math.min(...delays), most: Math.max(...delays) };
  }
}
