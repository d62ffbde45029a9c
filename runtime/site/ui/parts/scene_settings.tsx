// How one display of a scene looks: its points, colour, opacity, how long its messages stay, by what it is coloured.

import { MAP_SCHEMES, MOST_DECAY, MOST_SIZE } from '../model/display_look.ts';
import type { DisplayLook, Setting } from '../model/display_look.ts';
import { sceneTexts } from '../texts_scene.ts';

export type LookChange = { readonly [K in keyof DisplayLook]?: DisplayLook[K] | undefined; };

export interface SceneSettingsProps {
  readonly topic: string;
  readonly settings: readonly Setting[];
  readonly look: DisplayLook;
  /** The fields of the message by which it can be coloured. */
  readonly fields: readonly string[];
  readonly change: (change: LookChange) => void;
}

const USUAL_COLOR = '#4f7cff';
const CHANNELS = ['', 'flat', 'rgb', 'intensity', 'x', 'y', 'z'] as const;

export function SceneSettings({ topic, settings, look, fields, change }: SceneSettingsProps) {
  const has = (setting: Setting): boolean => settings.includes(setting);
  const channels = [...new Set([...CHANNELS, ...fields, ...(look.channel === undefined ? [] : [look.channel])])];
  return (
    <div class="scene-settings" role="group" aria-label={sceneTexts.settings(topic)}>
      {has('size')
        ? (
          <NumberRow words={sceneTexts.size} value={look.size} usual="3" least={1} most={MOST_SIZE} step={1} set={(size) => change({ size })} />
        )
        : null}
      {has('color')
        ? (
          <label class="scene-setting">
            <span>{sceneTexts.color}</span>
            <input
              type="color"
              value={look.color ?? USUAL_COLOR}
              onChange={(event) => change({ color: event.currentTarget.value })}
            />
          </label>
        )
        : null}
      {has('alpha')
        ? (
          <label class="scene-setting">
            <span>{sceneTexts.alpha}</span>
            <input
              type="range"
              min={0}
              max={1}
              step={0.05}
              value={look.alpha ?? 1}
              onInput={(event) => change({ alpha: Number(event.currentTarget.value) })}
            />
          </label>
        )
        : null}
      {has('decay')
        ? (
          <NumberRow words={sceneTexts.decay} value={look.decay} usual="0" least={0} most={MOST_DECAY} step={0.5} set={(decay) => change({ decay })} />
        )
        : null}
      {has('channel')
        ? (
          <>
            <label class="scene-setting">
              <span>{sceneTexts.channel}</span>
              <select
                class="select"
                value={look.channel ?? ''}
                onChange={(event) => change({ channel: event.currentTarget.value === '' ? undefined : event.currentTarget.value })}
              >
                {channels.map((name) => (
                  <option key={name} value={name}>{(sceneTexts.channels as Readonly<Record<string, string>>)[name] ?? name}</option>
                ))}
              </select>
            </label>
            {look.channel === 'flat' || look.channel === 'rgb' ? null : (
              <>
                <NumberRow words={sceneTexts.least} value={look.least} usual="" step={0.1} set={(least) => change({ least })} />
                <NumberRow words={sceneTexts.most} value={look.most} usual="" step={0.1} set={(most) => change({ most })} />
              </>
            )}
          </>
        )
        : null}
      {has('scheme')
        ? (
          <label class="scene-setting">
            <span>{sceneTexts.scheme}</span>
            <select
              class="select"
              value={look.scheme ?? 'map'}
              onChange={(event) => change({ scheme: MAP_SCHEMES.find((one) => one === event.currentTarget.value) })}
            >
              {MAP_SCHEMES.map((name) => <option key={name} value={name}>{sceneTexts.schemes[name]}</option>)}
            </select>
          </label>
        )
        : null}
      {has('shapes')
        ? (
          <>
            <FlagRow words={sceneTexts.visual} on={look.hideVisual !== true} set={(on) => change({ hideVisual: on ? undefined : true })} />
            <FlagRow words={sceneTexts.collision} on={look.collision === true} set={(on) => change({ collision: on ? true : undefined })} />
          </>
        )
        : null}
      {Object.keys(look).length === 0 ? null : (
        <button
          type="button"
          class="button"
          onClick={() => change(Object.fromEntries(Object.keys(look).map((name) => [name, undefined])))}
        >
          {sceneTexts.usual}
        </button>
      )}
    </div>
  );
}

interface NumberRowProps {
  readonly words: string;
  readonly value: number | undefined;
  readonly usual: string;
  readonly least?: number;
  readonly most?: number;
  readonly step: number;
  /** undefined: as usual. */
  readonly set: (value: number | undefined) => void;
}

function NumberRow({ words, value, usual, least, most, step, set }: NumberRowProps) {
  return (
    <label class="scene-setting">
      <span>{words}</span>
      <input
        class="field"
        type="number"
        min={least}
        max={most}
        step={step}
        placeholder={usual}
        value={value ?? ''}
        onChange={(event) => {
          const { valueAsNumber } = event.currentTarget;
          set(Number.isNaN(valueAsNumber) ? undefined : Math.max(least ?? -Infinity, Math.min(most ?? Infinity, valueAsNumber)));
        }}
      />
    </label>
  );
}

function FlagRow({ words, on, set }: { readonly words: string; readonly on: boolean; readonly set: (on: boolean) => void; }) {
  return (
    <label class="check">
      <input type="checkbox" checked={on} onChange={(event) => set(event.currentTarget.checked)} />
      {words}
    </label>
  );
}
