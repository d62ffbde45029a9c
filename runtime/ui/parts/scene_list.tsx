// The list of what a scene shows: grid and frames, then every topic that it can show, each with why it does not.

import { texts } from '../texts.ts';
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
  readonly rows: readonly SceneRow[];
  readonly onRow: (name: string, on: boolean) => void;
  readonly note: string;
}

export function SceneList({ flags, rows, onRow, note }: SceneListProps) {
  return (
    <div class="scene-list" role="group" aria-label={texts.scene.list}>
      {flags.map(({ words, on, set }) => (
        <label class="check" key={words}>
          <input type="checkbox" checked={on} onChange={(event) => set(event.currentTarget.checked)} />
          {words}
        </label>
      ))}
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
      {rows.length === 0 ? <p class="hint">{texts.scene.noTopics}</p> : null}
    </div>
  );
}
