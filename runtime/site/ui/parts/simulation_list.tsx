// The models of a simulated world with their links, and what is drawn of it.

import { useState } from 'preact/hooks';
import { linkOf } from '../model/sim_world.ts';
import type { ModelEntity } from '../model/sim_world.ts';
import { SIM_FLAGS } from '../model/simulation_options.ts';
import type { SimFlag } from '../model/simulation_options.ts';
import { simulationTexts } from '../texts_simulation.ts';
import { Icon } from './icon.tsx';
import { Name } from './name.tsx';
import { PictureChoice } from './picture_choice.tsx';
import type { PictureChoiceProps } from './picture_choice.tsx';

const MOST_ROWS = 200;

export interface SimulationListProps {
  readonly models: readonly ModelEntity[];
  /** A model or a link. */
  readonly selected: string;
  readonly select: (name: string) => void;
  /** The model that is selected, or whose link is. */
  readonly remove: () => void;
  readonly flags: Readonly<Record<SimFlag, boolean>>;
  readonly setFlag: (flag: SimFlag, on: boolean) => void;
  readonly pictures: PictureChoiceProps;
}

export function SimulationList({ models, selected, select, remove, flags, setFlag, pictures }: SimulationListProps) {
  const [opened, open] = useState<ReadonlySet<string>>(new Set());
  const toggle = (name: string): void => {
    const next = new Set(opened);
    if (!next.delete(name)) next.add(name);
    open(next);
  };
  const entity = (name: string, words: string) => (
    <button
      type="button"
      class="simulation-entity"
      aria-pressed={selected === name}
      onClick={() => select(selected === name ? '' : name)}
      onKeyDown={(event) => {
        if (event.key !== 'Delete' || selected !== name) return;
        event.preventDefault();
        remove();
      }}
    >
      <Name text={words} />
    </button>
  );
  return (
    <div class="scene-list simulation-list" role="group" aria-label={simulationTexts.list}>
      <p class="simulation-count">{simulationTexts.models(models.length)}</p>
      <ul class="simulation-tree" role="list">
        {models.slice(0, MOST_ROWS).map(({ name, links }) => (
          <li key={name}>
            <div class="simulation-row">
              {links.length > 1
                ? (
                  <button
                    type="button"
                    class="simulation-fold"
                    aria-label={simulationTexts.links(name)}
                    aria-expanded={opened.has(name)}
                    onClick={() => toggle(name)}
                  >
                    <Icon name="chevron" />
                  </button>
                )
                : <span class="simulation-fold" />}
              {entity(name, name)}
            </div>
            {links.length > 1 && opened.has(name)
              ? (
                <ul class="simulation-links" role="list">
                  {links.slice(0, MOST_ROWS).map((frame) => <li key={frame}>{entity(frame, linkOf(frame))}</li>)}
                  {links.length > MOST_ROWS ? <li class="hint">{simulationTexts.more(links.length - MOST_ROWS)}</li> : null}
                </ul>
              )
              : null}
          </li>
        ))}
      </ul>
      {models.length > MOST_ROWS ? <p class="hint">{simulationTexts.more(models.length - MOST_ROWS)}</p> : null}
      <fieldset class="scene-pictures">
        <legend>{simulationTexts.drawn}</legend>
        {SIM_FLAGS.map((flag) => (
          <label class="check" key={flag}>
            <input type="checkbox" checked={flags[flag]} onChange={(event) => setFlag(flag, event.currentTarget.checked)} />
            {simulationTexts.flags[flag]}
          </label>
        ))}
      </fieldset>
      <PictureChoice {...pictures} />
    </div>
  );
}
