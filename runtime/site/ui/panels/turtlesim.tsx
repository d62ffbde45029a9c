// The window of a turtle simulator: its sheet with turtles and strokes. Arrow keys and a pad drive a turtle, as
// turtle_teleop_key does. State: {node, turtle}.

import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { textMember } from '../model/json.ts';
import { problemOf } from '../model/problem.ts';
import { readPicture, readScene } from '../model/turtle_scene.ts';
import type { Picture, Scene } from '../model/turtle_scene.ts';
import { IconButton } from '../parts/button.tsx';
import { feed, useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { TurtlePad, useTurtleDrive } from '../parts/turtle_drive.tsx';
import { TurtleSheet } from '../parts/turtle_sheet.ts';
import { useTime, useTopics } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

const SCENE_TYPE = 'turtlesim_scene/msg/Scene';
const PICTURE_TYPE = 'turtlesim_scene/srv/GetPicture';
const SCENE_TOPIC = '/_scene';
/** Words for those who do not see the drawing come no more often than this. */
const WORDS_MS = 500;

export function TurtlesimPanel({ session, state, setState }: PanelProps) {
  const topics = useTopics(session).filter((topic) => topic.type === SCENE_TYPE);
  const nodes = topics.map((topic) => nodeOf(topic.name)).toSorted();
  const asked = textMember(state, 'node');
  const running = topics.filter((topic) => topic.publishers > 0).map((topic) => nodeOf(topic.name));
  const node = asked === '' ? (running.toSorted()[0] ?? nodes[0] ?? '') : asked;
  const codec = useCodec(session);
  const ready = codec !== null && typeof codec !== 'string' ? codec : null;
  const frame = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const sheet = useRef<TurtleSheet | null>(null);
  const [aspect, setAspect] = useState(1);
  const [turtles, setTurtles] = useState<readonly string[]>([]);
  const [problem, setProblem] = useState('');
  const held = useTime(session).state !== 'running';

  const wanted = textMember(state, 'turtle');
  const turtle = turtles.includes(wanted) ? wanted : (turtles[0] ?? '');
  const space = node.slice(0, node.lastIndexOf('/'));
  const drive = useTurtleDrive(session, ready, turtle === '' ? '' : `${space}/${turtle}/cmd_vel`, setProblem);
  const choose = (name: string): void => setState({ node, turtle: name });

  useEffect(() => {
    if (ready === null || node === '' || canvas.current === null) return undefined;
    const words = new Words(frame.current);
    const drawn = new TurtleSheet({
      canvas: canvas.current,
      ask: () => pictureOf(session, ready, node),
      onDrawn: (scene) => words.tell(node, scene),
    });
    sheet.current = drawn;
    words.say(panelTexts.turtlesim.waiting);
    setTurtles([]);
    setProblem('');
    let known = '';
    const stop = feed(session, ready, `${node}${SCENE_TOPIC}`, ({ decoded, type, gid }) => {
      const scene = decoded.kind === 'failed' || type !== SCENE_TYPE ? null : readScene(decoded.value);
      if (scene === null) {
        setProblem(panelTexts.turtlesim.noScene);
        return;
      }
      const names = scene.turtles.map(({ name }) => name);
      if (names.join(' ') !== known) setTurtles(names);
      known = names.join(' ');
      setAspect(scene.width / scene.height);
      drawn.take(scene, gid);
    });
    return () => {
      stop();
      drawn.close();
      words.close();
      sheet.current = null;
    };
  }, [session, ready, node]);
  useEffect(() => sheet.current?.mark(turtle), [turtle, node, ready]);

  // Keys that no other element takes drive the turtle, too, so that a visitor can begin at once. The listener is there from the
  // moment on in which the words beside the pad say so.
  useLayoutEffect(() => {
    const press = (event: KeyboardEvent): void => {
      const at = document.activeElement;
      if (at === null || at === document.body || frame.current?.contains(at) === true) drive.key(event);
    };
    document.addEventListener('keydown', press);
    return () => document.removeEventListener('keydown', press);
  }, [drive]);

  const call = (name: string): void => {
    if (ready !== null)
      callEmpty(session, ready, `${space}/${name}`).then(
        () => setProblem(''),
        (error: unknown) => setProblem(problemOf(error).what),
      );
  };
  const said = problem === '' && held ? panelTexts.turtlesim.held : problem;
  const gone = node !== '' && !running.includes(node);
  return (
    <PanelFrame
      id="turtlesim"
      title={texts.panels.turtlesim}
      icon="turtle"
      note={gone && turtles.length > 0 ? panelTexts.turtlesim.gone : ''}
      tools={node === '' ? null : (
        <>
          {nodes.length < 2 && nodes.includes(node) ? null : (
            <Choice
              label={panelTexts.turtlesim.simulator}
              value={node}
              values={[...new Set([...nodes, node])]}
              onChange={(name) => setState({ node: name })}
            />
          )}
          {turtles.length < 2 ? null : (
            <Choice label={panelTexts.turtlesim.driven} value={turtle} values={turtles} onChange={choose} />
          )}
          <IconButton icon="clear" label={panelTexts.turtlesim.clear} onClick={() => call('clear')} />
          <IconButton icon="restart" label={panelTexts.turtlesim.reset} onClick={() => call('reset')} />
        </>
      )}
    >
      {node === '' ? <p class="hint">{panelTexts.turtlesim.none}</p> : null}
      {typeof codec === 'string' ? <p class="hint">{codec}</p> : null}
      <div class="turtle-view" hidden={node === ''}>
        <div class="turtle-room">
          <div
            class="turtle-sheet"
            role="application"
            tabIndex={0}
            ref={frame}
            style={{ '--aspect': String(aspect) }}
            onPointerDown={(event) => {
              const found = sheet.current?.turtleAt(event.clientX, event.clientY) ?? null;
              if (found !== null && turtles.length > 1) choose(found.name);
            }}
          >
            <canvas class="turtle-canvas" aria-hidden="true" ref={canvas} />
          </div>
        </div>
        <div class="turtle-bar">
          <TurtlePad drive={drive} turtle={turtle} />
          {said !== ''
            ? (
              <p class="hint">{said}</p>
            )
            : turtle === ''
            ? null
            : (
              <p class="hint turtle-keys">{panelTexts.turtlesim.keys(turtle)}</p>
            )}
        </div>
      </div>
    </PanelFrame>
  );
}

interface ChoiceProps {
  readonly label: string;
  readonly value: string;
  readonly values: readonly string[];
  readonly onChange: (value: string) => void;
}

function Choice({ label, value, values, onChange }: ChoiceProps) {
  return (
    <select
      class="select turtle-choice"
      aria-label={label}
      title={label}
      value={value}
      onChange={(event) => onChange(event.currentTarget.value)}
    >
      {values.map((one) => (
        <option key={one} value={one}>
          {one}
        </option>
      ))}
    </select>
  );
}

/** The label of the drawing: it has the places of its turtles. */
class Words {
  private readonly element: HTMLElement | null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private next = '';

  constructor(element: HTMLElement | null) {
    this.element = element;
  }

  say(words: string): void {
    if (words !== this.element?.getAttribute('aria-label'))
      this.element?.setAttribute('aria-label', words);
  }

  tell(node: string, scene: Scene): void {
    this.next = panelTexts.turtlesim.shows(
      node,
      scene.turtles.slice(0, 10).map(({ name, x, y, theta }) =>
        panelTexts.turtlesim.turtle(name, x.toFixed(1), y.toFixed(1), String(Math.round((theta * 180) / Math.PI) + 0))
      ),
      scene.turtles.length,
    );
    this.timer ??= setTimeout(() => {
      this.timer = undefined;
      this.say(this.next);
    }, WORDS_MS);
  }

  close(): void {
    clearTimeout(this.timer);
  }
}

/** `/turtlesim/_scene` is that of /turtlesim. */
function nodeOf(topic: string): string {
  return topic.endsWith(SCENE_TOPIC) ? topic.slice(0, -SCENE_TOPIC.length) : topic;
}

async function callEmpty(session: Session, codec: Codec, service: string): Promise<void> {
  await ask(session, codec, service, 'std_srvs/srv/Empty');
}

async function pictureOf(session: Session, codec: Codec, node: string): Promise<Picture | null> {
  const reply = codec.decode(
    `${PICTURE_TYPE}_Response`,
    await ask(session, codec, `${node}/_get_picture`, PICTURE_TYPE),
  );
  return reply.kind === 'failed' ? null : readPicture(reply.value);
}

/** A service whose request is empty. */
async function ask(session: Session, codec: Codec, service: string, type: string): Promise<Uint8Array> {
  const made = codec.encode(`${type}_Request`, {});
  if (made.kind === 'failed') throw new Error(made.reason);
  const client = session.node().client(service, type);
  try {
    return await client.call(made.bytes);
  } finally {
    client.close();
  }
}
