// A message as a tree that reads like the YAML of `ros2 topic echo`. Long arrays are folded and cut. On request: what
// has changed since an earlier message, and fields that can be chosen, by mouse or with the arrow keys.

import { fieldOf, formatScalar, isList, isMessage, TRUNCATE_LENGTH } from '../../decode/yaml.ts';
import { isFloat } from '../../decode/shape.ts';
import type { Field, Shape } from '../../decode/shape.ts';
import { partOf, sameValue } from '../model/message_change.ts';
import { formatCount } from '../model/quantities.ts';
import { texts } from '../texts.ts';
import { Icon } from './icon.tsx';

/** Texts are shown up to this length: longer ones than in a terminal, since here they wrap. */
const TEXT_LENGTH = 2000;
/** Lists up to this length, and messages up to this depth, are open at first. */
const OPEN_LENGTH = 12;
const OPEN_DEPTH = 3;
/** Upper bound of the length of an earlier value beside the present one. */
const WAS_LENGTH = 80;

/** The message with which the tree is compared, and the words for differences. */
export interface TreeChange {
  readonly before: unknown;
  /** True: equal values are not shown. */
  readonly only: boolean;
  readonly was: (text: string) => string;
  readonly changed: string;
}

/** `path` as in `/odom.pose.pose.position.x`. */
export interface TreeChoice {
  /** The name of the message: paths begin with it. */
  readonly topic: string;
  readonly path: string | null;
  readonly choose: (path: string, value: unknown) => void;
}

export interface MessageTreeProps {
  readonly label: string;
  readonly value: unknown;
  readonly shape: Shape | null;
  readonly change?: TreeChange | undefined;
  readonly choice?: TreeChoice | undefined;
}

/** The properties that all parts of one tree share. */
interface Context {
  readonly change: TreeChange | undefined;
  readonly choice: TreeChoice | undefined;
}

export function MessageTree({ label, value, shape, change, choice }: MessageTreeProps) {
  return (
    <div class="tree" role="group" aria-label={label} tabIndex={0} onKeyDown={choice === undefined ? undefined : moveFocus}>
      {isMessage(value)
        ? (
          <Fields
            // Each view has its own opened and closed parts.
            key={change?.only === true ? 'changed' : 'all'}
            message={value}
            shape={shape}
            depth={0}
            path={choice?.topic ?? ''}
            before={change?.before}
            context={{ change, choice }}
          />
        )
        : (
          <Scalar value={value} float={false} />
        )}
    </div>
  );
}

/** Up and down go from field to field; one Tab leads in, and the next one on. */
function moveFocus(event: KeyboardEvent): void {
  const tree = event.currentTarget;
  const by = event.key === 'ArrowDown' ? 1 : event.key === 'ArrowUp' ? -1 : 0;
  if (by === 0 || !(tree instanceof HTMLElement)) return;
  const stops = [...tree.querySelectorAll<HTMLElement>('summary, .tree-pick')].filter((each) => each.checkVisibility());
  const at = stops.findIndex((each) => each === document.activeElement);
  const next = at === -1 ? (by > 0 ? stops[0] : undefined) : stops[at + by];
  if (next === undefined) return;
  event.preventDefault();
  next.focus();
}

interface Place {
  readonly depth: number;
  readonly path: string;
  /** The value at this place in the earlier message. */
  readonly before: unknown;
  readonly context: Context;
}

function Fields({
  message,
  shape,
  depth,
  path,
  before,
  context,
}: Place & { readonly message: Readonly<Record<string, unknown>>; readonly shape: Shape | null; }) {
  const entries = Object.entries(message);
  if (entries.length === 0) return <span class="tree-value">{'{}'}</span>;
  return (
    <>
      {entries.map(([name, value]) => (
        <Entry
          key={name}
          name={name}
          value={value}
          field={fieldOf(shape, name)}
          depth={depth}
          path={`${path}.${name}`}
          before={partOf(before, name)}
          context={context}
        />
      ))}
    </>
  );
}

interface EntryProps extends Place {
  readonly name: string;
  readonly value: unknown;
  readonly field: Field | undefined;
}

function Entry({ name, value, field, depth, path, before, context }: EntryProps) {
  const { change } = context;
  const changed = change !== undefined && !sameValue(value, before);
  if (change?.only === true && !changed) return null;
  const open = change?.only === true;
  const mark = changed ? <span class="tree-mark">{change.changed}</span> : null;
  const key = <span class="tree-key">{`${name}:`}</span>;
  if (isList(value) && value.length > 0) {
    return (
      <details class="tree-branch" open={open || (value.length <= OPEN_LENGTH && depth < OPEN_DEPTH)}>
        <summary title={field?.type}>
          <Icon name="chevron" class="tree-turn" />
          {key}{' '}
          <span class="tree-note">
            {texts.topics.items(formatCount(value.length), field?.type ?? '')}
          </span>
          {mark}
        </summary>
        <List list={value} field={field} depth={depth + 1} path={path} before={before} context={context} />
      </details>
    );
  }
  if (isMessage(value) && Object.keys(value).length > 0) {
    return (
      <details class="tree-branch" open={open || depth < OPEN_DEPTH}>
        <summary title={field?.type}>
          <Icon name="chevron" class="tree-turn" />
          {key}
          {mark}
        </summary>
        <div class="tree-inside">
          <Fields
            message={value}
            shape={field?.shape ?? null}
            depth={depth + 1}
            path={path}
            before={before}
            context={context}
          />
        </div>
      </details>
    );
  }
  return <Leaf name={`${name}:`} value={value} field={field} path={path} before={before} context={context} />;
}

/** One value, or an empty list or message. */
function Leaf({
  name,
  value,
  field,
  path,
  before,
  context: { change, choice },
}: Omit<EntryProps, 'depth'>) {
  const changed = change !== undefined && !sameValue(value, before);
  const raw = typeof value === 'object';
  return (
    <div class={`tree-leaf ${changed ? 'tree-changed' : ''}`} title={field?.type}>
      {choice === undefined
        ? (
          <span class="tree-key">{name}</span>
        )
        : (
          <button
            type="button"
            class="tree-key tree-pick"
            tabIndex={-1}
            aria-label={path}
            aria-pressed={choice.path === path}
            onClick={() => choice.choose(path, value)}
          >
            {name}
          </button>
        )}{' '}
      <Scalar
        value={isList(value) ? '[]' : isMessage(value) ? '{}' : value}
        float={isFloat(field)}
        raw={raw}
      />
      {!changed || before === undefined || typeof before === 'object' ? null : (
        <span class="tree-was">{` ${change.was(formatScalar(before, WAS_LENGTH, '', isFloat(field)))}`}</span>
      )}
    </div>
  );
}

function List({
  list,
  field,
  depth,
  path,
  before,
  context,
}: Place & { readonly list: ArrayLike<unknown>; readonly field: Field | undefined; }) {
  const shown: number[] = [];
  let count = 0;
  for (let index = 0; index < list.length; index += 1) {
    if (context.change?.only === true && sameValue(list[index], partOf(before, index))) continue;
    count += 1;
    if (shown.length < TRUNCATE_LENGTH) shown.push(index);
  }
  return (
    <div class="tree-inside">
      {shown.map((index) => {
        const place = { path: `${path}[${index}]`, before: partOf(before, index), context, field };
        const item = list[index];
        return isMessage(item)
          ? (
            <Entry key={index} name={`- ${index}`} value={item} depth={depth} {...place} />
          )
          : (
            <Leaf key={index} name={context.change?.only === true ? `- ${index}:` : '-'} value={item} {...place} />
          );
      })}
      {shown.length < count
        ? (
          <div class="tree-note">
            {texts.topics.shownOf(formatCount(shown.length), formatCount(count))}
          </div>
        )
        : null}
    </div>
  );
}

function Scalar({
  value,
  float,
  raw,
}: {
  readonly value: unknown;
  readonly float: boolean;
  readonly raw?: boolean;
}) {
  const text = raw === true ? String(value) : formatScalar(value, TEXT_LENGTH, '', float);
  return <span class={`tree-value tree-${typeof value}`}>{text}</span>;
}
