// The topics of the graph: who writes and reads, how often, whose QoS does not fit, and the last message of each opened
// one. State: {topic}, one that another panel asked for.

import { useEffect, useMemo, useState } from 'preact/hooks';
import type { TopicView } from '../../contract/session.ts';
import { isHiddenTopic } from '../model/hidden_names.ts';
import { textMember } from '../model/json.ts';
import { readPreference, writePreference } from '../model/preferences.ts';
import { formatRate } from '../model/quantities.ts';
import { misfitsOf, topicEndsOf } from '../model/topic_qos.ts';
import type { Misfit, TopicEnd } from '../model/topic_qos.ts';
import { GraphRow } from '../parts/graph_row.tsx';
import { Icon } from '../parts/icon.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { SearchField } from '../parts/search_field.tsx';
import { useLoaded } from '../parts/use_loaded.ts';
import { useGraph, useTopics } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import type { PanelProps } from './panel_props.ts';

/** A filter is worth its room from this many topics on. */
const FILTER_FROM = 8;

const NOBODY: readonly TopicEnd[] = [];

export function TopicsPanel({ session, store, announce, state, setState, open }: PanelProps) {
  const topics = useTopics(session);
  const graph = useGraph(session);
  const ends = useMemo(() => topicEndsOf(graph), [graph]);
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
        topic.name.toLowerCase().includes(text.toLowerCase())
        || topic.type.toLowerCase().includes(text.toLowerCase()),
    )
    .toSorted((a, b) => (a.name < b.name ? -1 : 1));
  const toggle = (name: string): void => {
    const next = new Set(opened);
    if (!next.delete(name)) next.add(name);
    // It can be asked for again.
    else if (name === asked) setState(null);
    setOpened(next);
  };

  const empty = topics.length === 0
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
      {allowed.length < FILTER_FROM && text === '' ? null : (
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
            ends={ends.get(topic.name) ?? NOBODY}
            open={opened.has(topic.name)}
            asked={topic.name === asked}
            onToggle={() => toggle(topic.name)}
            session={session}
            announce={announce}
            openPanel={open}
          />
        ))}
      </ul>
    </PanelFrame>
  );
}

interface TopicRowProps extends Pick<PanelProps, 'session' | 'announce'> {
  readonly topic: TopicView;
  readonly ends: readonly TopicEnd[];
  readonly open: boolean;
  /** Comes into sight. */
  readonly asked: boolean;
  readonly onToggle: () => void;
  readonly openPanel: PanelProps['open'];
}

function TopicRow({ topic, ends, open, asked, onToggle, session, announce, openPanel }: TopicRowProps) {
  const misfits = useMemo<readonly Misfit[]>(() => misfitsOf(ends), [ends]);
  const code = useLoaded(open, () => import('../parts/topic_inside.tsx'));
  const flow = (
    <>
      <span class="topic-rate">{formatRate(topic.rateHz)}</span>
      {misfits.length === 0 ? null : (
        <span class="topic-misfits">
          <Icon name="warning" />
          {texts.topics.misfits(misfits.length)}
        </span>
      )}
      <span class="topic-ends">
        <span class="visually-hidden">
          {texts.topics.publishers(topic.publishers)}, {texts.topics.subscriptions(topic.subscriptions)}
        </span>
        <span aria-hidden="true">
          {topic.publishers} {texts.topics.publishersShort} {'\u2192'} {topic.subscriptions} {texts.topics.subscriptionsShort}
        </span>
      </span>
    </>
  );
  const inside = () =>
    code === null
      ? (
        <p class="hint">{texts.topics.decoding}</p>
      )
      : (
        <code.TopicInside topic={topic} ends={ends} misfits={misfits} session={session} announce={announce} open={openPanel} />
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
