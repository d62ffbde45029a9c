// Time of the whole site: holds it, lets it run for a chosen while, sets its speed.

import { useState } from 'preact/hooks';
import type { Session, SteppedRun } from '../../contract/session.ts';
import { texts } from '../texts.ts';
import { IconButton } from './button.tsx';
import { useTime } from './watch.ts';

const STEPS_MS = [1, 10, 100, 1000, 10_000] as const;
const RATES = [0.1, 0.25, 0.5, 1, 2, 5, 10] as const;

export function TimeControl({ session }: { readonly session: Session; }) {
  const { time } = session;
  const { state, rate } = useTime(session);
  const [stepMs, setStepMs] = useState<number>(100);
  const held = state !== 'running';
  const rates = RATES.some((each) => each === rate)
    ? RATES
    : [...RATES, rate].sort((a, b) => a - b);
  return (
    <div class="time" role="group" aria-label={texts.time.group} data-state={state}>
      <IconButton
        icon={held ? 'play' : 'pause'}
        label={held ? texts.time.resume : texts.time.pause}
        words={held ? texts.time.resumeShort : texts.time.pauseShort}
        onClick={() => (held ? time.resume() : time.pause())}
      />
      <IconButton
        icon="step"
        label={texts.time.step(texts.time.length(stepMs))}
        words={texts.time.stepShort(texts.time.length(stepMs))}
        onClick={() => time.step(stepMs * 1e6)}
      />
      <select
        class="select time-choice"
        aria-label={texts.time.stepLength}
        title={texts.time.stepLength}
        value={String(stepMs)}
        onChange={(event) => setStepMs(Number(event.currentTarget.value))}
      >
        {STEPS_MS.map((ms) => (
          <option value={String(ms)}>{texts.time.length(ms)}</option>
        ))}
      </select>
      <select
        class="select time-choice"
        aria-label={texts.time.speed}
        title={texts.time.speed}
        value={String(rate)}
        onChange={(event) => time.setRate(Number(event.currentTarget.value))}
      >
        {rates.map((each) => (
          <option value={String(each)}>{texts.time.times(each)}</option>
        ))}
      </select>
      <span class="time-state" role="status">
        {texts.time.state[state]}
      </span>
      {session.stepped === undefined ? null : (
        <Trace stepped={session.stepped} settled={state === 'paused'} />
      )}
    </div>
  );
}

/** The messages that a stepped run has sent, shown while time is paused. */
function Trace({ stepped, settled }: { readonly stepped: SteppedRun; readonly settled: boolean; }) {
  const trace = settled ? stepped.trace() : undefined;
  return (
    <span class="time-state" title={trace?.sha256 ?? ''} data-sha256={trace?.sha256 ?? ''}>
      {trace === undefined
        ? texts.time.seed(stepped.seed)
        : texts.time.trace(stepped.seed, trace.messages, trace.sha256.slice(0, 8))}
    </span>
  );
}
