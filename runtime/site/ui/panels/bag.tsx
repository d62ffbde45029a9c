// Bags: records topics, and plays what was recorded here, dropped on the page or packed with the site.

import { fileName } from '../../contract/file_name.ts';
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { recordsAll } from '../../bag/recorder.ts';
import { flagMember, member, numberMember, textMember, textsMember } from '../model/json.ts';
import { formatBytes, formatCount, formatDuration } from '../model/quantities.ts';
import { BagPlayerView, RATES } from '../parts/bag_player_view.tsx';
import { type BagDesk, bagDesk, type ShelfBag } from '../parts/bag_desk.ts';
import { IconButton } from '../parts/button.tsx';
import { download } from '../parts/download.ts';
import { takeDrops } from '../parts/dropped_files.ts';
import { Icon } from '../parts/icon.tsx';
import { Name } from '../parts/name.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { ProblemView } from '../parts/problem_view.tsx';
import { useTopics } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import { bagTexts as words } from '../texts_bag.ts';
import type { PanelProps } from './panel_props.ts';

const MOST_CHOSEN = 200;

export interface BagState {
  /** The file of a bag of the site. */
  readonly file: string;
  readonly play: boolean;
  readonly loop: boolean;
  readonly rate: number;
  readonly clock: boolean;
  /** null: all. */
  readonly topics: readonly string[] | null;
  readonly hidden: boolean;
}

export function BagPanel({ session, state, setState, announce }: PanelProps) {
  const desk = bagDesk(session);
  const [, setVersion] = useState(0);
  useEffect(() => desk.onChange(() => setVersion((version) => version + 1)), [desk]);
  useEffect(() => () => desk.leave(), [desk]);
  const options: BagState = {
    file: textMember(state, 'file'),
    play: flagMember(state, 'play', false),
    loop: flagMember(state, 'loop', false),
    rate: numberMember(state, 'rate', RATES[0]!, RATES.at(-1)!, 1),
    clock: flagMember(state, 'clock', false),
    topics: member(state, 'topics') === undefined ? null : textsMember(state, 'topics', MOST_CHOSEN),
    hidden: flagMember(state, 'hidden', false),
  };
  const newest = useRef(options);
  newest.current = options;
  const change = (some: Partial<BagState>): void => {
    const { topics, ...others } = { ...newest.current, ...some };
    newest.current = { topics, ...others };
    setState({ ...others, ...(topics === null ? {} : { topics }) });
  };
  const show = async (bag: ShelfBag, play: boolean): Promise<void> => {
    const { loop, rate, clock } = newest.current;
    const player = await desk.load(bag);
    player?.set({ loop, rate, clockHz: clock ? 40 : 0 });
    if (play) player?.play();
  };
  useEffect(() => {
    const { file, play } = newest.current;
    const named = desk.shelf.find((bag) => bag.origin === 'site' && bag.name === file);
    if (named !== undefined && desk.loaded === undefined) void show(named, play);
    return takeDrops((file) => void show(desk.put(file.name, file, 'file'), false));
  }, [desk]);

  const { player, loaded } = desk;
  return (
    <PanelFrame id="bag" title={texts.panels.bag} icon="bag">
      <div class="work">
        <RecordRow desk={desk} session={session} options={options} change={change} announce={announce} />
        {desk.problem === undefined ? null : <ProblemView problem={desk.problem} announce={announce} />}
        <Shelf
          desk={desk}
          choose={(bag) => {
            change({ file: bag.origin === 'site' ? bag.name : '', play: false });
            void show(bag, false);
          }}
        />
        <Files desk={desk} />
        {loaded !== undefined && player === undefined ? <p class="hint">{words.loading}</p> : null}
        {player === undefined || loaded === undefined ? null : (
          <BagPlayerView
            key={loaded.name}
            session={session}
            player={player}
            options={options}
            change={change}
            announce={announce}
          />
        )}
      </div>
    </PanelFrame>
  );
}

interface RecordRowProps {
  readonly desk: BagDesk;
  readonly session: PanelProps['session'];
  readonly options: BagState;
  readonly change: (some: Partial<BagState>) => void;
  readonly announce: (text: string) => void;
}

function RecordRow({ desk, session, options, change, announce }: RecordRowProps) {
  const { recorder } = desk;
  const [, setTick] = useState(0);
  useEffect(() => {
    if (recorder === undefined) return undefined;
    const timer = setInterval(() => setTick((tick) => tick + 1), 250);
    return () => clearInterval(timer);
  }, [recorder]);
  const all = useTopics(session);
  const names = useMemo(() => all.map(({ name }) => name).filter(recordsAll(options.hidden)).sort(), [all, options.hidden]);
  const { topics, hidden } = options;
  if (recorder !== undefined) {
    const facts = words.recording(
      formatDuration(recorder.durationMs),
      words.messages(formatCount(recorder.messages)),
      recorder.topics,
      formatBytes(recorder.bytes),
    );
    return (
      <div class="work-row bag-recording">
        <button
          type="button"
          class="button"
          onClick={() => {
            void desk.stopRecording().then((bag) => {
              if (bag !== undefined) announce(words.saved(bag.name));
            });
          }}
        >
          <Icon name="stop" />
          {words.stopRecording}
        </button>
        <span class="bag-light" aria-hidden="true" />
        <span class="bag-facts">{facts}</span>
      </div>
    );
  }
  const open = (): void => {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = '.mcap';
    input.addEventListener('change', () => {
      const file = input.files?.[0];
      if (file !== undefined) void desk.load(desk.put(file.name, file, 'file'));
    });
    input.click();
  };
  return (
    <>
      <div class="work-row">
        <button
          type="button"
          class="button button-main"
          onClick={() => {
            const wants = recordsAll(hidden);
            void desk.record(topics === null ? wants : (name) => topics.includes(name));
          }}
        >
          <Icon name="disc" />
          {words.record}
        </button>
        <select
          class="select bag-what"
          aria-label={words.what}
          value={topics === null ? 'all' : 'chosen'}
          onChange={(event) => change({ topics: event.currentTarget.value === 'all' ? null : names.slice(0, MOST_CHOSEN) })}
        >
          <option value="all">{words.all}</option>
          <option value="chosen">{words.chosen}</option>
        </select>
        <label class="check">
          <input type="checkbox" checked={hidden} onChange={(event) => change({ hidden: event.currentTarget.checked })} />
          {words.hidden}
        </label>
        <button type="button" class="button bag-open" onClick={open}>
          {words.open}
        </button>
      </div>
      {topics === null ? null : (
        <fieldset class="bag-topics">
          <legend class="visually-hidden">{words.what}</legend>
          {names.length === 0 ? <p class="hint">{words.noTopics}</p> : null}
          {[...new Set([...names, ...topics])].map((name) => (
            <label class="check">
              <input
                type="checkbox"
                checked={topics.includes(name)}
                onChange={(event) =>
                  change({
                    topics: event.currentTarget.checked
                      ? [...topics, name].slice(0, MOST_CHOSEN)
                      : topics.filter((one) => one !== name),
                  })}
              />
              <Name text={name} />
            </label>
          ))}
        </fieldset>
      )}
    </>
  );
}

function Shelf({ desk, choose }: { readonly desk: BagDesk; readonly choose: (bag: ShelfBag) => void; }) {
  if (desk.shelf.length === 0) return <p class="hint">{words.none}</p>;
  return (
    <ul class="bag-shelf" role="list" aria-label={words.shelf}>
      {desk.shelf.map((bag) => (
        <li key={bag.name}>
          <button
            type="button"
            class="bag-choose"
            aria-pressed={desk.loaded === bag}
            onClick={() => choose(bag)}
          >
            <span class="bag-name">{bag.name}</span>
            <span class="bag-facts">{`${formatBytes(bag.size)}, ${words.origin[bag.origin]}`}</span>
          </button>
          <IconButton
            icon="down"
            label={words.save(bag.name)}
            onClick={() => {
              bag.content().then((blob) => download(bag.name, blob), (error: unknown) => desk.fail(error));
            }}
          />
          {bag.origin === 'site' ? null : (
            <IconButton icon="clear" label={words.remove(bag.name)} onClick={() => desk.remove(bag)} />
          )}
        </li>
      ))}
    </ul>
  );
}

function Files({ desk }: { readonly desk: BagDesk; }) {
  if (desk.files.length === 0) return null;
  return (
    <>
      <h3>{words.files}</h3>
      <ul class="bag-shelf" role="list" aria-label={words.files}>
        {desk.files.map((file) => {
          const name = `${file.node}: ${file.path}`;
          return (
            <li key={name}>
              <span class="bag-choose">
                <span class="bag-name">{name}</span>
                <span class="bag-facts">{formatBytes(file.content.size)}</span>
              </span>
              <IconButton icon="down" label={words.save(name)} onClick={() => download(fileName(file.path), file.content)} />
              <IconButton icon="clear" label={words.remove(name)} onClick={() => desk.forget(file)} />
            </li>
          );
        })}
      </ul>
    </>
  );
}
