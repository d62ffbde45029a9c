// Pan and zoom of a drawing: by mouse, wheel and touch; fitted to its room until the visitor moves it.

import { useCallback, useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { RefObject } from 'preact';
import { fitted, DRAWING_LIMITS, moved, showing, zoomed } from '../model/camera.ts';
import type { Camera, CameraLimits } from '../model/camera.ts';
import type { Place, Point, Size } from '../model/graph_layout.ts';

export interface CameraControl {
  readonly camera: Camera;
  readonly view: Size;
  readonly fit: () => void;
  /** Around the middle of the view, or a point of it. */
  readonly zoom: (factor: number, at?: Point) => void;
  readonly move: (by: Point) => void;
  readonly show: (place: Place) => void;
  readonly onPointerDown: (event: PointerEvent) => void;
  readonly onPointerMove: (event: PointerEvent) => void;
  readonly onPointerEnd: (event: PointerEvent) => void;
  /** The pointer has dragged the drawing: this click is the end of it. */
  readonly dragged: (click: MouseEvent) => boolean;
}

const DRAG_FROM = 4;

/** `limits` stay the same from one drawing to the next. */
export function useCamera(host: RefObject<HTMLElement | SVGSVGElement | null>, bounds: Place, limits: CameraLimits = DRAWING_LIMITS): CameraControl {
  const [view, setView] = useState<Size>({ width: 0, height: 0 });
  const [chosen, setChosen] = useState<Camera | null>(null);
  const camera = chosen ?? fitted(bounds, view, limits);
  const latest = useRef({ camera, view });
  latest.current = { camera, view };
  const pointers = useRef(new Map<number, Point>());
  const began = useRef<Point | null>(null);
  const dragging = useRef(false);

  const change = useCallback((next: (camera: Camera) => Camera): void => {
    const { camera: now, view: room } = latest.current;
    const changed = next(now);
    latest.current = { camera: changed, view: room };
    setChosen(changed);
  }, []);

  // Before it is first seen.
  useLayoutEffect(() => {
    const element = host.current;
    if (element === null) return undefined;
    const measure = (): void => setView({ width: element.clientWidth, height: element.clientHeight });
    measure();
    const resized = new ResizeObserver(measure);
    resized.observe(element);
    const wheel = (event: Event): void => {
      if (!(event instanceof WheelEvent)) return;
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
      change((now) => zoomed(now, Math.exp(-Math.max(-200, Math.min(200, event.deltaY * lines)) / 400), pointOf(event, element), limits));
    };
    // A listener of Preact's would be passive, and the page would scroll.
    element.addEventListener('wheel', wheel, { passive: false });
    return () => {
      resized.disconnect();
      element.removeEventListener('wheel', wheel);
    };
  }, []);

  return {
    camera,
    view,
    fit: () => setChosen(null),
    zoom: (factor, at) => change((now) => zoomed(now, factor, at ?? { x: latest.current.view.width / 2, y: latest.current.view.height / 2 }, limits)),
    move: (by) => change((now) => moved(now, by)),
    show: (place) => {
      const { camera: now, view: room } = latest.current;
      const next = showing(now, place, room, limits);
      if (next.x !== now.x || next.y !== now.y) change(() => next);
    },
    onPointerDown(event) {
      if (event.button !== 0 || host.current === null) return;
      const at = pointOf(event, host.current);
      pointers.current.delete(event.pointerId);
      if (pointers.current.size === 0) {
        began.current = at;
        dragging.current = false;
      }
      pointers.current.set(event.pointerId, at);
    },
    onPointerMove(event) {
      // Lifted outside, before it was dragged far enough to be followed there.
      if (event.buttons === 0) pointers.current.delete(event.pointerId);
      const before = pointers.current.get(event.pointerId);
      const element = host.current;
      if (before === undefined || element === null) return;
      const at = pointOf(event, element);
      const start = began.current ?? at;
      const others = [...pointers.current].filter(([id]) => id !== event.pointerId).map(([, point]) => point);
      if (!dragging.current) {
        if (others.length === 0 && distance(at, start) < DRAG_FROM) return;
        dragging.current = true;
        element.setPointerCapture(event.pointerId);
      }
      pointers.current.set(event.pointerId, at);
      const [other] = others;
      if (other === undefined) {
        change((now) => moved(now, { x: at.x - before.x, y: at.y - before.y }));
      } else {
        const middle = { x: (at.x + other.x) / 2, y: (at.y + other.y) / 2 };
        const shift = { x: (at.x - before.x) / 2, y: (at.y - before.y) / 2 };
        change((now) => zoomed(moved(now, shift), distance(at, other) / Math.max(1, distance(before, other)), middle, limits));
      }
    },
    onPointerEnd(event) {
      pointers.current.delete(event.pointerId);
    },
    // A click without a pointer, as by what reads the page, has no count.
    dragged: (click) => click.detail > 0 && dragging.current,
  };
}

function pointOf(event: MouseEvent, element: Element): Point {
  const box = element.getBoundingClientRect();
  return { x: event.clientX - box.left, y: event.clientY - box.top };
}

function distance(a: Point, b: Point): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}
