// The selected model or link of a simulated world: where it is, and what can be done with it.

import { modelOf } from '../model/sim_world.ts';
import { toRollPitchYaw } from '../model/transform.ts';
import type { Transform, Vector } from '../model/transform.ts';
import { simulationTexts } from '../texts_simulation.ts';
import { IconButton } from './button.tsx';
import { Name } from './name.tsx';

export interface SimulationSelectionProps {
  readonly name: string;
  /** undefined: it has gone. */
  readonly place: Transform | undefined;
  readonly moves: boolean;
  readonly follows: boolean;
  readonly follow: () => void;
  /** null: the simulator cannot be asked yet. */
  readonly push: (() => void) | null;
  readonly remove: () => void;
}

export function SimulationSelection({ name, place, moves, follows, follow, push, remove }: SimulationSelectionProps) {
  const words = simulationTexts.shortOne;
  return (
    <div class="simulation-selection" role="group" aria-label={simulationTexts.selected(name)}>
      <div class="simulation-selection-head">
        <strong class="simulation-name">
          <Name text={name} />
        </strong>
        <IconButton icon="target" label={simulationTexts.follow(name)} words={words.follow} pressed={follows} onClick={follow} />
        {moves ? <IconButton icon="push" label={simulationTexts.pushOne(name)} words={words.push} disabled={push === null} onClick={() => push?.()} /> : null}
        <IconButton icon="clear" label={simulationTexts.remove(modelOf(name))} words={words.remove} onClick={remove} />
      </div>
      {place === undefined ? null : (
        <dl class="scene-facts">
          <div>
            <dt>{simulationTexts.place}</dt>
            <dd>{numbers(place.translation)} m</dd>
          </div>
          <div>
            <dt>{simulationTexts.turn}</dt>
            <dd>{numbers(degrees(toRollPitchYaw(place.rotation)), 1)}{'\u00b0'}</dd>
          </div>
        </dl>
      )}
      {moves ? null : <p class="hint">{simulationTexts.fixed}</p>}
    </div>
  );
}

function degrees([roll, pitch, yaw]: Vector): Vector {
  const turn = 180 / Math.PI;
  return [roll * turn, pitch * turn, yaw * turn];
}

/** Not "-0.00". */
function numbers(vector: Vector, digits = 2): string {
  return vector.map((value) => (Number(value.toFixed(digits)) + 0).toFixed(digits)).join(', ');
}
