// Drives a robot by hand: keys, buttons, a joystick for finger or mouse, a gamepad. Whatever lets go (a key, the focus,
// the page, the panel) stops the robot. State: {topic, stamped, frame, linear, angular, rate, gamepad}.

import { useEffect, useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { expandName } from '../../decode/ros_names.ts';
import { wantedGamepads } from '../model/gamepads.ts';
import { flagMember, member, numberMember, textMember } from '../model/json.ts';
import { driveTopics, isRest, REST, TWIST, TWIST_STAMPED, padStick, sumOf } from '../model/twist.ts';
import type { Stick } from '../model/twist.ts';
import { DrivePad } from '../parts/drive_pad.tsx';
import { GamepadField } from '../parts/gamepad_field.tsx';
import { useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { useLetGo } from '../parts/use_let_go.ts';
import { TwistSender } from '../parts/twist_sender.ts';
import { useGraph, useTopics } from '../parts/watch.ts';
import { WorkProblem } from '../parts/work_problem.tsx';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

const MOST_SPEED = 1000;
const LEAST_RATE = 0.1;
const MOST_RATE = 200;
const MOST_NAME = 300;

export function TeleopPanel({ session, state, setState, instance }: PanelProps) {
  const graph = useGraph(session);
  const drives = useMemo(() => driveTopics(graph), [graph]);
  const codec = useCodec(session);
  const written = fullName(textMember(state, 'topic').slice(0, MOST_NAME));
  const topic = written !== '' ? written : (drives[0]?.name ?? '/cmd_vel');
  const waiting = drives.filter(({ name }) => name === topic);
  const stamped = typeof member(state, 'stamped') === 'boolean' ? flagMember(state, 'stamped', false) : waiting[0]?.stamped === true;
  const frame = textMember(state, 'frame').slice(0, MOST_NAME);
  const linear = numberMember(state, 'linear', 0, MOST_SPEED, 0.5);
  const angular = numberMember(state, 'angular', 0, MOST_SPEED, 1);
  const rate = numberMember(state, 'rate', LEAST_RATE, MOST_RATE, 10);
  const usesPad = flagMember(state, 'gamepad', true);
  const [problem, setProblem] = useState('');
  /** The text that is being typed as topic, but is not the topic yet. */
  const [typed, setTyped] = useState<string | undefined>(undefined);
  const [shown, setShown] = useState<Stick>(REST);
  const sender = useRef<TwistSender | null>(null);
  const held = useRef(new Map<string, Stick>());
  const ready = codec !== null && typeof codec !== 'string';

  const change = (next: Readonly<Record<string, string | number | boolean>>): void =>
    setState({
      ...(written === '' ? {} : { topic: written }),
      ...(typeof member(state, 'stamped') === 'boolean' ? { stamped } : {}),
      frame,
      linear,
      angular,
      rate,
      gamepad: usesPad,
      ...next,
    });
  const tell = (): void => {
    const now = sumOf(held.current.values());
    sender.current?.hold(now);
    setShown((before) => (before.ahead === now.ahead && before.turn === now.turn ? before : now));
  };
  /** A robot that comes later does not take over from the one that is driven. */
  const pin = (): void => {
    if (written === '' && drives.length > 0) change({ topic });
  };
  const hold = (source: string, stick: Stick): void => {
    if (isRest(stick)) {
      held.current.delete(source);
    } else {
      held.current.set(source, stick);
      pin();
    }
    tell();
  };
  const release = (): void => {
    held.current.clear();
    tell();
  };

  // At once: who turns to the pad now drives what is shown.
  useLayoutEffect(() => {
    if (!ready) return undefined;
    const made = new TwistSender(session, codec, { topic, stamped, frame }, setProblem);
    sender.current = made;
    setProblem('');
    return () => {
      // The robot stands still before another one is driven.
      release();
      sender.current = null;
      made.close();
    };
  }, [session, codec, topic, stamped, frame]);
  useLayoutEffect(() => {
    if (sender.current === null) return;
    sender.current.limits = { linear, angular };
    sender.current.rateHz = rate;
    sender.current.pace();
    // A key may be held since before the types were loaded.
    tell();
  }, [session, codec, topic, stamped, frame, linear, angular, rate]);
  useLetGo(release);
  /** A node drives by the gamepad: two would disagree. */
  const isForNode = wantedGamepads(useTopics(session)).length > 0;
  const pad = useGamepad(usesPad && !isForNode, (stick) => hold('gamepad', stick));

  const open = (): void => {
    sender.current?.open();
    pin();
  };
  const type = stamped ? TWIST_STAMPED : TWIST;
  const heard = waiting.some((each) => each.stamped === stamped);
  return (
    <PanelFrame id="teleop" title={texts.panels.teleop} icon="drive">
      <div class="work">
        {typeof codec === 'string' ? <p class="hint">{codec}</p> : null}
        {codec === null ? <p class="hint">{texts.starting}</p> : null}
        <DrivePad session={session} shown={shown} hold={hold} release={release} open={open} topic={topic} />
        <p class="drive-now">
          <span>{panelTexts.teleop.speed(shown.ahead * linear, shown.turn * angular)}</span>
          <span class="hint">{isRest(shown) ? panelTexts.teleop.silent : panelTexts.teleop.sending(topic)}</span>
        </p>
        <WorkProblem text={problem} />
        {heard ? null : <p class="hint">{panelTexts.teleop.unheard(topic, type)}</p>}
        <label class="editor-field">
          <span class="editor-name">{panelTexts.publish.topic}</span>
          <input
            type="text"
            class="field"
            list={`teleop-topics-${instance}`}
            value={typed ?? topic}
            autocomplete="off"
            autocapitalize="off"
            spellcheck={false}
            onInput={(event) => setTyped(event.currentTarget.value)}
            onBlur={() => setTyped(undefined)}
            onChange={(event) => {
              setTyped(undefined);
              const name = fullName(event.currentTarget.value.trim());
              const found = drives.find((each) => each.name === name);
              change({ topic: name, ...(found === undefined ? {} : { stamped: found.stamped }) });
            }}
          />
        </label>
        <datalist id={`teleop-topics-${instance}`}>
          {[...new Set(drives.map(({ name }) => name))].map((name) => (
            <option key={name} value={name} />
          ))}
        </datalist>
        <NumberField
          label={panelTexts.teleop.linear}
          value={linear}
          least={0}
          most={MOST_SPEED}
          onNumber={(value) => change({ linear: value })}
        />
        <NumberField
          label={panelTexts.teleop.angular}
          value={angular}
          least={0}
          most={MOST_SPEED}
          onNumber={(value) => change({ angular: value })}
        />
        <NumberField
          label={panelTexts.publish.rate}
          value={rate}
          least={LEAST_RATE}
          most={MOST_RATE}
          onNumber={(value) => change({ rate: value })}
        />
        <div class="work-row">
          <label class="check">
            <input type="checkbox" checked={stamped} onChange={(event) => change({ stamped: event.currentTarget.checked })} />
            {panelTexts.teleop.stamped}
          </label>
          <GamepadField pad={pad} isForNode={isForNode} isUsed={usesPad} onUse={(gamepad) => change({ gamepad })} />
        </div>
        {stamped
          ? (
            <label class="editor-field">
              <span class="editor-name">{panelTexts.teleop.frame}</span>
              <input
                type="text"
                class="field"
                value={frame}
                autocomplete="off"
                autocapitalize="off"
                spellcheck={false}
                onChange={(event) => change({ frame: event.currentTarget.value })}
              />
            </label>
          )
          : null}
      </div>
    </PanelFrame>
  );
}

function fullName(name: string): string {
  return name === '' ? '' : expandName(name, '');
}

/** A frame around the page may forbid them. */
function firstGamepad(): Gamepad | null {
  try {
    return navigator.getGamepads().find((each) => each?.connected === true) ?? null;
  } catch {
    return null;
  }
}

/** The name of the gamepad that is used; empty: none. It is looked at once per frame, and says nothing while the page is not looked at. */
function useGamepad(used: boolean, tell: (stick: Stick) => void): string {
  const [name, setName] = useState('');
  const newest = useRef(tell);
  newest.current = tell;
  useEffect(() => {
    let frame = 0;
    let last: Stick = REST;
    const look = (): void => {
      frame = 0;
      const pad = firstGamepad();
      setName(pad?.id ?? '');
      const stick = pad !== null && used && document.hasFocus() ? padStick(pad) : REST;
      if (!(isRest(stick) && isRest(last))) newest.current(stick);
      last = stick;
      if (pad !== null && used) frame = requestAnimationFrame(look);
    };
    const begin = (): void => {
      if (frame === 0) look();
    };
    begin();
    window.addEventListener('gamepadconnected', begin);
    window.addEventListener('gamepaddisconnected', begin);
    return () => {
      cancelAnimationFrame(frame);
      window.removeEventListener('gamepadconnected', begin);
      window.removeEventListener('gamepaddisconnected', begin);
      if (!isRest(last)) newest.current(REST);
    };
  }, [used]);
  return name;
}

interface NumberFieldProps {
  readonly label: string;
  readonly value: number;
  readonly least: number;
  readonly most: number;
  readonly onNumber: (value: number) => void;
}

/** Keeps what is typed while it is not a number that is allowed. */
function NumberField({ label, value, least, most, onNumber }: NumberFieldProps) {
  const [draft, setDraft] = useState<string | null>(null);
  return (
    <label class="editor-field">
      <span class="editor-name">{label}</span>
      <input
        type="text"
        inputMode="decimal"
        class="field"
        autocomplete="off"
        aria-invalid={draft !== null && Number(draft) !== value}
        value={draft ?? String(value)}
        onInput={(event) => {
          const text = event.currentTarget.value;
          setDraft(text);
          const number = text.trim() === '' ? NaN : Number(text);
          if (number >= least && number <= most) onNumber(number);
        }}
        onBlur={() => setDraft(null)}
      />
    </label>
  );
}
