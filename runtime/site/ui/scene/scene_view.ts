// A scene as a whole: the frames of a tree and the displays of topics, each where the tree says that it is in the
// fixed frame. Everything is made and placed just before it is drawn.

import type { CameraView } from '../model/camera_view.ts';
import { IDENTITY } from '../model/transform.ts';
import type { HeaderView, Vector } from '../model/transform.ts';
import type { Lookup, TransformTree } from '../model/transform_tree.ts';
import { unreachable } from '../../contract/session.ts';
import { panelTexts } from '../texts_panels.ts';
import type { Display, DisplayColors } from './display.ts';
import { FrameAxes } from './frame_axes.ts';
import type { FramePlace } from './frame_axes.ts';
import type { GroundPose } from './camera_control.ts';
import { GoalArrow } from './goal_arrow.ts';
import { pick } from './pick.ts';
import type { Picked } from './pick.ts';
import { Ruler } from './ruler.ts';
import { placeAt } from './shapes.ts';
import type { Stage } from './stage.ts';

/** The fixed frame when nobody chose one: the first of these that there is, else a root. */
const USUAL_FRAMES = ['map', 'odom', 'world', 'base_link'] as const;

export interface SceneHost {
  /** Seconds of the site's time. */
  now(): number;
  /** Wants to draw again at that time. */
  wake(at: number): void;
  /** Frames that are drawn as axes; all, when omitted. */
  readonly showsFrame?: ((name: string) => boolean) | undefined;
  /** Everything has its place, and is about to be drawn. */
  readonly arranged?: (() => void) | undefined;
}

export class SceneView {
  private readonly stage: Stage;
  private readonly tree: TransformTree;
  private readonly host: SceneHost;
  private readonly axes = new FrameAxes();
  private readonly goal = new GoalArrow();
  private readonly ruler = new Ruler();
  private readonly displays = new Map<string, Display>();
  /** By topic: why its parts have no place. */
  private readonly lost = new Map<string, string>();
  private chosen = '';
  private fixed = '';
  private followed = '';
  private camera: CameraView;
  private framesMoved = true;
  private changes = 0;

  /** The stage calls arrange() before it draws. */
  constructor(stage: Stage, tree: TransformTree, camera: CameraView, host: SceneHost) {
    this.stage = stage;
    this.tree = tree;
    this.camera = camera;
    this.host = host;
    stage.scene.add(this.axes.group, this.goal.group, this.ruler.group);
  }

  /** Grows when something that is told about the scene in words may be different. */
  get version(): number {
    return this.changes;
  }

  get fixedFrame(): string {
    return this.fixed;
  }

  /** How many frames are shown. */
  get frameCount(): number {
    return this.axes.count;
  }

  get view(): CameraView {
    return this.camera;
  }

  /** Empty: one that suits. */
  chooseFrame(name: string): void {
    this.chosen = name;
    this.transformsMoved();
  }

  look(view: CameraView): void {
    this.camera = view;
    this.stage.setView(view);
  }

  show({ grid, frames, names }: { readonly grid: boolean; readonly frames: boolean; readonly names: boolean; }): void {
    this.axes.group.visible = frames;
    this.axes.showNames(names);
    this.stage.showGrid(grid);
  }

  get displayColors(): DisplayColors {
    const { stage } = this;
    return {
      get text() {
        return stage.colors.text;
      },
      get accent() {
        return stage.colors.accent;
      },
    };
  }

  /** The view goes with this frame; empty: with the fixed one. */
  follow(name: string): void {
    this.followed = name;
    this.transformsMoved();
  }

  /** null: nothing is there. */
  pick(x: number, y: number): Picked | null {
    return pick(this.stage, this.displays, x, y);
  }

  /** At most two places of the fixed frame. */
  measure(places: readonly Vector[]): void {
    this.ruler.set(places);
    this.stage.draw();
  }

  /** While a goal or an estimate is set. */
  aim(goal: GroundPose | null): void {
    this.goal.set(goal, this.camera.distance);
    this.stage.draw();
  }

  /** The tree has changed. */
  transformsMoved(): void {
    this.framesMoved = true;
    this.stage.draw();
  }

  setColors(): void {
    this.stage.setColors();
    this.framesMoved = true;
    for (const display of this.displays.values()) display.repaint();
  }

  /** The look of a topic's display has changed. */
  repaint(topic: string): void {
    this.displays.get(topic)?.repaint();
    this.stage.draw();
  }

  add(topic: string, display: Display): void {
    this.displays.set(topic, display);
    this.stage.scene.add(display.group);
    this.stage.draw();
  }

  remove(topic: string): void {
    const display = this.displays.get(topic);
    if (display === undefined) return;
    this.stage.scene.remove(display.group);
    display.close();
    this.displays.delete(topic);
    this.lost.delete(topic);
    this.stage.draw();
  }

  /** The display has taken a message. */
  messageTaken(): void {
    this.stage.draw();
  }

  /** Why a topic is not shown, or not all of it; empty: it is. */
  problem(topic: string): string {
    const own = this.displays.get(topic)?.problem ?? '';
    return own === '' ? (this.lost.get(topic) ?? '') : own;
  }

  /** Before each drawing. */
  arrange(): void {
    let next = Infinity;
    for (const display of this.displays.values())
      next = Math.min(next, display.build(this.host.now()) ?? Infinity);
    if (Number.isFinite(next)) this.host.wake(next);
    const fixed = this.chosen === '' ? this.usualFrame() : this.chosen;
    if (fixed !== this.fixed) this.framesMoved = true;
    this.fixed = fixed;
    if (this.framesMoved) this.arrangeFrames();
    this.framesMoved = false;
    const eye = this.followed === '' ? null : this.lookup({ frame: this.followed, stamp: NaN });
    this.stage.setOrigin(eye?.kind === 'found' ? eye.transform.translation : IDENTITY.translation);
    this.axes.fit(this.camera);
    for (const [topic, display] of this.displays) this.lost.set(topic, this.place(display));
    this.host.arranged?.();
    this.changes += 1;
  }

  close(): void {
    for (const topic of [...this.displays.keys()]) this.remove(topic);
    this.axes.close();
    this.goal.close();
    this.ruler.close();
    this.stage.close();
  }

  private arrangeFrames(): void {
    const places: FramePlace[] = [];
    const transforms = this.tree.places(this.fixed);
    for (const { name, parent } of this.tree.views()) {
      if (this.host.showsFrame?.(name) === false) continue;
      const transform = transforms.get(name);
      if (transform !== undefined) places.push({ name, parent, transform });
    }
    this.axes.set(places, this.stage.colors.text);
  }

  /** Empty: each of its parts has its place. */
  private place(display: Display): string {
    let problem = '';
    const found = new Map<string, Lookup>();
    for (const { object, header } of display.anchored()) {
      const key = `${header.stamp} ${header.frame}`;
      const lookup = found.get(key) ?? this.lookup(header);
      found.set(key, lookup);
      object.visible = lookup.kind === 'found';
      if (lookup.kind === 'found') placeAt(object, lookup.transform);
      else problem = lostWords(lookup, header.frame, this.fixed);
    }
    return problem;
  }

  private lookup({ frame, stamp }: HeaderView): Lookup {
    // An object in the fixed frame has its place even if no transform mentions that frame.
    if (frame === this.fixed) return { kind: 'found', transform: IDENTITY };
    return this.tree.lookup(this.fixed, frame, stamp);
  }

  private usualFrame(): string {
    for (const name of USUAL_FRAMES) if (this.tree.has(name)) return name;
    const [root] = this.tree.roots();
    if (root !== undefined) return root;
    for (const display of this.displays.values())
      for (const { header } of display.anchored()) if (header.frame !== '') return header.frame;
    return this.fixed;
  }
}

function lostWords(lookup: Exclude<Lookup, { kind: 'found'; }>, frame: string, fixed: string): string {
  if (frame === '') return panelTexts.scene.noFrame;
  switch (lookup.kind) {
    case 'unknown':
      return panelTexts.scene.unknownFrame(lookup.frame);
    case 'loop':
      return panelTexts.scene.loop(lookup.frame);
    case 'apart':
      return panelTexts.scene.apart(frame, fixed);
    default:
      return unreachable(lookup);
  }
}
