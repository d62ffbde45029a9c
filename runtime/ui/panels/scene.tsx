// A scene in three dimensions: the frames of /tf, what topics tell, and goals that are set with the pointer.
// State: model/scene_options.ts.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { PagePublisher } from '../../wasm_js/session.ts';
import { kUsualView } from '../model/camera_view.ts';
import { stampOf } from '../model/draft_value.ts';
import { isHiddenTopic } from '../model/hidden_names.ts';
import { problemOf } from '../model/problem.ts';
import { readOptions, writeOptions } from '../model/scene_options.ts';
import type { SceneOptions } from '../model/scene_options.ts';
import { fromRollPitchYaw } from '../model/transform.ts';
import { IconButton } from '../parts/button.tsx';
import { MenuButton } from '../parts/menu.tsx';
import { useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { SceneList } from '../parts/scene_list.tsx';
import { chooseText, readSiteText } from '../parts/site_text.ts';
import { useTopics } from '../parts/watch.ts';
import type { GoalPose } from '../scene/camera_control.ts';
import { canShow, kOdometry } from '../scene/kinds.ts';
import { useScene } from '../scene/use_scene.ts';
import type { ShownTopic } from '../scene/use_scene.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

/** Of those that nobody chose. */
const kMostUnasked = 20;
const kMostOffers = 1000;
const kMostFiles = 20;
const kPose = 'geometry_msgs/msg/PoseStamped';

export function ScenePanel({ session, state, setState, announce }: PanelProps) {
  const options = useMemo(() => readOptions(state), [state]);
  const codec = useCodec(session);
  const topics = useTopics(session);
  const [goalMode, setGoalMode] = useState(false);
  const [said, setSaid] = useState('');
  const publisher = useRef<PagePublisher | null>(null);

  const latest = useRef({ options, setState });
  latest.current = { options, setState };
  const change = (next: Partial<SceneOptions>): void =>
    latest.current.setState(writeOptions({ ...latest.current.options, ...next }));

  const known = topics
    .filter(({ name, type }) => canShow(name, type))
    .toSorted((a, b) => (a.name < b.name ? -1 : 1));
  const usual = known.filter(({ name }) => !isHiddenTopic(name)).slice(0, kMostUnasked);
  const isOn = (name: string): boolean =>
    options.topics === null ? usual.some((topic) => topic.name === name) : options.topics.includes(name);
  const shown: readonly ShownTopic[] = known.filter(({ name }) => isOn(name));

  useEffect(() => {
    if (!goalMode) return undefined;
    publisher.current = session.node().publisher(options.goal, kPose);
    setSaid(panelTexts.scene.goalHint);
    return () => {
      publisher.current?.close();
      publisher.current = null;
      setSaid('');
    };
  }, [session, goalMode, options.goal]);

  const say = (words: string): void => {
    setSaid(words);
    announce(words);
  };
  const publishGoal = (goal: GoalPose, frame: string): void => say(sendGoal(goal, frame));
  const sendGoal = ({ place: [x, y], heading }: GoalPose, frame: string): string => {
    if (frame === '') return panelTexts.scene.goalNoFrame;
    if (codec === null || typeof codec === 'string' || publisher.current === null) return texts.topics.decoding;
    const [qx, qy, qz, qw] = fromRollPitchYaw(0, 0, heading);
    const encoded = codec.encode(kPose, {
      header: { stamp: stampOf(session.time.view().now), frame_id: frame },
      pose: { position: { x, y, z: 0 }, orientation: { x: qx, y: qy, z: qz, w: qw } },
    });
    if (encoded.kind !== 'bytes') return panelTexts.text.failed(encoded.reason);
    const problem = publisher.current.problem ?? publisher.current.publish(encoded.bytes);
    if (problem !== undefined) return panelTexts.text.failed(problem.message);
    return panelTexts.scene.goalSent(x.toFixed(2), y.toFixed(2), ((heading * 180) / Math.PI).toFixed(0));
  };

  const files = useMemo(
    () => session.site.files.map(({ path }) => path).filter((path) => path.endsWith('.rviz')).slice(0, kMostFiles),
    [session],
  );
  const showAs = async (file: Promise<{ readonly name: string; readonly text: string }>): Promise<void> => {
    try {
      const { name, text } = await file;
      const { readRviz } = await import('../model/rviz_config.ts');
      const scene = readRviz(text);
      if (scene !== null) change(scene.options);
      say(scene === null ? panelTexts.scene.noRviz(name) : panelTexts.scene.rvizRead(name, scene.leftOut));
    } catch (error) {
      say(panelTexts.text.failed(problemOf(error).what));
    }
  };

  const { canvas, view, tree, problem, forget, unreadable } = useScene({
    session, codec, options, shown, goalMode,
    onView: (next) => change({ view: next }),
    onGoal: publishGoal,
    onLeaveGoalMode: () => setGoalMode(false),
  });

  // Roots first: those are what one wants to see from.
  const frames = [...new Set([...tree.roots(), ...tree.views().map(({ name }) => name)])].slice(0, kMostOffers);
  const fixed = view?.fixedFrame ?? '';
  const rows = known.map(({ name, type }) => ({
    name,
    type,
    on: isOn(name),
    problem: isOn(name) ? (unreadable.get(name) ?? view?.problem(name) ?? '') : '',
  }));
  const loops = tree.loops().map(([first]) => panelTexts.scene.loop(first ?? ''));
  const note = [unreadable.get('') ?? '', ...loops.slice(0, 3)].filter((one) => one !== '').join('; ');

  return (
    <PanelFrame
      id="scene"
      title={texts.panels.scene}
      icon="scene"
      note={said === '' && view !== null ? panelTexts.scene.frameCount(view.frameCount) : said}
      tools={
        <>
          <select
            class="select scene-frame"
            aria-label={panelTexts.scene.frame}
            value={options.frame}
            onChange={(event) => change({ frame: event.currentTarget.value })}
          >
            <option value="">{panelTexts.scene.usualFrame(options.frame === '' ? fixed : '')}</option>
            {frames.map((name) => (
              <option key={name} value={name}>{name}</option>
            ))}
            {options.frame === '' || frames.includes(options.frame) ? null : (
              <option value={options.frame}>{panelTexts.scene.missingFrame(options.frame)}</option>
            )}
          </select>
          <IconButton
            icon="list"
            label={panelTexts.scene.list}
            pressed={options.list}
            onClick={() => change({ list: !options.list })}
          />
          <IconButton
            icon="above"
            label={panelTexts.scene.top}
            pressed={options.view.top}
            onClick={() => change({ view: { ...options.view, top: !options.view.top } })}
          />
          <IconButton
            icon="home"
            label={panelTexts.scene.home}
            onClick={() => change({ view: { ...kUsualView, top: options.view.top } })}
          />
          <IconButton
            icon="goal"
            label={panelTexts.scene.goal(options.goal)}
            pressed={goalMode}
            onClick={() => setGoalMode(!goalMode)}
          />
          <MenuButton
            icon="layout"
            label={panelTexts.scene.rviz}
            items={[
              ...files.map((path) => ({
                id: path,
                words: nameOf(path),
                choose: () => void showAs(readSiteText(path).then((text) => ({ name: nameOf(path), text }))),
              })),
              { id: '', words: panelTexts.scene.rvizOpen, choose: () => void showAs(chooseText('.rviz')) },
            ]}
          />
          <IconButton icon="restart" label={panelTexts.scene.forget} onClick={forget} />
        </>
      }
    >
      {typeof codec === 'string' ? <p class="hint">{texts.topics.undecodable(codec)}</p> : null}
      {problem === '' ? null : <p class="hint" role="alert">{problem}</p>}
      <div class="scene">
        {options.list ? (
          <SceneList
            flags={[
              { words: panelTexts.scene.grid, on: options.grid, set: (grid) => change({ grid }) },
              { words: panelTexts.scene.frames, on: options.frames, set: (on) => change({ frames: on }) },
              { words: panelTexts.scene.names, on: options.names, set: (names) => change({ names }) },
            ]}
            keep={shown.some(({ type }) => type === kOdometry) ? { count: options.keep, set: (keep) => change({ keep }) } : null}
            rows={rows}
            note={note}
            onRow={(name, on) => {
              const others = shown.map((topic) => topic.name).filter((other) => other !== name);
              const kept = (options.topics ?? []).filter((other) => other !== name && !others.includes(other));
              change({ topics: [...others, ...kept, ...(on ? [name] : [])] });
            }}
          />
        ) : null}
        <canvas
          class={`scene-canvas ${goalMode ? 'scene-goal' : ''}`}
          role="application"
          aria-label={panelTexts.scene.canvas}
          tabIndex={0}
          ref={canvas}
        />
      </div>
    </PanelFrame>
  );
}

function nameOf(path: string): string {
  return path.slice(path.lastIndexOf('/') + 1);
}
