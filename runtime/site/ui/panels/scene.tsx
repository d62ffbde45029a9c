// A scene in three dimensions: the frames of /tf, what topics tell, pictures over it, and tools for the pointer.
// State: model/scene_options.ts.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { PLAIN_LOOK, withLook } from '../model/display_look.ts';
import { isHiddenTopic } from '../model/hidden_names.ts';
import { member, textMember } from '../model/json.ts';
import { problemOf } from '../model/problem.ts';
import { readOptions, writeOptions } from '../model/scene_options.ts';
import type { SceneOptions } from '../model/scene_options.ts';
import { isImage } from '../parts/image_drawing.ts';
import { useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { SceneDetails } from '../parts/scene_details.tsx';
import type { Inspected } from '../parts/scene_details.tsx';
import { SceneImages } from '../parts/scene_images.tsx';
import { SceneList } from '../parts/scene_list.tsx';
import { SceneToolbar, siteFile } from '../parts/scene_toolbar.tsx';
import type { NamedText } from '../parts/scene_toolbar.tsx';
import { SceneTroubles } from '../parts/scene_troubles.tsx';
import { useTopics } from '../parts/watch.ts';
import { canShow, ODOMETRY, settingsOf } from '../scene/kinds.ts';
import type { Picked } from '../scene/pick.ts';
import { useScene } from '../scene/use_scene.ts';
import type { ShownTopic } from '../scene/use_scene.ts';
import { useTools } from '../scene/use_tools.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

/** Upper bound of the topics that are shown though nobody chose them. */
const MOST_UNASKED = 20;
const MOST_OFFERS = 1000;
const MOST_FILES = 20;
const MOST_FIELDS = 30;

/** Words and lines of the scene that can be read over a background which is not the page's; none for the page's. */
function colorsOver(background: string): Readonly<Record<string, string>> {
  if (background === '') return {};
  const [red, green, blue] = [1, 3, 5].map((at) => Number.parseInt(background.slice(at, at + 2), 16)) as [number, number, number];
  const isDark = 0.299 * red + 0.587 * green + 0.114 * blue < 128;
  return { background, color: isDark ? '#f4f4f4' : '#1a1a1a', borderTopColor: isDark ? '#a0a0a0' : '#707070' };
}

export function ScenePanel({ session, state, setState, announce }: PanelProps) {
  const options = useMemo(() => readOptions(state), [state]);
  const codec = useCodec(session);
  const ready = codec === null || typeof codec === 'string' ? null : codec;
  const topics = useTopics(session);
  const [inspected, inspect] = useState<Inspected | null>(null);

  const latest = useRef({ options, setState });
  latest.current = { options, setState };
  const change = (next: Partial<SceneOptions>): void => {
    // More than one change may come before the page has told of the first.
    latest.current.options = { ...latest.current.options, ...next };
    latest.current.setState(writeOptions(latest.current.options));
  };
  const tools = useTools(session, codec, options, announce, (picked: Picked | null, frame) => {
    inspect(picked?.part == null ? null : { topic: picked.part.topic, hit: { place: picked.place, frame, part: picked.part } });
  });

  // Hidden topics, such as those of a simulator before its bridge, are there for who names them in the layout.
  const known = topics
    .filter(({ name, type }) => canShow(name, type) && (!isHiddenTopic(name) || options.topics?.includes(name) === true))
    .toSorted((a, b) => (a.name < b.name ? -1 : 1));
  const usual = known.slice(0, MOST_UNASKED);
  const isOn = (name: string): boolean => options.topics === null ? usual.some((topic) => topic.name === name) : options.topics.includes(name);
  const shown: readonly ShownTopic[] = known.filter(({ name }) => isOn(name));

  const files = useMemo(
    () => session.site.files.map(({ path }) => path).filter((path) => path.endsWith('.rviz')).slice(0, MOST_FILES),
    [session],
  );
  const showAs = async (file: NamedText): Promise<void> => {
    try {
      const { name, text } = await file;
      const { readRviz } = await import('../model/rviz_config.ts');
      const scene = readRviz(text);
      if (scene !== null) change(scene.options);
      tools.say(scene === null ? panelTexts.scene.noRviz(name) : panelTexts.scene.rvizRead(name, scene.leftOut));
    } catch (error) {
      tools.say(panelTexts.text.failed(problemOf(error).what));
    }
  };

  // The file of the site that the panel shows at first: from then on the visitor's changes count.
  const asked = textMember(state, 'file');
  useEffect(() => {
    if (asked !== '' && files.includes(asked)) void showAs(siteFile(asked));
  }, [asked]);

  const { canvas, veil, view, tree, problem, forget, unreadable, newest } = useScene({
    session,
    codec,
    options,
    shown,
    aims: tools.aims,
    onView: (next) => change({ view: next }),
    onPose: tools.onPose,
    onPick: tools.onPick,
    onLeaveTool: () => tools.choose(null),
  });
  useEffect(() => view?.measure(tools.measured), [view, tools.measured]);

  // Roots first: those are what one wants to see from.
  const frames = [...new Set([...tree.roots(), ...tree.views().map(({ name }) => name)])].slice(0, MOST_OFFERS);
  const rows = known.map(({ name, type }) => ({
    name,
    type,
    on: isOn(name),
    problem: isOn(name) ? (unreadable.get(name) ?? view?.problem(name) ?? '') : '',
    settings: settingsOf(name, type),
    look: options.looks[name] ?? PLAIN_LOOK,
    fields: fieldsOf(newest(name)),
  }));
  const loops = tree.loops().map(([first]) => panelTexts.scene.loop(first ?? ''));
  const note = [unreadable.get('') ?? '', ...loops.slice(0, 3)].filter((one) => one !== '').join('; ');
  const troubles = [...(note === '' ? [] : [note]), ...rows.filter((row) => row.problem !== '').map((row) => `${row.name}: ${row.problem}`)];
  const said = tools.said === '' && view !== null ? panelTexts.scene.frameCount(view.frameCount) : tools.said;
  const pictures = [...new Set([
    ...topics.filter(({ name, type }) => isImage(type) && !isHiddenTopic(name)).map(({ name }) => name).toSorted(),
    ...options.images.map(({ topic }) => topic),
  ])].slice(0, MOST_OFFERS);

  return (
    <PanelFrame
      id="scene"
      title={texts.panels.scene}
      icon="scene"
      tools={
        <SceneToolbar
          options={options}
          change={change}
          frames={frames}
          fixed={view?.fixedFrame ?? ''}
          tools={tools}
          files={files}
          showAs={(file) => void showAs(file)}
          forget={forget}
        />
      }
    >
      {typeof codec === 'string' ? <p class="hint">{texts.topics.undecodable(codec)}</p> : null}
      {problem === '' ? null : <p class="hint" role="alert">{problem}</p>}
      <div class="scene">
        {options.list
          ? (
            <SceneList
              flags={[
                { words: panelTexts.scene.grid, on: options.grid, set: (grid) => change({ grid }) },
                { words: panelTexts.scene.frames, on: options.frames, set: (on) => change({ frames: on }) },
                { words: panelTexts.scene.names, on: options.names, set: (names) => change({ names }) },
              ]}
              keep={shown.some(({ type }) => type === ODOMETRY) ? { count: options.keep, set: (keep) => change({ keep }) } : null}
              follow={{ frame: options.follow, frames, set: (follow) => change({ follow }) }}
              rows={rows}
              note={note}
              onRow={(name, on) => {
                const others = shown.map((topic) => topic.name).filter((other) => other !== name);
                const kept = (options.topics ?? []).filter((other) => other !== name && !others.includes(other));
                change({ topics: [...others, ...kept, ...(on ? [name] : [])] });
              }}
              onLook={(name, look) => change({ looks: withLook(latest.current.options.looks, name, look) })}
              onDetails={(topic) => inspect({ topic, hit: null })}
              pictures={{ topics: pictures, images: options.images, set: (images) => change({ images }) }}
            />
          )
          : null}
        <div class="scene-stage">
          <canvas
            class={`scene-canvas ${tools.tool === null ? '' : 'scene-tool'}`}
            role="application"
            aria-label={panelTexts.scene.canvas}
            tabIndex={0}
            style={colorsOver(options.background)}
            ref={canvas}
          />
          {tools.tool === null ? null : <span class="scene-cross" aria-hidden="true" />}
          <canvas class="scene-veil" aria-hidden="true" ref={veil} />
          {said === '' ? null : <p class="scene-said">{said}</p>}
          {ready === null || options.images.length === 0 ? null : (
            <SceneImages session={session} codec={ready} images={options.images} set={(images) => change({ images })} />
          )}
          {options.list || troubles.length === 0 ? null : <SceneTroubles troubles={troubles} />}
          {inspected === null ? null : (
            <SceneDetails
              inspected={inspected}
              type={known.find(({ name }) => name === inspected.topic)?.type ?? ''}
              message={newest(inspected.topic)}
              codec={ready}
              close={() => inspect(null)}
            />
          )}
        </div>
      </div>
    </PanelFrame>
  );
}

/** The fields of a point cloud by which its points can be coloured. */
function fieldsOf(message: unknown): readonly string[] {
  const fields = member(message, 'fields');
  if (!Array.isArray(fields)) return [];
  return (fields.slice(0, MOST_FIELDS) as readonly unknown[])
    .map((field) => textMember(field, 'name'))
    .filter((name) => name !== '' && name !== 'rgba');
}
