// The picture of a figure in the middle of its panel. The pointer and keys go to the program.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { RefObject } from 'preact';
import { modifiersOf, pixelIn, placeIn, pressCounter } from '../model/figure_controls.ts';
import type { FigureControls } from '../model/figure_controls.ts';
import type { Size } from '../model/graph_layout.ts';
import { figureTexts } from '../texts_figure.ts';
import type { WindowEvent } from './window_link.ts';

export interface FigureViewProps {
  readonly canvas: RefObject<HTMLCanvasElement | null>;
  /** The size of the canvas; null while nothing is drawn on it. */
  readonly size: Size | null;
  readonly controls: FigureControls;
  readonly send: (event: WindowEvent) => boolean;
  /** Called for each press of a button or key. */
  readonly acted: () => void;
  /** Called with the size of the view when it changes. */
  readonly onSize: (size: Size) => void;
}

export function FigureView({ canvas, size, controls, send, acted, onSize }: FigureViewProps) {
  const view = useRef<HTMLDivElement>(null);
  const box = useBox(view, onSize);
  const isSecond = useMemo(pressCounter, []);
  const move = useRef({ frame: 0, event: null as PointerEvent | null });
  useEffect(() => () => cancelAnimationFrame(move.current.frame), []);
  const place = box === null || size === null ? null : placeIn(box, size);

  const pixel = (event: MouseEvent) => {
    const { left = 0, top = 0 } = view.current?.getBoundingClientRect() ?? {};
    return place === null ? { x: 0, y: 0 } : pixelIn(place, { x: event.clientX - left, y: event.clientY - top });
  };
  const mouse = (kind: string, event: MouseEvent, more: WindowEvent = {}): void =>
    void send({ mouse: kind, ...pixel(event), modifiers: modifiersOf(event), ...more });
  /** Moves are sent once per frame, and before the next other event. */
  const flush = (): void => {
    const { frame, event } = move.current;
    cancelAnimationFrame(frame);
    move.current = { frame: 0, event: null };
    if (event !== null) mouse('move', event);
  };
  const onMove = (event: PointerEvent): void => {
    move.current.event = event;
    if (move.current.frame === 0) move.current.frame = requestAnimationFrame(flush);
  };
  const onPress = (event: PointerEvent): void => {
    flush();
    acted();
    view.current?.setPointerCapture(event.pointerId);
    mouse('press', event, { button: event.button, double: isSecond(event.button, pixel(event), event.timeStamp) });
  };
  const onKey = (kind: string, event: KeyboardEvent): void => {
    if (event.key === 'Tab') return;
    acted();
    // The browser keeps its own shortcuts.
    if (send({ key: kind, name: event.key, modifiers: modifiersOf(event) }) && !event.ctrlKey && !event.metaKey && !/^F\d/.test(event.key))
      event.preventDefault();
  };
  const band = controls.rubberband;

  return (
    <div
      class="figure-view"
      role="application"
      aria-label={figureTexts.view(controls.title)}
      tabIndex={0}
      hidden={size === null}
      ref={view}
      style={{ cursor: controls.cursor }}
      onPointerDown={onPress}
      onPointerMove={onMove}
      onPointerUp={(event) => {
        flush();
        mouse('release', event, { button: event.button });
      }}
      onPointerEnter={(event) => mouse('enter', event)}
      onPointerLeave={(event) => {
        flush();
        mouse('leave', event);
      }}
      onWheel={(event) => {
        event.preventDefault();
        acted();
        mouse('scroll', event, { step: -Math.sign(event.deltaY) });
      }}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => onKey('press', event)}
      onKeyUp={(event) => onKey('release', event)}
    >
      <canvas class="figure-canvas" role="img" aria-label={controls.title} ref={canvas} />
      {band === null || place === null ? null : (
        <span
          class="figure-band"
          aria-hidden="true"
          style={{
            left: `${place.left + place.scale * Math.min(band[0], band[2])}px`,
            top: `${place.top + place.scale * Math.min(band[1], band[3])}px`,
            width: `${place.scale * Math.abs(band[2] - band[0])}px`,
            height: `${place.scale * Math.abs(band[3] - band[1])}px`,
          }}
        />
      )}
    </div>
  );
}

function useBox(view: RefObject<HTMLElement | null>, onSize: (size: Size) => void): Size | null {
  const [box, setBox] = useState<Size | null>(null);
  const newest = useRef(onSize);
  newest.current = onSize;
  useEffect(() => {
    const element = view.current;
    if (element === null) return undefined;
    const observer = new ResizeObserver(() => {
      const size = { width: element.clientWidth, height: element.clientHeight };
      if (size.width === 0 || size.height === 0) return;
      setBox(size);
      newest.current(size);
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, [view]);
  return box;
}
