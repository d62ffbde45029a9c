// The topics of the graph: who writes and reads, how often, and the last message of each opened one. State: {topic}, one
// that another panel asked for.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { QosView, TopicView } from '../../wasm_js/session.ts';
import type { Decoded, Decoder } from '../../decode/decoder.ts';
import { isHiddenTopic } from '../model/hidden_names.ts';
import { textMember } from '../model/json.ts';
import { readPreference, writePreference } from '../model/preferences.ts';
import { formatBandwidth, formatCount, formatDuration, formatRate } from '../model/quantities.ts';
import { GraphRow } from '../parts/graph_row.tsx';
import { useCodec } from '../parts/message_feed.ts';
import { MessageView } from '../parts/message_view.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { SearchField } from '../parts/search_field.tsx';
import { useTopics } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import type { PanelProps } from './panel_props.ts';

/** A filter is worth its room from this many topics on. */
const kFilterFrom = 8;

export function TopicsPanel({ session, store, announce, state, setState }: PanelProps) {
  const topics = useTopics(session);
  const [hidden, setHidden] = useState(
    () => readPreference(store, 'hiddenTopics', ['yes', 'no'], 'no') === 'yes',
  );
  const [text, setText] = useState('');
  const [opened, setOpened] = useState<ReadonlySet<string>>(new Set());

  const asked = textMember(state, 'topic');
  useEffect(() => {
    if (asked === '') return;
    setText('');
    setOpened((before) => new Set([...before, asked]));
  }, [asked]);

  const allowed = topics.filter((topic) => hidden || topic.name === asked || !isHiddenTopic(topic.name));
  const shown = allowed
    .filter(
      (topic) =>
        topic.name.toLowerCase().includes(text.toLowerCase()) ||
        topic.type.toLowerCase().includes(text.toLowerCase()),
    )
    .toSorted((a, b) => (a.name < b.name ? -1 : 1));
  const toggle = (name: string): void => {
    const next = new Set(opened);
    if (!next.delete(name)) next.add(name);
    // It can be asked for again.
    else if (name === asked) setState(null);
    setOpened(next);
  };

  const empty =
    topics.length === 0
      ? texts.topics.none
      : allowed.length === 0
        ? texts.topics.noneShown
        : texts.topics.noneMatch;
  const tools = (
    <>
      <label class="check" title={texts.topics.hidden}>
        <input
          type="checkbox"
          checked={hidden}
          aria-label={texts.topics.hidden}
          onChange={(event) => {
            setHidden(event.currentTarget.checked);
            writePreference(store, 'hiddenTopics', event.currentTarget.checked ? 'yes' : 'no');
          }}
        />
        <span aria-hidden="true">{texts.topics.hiddenShort}</span>
      </label>
      {allowed.length < kFilterFrom && text === '' ? null : (
        <SearchField value={text} label={texts.topics.filter} onText={setText} />
      )}
    </>
  );
  return (
    <PanelFrame
      id="topics"
      title={texts.panels.topics}
      icon="topics"
      note={allowed.length === 0 ? '' : String(allowed.length)}
      tools={tools}
    >
      {shown.length === 0 ? <p class="hint">{empty}</p> : null}
      <ul class="topics" role="list">
        {shown.map((topic) => (
          <TopicRow
            key={topic.name}
            topic={topic}
            open={opened.has(topic.name)}
            asked={topic.name === asked}
            onToggle={() => toggle(topic.name)}
            session={session}
            announce={announce}
          />
        ))}
      </ul>
    </PanelFrame>
  );
}

interface TopicRowProps extends Pick<PanelProps, 'session' | 'announce'> {
  readonly topic: TopicView;
  readonly open: boolean;
  /** Comes into sight. */
  readonly asked: boolean;
  readonly onToggle: () => void;
}

function TopicRow({ topic, open, asked, onToggle, session, announce }: TopicRowProps) {
  const flow = (
    <>
      <span class="topic-rate">{formatRate(topic.rateHz)}</span>
      <span class="topic-ends">
        <span class="visually-hidden">
          {texts.topics.publishers(topic.publishers)},{' '}
          {texts.topics.subscriptions(topic.subscriptions)}
        </span>
        <span aria-hidden="true">
          {topic.publishers} {texts.topics.publishersShort} {'\u2192'} {topic.subscriptions}{' '}
          {texts.topics.subscriptionsShort}
        </span>
      </span>
    </>
  );
  const inside = () => (
    <>
      <dl class="facts">
        <Fact name={texts.topics.bandwidth} value={formatBandwidth(topic.bytesPerSecond)} />
        <Fact name={texts.topics.count} value={formatCount(topic.count)} />
        {topic.qos.map((qos) => (
          <Fact name={texts.topics.qos} value={qosWords(qos)} />
        ))}
      </dl>
      <LastMessageView topic={topic} session={session} announce={announce} />
    </>
  );
  return (
    <GraphRow
      id={`topic-${encodeURIComponent(topic.name)}`}
      name={topic.name}
      type={topic.type}
      flow={flow}
      open={open}
      asked={asked}
      onToggle={onToggle}
      inside={inside}
    />
  );
}

function Fact({ name, value }: { readonly name: string; readonly value: string }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{value}</dd>
    </div>
  );
}

function LastMessageView({
  topic,
  session,
  announce,
}: Pick<TopicRowProps, 'topic' | 'session' | 'announce'>) {
  const decoder = useCodec(session);
  // Decoded again when a message came, not at every sample of the rates.
  const decoded = useRef<{
    readonly count: number;
    readonly decoder: Decoder;
    readonly result: Decoded;
  } | null>(null);
  const last = session.lastMessage(topic.name);
  if (last === undefined) return <p class="hint">{whyNoMessage(topic)}</p>;
  if (decoder === null) return <p class="hint">{texts.topics.decoding}</p>;
  if (typeof decoder === 'string') return <p class="hint">{texts.topics.undecodable(decoder)}</p>;
  if (decoded.current?.count !== last.count || decoded.current.decoder !== decoder) {
    decoded.current = {
      count: last.count,
      decoder,
      result: decoder.decode(topic.type, last.bytes),
    };
  }
  const result = decoded.current.result;
  if (result.kind === 'failed') return <p class="hint">{texts.topics.undecodable(result.reason)}</p>;
  const size = texts.topics.bytes(formatCount(last.bytes.byteLength));
  const ago = texts.topics.ago(formatDuration(session.time.view().now - last.receivedAt));
  return (
    <MessageView
      title={texts.topics.lastMessage}
      facts={`${ago}, ${size}`}
      message={result}
      label={texts.topics.lastOf(topic.name)}
      copyLabel={texts.topics.copy(topic.name)}
      announce={announce}
    />
  );
}

function whyNoMessage(topic: TopicView): string {
  if (topic.count === 0) return texts.topics.noMessage;
  return topic.publishers === 0 ? texts.topics.notKept : texts.topics.fetching;
}

function qosWords(qos: QosView): string {
  const words = texts.topics.qosWords;
  const history = qos.history === 'keep_last' ? words.keep_last(qos.depth) : words.keep_all;
  return [words[qos.reliability], words[qos.durability], history].join(', ');
}
