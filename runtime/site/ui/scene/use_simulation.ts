// A simulated world on a canvas for as long as a component stands: fed from the simulator's hidden topics, with the hand of
// the visitor.

import { useEffect, useReducer, useRef, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { writeView } from '../model/camera_view.ts';
import type { CameraView } from '../model/camera_view.ts';
import { member } from '../model/json.ts';
import { WORLD_FRAME, modelOf, readPace, SimWorld } from '../model/sim_world.ts';
import type { SimPace } from '../model/sim_world.ts';
import type { SimulationOptions } from '../model/simulation_options.ts';
import { readHeader, rotate } from '../model/transform.ts';
import type { Vector } from '../model/transform.ts';
import { feed } from '../parts/message_feed.ts';
import type { SimClient } from '../parts/sim_client.ts';
import { useTheme } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import { simulationTexts } from '../texts_simulation.ts';
import type { Grab } from './camera_control.ts';
import { Markers } from './markers.ts';
import { NewestDisplay } from './newest_display.ts';
import { openScene, shelfOf } from './open_scene.ts';
import type { OpenScene } from './open_scene.ts';
import type { Picked } from './pick.ts';
import { scanRays } from './scan_rays.ts';
import { SelectionBox } from './selection_box.ts';
import { WorldLights } from './world_lights.ts';

export type SimTool = 'drag' | 'push';

export interface SimulationUse {
  readonly session: Session;
  readonly codec: Codec | string | null;
  readonly client: SimClient | null;
  readonly options: SimulationOptions;
  /** Topics of laser scanners whose rays are drawn. */
  readonly scans: readonly string[];
  readonly tool: SimTool | null;
  /** A model or a link; empty: nothing. */
  readonly selected: string;
  readonly onView: (view: CameraView) => void;
  /** A link, or empty: the visitor has pressed on it. */
  readonly onPress: (pressed: Pressed | null) => void;
  readonly onLeaveTool: () => void;
  /** Pictures take too long; without shadows they may not. */
  readonly onShadowsTooDear: () => void;
}

export interface Pressed {
  /** `model::link` */
  readonly frame: string;
  /** In the link, and in the world. */
  readonly local: Vector;
  readonly place: Vector;
}

export interface Simulated {
  readonly canvas: { current: HTMLCanvasElement | null; };
  readonly veil: { current: HTMLCanvasElement | null; };
  readonly scene: OpenScene | null;
  readonly world: SimWorld;
  readonly pace: SimPace | null;
  /** undefined: the simulator has not said. */
  readonly paused: boolean | undefined;
  /** Why something is not drawn; each once. */
  readonly problems: readonly string[];
}

export const SCENE_TOPIC = '/_gz/scene';
const LIGHTS_TOPIC = '/_gz/lights';
const COLLISIONS_TOPIC = '/_gz/collisions';
const CONTACTS_TOPIC = '/_gz/contacts';
const POSES_TOPIC = '/_gz/poses';
const STATS_TOPIC = '/_gz/stats';
const PAUSED_TOPIC = '/_gz/paused';
/** The hand says again that it holds; the simulator lets go of what it has not heard of for a second. */
const HAND_MS = 200;
/** Lines of the grid stand this much above a floor at 0, in metres. */
const GRID_HEIGHT = 0.01;
const RAY_COLORS = ['#e5484d', '#3e7bfa', '#30a46c', '#d08a1d'] as const;

export function useSimulation(use: SimulationUse): Simulated {
  const { session, codec, options, scans, selected } = use;
  const latest = useRef(use);
  latest.current = use;
  const theme = useTheme();
  const canvas = useRef<HTMLCanvasElement>(null);
  const veil = useRef<HTMLCanvasElement>(null);
  const [world] = useState(() => new SimWorld());
  const [scene, setScene] = useState<OpenScene | null>(null);
  const [failed, setFailed] = useState('');
  const [paused, setPaused] = useState<boolean>();
  const [, tell] = useReducer<number, void>((n) => n + 1, 0);
  const problems = useRef(new Map<string, string>());
  const pace = useRef<SimPace | null>(null);
  const box = useRef<SelectionBox | null>(null);
  const visuals = useRef<Markers | null>(null);
  const hand = useRef<Hand | null>(null);
  const settled = useRef('');

  useEffect(() => {
    const element = canvas.current;
    if (element === null || veil.current === null) return undefined;
    const opened = openScene({
      session,
      canvas: element,
      veil: veil.current,
      tree: world.tree,
      view: latest.current.options.view,
      onProblem: setFailed,
      onWords: tell,
      showsFrame: (name) => world.isInner(name),
      arranged: () => {
        const { selected: chosen } = latest.current;
        if (box.current === null || visuals.current === null) return;
        box.current.around(visuals.current, (frame) => chosen !== '' && (frame === chosen || modelOf(frame) === chosen));
        const held = hand.current;
        const from = held === null ? null : placeIn(world, held.frame, held.local);
        box.current.pull(from, held?.target ?? null);
      },
      hand: (made) => ({
        settle: () => {
          settled.current = keyOf(made.view.view);
          latest.current.onView(made.view.view);
        },
        aims: () => 'point',
        setPose: () => undefined,
        setPoint: (x, y) => latest.current.onPress(pressedOf(made.view.pick(x, y))),
        leaveTool: () => latest.current.onLeaveTool(),
        grab: (x, y, event) => (event.ctrlKey || latest.current.tool === 'drag' ? grab(made, world, latest.current.client, hand, x, y) : null),
      }),
    });
    if (opened === null) return undefined;
    opened.view.chooseFrame(WORLD_FRAME);
    opened.stage.raiseGrid(GRID_HEIGHT);
    const around = new SelectionBox(opened.stage.colors.accent);
    box.current = around;
    opened.stage.scene.add(around.group);
    setScene(opened);
    return () => {
      box.current = null;
      around.close();
      opened.close();
      setScene(null);
    };
  }, [session]);

  const { shadows, grid, collisions, contacts, rays, frames, names } = options.flags;
  useEffect(() => {
    if (scene === null) return;
    scene.view.setColors();
    box.current?.setColor(scene.stage.colors.accent);
  }, [scene, theme]);
  useEffect(() => {
    // The visitor's own change comes back late and rounded.
    if (keyOf(options.view) === settled.current) return;
    settled.current = '';
    scene?.view.look(options.view);
  }, [scene, options.view]);
  useEffect(() => scene?.view.follow(options.follow), [scene, options.follow]);
  useEffect(() => scene?.stage.showShadows(shadows, () => latest.current.onShadowsTooDear()), [scene, shadows]);
  useEffect(() => scene?.view.show({ grid, frames, names }), [scene, grid, frames, names]);
  useEffect(() => scene?.stage.draw(), [scene, selected]);

  const ready = codec === null || typeof codec === 'string' ? null : codec;
  useEffect(() => {
    if (scene === null || ready === null) return undefined;
    const meshes = shelfOf(session, scene.view);
    const shapes = new Markers(meshes);
    visuals.current = shapes;
    scene.view.add(SCENE_TOPIC, shapes);
    const lights = new WorldLights((list) => scene.stage.useLights(list));
    scene.view.add(LIGHTS_TOPIC, lights);
    const follow = follower(session, ready, problems.current, tell);
    const stops = [
      follow(SCENE_TOPIC, (message) => {
        world.takeShapes(message);
        shapes.take(message);
        scene.view.messageTaken();
      }),
      follow(LIGHTS_TOPIC, (message) => {
        lights.take(message);
        scene.view.messageTaken();
      }),
      follow(POSES_TOPIC, (message) => {
        const change = world.take(message);
        if (change !== 'same') scene.view.transformsMoved();
        if (change === 'models') tell();
      }),
      follow(STATS_TOPIC, (message) => {
        pace.current = readPace(message) ?? pace.current;
        tell();
      }),
      follow(PAUSED_TOPIC, (message) => setPaused(member(message, 'data') === true)),
    ];
    return () => {
      for (const stop of stops) stop();
      visuals.current = null;
      scene.view.remove(SCENE_TOPIC);
      scene.view.remove(LIGHTS_TOPIC);
    };
  }, [session, scene, ready]);

  const followMarkers = (topic: string, on: boolean) => () => {
    if (scene === null || ready === null || !on) return undefined;
    const shapes = new Markers(shelfOf(session, scene.view));
    scene.view.add(topic, shapes);
    const stop = follower(session, ready, problems.current, tell)(topic, (message) => {
      shapes.take(message);
      scene.view.messageTaken();
    });
    return () => {
      stop();
      scene.view.remove(topic);
    };
  };
  useEffect(followMarkers(COLLISIONS_TOPIC, collisions), [session, scene, ready, collisions]);
  useEffect(followMarkers(CONTACTS_TOPIC, contacts), [session, scene, ready, contacts]);

  const followed = rays ? scans.join('\n') : '';
  useEffect(() => {
    if (scene === null || ready === null || followed === '') return undefined;
    const stops = followed.split('\n').map((topic, index) => {
      const display = new NewestDisplay(scanRays(RAY_COLORS[index % RAY_COLORS.length] ?? RAY_COLORS[0]));
      scene.view.add(topic, display);
      const stop = follower(session, ready, problems.current, tell)(topic, (message) => {
        const { frame: named } = readHeader(message);
        const frame = world.frameOf(named);
        if (frame === undefined) {
          problems.current.set(topic, simulationTexts.noScan(topic, named));
          return;
        }
        problems.current.delete(topic);
        display.take({ ...(message as object), header: { stamp: { sec: 0, nanosec: 0 }, frame_id: frame } });
        scene.view.messageTaken();
      });
      return () => {
        stop();
        problems.current.delete(topic);
        scene.view.remove(topic);
      };
    });
    return () => {
      for (const stop of stops) stop();
    };
  }, [session, scene, ready, followed]);

  const said = [failed, ...problems.current.values(), scene?.view.problem(SCENE_TOPIC) ?? ''];
  return { canvas, veil, scene, world, pace: pace.current, paused, problems: [...new Set(said.filter((one) => one !== ''))] };
}

/** Follows topics; what cannot be read is noted. */
function follower(
  session: Session,
  codec: Codec,
  problems: Map<string, string>,
  tell: () => void,
): (topic: string, listener: (message: unknown) => void) => () => void {
  return (topic, listener) => {
    const stop = feed(session, codec, topic, ({ decoded }) => {
      if (decoded.kind === 'failed') {
        problems.set(topic, `${topic}: ${texts.topics.undecodable(decoded.reason)}`);
        tell();
        return;
      }
      problems.delete(topic);
      listener(decoded.value);
    });
    return () => {
      stop();
      problems.delete(topic);
    };
  };
}

/** Where the visitor holds a link, and where the hand is in the world. */
interface Hand {
  readonly frame: string;
  readonly local: Vector;
  readonly target: Vector;
}

/** Takes the link below a place of the canvas, if it can move. */
function grab(
  made: Pick<OpenScene, 'view' | 'stage'>,
  world: SimWorld,
  client: SimClient | null,
  hand: { current: Hand | null; },
  x: number,
  y: number,
): Grab | null {
  const pressed = pressedOf(made.view.pick(x, y));
  if (pressed === null || client === null || !world.moves(pressed.frame)) return null;
  const { frame, local, place } = pressed;
  hand.current = { frame, local, target: place };
  client.hold(frame, local, place);
  const beat = setInterval(() => client.hold(frame, local, hand.current?.target ?? place), HAND_MS);
  return {
    move(toX, toY) {
      const target = made.stage.besideAt(toX, toY, place);
      if (target === null) return;
      hand.current = { frame, local, target };
      client.hold(frame, local, target);
      made.stage.draw();
    },
    end() {
      clearInterval(beat);
      hand.current = null;
      client.letGo(frame);
      made.stage.draw();
    },
  };
}

/** null: it is not a part of the world. */
function pressedOf(picked: Picked | null): Pressed | null {
  if (picked?.part == null) return null;
  const { topic, header, local } = picked.part;
  return topic === SCENE_TOPIC || topic === COLLISIONS_TOPIC ? { frame: header.frame, local, place: picked.place } : null;
}

function placeIn(world: SimWorld, frame: string, local: Vector): Vector | null {
  const found = world.tree.lookup(WORLD_FRAME, frame, NaN);
  if (found.kind !== 'found') return null;
  const { translation: [x, y, z], rotation } = found.transform;
  const [dx, dy, dz] = rotate(rotation, local);
  return [x + dx, y + dy, z + dz];
}

function keyOf(view: CameraView): string {
  return JSON.stringify(writeView(view));
}
