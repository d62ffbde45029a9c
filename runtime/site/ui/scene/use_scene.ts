// A scene on a canvas for as long as a component stands: fed from the session's topics, turned by its visitor.

import { useEffect, useMemo, useReducer, useRef, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { writeView } from '../model/camera_view.ts';
import type { CameraView } from '../model/camera_view.ts';
import { PLAIN_LOOK } from '../model/display_look.ts';
import type { SceneOptions } from '../model/scene_options.ts';
import { TransformTree } from '../model/transform_tree.ts';
import { followTransforms } from '../parts/follow_transforms.ts';
import { feed } from '../parts/message_feed.ts';
import { useTheme } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import type { GroundPose } from './camera_control.ts';
import { ODOMETRY, makeDisplay, updatesOf } from './kinds.ts';
import type { DisplayContext } from './display.ts';
import { openScene, shelfOf } from './open_scene.ts';
import type { Picked } from './pick.ts';
import type { SceneView } from './scene_view.ts';

export interface ShownTopic {
  readonly name: string;
  readonly type: string;
}

export interface SceneUse {
  readonly session: Session;
  readonly codec: Codec | string | null;
  readonly options: SceneOptions;
  readonly shown: readonly ShownTopic[];
  /** The kind of input of the selected tool; null: no tool is selected. */
  readonly aims: 'pose' | 'point' | null;
  readonly onView: (view: CameraView) => void;
  readonly onPose: (pose: GroundPose, frame: string) => void;
  /** null: nothing was there. */
  readonly onPick: (picked: Picked | null, frame: string) => void;
  readonly onLeaveTool: () => void;
}

export interface Scene {
  readonly canvas: { current: HTMLCanvasElement | null; };
  /** Lies over it. */
  readonly veil: { current: HTMLCanvasElement | null; };
  readonly view: SceneView | null;
  readonly tree: TransformTree;
  /** Why nothing can be drawn; empty: it can. */
  readonly problem: string;
  /** Forgets all frames and messages. */
  readonly forget: () => void;
  /** Why a topic cannot be shown. */
  readonly unreadable: ReadonlyMap<string, string>;
  /** The newest message of a topic that is shown; undefined: none has come. */
  readonly newest: (topic: string) => unknown;
}

export function useScene(use: SceneUse): Scene {
  const { session, codec, options, shown } = use;
  const latest = useRef(use);
  latest.current = use;
  const theme = useTheme();
  const canvas = useRef<HTMLCanvasElement>(null);
  const veil = useRef<HTMLCanvasElement>(null);
  const [tree] = useState(() => new TransformTree());
  const [unreadable] = useState(() => new Map<string, string>());
  const [view, setView] = useState<SceneView | null>(null);
  const [problem, setProblem] = useState('');
  const [era, begin] = useReducer<number, void>((n) => n + 1, 0);
  const settled = useRef('');
  /** By type and name: ends what shows the topic. */
  const followed = useRef(new Map<string, () => void>());
  const newest = useRef(new Map<string, unknown>());
  const [, tell] = useReducer<number, void>((n) => n + 1, 0);

  useEffect(() => {
    const element = canvas.current;
    if (element === null || veil.current === null) return undefined;
    const opened = openScene({
      session,
      tree,
      veil: veil.current,
      canvas: element,
      view: latest.current.options.view,
      onProblem: setProblem,
      onWords: tell,
      hand: ({ view: made }) => ({
        settle: () => {
          settled.current = keyOf(made.view);
          latest.current.onView(made.view);
        },
        aims: () => latest.current.aims,
        setPose: (pose) => latest.current.onPose(pose, made.fixedFrame),
        setPoint: (x, y) => latest.current.onPick(made.pick(x, y), made.fixedFrame),
        leaveTool: () => latest.current.onLeaveTool(),
      }),
    });
    if (opened === null) return undefined;
    setView(opened.view);
    return () => {
      opened.close();
      setView(null);
    };
  }, [session]);

  useEffect(() => view?.setColors(), [view, theme, options.background]);
  useEffect(() => {
    // The visitor's own change comes back late and rounded: by then the view may have moved on.
    if (keyOf(options.view) === settled.current) return;
    settled.current = '';
    view?.look(options.view);
  }, [view, options.view]);
  useEffect(() => view?.chooseFrame(options.frame), [view, options.frame]);
  useEffect(() => view?.follow(options.follow), [view, options.follow]);
  const known = useRef(options.looks);
  useEffect(() => {
    const before = known.current;
    known.current = options.looks;
    for (const topic of new Set([...Object.keys(before), ...Object.keys(options.looks)]))
      if (JSON.stringify(before[topic]) !== JSON.stringify(options.looks[topic])) view?.repaint(topic);
  }, [view, options.looks]);
  useEffect(() => view?.show(options), [view, options.grid, options.frames, options.names]);

  useEffect(() => {
    if (view === null || codec === null || typeof codec === 'string') return undefined;
    return followTransforms(session, codec, tree, {
      onTransforms(moved) {
        if (moved) view.transformsMoved();
      },
      onProblem: (words) => {
        unreadable.set('', words);
        tell();
      },
    });
  }, [session, view, codec, era]);

  const meshes = useMemo(() => view === null ? null : shelfOf(session, view), [session, view]);

  const { keep } = options;
  const keyOfTopic = ({ name, type }: ShownTopic): string => `${type} ${name}${type === ODOMETRY ? ` ${keep}` : ''}`;
  const names = shown.map(keyOfTopic).join('\n');
  useEffect(() => () => {
    for (const stop of followed.current.values()) stop();
    followed.current.clear();
  }, [session, view, codec, era]);
  useEffect(() => {
    if (view === null || meshes === null || codec === null || typeof codec === 'string') return;
    const wanted = new Map(shown.map((topic) => [keyOfTopic(topic), topic]));
    // A subscription that stays keeps its messages: most of them are not published twice.
    for (const [key, stop] of followed.current) {
      if (wanted.has(key)) continue;
      stop();
      followed.current.delete(key);
    }
    for (const [key, { name, type }] of wanted) {
      if (followed.current.has(key)) continue;
      const context: DisplayContext = {
        colors: view.displayColors,
        keep,
        meshes,
        get look() {
          return latest.current.options.looks[name] ?? PLAIN_LOOK;
        },
      };
      const display = makeDisplay(name, type, context);
      if (display === null) continue;
      view.add(name, display);
      const follow = (topic: string): () => void =>
        topic === '' ? () => undefined : feed(session, codec, topic, ({ decoded }) => {
          if (decoded.kind === 'failed') {
            unreadable.set(name, texts.topics.undecodable(decoded.reason));
            tell();
            return;
          }
          unreadable.delete(name);
          if (topic === name) newest.current.set(name, decoded.value);
          display.take(decoded.value);
          view.messageTaken();
        });
      const stops = [follow(name), follow(updatesOf(name, type))];
      followed.current.set(key, () => {
        for (const stop of stops) stop();
        view.remove(name);
        newest.current.delete(name);
        unreadable.delete(name);
      });
    }
  }, [session, view, codec, names, era]);

  const forget = (): void => {
    tree.clear();
    view?.transformsMoved();
    begin();
  };
  return { canvas, veil, view, tree, problem, forget, unreadable, newest: (topic) => newest.current.get(topic) };
}

function keyOf(view: CameraView): string {
  return JSON.stringify(writeView(view));
}
