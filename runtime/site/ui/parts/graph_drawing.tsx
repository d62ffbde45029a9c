// Draws an arranged graph as SVG: boxes, wires with rates, groups. One tab stop; arrow keys go from box to box.

import { useEffect, useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { RefObject } from 'preact';
import type { Place, Point, Sizes } from '../model/graph_layout.ts';
import type { Arrangement } from '../model/graph_places.ts';
import { boxId } from '../model/graph_picture.ts';
import type { Box, Picture, Wire } from '../model/graph_picture.ts';
import { arrowOf, nextOf, pathOf, readingOrder } from '../model/graph_shapes.ts';
import { viewTexts } from '../texts_views.ts';
import { IconButton } from './button.tsx';
import { useCamera } from './use_camera.ts';

const FONT = '13px';
const SMALL_FONT = '11px';
const LINE = 16;
const ZOOM = 1.3;
/** Room for a rate behind a name. */
const RATE_ROOM = '  1000 Hz';

export interface GraphDrawingProps {
  readonly picture: Picture;
  readonly arrangement: Arrangement;
  readonly label: string;
  /** The rate of a topic, `10.0 Hz`; empty when no messages come. */
  readonly rateOf: (topic: string) => string;
  readonly selected: string | null;
  readonly onSelect: (id: string) => void;
  readonly svg: RefObject<SVGSVGElement | null>;
}

export function sizesOf(picture: Picture): Sizes {
  const width = textWidth();
  return {
    boxes: new Map(picture.boxes.map(({ id, kind, label }) => [
      id,
      { width: Math.max(56, Math.ceil(width(label, FONT)) + (kind === 'node' ? 32 : 22)), height: kind === 'node' ? 38 : 30 },
    ])),
    wires: new Map(picture.wires.filter(({ lines }) => lines.length > 0).map(({ id, lines, more }) => [
      id,
      {
        width: Math.ceil(Math.max(...lines.map(({ label }) => width(`${label}${RATE_ROOM}`, SMALL_FONT)))) + 10,
        height: LINE * (lines.length + (more > 0 ? 1 : 0)) + 4,
      },
    ])),
  };
}

interface Item {
  readonly id: string;
  readonly place: Place;
}

export function GraphDrawing({ picture, arrangement, label, rateOf, selected, onSelect, svg }: GraphDrawingProps) {
  const { places, routes, groups, bounds, direction, version } = arrangement;
  const control = useCamera(svg, bounds);
  const { camera } = control;
  const [near, setNear] = useState<string | null>(null);
  const [current, setCurrent] = useState<string | null>(null);
  const moveFocus = useRef(false);
  const { fit } = control;
  // A graph that was laid out again is shown whole.
  useEffect(() => fit(), [version]);

  const items: readonly Item[] = readingOrder(
    [
      ...picture.boxes.flatMap(({ id }) => {
        const place = places.get(id);
        return place === undefined ? [] : [{ id, place }];
      }),
      ...picture.wires.flatMap(({ id, lines }) => {
        const at = routes.get(id)?.label;
        return at === null || at === undefined
          ? []
          : lines.map((line, index) => ({ id: `${id} ${line.name}`, place: { x: at.x, y: at.y + index * LINE, width: 40, height: LINE } }));
      }),
    ],
    direction,
  );
  const stop = items.some(({ id }) => id === current) ? current : (items[0]?.id ?? null);
  const go = (id: string | undefined): void => {
    if (id === undefined) return;
    moveFocus.current = true;
    setCurrent(id);
  };
  useLayoutEffect(() => {
    if (!moveFocus.current) return;
    moveFocus.current = false;
    svg.current?.querySelector<SVGGElement>('[tabindex="0"]')?.focus({ preventScroll: true });
  }, [current]);

  const onKeyDown = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const at = items.findIndex(({ id }) => id === stop);
    switch (event.key) {
      case 'ArrowRight':
      case 'ArrowLeft':
      case 'ArrowUp':
      case 'ArrowDown':
        go(nextOf(items, at, event.key)?.id);
        break;
      case 'Home':
        go(items[0]?.id);
        break;
      case 'End':
        go(items.at(-1)?.id);
        break;
      case '+':
      case '=':
        control.zoom(ZOOM);
        break;
      case '-':
        control.zoom(1 / ZOOM);
        break;
      case '0':
        control.fit();
        break;
      default:
        return;
    }
    event.preventDefault();
  };
  const item = (id: string, subject: string, place: Place) => ({
    role: 'button' as const,
    // As SVG spells it: in an SVG element it is an attribute as it stands here.
    tabindex: id === stop ? 0 : -1,
    'aria-pressed': subject === selected,
    onClick: (event: MouseEvent) => {
      if (control.dragged(event)) return;
      setCurrent(id);
      onSelect(subject);
    },
    onKeyDown: (event: KeyboardEvent) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      onSelect(subject);
    },
    onFocus: () => {
      setCurrent(id);
      // A pointer's user sees it already.
      if (svg.current?.querySelector(':focus-visible') != null) control.show(place);
    },
    onPointerEnter: () => setNear(subject),
    onPointerLeave: () => setNear(null),
  });

  return (
    <div class="graph">
      <svg
        ref={svg}
        class="graph-drawing"
        role="group"
        aria-label={label}
        onPointerDown={control.onPointerDown}
        onPointerMove={control.onPointerMove}
        onPointerUp={control.onPointerEnd}
        onPointerCancel={control.onPointerEnd}
        onKeyDown={onKeyDown}
      >
        <g class="graph-all" transform={`translate(${round(camera.x)} ${round(camera.y)}) scale(${round(camera.scale)})`}>
          {picture.groups.map(({ id, label: name }) => {
            const place = groups.get(id);
            return place === undefined ? null : (
              <g key={`group ${id}`} aria-hidden="true">
                <rect class="graph-group" {...corner(place)} rx="10" />
                <text class="graph-group-name" x={place.x - place.width / 2 + 10} y={place.y - place.height / 2 + 17}>
                  {name}
                </text>
              </g>
            );
          })}
          {picture.wires.map((wire) => {
            const route = routes.get(wire.id);
            return route === undefined ? null : (
              <WireLine key={wire.id} wire={wire} points={route.points} rateOf={rateOf} lit={isLit(wire, selected, near)} />
            );
          })}
          {picture.boxes.map((box) => {
            const place = places.get(box.id);
            return place === undefined ? null : (
              <BoxShape key={box.id} box={box} place={place} words={wordsOf(box, rateOf)} props={item(box.id, box.id, place)} />
            );
          })}
          {picture.wires.map((wire) => {
            const at = routes.get(wire.id)?.label;
            return at === null || at === undefined ? null : (
              <g key={`words ${wire.id}`}>
                {wire.lines.map((line, index) => {
                  const y = at.y + (index - (wire.lines.length + (wire.more > 0 ? 1 : 0) - 1) / 2) * LINE;
                  const rate = line.kind === 'topic' ? rateOf(line.name) : '';
                  const words = wordsOf(line, rateOf);
                  return (
                    <g
                      key={line.name}
                      class="graph-words"
                      aria-label={withLabel(words, line.label)}
                      {...item(`${wire.id} ${line.name}`, boxId(line.kind, line.name), { x: at.x, y, width: 80, height: LINE })}
                    >
                      <title>{words}</title>
                      <text class="graph-wire-text" x={at.x} y={y + 4}>
                        {line.label}
                        {rate === '' ? null : <tspan class="graph-rate">{`  ${rate}`}</tspan>}
                      </text>
                    </g>
                  );
                })}
                {wire.more > 0
                  ? (
                    <text class="graph-wire-text" x={at.x} y={at.y + (wire.lines.length / 2) * LINE + 4}>
                      {viewTexts.graph.more(wire.more)}
                    </text>
                  )
                  : null}
              </g>
            );
          })}
        </g>
      </svg>
      <div class="graph-tools">
        <IconButton icon="plus" label={viewTexts.graph.zoomIn} onClick={() => control.zoom(ZOOM)} />
        <IconButton icon="minus" label={viewTexts.graph.zoomOut} onClick={() => control.zoom(1 / ZOOM)} />
        <IconButton icon="fit" label={viewTexts.graph.fit} onClick={control.fit} />
      </div>
    </div>
  );
}

function wordsOf({ kind, name }: { readonly kind: Box['kind']; readonly name: string; }, rateOf: (topic: string) => string): string {
  const rate = kind === 'topic' ? rateOf(name) : '';
  return viewTexts.graph.item[kind](name) + (rate === '' ? '' : `, ${rate}`);
}

/** The words for who does not see the drawing, with its text: people who speak to their browser say what they read. */
function withLabel(words: string, label: string): string {
  return words.includes(label) ? words : `${words} ${label}`;
}

interface BoxShapeProps {
  readonly box: Box;
  readonly place: Place;
  readonly words: string;
  readonly props: object;
}

function BoxShape({ box, place, words, props }: BoxShapeProps) {
  return (
    <g class={`graph-box graph-${box.kind}`} aria-label={withLabel(words, box.label)} {...props}>
      <title>{words}</title>
      <rect {...corner(place)} rx={box.kind === 'node' ? place.height / 2 : 3} />
      <text x={place.x} y={place.y + 4.5}>
        {box.label}
      </text>
    </g>
  );
}

interface WireLineProps {
  readonly wire: Wire;
  readonly points: readonly Point[];
  readonly rateOf: (topic: string) => string;
  readonly lit: boolean;
}

function WireLine({ wire, points, rateOf, lit }: WireLineProps) {
  // The same for as long as shown there, however often the rates change.
  const [line, arrow] = useMemo(() => [pathOf(points), arrowOf(points)] as const, [points]);
  const rate = wire.rateOf === null ? '' : rateOf(wire.rateOf);
  const flows = wire.kind === 'topic' && wire.names.some((name) => rateOf(name) !== '');
  const middle = points[Math.floor(points.length / 2)] ?? { x: 0, y: 0 };
  return (
    <g class={`graph-wire graph-wire-${wire.kind} ${flows ? 'graph-flows' : ''} ${lit ? 'graph-lit' : ''}`} aria-hidden="true">
      <path class="graph-line" d={line} />
      <path class="graph-arrow" d={arrow} />
      {rate === '' ? null : (
        <text class="graph-wire-text graph-rate" x={middle.x} y={middle.y - 5}>
          {rate}
        </text>
      )}
    </g>
  );
}

function isLit({ from, to, names, kind }: Wire, selected: string | null, near: string | null): boolean {
  return [selected, near].some(
    (id) => id !== null && (id === from || id === to || names.some((name) => boxId(kind, name) === id)),
  );
}

function corner({ x, y, width, height }: Place) {
  return { x: round(x - width / 2), y: round(y - height / 2), width, height };
}

function round(value: number): number {
  return Math.round(value * 100) / 100;
}

/** Reckons the width of a text in the page's font. */
function textWidth(): (text: string, size: string) => number {
  const context = document.createElement('canvas').getContext('2d');
  const family = getComputedStyle(document.body).fontFamily;
  return (text, size) => {
    if (context === null) return text.length * 8;
    context.font = `${size} ${family}`;
    return context.measureText(text).width;
  };
}
