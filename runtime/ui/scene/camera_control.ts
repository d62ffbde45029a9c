// Turns, moves and zooms a view: by mouse, by one or two fingers, by keys. In goal mode one pointer sets a pose on the
// ground instead: where it goes down is the place, whereto it is drawn the heading.

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
  isGoalMode(): boolean;
  groundAt(x: number, y: number): Vector | null;
  /** While a goal is drawn; null when it was given up. */
  aim(goal: GoalPose | null): void;
  setGoal(goal: GoalPose): void;
  leaveGoalMode(): void;
}

export interface GoalPose {
  readonly place: Vector;
  /** A yaw in radians. */
  readonly heading: number;
}

interface Pointer {
  x: number;
  y: number;
}

const kTurnStep = 40; // pixels' worth, for one press of a key
const kZoomStep = 1.2;
const kLeastDrag = 8; // pixels, below which a goal has no heading of its own
const kUsualHeight = 400;

export function controlCamera(canvas: HTMLCanvasElement, host: CameraHost): () => void {
  const pointers = new Map<number, Pointer>();
  let goalStart: { readonly place: Vector; readonly x: number; readonly y: number } | null = null;
  let settling: ReturnType<typeof setTimeout> | undefined;
  const abort = new AbortController();
  const height = (): number => canvas.clientHeight || kUsualHeight;
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
    const isGoal = host.isGoalMode() && pointers.size === 1 && event.button === 0;
    const place = isGoal ? host.groundAt(at.x, at.y) : null;
    if (goalStart !== null) host.aim(null); // a second finger: not a goal after all
    goalStart = place === null ? null : { place, ...at };
    if (place !== null) host.aim({ place, heading: 0 });
  };

  const goalAt = (at: Pointer): GoalPose | null => {
    if (goalStart === null) return null;
    const { place, x, y } = goalStart;
    const end = Math.hypot(at.x - x, at.y - y) < kLeastDrag ? null : host.groundAt(at.x, at.y);
    const heading = end === null ? 0 : Math.atan2(end[1] - place[1], end[0] - place[0]);
    return { place, heading };
  };

  const move = (event: PointerEvent): void => {
    const pointer = pointers.get(event.pointerId);
    if (pointer === undefined) return;
    const at = placeOf(event);
    const goal = goalAt(at);
    if (goal !== null) {
      host.aim(goal);
      return;
    }
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
    if (goalStart !== null) {
      goalStart = null;
      host.aim(null);
      if (goal !== null) host.setGoal(goal);
    } else if (pointers.size === 0) {
      host.settle();
    }
  };

  const wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const lines = event.deltaMode === 0 ? event.deltaY / 100 : event.deltaY / 3;
    host.look(zoomed(host.view(), kZoomStep ** Math.max(-5, Math.min(5, lines))));
    clearTimeout(settling);
    settling = setTimeout(() => host.settle(), 300);
  };

  const key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (host.isGoalMode() && (event.key === 'Enter' || event.key === 'Escape')) {
      event.preventDefault();
      const place = event.key === 'Enter' ? host.groundAt(canvas.clientWidth / 2, canvas.clientHeight / 2) : null;
      if (event.key === 'Escape') host.leaveGoalMode();
      // Away from the eye: as one looks, so one goes.
      else if (place !== null) host.setGoal({ place, heading: host.view().top ? 0 : turnedBack(host.view().azimuth) });
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
    abort.abort();
  };
}

/** What a key does to a view; null: nothing. */
export function keyed(view: CameraView, key: string, shift: boolean, height: number): CameraView | 'home' | null {
  const move = view.top || shift ? panned : turned;
  switch (key) {
    case 'ArrowLeft':
      return move(view, kTurnStep, 0, height);
    case 'ArrowRight':
      return move(view, -kTurnStep, 0, height);
    case 'ArrowUp':
      return move(view, 0, kTurnStep, height);
    case 'ArrowDown':
      return move(view, 0, -kTurnStep, height);
    case '+':
    case '=':
      return zoomed(view, 1 / kZoomStep);
    case '-':
      return zoomed(view, kZoomStep);
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

function turnedBack(azimuth: number): number {
  return Math.atan2(-Math.sin(azimuth), -Math.cos(azimuth));
}
