// The list of what a scene shows: grid and frames, then every topic that it can show, each with why it does not, how it
// looks and what it says, then the pictures over it.

import { useState } from 'preact/hooks';
import type { DisplayLook, Setting } from '../model/display_look.ts';
import { panelTexts } from '../texts_panels.ts';
import { sceneTexts } from '../texts_scene.ts';
import { viewTexts } from '../texts_views.ts';
import { IconButton } from './button.tsx';
import { Name } from './name.tsx';
import { PictureChoice } from './picture_choice.tsx';
import type { PictureChoiceProps } from './picture_choice.tsx';
import { SceneSettings } from './scene_settings.tsx';
import type { LookChange } from './scene_settings.tsx';

export interface SceneRow {
  readonly name: string;
  readonly type: string;
  readonly on: boolean;
  /** Why it is not shown, or not all of it; empty: it is. */
  readonly problem: string;
  readonly settings: readonly Setting[];
  readonly look: DisplayLook;
  readonly fields: readonly string[];
}

export interface SceneListProps {
  readonly flags: readonly { readonly words: string; readonly on: boolean; readonly set: (on: boolean) => void; }[];
  /** How many arrows of odometry stay; null: no odometry is shown. */
  readonly keep: { readonly count: number; readonly set: (count: number) => void; } | null;
  readonly follow: { readonly frame: string; readonly frames: readonly string[]; readonly set: (frame: string) => void; };
  readonly rows: readonly SceneRow[];
  readonly onRow: (name: string, on: boolean) => void;
  readonly onLook: (name: string, change: LookChange) => void;
  readonly onDetails: (name: string) => void;
  readonly pictures: PictureChoiceProps;
  readonly note: string;
}

const KEEPS: readonly number[] = [1, 10, 100, 1000];

export function SceneList({ flags, keep, follow, rows, onRow, onLook, onDetails, pictures, note }: SceneListProps) {
  const [opened, open] = useState('');
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
            {[...new Set([...KEEPS, keep.count])].toSorted((a, b) => a - b).map((count) => (
              <option key={count} value={count}>{count}</option>
            ))}
          </select>
          {viewTexts.scene.keep}
        </label>
      )}
      <label class="scene-setting">
        <span>{sceneTexts.follow}</span>
        <select class="select" value={follow.frame} onChange={(event) => follow.set(event.currentTarget.value)}>
          <option value="">{sceneTexts.followNone}</option>
          {[...new Set([...follow.frames, ...(follow.frame === '' ? [] : [follow.frame])])].map((name) => (
            <option key={name} value={name}>{name}</option>
          ))}
        </select>
      </label>
      {note === '' ? null : <p class="scene-problem">{note}</p>}
      <ul class="scene-topics" role="list">
        {rows.map(({ name, type, on, problem, settings, look, fields }) => (
          <li key={name}>
            <div class="scene-row">
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
              {on ? <IconButton icon="info" label={sceneTexts.details(name)} onClick={() => onDetails(name)} /> : null}
              {on && settings.length > 0
                ? (
                  <IconButton
                    icon="sliders"
                    label={sceneTexts.settings(name)}
                    pressed={opened === name}
                    onClick={() => open(opened === name ? '' : name)}
                  />
                )
                : null}
            </div>
            {problem === '' ? null : <p class="scene-problem">{problem}</p>}
            {on && opened === name && settings.length > 0
              ? (
                <SceneSettings topic={name} settings={settings} look={look} fields={fields} change={(change) => onLook(name, change)} />
              )
              : null}
          </li>
        ))}
      </ul>
      {rows.length === 0 ? <p class="hint">{panelTexts.scene.noTopics}</p> : null}
      <PictureChoice {...pictures} />
    </div>
  );
}
