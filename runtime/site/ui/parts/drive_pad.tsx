// The controls to drive by hand: a round pad for a finger, the mouse and keys, and a button for each direction. They only
// report the direction that is held, with its source.

import { useRef } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import { isRest, keyStick, REST, pointStick } from '../model/twist.ts';
import type { Stick } from '../model/twist.ts';
import { panelTexts } from '../texts_panels.ts';
import { Icon } from './icon.tsx';

export interface DrivePadProps {
  readonly session: Session;
  readonly topic: string;
  /** Where the knob stands. */
  readonly shown: Stick;
  /** `REST`: it is let go. */
  readonly hold: (source: string, stick: Stick) => void;
  readonly release: () => void;
  /** Somebody is about to drive. */
  readonly open: () => void;
}

/** How far the knob goes, in the pad's own units: it is 100 wide. */
const TRAVEL = 32;
/** ms of the site's time. */
const NUDGE_MS = 500;

const BUTTONS = [
  { id: 'ahead', stick: { ahead: 1, turn: 0 }, turned: 'drive-up' },
  { id: 'left', stick: { ahead: 0, turn: 1 }, turned: 'drive-left' },
  { id: 'right', stick: { ahead: 0, turn: -1 }, turned: 'drive-right' },
  { id: 'back', stick: { ahead: -1, turn: 0 }, turned: '' },
] as const;

export function DrivePad({ session, topic, shown, hold, release, open }: DrivePadProps) {
  const pointer = useRef<number | null>(null);
  const keys = useRef(new Set<string>());
  const letGoKeys = (): void => {
    for (const key of keys.current) hold(key, REST);
    keys.current.clear();
  };
  const press = (event: KeyboardEvent, stick: Stick): void => {
    keys.current.add(keyOf(event));
    hold(keyOf(event), stick);
  };
  const point = (event: PointerEvent, element: Element): void => {
    const { left, top, width, height } = element.getBoundingClientRect();
    const radius = (Math.min(width, height) / 100) * TRAVEL;
    hold('pad', pointStick((event.clientX - left - width / 2) / radius, (event.clientY - top - height / 2) / radius));
  };
  const lift = (event: PointerEvent): void => {
    if (event.pointerId !== pointer.current) return;
    pointer.current = null;
    hold('pad', REST);
  };
  const scale = TRAVEL / Math.max(1, Math.hypot(shown.ahead, shown.turn));
  return (
    <div
      class="drive"
      onFocusIn={open}
      onFocusOut={(event) => {
        if (!(event.relatedTarget instanceof Node && event.currentTarget.contains(event.relatedTarget))) letGoKeys();
      }}
      onKeyDown={(event) => {
        // While these are held, the end of another key may not be told.
        if (event.ctrlKey || event.altKey || event.metaKey) {
          letGoKeys();
          return;
        }
        const stick = keyStick(codeOf(event));
        if (stick !== undefined) {
          event.preventDefault();
          press(event, stick);
        } else if (event.key === 'Escape') {
          keys.current.clear();
          release();
        }
      }}
      onKeyUp={(event) => hold(keyOf(event), REST)}
    >
      <div
        class="drive-pad"
        role="application"
        tabIndex={0}
        aria-label={panelTexts.teleop.pad(topic)}
        onKeyDown={(event) => {
          if (event.key !== ' ') return;
          event.preventDefault();
          release();
        }}
        onPointerDown={(event) => {
          if (event.button !== 0 || pointer.current !== null) return;
          event.preventDefault();
          event.currentTarget.focus({ preventScroll: true });
          event.currentTarget.setPointerCapture(event.pointerId);
          pointer.current = event.pointerId;
          point(event, event.currentTarget);
        }}
        onPointerMove={(event) => {
          if (event.pointerId === pointer.current) point(event, event.currentTarget);
        }}
        onPointerUp={lift}
        onPointerCancel={lift}
        onLostPointerCapture={lift}
        onContextMenu={(event) => event.preventDefault()}
      >
        <svg viewBox="-50 -50 100 100" aria-hidden="true" focusable="false">
          <circle class="drive-ground" r="48" />
          <path class="drive-cross" d="M0-40V40M-40 0H40" />
          <circle class={`drive-knob ${isRest(shown) ? '' : 'drive-held'}`} r="13" cx={-shown.turn * scale} cy={-shown.ahead * scale} />
        </svg>
      </div>
      <div class="drive-buttons" role="group" aria-label={panelTexts.teleop.buttons}>
        {BUTTONS.map(({ id, stick, turned }) => (
          <button
            type="button"
            class={`button drive-button drive-at-${id}`}
            aria-label={panelTexts.teleop.directions[id]}
            title={panelTexts.teleop.directions[id]}
            onPointerDown={(event) => {
              if (event.button !== 0) return;
              event.currentTarget.focus({ preventScroll: true });
              event.currentTarget.setPointerCapture(event.pointerId);
              hold(`button ${id}`, stick);
            }}
            onPointerUp={() => hold(`button ${id}`, REST)}
            onPointerCancel={() => hold(`button ${id}`, REST)}
            onLostPointerCapture={() => hold(`button ${id}`, REST)}
            onContextMenu={(event) => event.preventDefault()}
            onKeyDown={(event) => {
              if (event.key !== ' ' && event.key !== 'Enter') return;
              event.preventDefault();
              press(event, stick);
            }}
            onKeyUp={(event) => {
              if (event.key === ' ') event.preventDefault();
            }}
            onBlur={letGoKeys}
            onClick={(event) => {
              // Pressed by software that holds nothing: a short way.
              if (event.detail !== 0) return;
              hold(`nudge ${id}`, stick);
              const end = session.node().timer(NUDGE_MS, () => {
                end.close();
                hold(`nudge ${id}`, REST);
              });
            }}
          >
            <Icon name="down" class={turned} />
          </button>
        ))}
        <button type="button" class="button drive-button drive-at-stop" aria-label={panelTexts.teleop.stop} title={panelTexts.teleop.stop} onClick={release}>
          <Icon name="stop" />
        </button>
      </div>
    </div>
  );
}

/** Keyboards on a screen know no places. */
function codeOf({ code, key }: KeyboardEvent): string {
  return code === '' ? key : code;
}

function keyOf(event: KeyboardEvent): string {
  return `key ${codeOf(event)}`;
}
