// Sliders for the joints of a robot description, published as sensor_msgs/msg/JointState ten times a second, as
// joint_state_publisher_gui does; while they are not published, they follow what others publish on the topic.
// State: {topic, description, on}.

import { useEffect, useRef, useState } from 'preact/hooks';
import { stampOf } from '../model/draft_value.ts';
import { flagMember, member, textMember } from '../model/json.ts';
import { jointPositions, readJointState, readJoints } from '../model/joints.ts';
import type { Joint } from '../model/joints.ts';
import { IconButton } from '../parts/button.tsx';
import { feed, useCodec } from '../parts/message_feed.ts';
import { Name } from '../parts/name.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { useTopics } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import { sceneTexts } from '../texts_scene.ts';
import type { PanelProps } from './panel_props.ts';

const TYPE = 'sensor_msgs/msg/JointState';
const PERIOD_MS = 100;
const STEPS = 1000;
const OWN_NODE = 1;

export function JointsPanel({ session, state, setState }: PanelProps) {
  const topic = textMember(state, 'topic', '/joint_states');
  const description = textMember(state, 'description', '/robot_description');
  const codec = useCodec(session);
  const ready = codec === null || typeof codec === 'string' ? null : codec;
  const topics = useTopics(session);
  const others = topics.find(({ name }) => name === topic)?.publishers ?? 0;
  const targets = [...new Set(['/joint_states', topic, ...topics.filter(({ type }) => type === TYPE).map(({ name }) => name)])];
  const [joints, setJoints] = useState<readonly Joint[]>([]);
  const [problem, setProblem] = useState('');
  const [set, setSet] = useState<ReadonlyMap<string, number>>(new Map());
  /** Positions by the last messages of others, by joint. */
  const [heard, setHeard] = useState<ReadonlyMap<string, number>>(new Map());
  const publishing = useRef(false);
  // While somebody else says where the joints are, nothing is said over them unasked.
  const isOn = flagMember(state, 'on', publishing.current || others === 0);
  const latest = useRef({ joints, set });
  latest.current = { joints, set };

  useEffect(() => {
    if (ready === null) return undefined;
    setJoints([]);
    return feed(session, ready, description, ({ decoded }) => {
      const text = decoded.kind === 'failed' ? undefined : member(decoded.value, 'data');
      const found = typeof text === 'string' ? readJoints(text) : null;
      setProblem(found === null ? sceneTexts.joints.noRobot(description) : '');
      setJoints(found ?? []);
    });
  }, [session, ready, description]);

  const hasJoints = joints.length > 0;
  useEffect(() => {
    if (ready === null || isOn || !hasJoints) return undefined;
    const positions = new Map<string, number>();
    let frame = 0;
    const close = feed(session, ready, topic, ({ decoded }) => {
      if (decoded.kind === 'failed') return;
      for (const [joint, position] of readJointState(decoded.value)) positions.set(joint, position);
      // Once per picture: a robot says it a hundred times a second.
      if (frame === 0) {
        frame = requestAnimationFrame(() => {
          frame = 0;
          setHeard(new Map(positions));
        });
      }
    });
    return () => {
      close();
      cancelAnimationFrame(frame);
    };
  }, [session, ready, topic, isOn, hasJoints]);

  useEffect(() => {
    if (ready === null || !isOn || !hasJoints) return undefined;
    const publisher = session.node().publisher(topic, TYPE);
    publishing.current = true;
    const tell = (): void => {
      const { joints: all, set: positions } = latest.current;
      const made = ready.encode(TYPE, {
        header: { stamp: stampOf(session.time.view().now), frame_id: '' },
        name: all.map(({ name }) => name),
        position: [...jointPositions(all, positions)],
        velocity: [],
        effort: [],
      });
      const fault = publisher.problem?.message ?? (made.kind === 'bytes' ? publisher.publish(made.bytes)?.message : made.reason);
      setProblem(fault === undefined ? '' : panelTexts.text.failed(fault));
    };
    const timer = session.node().timer(PERIOD_MS, tell);
    return () => {
      timer.close();
      publisher.close();
      publishing.current = false;
    };
  }, [session, ready, topic, isOn, hasJoints]);

  const shown = isOn ? set : heard;
  const move = (positions: ReadonlyMap<string, number>): void => {
    setSet(positions);
    if (!isOn) setState({ topic, description, on: true });
  };
  const free = joints.filter(({ mimic }) => mimic === null);
  const positions = jointPositions(joints, shown);
  const isAlone = others - (isOn ? OWN_NODE : 0) <= 0;
  return (
    <PanelFrame
      id="joints"
      title={texts.panels.joints}
      icon="sliders"
      tools={hasJoints
        ? (
          <>
            <select
              class="select"
              aria-label={sceneTexts.joints.topic}
              value={topic}
              onChange={(event) => setState({ topic: event.currentTarget.value, description, on: isOn })}
            >
              {targets.map((name) => <option key={name} value={name}>{name}</option>)}
            </select>
            <label class="check">
              <input
                type="checkbox"
                checked={isOn}
                onChange={(event) => setState({ topic, description, on: event.currentTarget.checked })}
              />
              {sceneTexts.joints.publish}
            </label>
            <IconButton icon="home" label={sceneTexts.joints.center} onClick={() => move(new Map())} />
            <IconButton
              icon="restart"
              label={sceneTexts.joints.randomize}
              onClick={() => move(new Map(free.map(({ name, least, most }) => [name, least + Math.random() * (most - least)])))}
            />
          </>
        )
        : undefined}
    >
      {problem === '' ? null : <p class="hint" role="alert">{problem}</p>}
      {!hasJoints && problem === '' ? <p class="hint">{sceneTexts.joints.waiting(description)}</p> : null}
      {hasJoints && !isAlone ? <p class="hint">{isOn ? sceneTexts.joints.others(topic) : sceneTexts.joints.follows(topic)}</p> : null}
      <div class="joints">
        {joints.map((joint, index) => (
          <JointRow
            key={joint.name}
            joint={joint}
            position={positions[index] ?? 0}
            move={(position) => move(new Map(shown).set(joint.name, position))}
          />
        ))}
      </div>
    </PanelFrame>
  );
}

interface JointRowProps {
  readonly joint: Joint;
  readonly position: number;
  readonly move: (position: number) => void;
}

function JointRow({ joint: { name, least, most, isSliding, mimic }, position, move }: JointRowProps) {
  const unit = isSliding ? 'm' : 'rad';
  const bounded = (value: number): void => {
    if (Number.isFinite(value)) move(Math.max(least, Math.min(most, value)));
  };
  return (
    <div class="joint">
      <span class="joint-name">
        <Name text={name} />
      </span>
      {mimic === null
        ? (
          <>
            <input
              type="range"
              aria-label={name}
              min={least}
              max={most}
              step={(most - least) / STEPS}
              value={position}
              onInput={(event) => bounded(event.currentTarget.valueAsNumber)}
            />
            <input
              class="field joint-number"
              type="number"
              aria-label={sceneTexts.joints.position(name, unit)}
              min={least}
              max={most}
              step="any"
              value={Number(position.toFixed(3))}
              onChange={(event) => bounded(event.currentTarget.valueAsNumber)}
            />
          </>
        )
        : (
          <span class="joint-mimic">{sceneTexts.joints.mimics(mimic.joint, position.toFixed(3), unit)}</span>
        )}
    </div>
  );
}
