// A display that shows the newest message of its topic, as one object in the message's frame.

import { Group } from 'three';
import type { Object3D } from 'three';
import { readHeader } from '../model/transform.ts';
import type { HeaderView } from '../model/transform.ts';
import type { Anchored, Display } from './display.ts';
import { emptied } from './dispose.ts';

export interface Built {
  readonly object: Object3D | null;
  readonly problem: string;
  /** Where it stands, if not where the message's header says. */
  readonly header?: HeaderView;
}

export class NewestDisplay implements Display {
  readonly group = new Group();
  problem = '';
  private readonly make: (message: unknown) => Built;
  private waiting: { readonly message: unknown; } | null = null;
  /** Kept for another theme or look. */
  private shown: { readonly message: unknown; } | null = null;
  private header: HeaderView = { stamp: NaN, frame: '' };

  constructor(make: (message: unknown) => Built) {
    this.make = make;
  }

  repaint(): void {
    this.waiting ??= this.shown;
  }

  take(message: unknown): void {
    this.waiting = { message };
  }

  build(): undefined {
    if (this.waiting === null) return;
    const { message } = this.waiting;
    this.shown = this.waiting;
    this.waiting = null;
    emptied(this.group);
    const { object, problem, header } = this.make(message);
    this.problem = problem;
    this.header = header ?? readHeader(message);
    if (object !== null) this.group.add(object);
  }

  *anchored(): Iterable<Anchored> {
    if (this.group.children.length > 0) yield { object: this.group, header: this.header };
  }

  close(): void {
    emptied(this.group);
  }
}
