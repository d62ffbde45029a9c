// Turns, moves and zooms a view: by mouse, by one or two fingers, by keys. With a tool for poses one pointer sets a pose
// on the ground instead: where it goes down is the place, whereto it is drawn the heading. With a tool for points a press
// that goes nowhere is one. Keys do both in the middle of the picture.

import { panned, turned, zoomed } from '../model/camera_view.ts';
import type { CameraView } from '../model/camera_view.ts';
import type { Vector } from '../model/transform.ts';

export interface CameraHost {
  view(): CameraView;
  /** While it goes on. */
  look(view: CameraView): void;
  /** It rests again: worth keeping. */
  settle(): void;
  home(): void;
  /** The kind of input of the selected tool; null: no tool is selected. */
  aims(): 'pose' | 'point' | null;
  groundAt(x: number, y: number): Vector | null;
  /** While a pose is drawn; null when it was given up. */
  aim(pose: GroundPose | null): void;
  setPose(pose: GroundPose): void;
  /** In pixels of the canvas. */
  setPoint(x: number, y: number): void;
  leaveTool(): void;
  /** Takes the first pointer for itself until it goes up; null: it turns the view, as usual. */
  grab?(x: number, y: number, event: PointerEvent): Grab | null;
}

export interface Grab {
  /** In pixels of the canvas. */
  move(x: number, y: number): void;
  end(): void;
}

export interface GroundPose {
  readonly place: Vector;
  /** A yaw in radians. */
  readonly heading: number;
}

interface Pointer {
  x: number;
  y: number;
}

const TURN_STEP = 40; // pixels' worth, for one press of a key
const ZOOM_STEP = 1.2;
const LEAST_DRAG = 8; // pixels, below which a goal has no heading of its own
const USUAL_HEIGHT = 400;
const HEADING_STEP = Math.PI / 12; // for one press of a key

export function controlCamera(canvas: HTMLCanvasElement, host: CameraHost): () => void {
  const pointers = new Map<number, Pointer>();
  let goalStart: { readonly place: Vector; readonly x: number; readonly y: number; } | null = null;
  /** Where the pointer of a tool for points went down, until it is further than a press. */
  let press: Pointer | null = null;
  let grab: Grab | null = null;
  /** The angle in radians by which keys have turned the heading. */
  let keyTurn = 0;
  let settling: ReturnType<typeof setTimeout> | undefined;
  const abort = new AbortController();
  const height = (): number => canvas.clientHeight || USUAL_HEIGHT;
  const placeOf = (event: PointerEvent): Pointer => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  const down = (event: PointerEvent): void => {
    const at = placeOf(event);
    pointers.set(event.pointerId, at);
    canvas.setPointerCapture(event.pointerId);
    if (event.pointerType === 'mouse') event.preventDefault(); // no text is selected, no autoscroll begins
    canvas.focus({ preventScroll: true });
    const isFirst = pointers.size === 1 && event.button === 0;
    grab?.end(); // a second finger moves the view
    grab = isFirst ? (host.grab?.(at.x, at.y, event) ?? null) : null;
    if (grab !== null) {
      press = null;
      return;
    }
    press = host.aims() === 'point' && isFirst ? { ...at } : null;
    const isGoal = host.aims() === 'pose' && isFirst;
    const place = isGoal ? host.groundAt(at.x, at.y) : null;
    if (goalStart !== null) host.aim(null); // a second finger: not a goal after all
    goalStart = place === null ? null : { place, ...at };
    if (place !== null) host.aim({ place, heading: 0 });
  };

  const goalAt = (at: Pointer): GroundPose | null => {
    if (goalStart === null) return null;
    const { place, x, y } = goalStart;
    const end = Math.hypot(at.x - x, at.y - y) < LEAST_DRAG ? null : host.groundAt(at.x, at.y);
    const heading = end === null ? 0 : Math.atan2(end[1] - place[1], end[0] - place[0]);
    return { place, heading };
  };

  const move = (event: PointerEvent): void => {
    const pointer = pointers.get(event.pointerId);
    if (pointer === undefined) return;
    const at = placeOf(event);
    if (grab !== null) {
      grab.move(at.x, at.y);
      [pointer.x, pointer.y] = [at.x, at.y];
      return;
    }
    const goal = goalAt(at);
    if (goal !== null) {
      host.aim(goal);
      return;
    }
    if (press !== null && Math.hypot(at.x - press.x, at.y - press.y) < LEAST_DRAG) return;
    press = null;
    const [dx, dy] = [at.x - pointer.x, at.y - pointer.y];
    const before = spanOf(pointers);
    [pointer.x, pointer.y] = [at.x, at.y];
    const after = spanOf(pointers);
    const view = host.view();
    if (before !== null && after !== null) {
      const factor = after > 0 ? before / after : 1;
      host.look(zoomed(panned(view, dx / 2, dy / 2, height()), factor));
    } else if (view.top || event.shiftKey || (event.buttons & 6) !== 0) {
      host.look(panned(view, dx, dy, height()));
    } else {
      host.look(turned(view, dx, dy, height()));
    }
  };

  const up = (event: PointerEvent): void => {
    const goal = event.type === 'pointerup' ? goalAt(placeOf(event)) : null;
    if (!pointers.delete(event.pointerId)) return;
    if (grab !== null) {
      grab.end();
      grab = null;
      return;
    }
    if (goalStart !== null) {
      goalStart = null;
      host.aim(null);
      if (goal !== null) host.setPose(goal);
    } else if (press !== null) {
      if (event.type === 'pointerup') host.setPoint(press.x, press.y);
      press = null;
    } else if (pointers.size === 0) {
      host.settle();
    }
  };

  const wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const lines = event.deltaMode === 0 ? event.deltaY / 100 : event.deltaY / 3;
    host.look(zoomed(host.view(), ZOOM_STEP ** Math.max(-5, Math.min(5, lines))));
    clearTimeout(settling);
    settling = setTimeout(() => host.settle(), 300);
  };

  /** In the middle of the picture. False: the tool has no use for the key. */
  const toolKey = (name: string): boolean => {
    const [x, y] = [canvas.clientWidth / 2, canvas.clientHeight / 2];
    const aims = host.aims();
    if (name === 'Escape') {
      host.aim(null);
      host.leaveTool();
    } else if (aims === 'point' && name === 'Enter') {
      host.setPoint(x, y);
    } else if (aims === 'pose' && (name === 'Enter' || name === '[' || name === ']')) {
      keyTurn += name === '[' ? HEADING_STEP : name === ']' ? -HEADING_STEP : 0;
      const place = host.groundAt(x, y);
      // Away from the eye: as one looks, so one goes.
      const ahead = host.view().top ? 0 : turnedBack(host.view().azimuth);
      const pose = place === null ? null : { place, heading: wrapped(ahead + keyTurn) };
      if (name !== 'Enter') host.aim(pose);
      else if (pose !== null) {
        host.aim(null);
        host.setPose(pose);
      }
    } else {
      return false;
    }
    return true;
  };

  const key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (host.aims() !== null && toolKey(event.key)) {
      event.preventDefault();
      return;
    }
    const next = keyed(host.view(), event.key, event.shiftKey, height());
    if (next === null) return;
    event.preventDefault();
    if (next === 'home') host.home();
    else host.look(next);
    host.settle();
  };

  const { signal } = abort;
  canvas.addEventListener('pointerdown', down, { signal });
  canvas.addEventListener('pointermove', move, { signal });
  canvas.addEventListener('pointerup', up, { signal });
  canvas.addEventListener('pointercancel', up, { signal });
  canvas.addEventListener('wheel', wheel, { signal, passive: false });
  canvas.addEventListener('keydown', key, { signal });
  canvas.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
  return () => {
    clearTimeout(settling);
    grab?.end();
    abort.abort();
  };
}

/** The view after a key; null: the key does nothing. */
export function keyed(view: CameraView, key: string, shift: boolean, height: number): CameraView | 'home' | null {
  const move = view.top || shift ? panned : turned;
  switch (key) {
    case 'ArrowLeft':
      return move(view, TURN_STEP, 0, height);
    case 'ArrowRight':
      return move(view, -TURN_STEP, 0, height);
    case 'ArrowUp':
      return move(view, 0, TURN_STEP, height);
    case 'ArrowDown':
      return move(view, 0, -TURN_STEP, height);
    case '+':
    case '=':
      return zoomed(view, 1 / ZOOM_STEP);
    case '-':
      return zoomed(view, ZOOM_STEP);
    case 'Home':
      return 'home';
    default:
      return null;
  }
}

/** Between the first two of them; null for fewer. */
function spanOf(pointers: ReadonlyMap<number, Pointer>): number | null {
  const [a, b] = [...pointers.values()];
  return a === undefined || b === undefined ? null : Math.hypot(a.x - b.x, a.y - b.y);
}

function wrapped(angle: number): number {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}

function turnedBack(azimuth: number): number {
  return Math.atan2(-Math.sin(azimuth), -Math.cos(azimuth));
}
