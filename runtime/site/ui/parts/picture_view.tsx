// A picture that is zoomed and moved by pointer and by keys, with what stands at the pixel under the pointer, or else at
// the one that keys or a click have chosen.

import { useMemo, useRef, useState } from 'preact/hooks';
import type { RefObject } from 'preact';
import { PICTURE_LIMITS } from '../model/camera.ts';
import type { Camera } from '../model/camera.ts';
import type { PointerKeys, PointerKind } from '../model/cv_windows.ts';
import type { Point, Size } from '../model/graph_layout.ts';
import { imageTexts } from '../texts_image.ts';
import { IconButton } from './button.tsx';
import { useCamera } from './use_camera.ts';

export interface PictureViewProps {
  readonly canvas: RefObject<HTMLCanvasElement | null>;
  /** The size of the canvas; null while nothing is drawn on it. */
  readonly size: Size | null;
  readonly label: string;
  /** The value at a pixel, in words. Empty outside. */
  readonly wordsAt: (x: number, y: number) => string;
  readonly announce: (text: string) => void;
  /** Somebody else who wants a key first; true: it is taken. */
  readonly takesKey?: (key: string) => boolean;
  /** The same of the pointer over a pixel. */
  readonly takesPointer?: (kind: PointerKind, x: number, y: number, event: PointerKeys) => boolean;
}

const ZOOM = 1.5;
/** Pixels of the page for one press. */
const MOVE = 40;
/** A pixel of the picture that is smaller is marked by a square of that size. */
const LEAST_MARK = 7;

const STEPS: ReadonlyMap<string, readonly [number, number]> = new Map([
  ['ArrowRight', [1, 0]],
  ['ArrowLeft', [-1, 0]],
  ['ArrowUp', [0, -1]],
  ['ArrowDown', [0, 1]],
]);

export function PictureView({ canvas, size, label, wordsAt, announce, takesKey, takesPointer }: PictureViewProps) {
  const host = useRef<HTMLDivElement>(null);
  const { width, height } = size ?? { width: 1, height: 1 };
  const bounds = useMemo(() => ({ x: width / 2, y: height / 2, width, height }), [width, height]);
  const control = useCamera(host, bounds, PICTURE_LIMITS);
  const { camera, view } = control;
  const [near, setNear] = useState<Point | null>(null);
  const [chosen, setChosen] = useState<Point | null>(null);

  const words = (at: Point | null): string => {
    if (at === null || size === null) return '';
    const found = wordsAt(at.x, at.y);
    return found === '' ? '' : imageTexts.point(at.x, at.y, found);
  };
  const pixelAt = (event: MouseEvent): Point => {
    const box = host.current?.getBoundingClientRect();
    return {
      x: Math.floor((event.clientX - (box?.left ?? 0) - camera.x) / camera.scale),
      y: Math.floor((event.clientY - (box?.top ?? 0) - camera.y) / camera.scale),
    };
  };
  const marked = words(chosen) === '' ? null : chosen;
  /** Zooming keeps the chosen pixel where it is. */
  const zoom = (factor: number): void => {
    const at = marked === null ? null : middleOf(marked, camera);
    const seen = at !== null && at.x >= 0 && at.y >= 0 && at.x <= view.width && at.y <= view.height;
    control.zoom(factor, seen ? at : undefined);
  };
  const step = ([right, down]: readonly [number, number]): void => {
    const from = marked ?? { x: Math.floor(width / 2) - right, y: Math.floor(height / 2) - down };
    const next = {
      x: Math.max(0, Math.min(width - 1, from.x + right)),
      y: Math.max(0, Math.min(height - 1, from.y + down)),
    };
    setChosen(next);
    setNear(null);
    control.show({ x: next.x + 0.5, y: next.y + 0.5, width: 1, height: 1 });
    announce(words(next));
  };
  const onKeyDown = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (takesKey?.(event.key) === true) {
      event.preventDefault();
      return;
    }
    const direction = STEPS.get(event.key);
    if (direction !== undefined) {
      if (event.shiftKey) control.move({ x: -MOVE * direction[0], y: -MOVE * direction[1] });
      else step(direction);
    } else if (event.key === '+' || event.key === '=') zoom(ZOOM);
    else if (event.key === '-') zoom(1 / ZOOM);
    else if (event.key === '0') control.fit();
    else if (event.key === '1') zoom(1 / camera.scale);
    else if (event.key === 'Escape' && marked !== null) setChosen(null);
    else return;
    event.preventDefault();
  };
  const taken = (kind: PointerKind, event: MouseEvent): boolean => {
    const { x, y } = pixelAt(event);
    return takesPointer?.(kind, x, y, event) === true;
  };
  const told = words(near) || words(marked);

  return (
    <div class="picture" hidden={size === null}>
      <div
        class="picture-view"
        role="application"
        aria-label={imageTexts.view}
        tabIndex={0}
        ref={host}
        onPointerDown={(event) => {
          if (!taken('down', event)) control.onPointerDown(event);
        }}
        onPointerMove={(event) => {
          if (!taken('move', event)) control.onPointerMove(event);
          setNear(pixelAt(event));
        }}
        onPointerUp={(event) => {
          if (!taken('up', event)) control.onPointerEnd(event);
        }}
        onDblClick={(event) => void taken('double', event)}
        onPointerCancel={control.onPointerEnd}
        onPointerLeave={() => setNear(null)}
        onClick={(event) => {
          if (!control.dragged(event)) setChosen(pixelAt(event));
        }}
        onKeyDown={onKeyDown}
      >
        <canvas
          class={`picture-canvas ${camera.scale >= 1 ? 'picture-pixels' : ''}`}
          role="img"
          aria-label={label}
          ref={canvas}
          style={{ transform: `translate(${camera.x}px, ${camera.y}px) scale(${camera.scale})` }}
        />
        {marked === null ? null : <span class="picture-mark" aria-hidden="true" style={markStyle(marked, camera)} />}
      </div>
      {told === '' ? null : <p class="picture-words">{told}</p>}
      <div class="picture-tools">
        <span class="picture-scale">{imageTexts.scale(camera.scale)}</span>
        <IconButton icon="minus" label={imageTexts.zoomOut} onClick={() => zoom(1 / ZOOM)} />
        <IconButton icon="plus" label={imageTexts.zoomIn} onClick={() => zoom(ZOOM)} />
        <IconButton icon="fit" label={imageTexts.fit} onClick={control.fit} />
        <button
          type="button"
          class="icon-button picture-one"
          aria-label={imageTexts.oneToOne}
          title={imageTexts.oneToOne}
          onClick={() => zoom(1 / camera.scale)}
        >
          {imageTexts.oneToOneShort}
        </button>
      </div>
    </div>
  );
}

function middleOf({ x, y }: Point, camera: Camera): Point {
  return { x: camera.x + camera.scale * (x + 0.5), y: camera.y + camera.scale * (y + 0.5) };
}

function markStyle(pixel: Point, camera: Camera) {
  const side = Math.max(LEAST_MARK, camera.scale);
  const { x, y } = middleOf(pixel, camera);
  return { left: `${x - side / 2}px`, top: `${y - side / 2}px`, width: `${side}px`, height: `${side}px` };
}
