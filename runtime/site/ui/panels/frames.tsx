// The tree of frames of /tf and /tf_static: where each frame is in its parent, how often and how lately that was told,
// what is wrong with the tree, and where one frame is in another. State: {target, source, text}.

import { useEffect, useMemo, useReducer, useRef, useState } from 'preact/hooks';
import { frameRate, frameRows } from '../model/frame_rows.ts';
import type { FrameRow } from '../model/frame_rows.ts';
import { textMember } from '../model/json.ts';
import { formatAge, formatRate } from '../model/quantities.ts';
import { toRollPitchYaw } from '../model/transform.ts';
import type { Transform } from '../model/transform.ts';
import { TransformTree } from '../model/transform_tree.ts';
import type { Lookup } from '../model/transform_tree.ts';
import { followTransforms } from '../parts/follow_transforms.ts';
import { Icon } from '../parts/icon.tsx';
import { useCodec } from '../parts/message_feed.ts';
import { Name } from '../parts/name.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { SearchField } from '../parts/search_field.tsx';
import { useOpened } from '../parts/use_opened.ts';
import { texts } from '../texts.ts';
import { viewTexts } from '../texts_views.ts';
import type { PanelProps } from './panel_props.ts';

const MOST_ROWS = 300;
const MOST_NAMES = 1000;
const MOST_LISTED = 8;
const DEEPEST = 10;
const REDRAW_MS = 250;
const LONGEST_TEXT = 256;

interface FramesOptions {
  readonly target: string;
  readonly source: string;
  readonly text: string;
}

export function FramesPanel({ session, state, setState, instance }: PanelProps) {
  const field = (name: string): string => textMember(state, name).slice(0, LONGEST_TEXT);
  const options: FramesOptions = { target: field('target'), source: field('source'), text: field('text') };
  const codec = useCodec(session);
  const tree = useMemo(() => new TransformTree(), [session]);
  const [, redraw] = useReducer<number, void>((n) => n + 1, 0);
  const [problem, setProblem] = useState('');
  const [opened, toggle] = useOpened();
  const came = useRef(0);
  const shape = useRef<{ readonly came: number; readonly rows: ReturnType<typeof frameRows>; } | null>(null);

  useEffect(() => {
    if (codec === null || typeof codec === 'string') return undefined;
    return followTransforms(session, codec, tree, {
      onTransforms() {
        came.current += 1;
        setProblem('');
      },
      onProblem: setProblem,
    });
  }, [session, codec, tree]);
  // At a pace that can be read.
  useEffect(() => {
    const timer = setInterval(() => redraw(), REDRAW_MS);
    return () => clearInterval(timer);
  }, []);

  if (shape.current?.came !== came.current) shape.current = { came: came.current, rows: frameRows(tree) };
  const { rows, roots, loops } = shape.current.rows;
  const now = session.time.view().now / 1000;
  const wanted = options.text.trim().toLowerCase();
  const found = rows.filter(({ frame }) => frame.name.toLowerCase().includes(wanted));
  const names = rows.map(({ frame }) => frame.name).toSorted().slice(0, MOST_NAMES);
  const change = (next: Partial<FramesOptions>): void => setState({ ...options, ...next });

  return (
    <PanelFrame
      id="frames"
      title={texts.panels.frames}
      icon="frames"
      note={rows.length === 0 ? '' : viewTexts.frames.count(rows.length)}
      tools={<SearchField value={options.text} label={viewTexts.frames.filter} onText={(text) => change({ text })} />}
    >
      {typeof codec === 'string' ? <p class="hint">{codec}</p> : null}
      {problem === '' ? null : <p class="hint">{problem}</p>}
      {rows.length === 0 && problem === '' && typeof codec !== 'string' ? <p class="hint">{viewTexts.frames.none}</p> : null}
      {roots.length > 1 ? <Fault words={viewTexts.frames.apart(roots.length, list(roots, ', '))} /> : null}
      {loops.map((ring) => (
        <Fault key={ring[0]} words={viewTexts.frames.loop(list([...ring, ring[0] ?? ''], viewTexts.frames.within))} />
      ))}
      {tree.refused > 0 ? <Fault words={viewTexts.frames.refused(tree.refused)} /> : null}
      {rows.length > 0 && found.length === 0 ? <p class="hint">{viewTexts.frames.noneMatch}</p> : null}
      <ul class="topics" role="list">
        {found.slice(0, MOST_ROWS).map((row) => (
          <Row
            key={row.frame.name}
            row={row}
            now={now}
            open={opened.has(row.frame.name)}
            onToggle={() => toggle(row.frame.name)}
            id={`frame-${instance}-${encodeURIComponent(row.frame.name.toWellFormed())}`}
          />
        ))}
      </ul>
      {found.length > MOST_ROWS ? <p class="hint">{viewTexts.frames.more(found.length - MOST_ROWS)}</p> : null}
      {rows.length < 2 ? null : (
        <Between tree={tree} names={names} target={options.target} source={options.source} onChange={change} />
      )}
    </PanelFrame>
  );
}

function Fault({ words }: { readonly words: string; }) {
  return (
    <p class="frames-fault">
      <Icon name="warning" />
      <span>{words}</span>
    </p>
  );
}

/** Few of them, as one text. */
function list(names: readonly string[], joint: string): string {
  return [...names.slice(0, MOST_LISTED), ...(names.length > MOST_LISTED ? ['\u2026'] : [])].join(joint);
}

interface RowProps {
  readonly row: FrameRow;
  readonly now: number;
  readonly open: boolean;
  readonly onToggle: () => void;
  readonly id: string;
}

function Row({ row: { frame, depth, looped }, now, open, onToggle, id }: RowProps) {
  const { name, parent, isStatic, newest, transform } = frame;
  const about = parent === null ? viewTexts.frames.root : viewTexts.frames.inParent(parent);
  return (
    <li class={`topic ${open ? 'topic-open' : ''}`} style={{ paddingLeft: `${Math.min(depth, DEEPEST) * 0.875}rem` }}>
      <button type="button" class="topic-head" aria-expanded={open} aria-controls={open ? id : undefined} onClick={onToggle}>
        <Icon name="chevron" class="topic-turn" />
        <span class="topic-names">
          <span class="topic-name">
            <Name text={name} />
          </span>
          <span class="topic-type">
            <Name text={looped ? viewTexts.frames.looped(about) : about} />
          </span>
        </span>
        {parent === null ? null : (
          <span class="topic-flow">
            <span class="topic-rate">{isStatic ? viewTexts.frames.isStatic : formatRate(frameRate(frame, now))}</span>
            {isStatic ? null : <span class="topic-ends">{viewTexts.frames.age(formatAge(now - newest))}</span>}
          </span>
        )}
      </button>
      {open
        ? (
          <div class="topic-inside" id={id}>
            {parent === null ? <p class="hint">{viewTexts.frames.rootLong}</p> : <TransformFacts transform={transform} />}
          </div>
        )
        : null}
    </li>
  );
}

function TransformFacts({ transform: { translation, rotation } }: { readonly transform: Transform; }) {
  const angles = toRollPitchYaw(rotation);
  const degrees = angles.map((angle) => (angle * 180) / Math.PI);
  const facts: readonly (readonly [string, readonly number[], readonly string[], string])[] = [
    [viewTexts.frames.translation, translation, ['x', 'y', 'z'], viewTexts.frames.metres],
    [viewTexts.frames.quaternion, rotation, ['x', 'y', 'z', 'w'], ''],
    [viewTexts.frames.angles, angles, viewTexts.frames.axes, viewTexts.frames.radians],
    [viewTexts.frames.angles, degrees, viewTexts.frames.axes, viewTexts.frames.degrees],
  ];
  return (
    <dl class="facts frames-facts">
      {facts.map(([title, values, axes, unit]) => (
        <div key={`${title}${unit}`}>
          <dt>{unit === '' ? title : `${title} (${unit})`}</dt>
          <dd>
            {values.map((value, index) => (
              <span class="frames-number" key={axes[index]}>
                <span class="frames-axis">{axes[index]}</span> {numberWords(value)}
              </span>
            ))}
          </dd>
        </div>
      ))}
    </dl>
  );
}

function numberWords(value: number): string {
  if (Math.abs(value) >= 1e6) return value.toExponential(3);
  const words = value.toFixed(4);
  return words === '-0.0000' ? '0.0000' : words;
}

interface BetweenProps {
  readonly tree: TransformTree;
  readonly names: readonly string[];
  readonly target: string;
  readonly source: string;
  readonly onChange: (next: Partial<FramesOptions>) => void;
}

function Between({ tree, names, target, source, onChange }: BetweenProps) {
  const both = target !== '' && source !== '';
  const found = both ? tree.lookup(target, source) : null;
  return (
    <section class="work frames-between" aria-label={viewTexts.frames.between}>
      <h3>{viewTexts.frames.between}</h3>
      <div class="work-row">
        <FrameChoice label={viewTexts.frames.source} value={source} names={names} onChange={(name) => onChange({ source: name })} />
        <FrameChoice label={viewTexts.frames.target} value={target} names={names} onChange={(name) => onChange({ target: name })} />
      </div>
      {found === null ? <p class="hint">{viewTexts.frames.choose}</p> : null}
      {found === null || found.kind === 'found' ? null : <Fault words={whyNot(found)} />}
      {found?.kind === 'found' ? <TransformFacts transform={found.transform} /> : null}
    </section>
  );
}

function whyNot(found: Exclude<Lookup, { readonly kind: 'found'; }>): string {
  switch (found.kind) {
    case 'unknown':
      return viewTexts.frames.unknown(found.frame);
    case 'loop':
      return viewTexts.frames.onLoop(found.frame);
    case 'apart':
      return viewTexts.frames.noWay(...found.roots);
    default:
      return found satisfies never;
  }
}

interface FrameChoiceProps {
  readonly label: string;
  readonly value: string;
  readonly names: readonly string[];
  readonly onChange: (name: string) => void;
}

function FrameChoice({ label, value, names, onChange }: FrameChoiceProps) {
  const key = names.join('\n');
  // A list that stays the same is not built again at each redraw.
  const options = useMemo(
    () => names.map((name) => <option key={name} value={name}>{name}</option>),
    [key],
  );
  return (
    <label class="frames-choice">
      <span>{label}</span>
      <select class="select" value={value} onChange={(event) => onChange(event.currentTarget.value)}>
        <option value="">{viewTexts.frames.noFrame}</option>
        {value === '' || names.includes(value) ? null : <option value={value}>{value}</option>}
        {options}
      </select>
    </label>
  );
}
