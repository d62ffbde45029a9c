// A message as a tree that reads like the YAML of `ros2 topic echo`. Long arrays are folded and cut.

import { fieldOf, formatScalar, isList, isMessage, kTruncateLength } from '../../decode/yaml.ts';
import { isFloat } from '../../decode/shape.ts';
import type { Field, Shape } from '../../decode/shape.ts';
import { formatCount } from '../model/quantities.ts';
import { texts } from '../texts.ts';
import { Icon } from './icon.tsx';

/** Texts are shown up to this length: longer ones than in a terminal, since here they wrap. */
const kTextLength = 2000;
/** Lists up to this length, and messages up to this depth, are open at first. */
const kOpenLength = 12;
const kOpenDepth = 3;

export interface MessageTreeProps {
  readonly label: string;
  readonly value: unknown;
  readonly shape: Shape | null;
}

export function MessageTree({ label, value, shape }: MessageTreeProps) {
  return (
    <div class="tree" role="group" aria-label={label} tabIndex={0}>
      {isMessage(value) ? (
        <Fields message={value} shape={shape} depth={0} />
      ) : (
        <Scalar value={value} float={false} />
      )}
    </div>
  );
}

function Fields({
  message,
  shape,
  depth,
}: {
  readonly message: Readonly<Record<string, unknown>>;
  readonly shape: Shape | null;
  readonly depth: number;
}) {
  const entries = Object.entries(message);
  if (entries.length === 0) return <span class="tree-value">{'{}'}</span>;
  return (
    <>
      {entries.map(([name, value]) => (
        <Entry key={name} name={name} value={value} field={fieldOf(shape, name)} depth={depth} />
      ))}
    </>
  );
}

interface EntryProps {
  readonly name: string;
  readonly value: unknown;
  readonly field: Field | undefined;
  readonly depth: number;
}

function Entry({ name, value, field, depth }: EntryProps) {
  const key = <span class="tree-key">{`${name}:`}</span>;
  if (isList(value) && value.length > 0) {
    return (
      <details class="tree-branch" open={value.length <= kOpenLength && depth < kOpenDepth}>
        <summary title={field?.type}>
          <Icon name="chevron" class="tree-turn" />
          {key}{' '}
          <span class="tree-note">
            {texts.topics.items(formatCount(value.length), field?.type ?? '')}
          </span>
        </summary>
        <List list={value} field={field} depth={depth + 1} />
      </details>
    );
  }
  if (isMessage(value) && Object.keys(value).length > 0) {
    return (
      <details class="tree-branch" open={depth < kOpenDepth}>
        <summary title={field?.type}>
          <Icon name="chevron" class="tree-turn" />
          {key}
        </summary>
        <div class="tree-inside">
          <Fields message={value} shape={field?.shape ?? null} depth={depth + 1} />
        </div>
      </details>
    );
  }
  return (
    <div class="tree-leaf" title={field?.type}>
      {key}{' '}
      <Scalar
        value={isList(value) ? '[]' : isMessage(value) ? '{}' : value}
        float={isFloat(field)}
        raw={typeof value === 'object'}
      />
    </div>
  );
}

function List({
  list,
  field,
  depth,
}: {
  readonly list: ArrayLike<unknown>;
  readonly field: Field | undefined;
  readonly depth: number;
}) {
  const items: unknown[] = Array.from(
    { length: Math.min(list.length, kTruncateLength) },
    (_, index) => list[index],
  );
  return (
    <div class="tree-inside">
      {items.map((item, index) =>
        isMessage(item) ? (
          <Entry key={index} name={`- ${index}`} value={item} field={field} depth={depth} />
        ) : (
          <div class="tree-leaf" key={index}>
            <span class="tree-key">-</span> <Scalar value={item} float={isFloat(field)} />
          </div>
        ),
      )}
      {items.length < list.length ? (
        <div class="tree-note">
          {texts.topics.shownOf(formatCount(items.length), formatCount(list.length))}
        </div>
      ) : null}
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
  const text = raw === true ? String(value) : formatScalar(value, kTextLength, '', float);
  return <span class={`tree-value tree-${typeof value}`}>{text}</span>;
}
