// Odometry: the newest pose as an arrow, and smaller ones where the robot has been, as many as are kept. One is kept where
// the robot has moved or turned by a tenth since the last one, as in RViz.

import { Group } from 'three';
import { member } from '../model/json.ts';
import { readHeader, readPose } from '../model/transform.ts';
import type { HeaderView, Transform } from '../model/transform.ts';
import { isPlace } from './places.ts';
import type { Anchored, Display, DisplayContext } from './display.ts';
import { emptied } from './dispose.ts';
import { NewestDisplay } from './newest_display.ts';
import { arrows, singlePose } from './poses.ts';
import { lookOf } from './shapes.ts';

const LEAST_WAY = 0.1; // metres
const LEAST_TURN = 0.1; // radians

export class OdometryTrail implements Display {
  readonly group = new Group();
  private readonly trail = new Group();
  private readonly newest: NewestDisplay;
  /** There are at most `keep` arrows, including the newest one. */
  private readonly context: DisplayContext;
  private poses: Transform[] = [];
  private header: HeaderView = { stamp: NaN, frame: '' };
  private isChanged = false;

  constructor(context: DisplayContext) {
    this.context = context;
    this.newest = new NewestDisplay((message) => singlePose(lookOf(context))(message));
    this.group.add(this.newest.group, this.trail);
  }

  get problem(): string {
    return this.newest.problem;
  }

  take(message: unknown): void {
    this.newest.take(message);
    const pose = readPose(member(member(message, 'pose'), 'pose'));
    if (pose === null || !isPlace(...pose.translation)) return;
    const header = readHeader(message);
    // In another frame the places of before mean something else.
    if (header.frame !== this.header.frame) {
      this.poses = [];
      this.isChanged = true;
    }
    this.header = header;
    const last = this.poses.at(-1);
    if (last !== undefined && !isApart(last, pose)) return;
    this.poses.push(pose);
    if (this.poses.length > this.context.keep) this.poses.shift();
    this.isChanged = true;
  }

  build(): undefined {
    this.newest.build();
    if (!this.isChanged) return;
    this.isChanged = false;
    emptied(this.trail);
    const before = this.poses.slice(0, -1);
    if (before.length === 0) return;
    this.trail.add(arrows(before, lookOf(this.context)));
  }

  *anchored(): Iterable<Anchored> {
    if (this.poses.length > 0) yield { object: this.group, header: this.header };
  }

  repaint(): void {
    this.newest.repaint();
    this.isChanged = true;
  }

  close(): void {
    this.newest.close();
    emptied(this.trail);
  }
}

function isApart(from: Transform, to: Transform): boolean {
  const [x, y, z] = from.translation;
  const [a, b, c] = to.translation;
  const along = from.rotation.reduce((sum, part, index) => sum + part * (to.rotation[index] ?? 0), 0);
  return Math.hypot(a - x, b - y, c - z) >= LEAST_WAY || 2 * Math.acos(Math.min(1, Math.abs(along))) >= LEAST_TURN;
}
