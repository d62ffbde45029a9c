// The contents of an opened topic: its participants with their QoS, and its last message, which can be paused,
// compared with the one before, and used field by field. Loaded when a topic is first opened.

import { useRef, useState } from 'preact/hooks';
import type { Session, TopicView } from '../../contract/session.ts';
import type { Decoded, Decoder } from '../../decode/decoder.ts';
import { copyText } from '../model/clipboard.ts';
import { asNumber, asState, parseFieldPath } from '../model/field_path.ts';
import type { Json } from '../model/json.ts';
import { sameValue } from '../model/message_change.ts';
import { pubCommand } from '../model/pub_command.ts';
import { formatBandwidth, formatCount, formatDuration } from '../model/quantities.ts';
import { DelayWindow, delayOf } from '../model/stamp_delay.ts';
import type { Misfit, TopicEnd } from '../model/topic_qos.ts';
import { texts } from '../texts.ts';
import { topicTexts } from '../texts_topics.ts';
import { CopyButton, IconButton } from './button.tsx';
import { Icon } from './icon.tsx';
import { MenuButton } from './menu.tsx';
import { useCodec } from './message_feed.ts';
import type { TreeChange } from './message_tree.tsx';
import { MessageView } from './message_view.tsx';
import { Misfits } from './misfits.tsx';
import { Name } from './name.tsx';

export interface TopicInsideProps {
  readonly topic: TopicView;
  readonly ends: readonly TopicEnd[];
  readonly misfits: readonly Misfit[];
  readonly session: Session;
  readonly announce: (text: string) => void;
  readonly open: (panel: string, state: Json) => boolean;
}

export function TopicInside(props: TopicInsideProps) {
  const { topic, ends, misfits } = props;
  return (
    <>
      <dl class="facts">
        <Fact name={texts.topics.bandwidth} value={formatBandwidth(topic.bytesPerSecond)} />
        <Fact name={texts.topics.count} value={formatCount(topic.count)} />
      </dl>
      <ul class="topic-parts" role="list" aria-label={topicTexts.ends(topic.name)}>
        {ends.map(({ does, node, qos }, index) => (
          <li key={index}>
            <span class="topic-part">
              <Name text={node} /> <span class="hint-inline">{topicTexts[does]}</span>
            </span>
            <span class="topic-qos">{topicTexts.qos(qos)}</span>
          </li>
        ))}
      </ul>
      <Misfits list={misfits} />
      <LastMessageView {...props} />
    </>
  );
}

function Fact({ name, value }: { readonly name: string; readonly value: string; }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{value}</dd>
    </div>
  );
}

/** A message that was shown. */
interface Shown {
  readonly count: number;
  readonly receivedAt: number;
  readonly size: number;
  readonly decoder: Decoder;
  readonly result: Decoded;
}

interface ShownPair {
  readonly now: Shown;
  readonly before: Shown | null;
}

function LastMessageView({ topic, session, announce, open }: TopicInsideProps) {
  const decoder = useCodec(session);
  // Decoded again when a message came, not at every sample of the rates.
  const newest = useRef<ShownPair | null>(null);
  const [held, setHeld] = useState<ShownPair | null>(null);
  const [mark, setMark] = useState(false);
  const [only, setOnly] = useState(false);
  const [path, setPath] = useState<string | null>(null);
  const value = useRef<unknown>(undefined);
  const delays = useRef(new DelayWindow());
  const last = session.lastMessage(topic.name);
  if (last === undefined) return <p class="hint">{whyNoMessage(topic)}</p>;
  if (decoder === null) return <p class="hint">{texts.topics.decoding}</p>;
  if (typeof decoder === 'string') return <p class="hint">{texts.topics.undecodable(decoder)}</p>;
  const known = newest.current?.now;
  if (known?.count !== last.count || known.decoder !== decoder) {
    const result = decoder.decode(topic.type, last.bytes);
    delays.current.add(delayOf(result, last.receivedAt));
    const now = { count: last.count, receivedAt: last.receivedAt, size: last.bytes.byteLength, decoder, result };
    newest.current = { now, before: known === undefined || known.count === last.count ? null : known };
  }
  const pair = held ?? newest.current;
  if (pair === null) return null;
  const { now, before } = pair;
  const { result } = now;
  if (result.kind === 'failed') return <p class="hint">{texts.topics.undecodable(result.reason)}</p>;
  const size = texts.topics.bytes(formatCount(now.size));
  const ago = texts.topics.ago(formatDuration(session.time.view().now - now.receivedAt));
  const delay = delays.current.get();
  const earlier = before?.result.kind === 'value' ? before.result.value : undefined;
  const change: TreeChange | undefined = mark && earlier !== undefined
    ? { before: earlier, only, was: topicTexts.was, changed: topicTexts.changed }
    : undefined;
  return (
    <MessageView
      title={texts.topics.lastMessage}
      facts={[ago, size, ...(delay === undefined ? [] : [topicTexts.delay(delay)])].join(', ')}
      message={result}
      label={texts.topics.lastOf(topic.name)}
      copyLabel={texts.topics.copy(topic.name)}
      announce={announce}
      change={change}
      choice={{
        topic: topic.name,
        path,
        choose: (next, chosen) => {
          value.current = chosen;
          setPath(next === path ? null : next);
        },
      }}
      tools={
        <>
          <IconButton
            icon={held === null ? 'pause' : 'play'}
            label={held === null ? topicTexts.hold : topicTexts.follow}
            onClick={() => setHeld(held === null ? newest.current : null)}
          />
          <MenuButton
            icon="console"
            label={topicTexts.copyCommand(topic.name)}
            items={[
              { id: 'pub', words: topicTexts.pub, choose: () => copy(pubCommand(topic.name, topic.type, result.value, result.shape), announce) },
              { id: 'echo', words: topicTexts.echo, choose: () => copy(`ros2 topic echo ${topic.name} ${topic.type}`, announce) },
            ]}
          />
        </>
      }
    >
      <div class="message-options">
        <Check
          words={topicTexts.mark}
          on={mark}
          set={(on) => {
            setMark(on);
            if (!on) setOnly(false);
          }}
        />
        <Check
          words={topicTexts.only}
          on={only}
          set={(on) => {
            setOnly(on);
            if (on) setMark(true);
          }}
        />
        {mark ? <span class="message-facts">{compared(now, before, earlier, result.value)}</span> : null}
      </div>
      {path === null
        ? (
          <p class="message-hint">{topicTexts.hint}</p>
        )
        : (
          <FieldBar path={path} value={value.current} open={open} announce={announce} leave={() => setPath(null)} />
        )}
    </MessageView>
  );
}

function compared(now: Shown, before: Shown | null, earlier: unknown, value: unknown): string {
  if (before === null || earlier === undefined) return topicTexts.first;
  const since = topicTexts.since(now.count - before.count);
  return sameValue(earlier, value) ? `${topicTexts.same} (${since})` : since;
}

function Check({ words, on, set }: { readonly words: string; readonly on: boolean; readonly set: (on: boolean) => void; }) {
  return (
    <label class="check">
      <input type="checkbox" checked={on} onChange={(event) => set(event.currentTarget.checked)} />
      <span>{words}</span>
    </label>
  );
}

interface FieldBarProps extends Pick<TopicInsideProps, 'open' | 'announce'> {
  readonly path: string;
  readonly value: unknown;
  readonly leave: () => void;
}

/** Buttons for the field that was chosen. */
function FieldBar({ path, value, open, announce, leave }: FieldBarProps) {
  const readable = parseFieldPath(path) !== null;
  const show = (panel: string) => (): void => {
    open(panel, { paths: [path] });
  };
  return (
    <div class="field-bar" role="group" aria-label={topicTexts.field(path)}>
      <code>{path}</code>
      <CopyButton label={topicTexts.copyPath} words={topicTexts.copyPath} text={() => path} announce={announce} />
      {readable && !Number.isNaN(asNumber(value))
        ? (
          <button type="button" class="button" onClick={show('plot')}>
            <Icon name="plot" />
            {topicTexts.plot}
          </button>
        )
        : null}
      {readable && asState(value) !== undefined
        ? (
          <button type="button" class="button" onClick={show('timeline')}>
            <Icon name="timeline" />
            {topicTexts.states}
          </button>
        )
        : null}
      <IconButton icon="close" label={topicTexts.leave(path)} onClick={leave} />
    </div>
  );
}

function copy(text: string, announce: (text: string) => void): void {
  void copyText(text).then((copied) => announce(copied ? texts.copied : texts.copyFailed));
}

function whyNoMessage(topic: TopicView): string {
  if (topic.count === 0) return texts.topics.noMessage;
  return topic.publishers === 0 ? texts.topics.notKept : texts.topics.fetching;
}
