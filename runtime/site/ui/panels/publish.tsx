// Publishes messages that are written in a form or as YAML: once, or at a rate in the site's time.
// State: {topic, type, rate, message}, the message as YAML.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { toYaml } from '../../decode/yaml.ts';
import type { DraftText } from '../model/draft_value.ts';
import { isHiddenTopic } from '../model/hidden_names.ts';
import { numberMember, textMember } from '../model/json.ts';
import { problemOf } from '../model/problem.ts';
import { beginDraft, MessageEditor } from '../parts/message_editor.tsx';
import { useCodec } from '../parts/message_feed.ts';
import { NameField } from '../parts/name_field.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { usePublishing } from '../parts/use_publishing.ts';
import type { Publishing } from '../parts/use_publishing.ts';
import { useTopics } from '../parts/watch.ts';
import { WorkProblem } from '../parts/work_problem.tsx';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

const LEAST_RATE = 0.01;
const MOST_RATE = 1000;

/** The names of all message types; a failure goes to `fail`. */
function useMessageTypes(session: Session, fail: (problem: string) => void): readonly string[] {
  const [types, setTypes] = useState<readonly string[]>([]);
  useEffect(() => {
    let current = true;
    session.interfaces().then(
      (all) => {
        if (current) setTypes([...all.keys()].filter((name) => name.includes('/msg/')).sort());
      },
      (error: unknown) => {
        if (current) fail(problemOf(error).what);
      },
    );
    return () => {
      current = false;
    };
  }, [session]);
  return types;
}

/** The draft as YAML; empty while it is as it was at first. */
function draftText(codec: Codec, type: string, draft: DraftText): string | undefined {
  const parsed = codec.types.get(type);
  if (typeof parsed === 'string') return undefined;
  const text = draft.view === 'yaml' ? draft.text : toYaml(draft.value, parsed.shape, null);
  const usual = beginDraft(codec, type);
  const isUntouched = typeof usual !== 'string' && usual.view === 'form' && text === toYaml(usual.value, parsed.shape, null);
  return isUntouched ? '' : text;
}

interface SendRowProps {
  readonly publishing: Publishing;
  readonly isAble: boolean;
  readonly rate: number;
  readonly setRate: (rate: number) => void;
}

function SendRow({ publishing, isAble, rate, setRate }: SendRowProps) {
  const [rateText, setRateText] = useState(String(rate));
  const { isRepeating } = publishing;
  return (
    <div class="work-row">
      <button type="submit" class="button button-main" aria-disabled={isAble ? undefined : 'true'}>
        {panelTexts.publish.once}
      </button>
      <label class="check">
        {panelTexts.publish.rate}
        <input
          type="text"
          inputMode="decimal"
          class="field work-rate"
          value={rateText}
          onInput={(event) => {
            setRateText(event.currentTarget.value);
            const next = Number(event.currentTarget.value);
            if (next >= LEAST_RATE && next <= MOST_RATE) setRate(next);
          }}
        />
      </label>
      <button
        type="button"
        class="button"
        aria-disabled={isAble || isRepeating ? undefined : 'true'}
        onClick={() => {
          if (isAble || isRepeating) publishing.toggle(rate);
        }}
      >
        {isRepeating ? panelTexts.publish.stop : panelTexts.publish.repeat}
      </button>
      <span class="hint">{panelTexts.publish.sent(publishing.sent)}</span>
    </div>
  );
}

export function PublishPanel({ session, state, setState, instance }: PanelProps) {
  const topic = textMember(state, 'topic');
  const type = textMember(state, 'type');
  const rate = numberMember(state, 'rate', LEAST_RATE, MOST_RATE, 10);
  const message = textMember(state, 'message');
  const topics = useTopics(session);
  const codec = useCodec(session);
  const ready = codec === null || typeof codec === 'string' ? null : codec;
  const [draft, setDraft] = useState<DraftText | string>('');
  const publishing = usePublishing(session, ready, topic, type, draft);
  const allTypes = useMessageTypes(session, publishing.setProblem);
  const stored = useRef<string | null>(null);
  const known = topics.find((each) => each.name === topic)?.type ?? '';

  useEffect(() => {
    if (ready === null || type === '') setDraft('');
    // One that a link brings, and not what this panel has stored itself.
    else if (message !== '' && message !== stored.current) setDraft({ view: 'yaml', text: message });
    else if (message === '') setDraft(beginDraft(ready, type));
  }, [codec, type, message]);

  const change = (next: { topic?: string; type?: string; rate?: number; message?: string; }): void =>
    setState({ topic, type, rate, ...(message === '' ? {} : { message }), ...next });
  /** As it is when it is left: not at each key. */
  const store = (): void => {
    if (ready === null || typeof draft === 'string') return;
    const text = draftText(ready, type, draft);
    if (text === undefined) return;
    stored.current = text;
    if (text !== message) change({ message: text });
  };
  const chooseTopic = (name: string): void => {
    const found = topics.find((each) => each.name === name)?.type;
    change({ topic: name, ...(found === undefined || found === '' || found === type ? {} : { type: found, message: '' }) });
  };
  const offers = useMemo(
    () => topics.filter((each) => !isHiddenTopic(each.name)).map((each) => each.name),
    [topics],
  );
  const isAble = ready !== null && topic !== '' && typeof draft !== 'string';

  return (
    <PanelFrame id="publish" title={texts.panels.publish} icon="publish">
      <form
        class="work"
        onSubmit={(event) => {
          event.preventDefault();
          if (isAble) publishing.once();
        }}
      >
        <NameField
          id={`publish-topics-${instance}`}
          words={panelTexts.publish.topic}
          value={topic}
          offers={offers}
          placeholder="/cmd_vel"
          onInput={chooseTopic}
        />
        <NameField
          id={`publish-types-${instance}`}
          words={panelTexts.publish.type}
          value={type}
          offers={allTypes}
          placeholder="geometry_msgs/msg/Twist"
          onInput={(name) => change({ type: name, message: '' })}
        />
        {known !== '' && type !== '' && known !== type ? <p class="hint">{panelTexts.publish.otherType(topic, known)}</p> : null}
        {typeof codec === 'string' ? <p class="hint">{codec}</p> : null}
        {codec === null ? <p class="hint">{texts.starting}</p> : null}
        {typeof draft === 'string' && draft !== '' ? <p class="hint">{draft}</p> : null}
        {typeof draft === 'string' || ready === null ? null : (
          <div onFocusOut={store}>
            <MessageEditor codec={ready} type={type} draft={draft} onChange={setDraft} label={topic === '' ? type : topic} />
          </div>
        )}
        <SendRow
          publishing={publishing}
          isAble={isAble}
          rate={rate}
          setRate={(next) => {
            change({ rate: next });
            publishing.setRate(next);
          }}
        />
        <WorkProblem text={publishing.problem} />
      </form>
    </PanelFrame>
  );
}
