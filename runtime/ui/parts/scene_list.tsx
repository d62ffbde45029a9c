// The list of what a scene shows: grid and frames, then every topic that it can show, each with why it does not.

import { panelTexts } from '../texts_panels.ts';
import { viewTexts } from '../texts_views.ts';
import { Name } from './name.tsx';

export interface SceneRow {
  readonly name: string;
  readonly type: string;
  readonly on: boolean;
  /** Why it is not shown, or not all of it; empty: it is. */
  readonly problem: string;
}

export interface SceneListProps {
  readonly flags: readonly { readonly words: string; readonly on: boolean; readonly set: (on: boolean) => void }[];
  /** How many arrows of odometry stay; null: no odometry is shown. */
  readonly keep: { readonly count: number; readonly set: (count: number) => void } | null;
  readonly rows: readonly SceneRow[];
  readonly onRow: (name: string, on: boolean) => void;
  readonly note: string;
}

const kKeeps: readonly number[] = [1, 10, 100, 1000];

export function SceneList({ flags, keep, rows, onRow, note }: SceneListProps) {
  return (
    <div class="scene-list" role="group" aria-label={panelTexts.scene.list}>
      {flags.map(({ words, on, set }) => (
        <label class="check" key={words}>
          <input type="checkbox" checked={on} onChange={(event) => set(event.currentTarget.checked)} />
          {words}
        </label>
      ))}
      {keep === null ? null : (
        <label class="check">
          <select
            class="select"
            aria-label={viewTexts.scene.keep}
            value={keep.count}
            onChange={(event) => keep.set(Number(event.currentTarget.value))}
          >
            {[...new Set([...kKeeps, keep.count])].toSorted((a, b) => a - b).map((count) => (
              <option key={count} value={count}>{count}</option>
            ))}
          </select>
          {viewTexts.scene.keep}
        </label>
      )}
      {note === '' ? null : <p class="scene-problem">{note}</p>}
      <ul class="scene-topics" role="list">
        {rows.map(({ name, type, on, problem }) => (
          <li key={name}>
            <label class="check">
              <input
                type="checkbox"
                checked={on}
                onChange={(event) => onRow(name, event.currentTarget.checked)}
              />
              <span class="scene-topic">
                <Name text={name} />
                <span class="scene-type">{type.split('/').at(-1)}</span>
              </span>
            </label>
            {problem === '' ? null : <p class="scene-problem">{problem}</p>}
          </li>
        ))}
      </ul>
      {rows.length === 0 ? <p class="hint">{panelTexts.scene.noTopics}</p> : null}
    </div>
  );
}
