// The buttons above a simulated world: its time, objects to add, the hand, and the view.

import { USUAL_VIEW } from '../model/camera_view.ts';
import { SIM_SHAPES } from '../model/sim_shapes.ts';
import type { SimShape } from '../model/sim_shapes.ts';
import type { SimulationOptions } from '../model/simulation_options.ts';
import type { SimTool } from '../scene/use_simulation.ts';
import { simulationTexts } from '../texts_simulation.ts';
import { IconButton } from './button.tsx';
import { MenuButton } from './menu.tsx';
import type { SimClient } from './sim_client.ts';

/** Steps of the physics that the button *Step* makes. */
const STEPS = 100;

interface SimulationToolbarProps {
  readonly options: SimulationOptions;
  readonly change: (next: Partial<SimulationOptions>) => void;
  readonly tool: SimTool | null;
  readonly choose: (tool: SimTool | null) => void;
  readonly isPaused: boolean;
  /** Whether there is a simulator to ask. */
  readonly isReady: boolean;
  /** Asks the simulator, and then says that it is done. */
  readonly control: (asked: Parameters<SimClient['control']>[0], done: string) => void;
  readonly add: (shape: SimShape) => void;
}

export function SimulationToolbar({ options, change, tool, choose, isPaused, isReady, control, add }: SimulationToolbarProps) {
  const words = simulationTexts.short;
  return (
    <>
      <IconButton
        icon={isPaused ? 'play' : 'pause'}
        label={isPaused ? simulationTexts.play : simulationTexts.pause}
        words={isPaused ? words.play : words.pause}
        disabled={!isReady}
        onClick={() => control({ pause: !isPaused }, isPaused ? simulationTexts.running : simulationTexts.stands)}
      />
      <IconButton
        icon="step"
        label={simulationTexts.step}
        words={words.step}
        disabled={!isReady}
        onClick={() => control({ pause: true, multi_step: STEPS }, simulationTexts.stepped)}
      />
      <IconButton
        icon="restart"
        label={simulationTexts.reset}
        words={words.reset}
        disabled={!isReady}
        onClick={() => control({ pause: isPaused, reset: { all: true } }, simulationTexts.hasReset)}
      />
      <MenuButton
        icon="plus"
        label={simulationTexts.add}
        words={words.add}
        items={SIM_SHAPES.map((shape) => ({ id: shape, words: simulationTexts.shapes[shape], disabled: !isReady, choose: () => add(shape) }))}
      />
      {(['drag', 'push'] as const).map((one) => (
        <IconButton
          key={one}
          icon={one === 'drag' ? 'hand' : 'push'}
          label={simulationTexts[one]}
          words={words[one]}
          pressed={tool === one}
          onClick={() => choose(tool === one ? null : one)}
        />
      ))}
      <IconButton
        icon="above"
        label={simulationTexts.top}
        words={words.top}
        pressed={options.view.top}
        onClick={() => change({ view: { ...options.view, top: !options.view.top } })}
      />
      <IconButton
        icon="home"
        label={simulationTexts.home}
        words={words.home}
        onClick={() => change({ view: { ...USUAL_VIEW, top: options.view.top }, follow: '' })}
      />
      <IconButton icon="list" label={simulationTexts.list} words={words.list} pressed={options.list} onClick={() => change({ list: !options.list })} />
    </>
  );
}
