// The controls of the player: its place, speed, loop, and the published topics with their names.

import { useEffect, useState } from 'preact/hooks';
import type { BagPlayer } from '../../bag/player.ts';
import { playable } from '../../bag/player.ts';
import type { Session } from '../../contract/session.ts';
import { problemOf } from '../model/problem.ts';
import { formatCount, formatDuration } from '../model/quantities.ts';
import { bagTexts as words } from '../texts_bag.ts';
import { IconButton } from './button.tsx';
import { Name } from './name.tsx';
import { ProblemView } from './problem_view.tsx';

export const RATES: readonly number[] = [0.1, 0.25, 0.5, 1, 2, 5, 10];
/** Steps of the slider. */
const STEPS = 1000;
const CLOCK_HZ = 40;

interface Options {
  readonly loop: boolean;
  readonly rate: number;
  readonly clock: boolean;
}

export interface BagPlayerProps {
  readonly session: Session;
  readonly player: BagPlayer;
  readonly options: Options;
  readonly change: (some: Partial<Options & { play: boolean; }>) => void;
  readonly announce: (text: string) => void;
}

export function BagPlayerView({ session, player, options, change, announce }: BagPlayerProps) {
  const { bag } = player;
  const [, setTick] = useState(0);
  const playing = player.state === 'playing';
  useEffect(() => {
    if (!playing) return undefined;
    const timer = setInterval(() => setTick((tick) => tick + 1), 100);
    return () => clearInterval(timer);
  }, [playing]);
  const whole = Number(bag.end - bag.start) / 1e6;
  const place = Number(player.place() - bag.start) / 1e6;
  const held = playing && session.time.view().state === 'paused';
  const at = words.at(timeOf(place), timeOf(whole));
  const rates = RATES.includes(options.rate) ? RATES : [...RATES, options.rate].sort((a, b) => a - b);
  return (
    <section class="bag-player" aria-label={words.player(bag.name)}>
      <p class="bag-facts">
        {`${words.messages(formatCount(bag.messages))}, ${words.began(startOf(bag.start))}`}
      </p>
      {bag.damage === undefined ? null : <p class="hint">{words.damage(bag.damage)}</p>}
      {bag.messages === 0 ? <p class="hint">{words.empty}</p> : null}
      <div class="work-row">
        <IconButton
          icon={playing ? 'pause' : 'play'}
          label={playing ? words.pause : words.play}
          class="bag-play"
          onClick={() => {
            if (playing) player.pause();
            else player.play();
            session.tasks?.acted();
            change({ play: !playing });
          }}
        />
        <input
          type="range"
          class="bag-slider"
          min={0}
          max={STEPS}
          aria-label={words.place}
          aria-valuetext={at}
          value={whole === 0 ? 0 : Math.round((place / whole) * STEPS)}
          onInput={(event) => {
            const share = Number(event.currentTarget.value);
            player.seek(bag.start + ((bag.end - bag.start) * BigInt(share)) / BigInt(STEPS));
          }}
        />
        <span class="bag-time">{at}</span>
      </div>
      <div class="work-row">
        <select
          class="select bag-speed"
          aria-label={words.speed}
          value={String(options.rate)}
          onChange={(event) => {
            const rate = Number(event.currentTarget.value);
            change({ rate });
            player.set({ rate });
          }}
        >
          {rates.map((rate) => (
            <option value={String(rate)}>{words.times(rate)}</option>
          ))}
        </select>
        <label class="check">
          <input
            type="checkbox"
            checked={options.loop}
            onChange={(event) => {
              const loop = event.currentTarget.checked;
              change({ loop });
              player.set({ loop });
            }}
          />
          {words.loop}
        </label>
        <label class="check">
          <input
            type="checkbox"
            checked={options.clock}
            onChange={(event) => {
              const clock = event.currentTarget.checked;
              change({ clock });
              player.set({ clockHz: clock ? CLOCK_HZ : 0 });
            }}
          />
          {words.clock}
        </label>
      </div>
      {held ? <p class="hint">{words.held}</p> : null}
      {player.unsent === 0 ? null : <p class="hint">{words.unsent(player.unsent)}</p>}
      {player.problem === undefined ? null : <ProblemView problem={problemOf(player.problem)} announce={announce} />}
      <TopicTable player={player} />
    </section>
  );
}

function TopicTable({ player }: { readonly player: BagPlayer; }) {
  const { bag } = player;
  const [chosen, setChosen] = useState<readonly string[]>(() => playable(bag));
  const [names, setNames] = useState<ReadonlyMap<string, string>>(new Map());
  const can = new Set(playable(bag));
  const rename = (topic: string, name: string): void => {
    const next = new Map(names);
    if (name === '' || name === topic) next.delete(topic);
    else next.set(topic, name);
    setNames(next);
    player.set({ names: next });
  };
  return (
    <ul class="bag-channels" role="list" aria-label={words.topics}>
      {bag.channels.map(({ id, topic, type, count }) => (
        <li key={id}>
          <label class="check">
            <input
              type="checkbox"
              checked={chosen.includes(topic)}
              disabled={!can.has(topic)}
              onChange={(event) => {
                const next = event.currentTarget.checked ? [...chosen, topic] : chosen.filter((one) => one !== topic);
                setChosen(next);
                player.set({ topics: next });
              }}
            />
            <Name text={topic} />
          </label>
          <span class="bag-facts">{can.has(topic) ? `${type}, ${words.messages(formatCount(count))}` : words.unplayable}</span>
          {can.has(topic)
            ? (
              <span class="bag-as">
                <span class="bag-facts" aria-hidden="true">
                  {words.asShort}
                </span>
                <input
                  type="text"
                  class="field"
                  aria-label={words.as(topic)}
                  value={names.get(topic) ?? topic}
                  autocomplete="off"
                  autocapitalize="off"
                  spellcheck={false}
                  onChange={(event) => rename(topic, event.currentTarget.value.trim())}
                />
              </span>
            )
            : null}
        </li>
      ))}
    </ul>
  );
}

/** `3.2 s`, `1:05`. */
function timeOf(ms: number): string {
  return ms < 60_000 ? `${(Math.max(0, ms) / 1000).toFixed(1)} s` : formatDuration(ms);
}

/** In the visitor's own time. */
function startOf(ns: bigint): string {
  const date = new Date(Number(ns / 1_000_000n));
  return Number.isNaN(date.getTime()) ? `${ns} ns` : date.toLocaleString('en-GB', { dateStyle: 'medium', timeStyle: 'medium' });
}
