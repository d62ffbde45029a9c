// The world of a simulator: its models with shadows, their tree, a hand that drags and pushes, and the simulator's time.
// State: model/simulation_options.ts.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { isHiddenTopic } from '../model/hidden_names.ts';
import { freeName, SIM_SHAPE_HEIGHT, sdfOf } from '../model/sim_shapes.ts';
import type { SimShape } from '../model/sim_shapes.ts';
import { modelOf } from '../model/sim_world.ts';
import { readSimulation, writeSimulation } from '../model/simulation_options.ts';
import type { SimulationOptions } from '../model/simulation_options.ts';
import type { Vector } from '../model/transform.ts';
import { isImage } from '../parts/image_drawing.ts';
import { useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { SceneImages } from '../parts/scene_images.tsx';
import { SceneTroubles } from '../parts/scene_troubles.tsx';
import { SimClient, worldOf } from '../parts/sim_client.ts';
import { SimulationList } from '../parts/simulation_list.tsx';
import { SimulationSelection } from '../parts/simulation_selection.tsx';
import { SimulationToolbar } from '../parts/simulation_toolbar.tsx';
import { useGraph, useTime, useTopics } from '../parts/watch.ts';
import { drawsInSoftware } from '../scene/resolution.ts';
import { useSimulation } from '../scene/use_simulation.ts';
import type { Pressed, SimTool } from '../scene/use_simulation.ts';
import { texts } from '../texts.ts';
import { simulationTexts } from '../texts_simulation.ts';
import type { PanelProps } from './panel_props.ts';

const MOST_SCANS = 8;
const MOST_PICTURES = 50;
/** How long an answer stands over the picture. */
const SAID_MS = 5000;
/** Metres per second. */
const PUSH = 1;
/** Objects are added this high above the ground, in metres. */
const DROP = 0.2;
const SCAN = 'sensor_msgs/msg/LaserScan';

export function SimulationPanel({ session, state, setState, announce }: PanelProps) {
  // Shadows cost several pictures' worth where the processor draws.
  const [shadows, setShadows] = useState(() => !drawsInSoftware());
  const options = useMemo(() => readSimulation(state, shadows), [state, shadows]);
  const codec = useCodec(session);
  const ready = codec === null || typeof codec === 'string' ? null : codec;
  const topics = useTopics(session);
  const name = worldOf(useGraph(session));
  const time = useTime(session);
  const [selected, select] = useState('');
  const [tool, choose] = useState<SimTool | null>(null);
  const [said, setSaid] = useState('');
  const [client, setClient] = useState<SimClient | null>(null);

  useEffect(() => {
    if (ready === null || name === undefined) return undefined;
    const made = new SimClient(session, ready, name);
    setClient(made);
    return () => {
      made.close();
      setClient(null);
    };
  }, [session, ready, name]);

  useEffect(() => {
    if (said === '') return undefined;
    const timer = setTimeout(() => setSaid(''), SAID_MS);
    return () => clearTimeout(timer);
  }, [said]);

  const latest = useRef({ options, setState });
  latest.current = { options, setState };
  const change = (next: Partial<SimulationOptions>): void => {
    latest.current.options = { ...latest.current.options, ...next };
    latest.current.setState(writeSimulation(latest.current.options, shadows));
  };
  const say = (words: string): void => {
    setSaid(words);
    if (words !== '') announce(words);
  };

  const press = (pressed: Pressed | null): void => {
    if (pressed === null) {
      select('');
      return;
    }
    if (tool !== 'push') {
      select(modelOf(pressed.frame) === selected ? pressed.frame : modelOf(pressed.frame));
      return;
    }
    if (world.moves(pressed.frame)) client?.push(pressed.frame, pressed.local, away());
    else say(simulationTexts.unmoved(modelOf(pressed.frame)));
  };
  const scans = topics.filter(({ type, name: topic }) => type === SCAN && !isHiddenTopic(topic)).map(({ name: topic }) => topic).toSorted();
  const { canvas, veil, scene, world, pace, paused, problems } = useSimulation({
    session,
    codec,
    client,
    options,
    tool,
    selected,
    scans: scans.slice(0, MOST_SCANS),
    onView: (view) => change({ view }),
    onPress: press,
    onLeaveTool: () => choose(null),
    onShadowsTooDear: () => setShadows(false),
  });

  /** Over the ground, as one looks. */
  const away = (): Vector => {
    const ahead = scene?.stage.ahead();
    const flat = ahead === undefined ? 0 : Math.hypot(ahead.x, ahead.y);
    return ahead === undefined || flat < 1e-3 ? [0, PUSH, 0] : [(ahead.x / flat) * PUSH, (ahead.y / flat) * PUSH, 0];
  };
  const { models } = world;
  const model = modelOf(selected);
  const chosen = models.find((one) => one.name === model);
  // A model that was removed is selected no more.
  useEffect(() => {
    if (selected !== '' && chosen === undefined) select('');
  }, [selected, chosen]);
  const main = chosen === undefined ? '' : selected === model ? (chosen.links[0] ?? '') : selected;

  const order = async (asked: Promise<string> | undefined, done: string): Promise<void> => {
    const problem = await asked;
    if (problem === undefined) return;
    say(problem === '' ? done : simulationTexts.refused(problem));
  };
  const add = (shape: SimShape): void => {
    const element = canvas.current;
    const [x, y] = (element === null ? null : scene?.stage.groundAt(element.clientWidth / 2, element.clientHeight / 2)) ?? [0, 0];
    const named = freeName(shape, new Set(models.map((one) => one.name)));
    void order(client?.create(named, sdfOf(shape, named), [x, y, SIM_SHAPE_HEIGHT + DROP]), simulationTexts.added(named));
  };
  const remove = (): void => {
    if (model !== '') void order(client?.remove(model), simulationTexts.removed(model));
  };

  const seconds = pace === null ? '' : pace.time.toFixed(2);
  const note = pace === null ? '' : paused === true ? simulationTexts.pausedAt(seconds) : simulationTexts.pace(seconds, pace.factor.toFixed(2));
  const hint = tool === 'drag' ? simulationTexts.dragHint : tool === 'push' ? simulationTexts.pushHint : '';
  const over = time.state === 'paused' ? simulationTexts.held : hint === '' ? said : hint;
  const pictures = [...new Set([
    ...topics.filter(({ name: topic, type }) => isImage(type) && !isHiddenTopic(topic)).map(({ name: topic }) => topic).toSorted(),
    ...options.images.map(({ topic }) => topic),
  ])].slice(0, MOST_PICTURES);

  return (
    <PanelFrame
      id="simulation"
      title={texts.panels.simulation}
      icon="simulation"
      note={note}
      tools={
        <SimulationToolbar
          options={options}
          change={change}
          tool={tool}
          choose={choose}
          isPaused={paused === true}
          isReady={client !== null}
          control={(asked, done) => void order(client?.control(asked), done)}
          add={add}
        />
      }
    >
      {typeof codec === 'string' ? <p class="hint">{texts.topics.undecodable(codec)}</p> : null}
      {name === undefined ? <p class="hint">{simulationTexts.waiting}</p> : null}
      <div class="scene">
        {options.list
          ? (
            <SimulationList
              models={models}
              selected={selected}
              select={select}
              remove={remove}
              flags={options.flags}
              setFlag={(flag, on) => change({ flags: { ...latest.current.options.flags, [flag]: on } })}
              pictures={{ topics: pictures, images: options.images, set: (images) => change({ images }) }}
            />
          )
          : null}
        <div class="scene-stage">
          <canvas
            class={`scene-canvas ${tool === null ? '' : 'scene-tool'}`}
            role="application"
            aria-label={simulationTexts.canvas}
            tabIndex={0}
            ref={canvas}
          />
          <span class="scene-cross" aria-hidden="true" />
          <canvas class="scene-veil" aria-hidden="true" ref={veil} />
          {over === '' ? null : <p class="scene-said">{over}</p>}
          {ready === null || options.images.length === 0 ? null : (
            <SceneImages session={session} codec={ready} images={options.images} set={(images) => change({ images })} />
          )}
          {chosen !== undefined
            ? (
              <SimulationSelection
                name={selected}
                place={world.place(main)}
                moves={world.moves(main)}
                follows={options.follow === main}
                follow={() => change({ follow: options.follow === main ? '' : main, view: { ...latest.current.options.view, target: [0, 0, 0] } })}
                push={client === null ? null : () => client.push(main, [0, 0, 0], away())}
                remove={remove}
              />
            )
            : problems.length > 0
            ? <SceneTroubles troubles={problems} />
            : null}
        </div>
      </div>
    </PanelFrame>
  );
}
