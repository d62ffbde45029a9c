// Publishes messages that are written in a form or as YAML: once, or at a rate in the site's time.
// State: {topic, type, rate, message}, the message as YAML.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { PagePublisher, PageTimer } from '../../contract/session.ts';
import { draftBytes, refusal } from '../model/draft_value.ts';
import { toYaml } from '../../decode/yaml.ts';
import type { DraftText } from '../model/draft_value.ts';
import { isHiddenTopic } from '../model/hidden_names.ts';
import { numberMember, textMember } from '../model/json.ts';
import { problemOf } from '../model/problem.ts';
import { beginDraft, MessageEditor } from '../parts/message_editor.tsx';
import { useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { useTopics } from '../parts/watch.ts';
import { WorkProblem } from '../parts/work_problem.tsx';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

const kMostRate = 1000;

/** A publisher of one topic and type, and what publishes on it: all ends together. */
interface Outlet {
  readonly publisher: PagePublisher;
  timer: PageTimer | undefined;
}

export function PublishPanel({ session, state, setState, instance }: PanelProps) {
  const topic = textMember(state, 'topic');
  const type = textMember(state, 'type');
  const rate = numberMember(state, 'rate', 0.01, kMostRate, 10);
  const message = textMember(state, 'message');
  const [rateText, setRateText] = useState(String(rate));
  const topics = useTopics(session);
  const [allTypes, setAllTypes] = useState<readonly string[]>([]);
  const codec = useCodec(session);
  const [draft, setDraft] = useState<DraftText | string>('');
  const [problem, setProblem] = useState('');
  const [sent, setSent] = useState(0);
  const [running, setRunning] = useState(false);
  const outlet = useRef<Outlet | null>(null);
  const newest = useRef(draft);
  newest.current = draft;
  const kept = useRef<string | null>(null);
  const known = topics.find((each) => each.name === topic)?.type ?? '';
  const ready = codec !== null && typeof codec !== 'string';

  useEffect(() => {
    let current = true;
    session.interfaces().then(
      (all) => {
        if (current) setAllTypes([...all.keys()].filter((name) => name.includes('/msg/')).sort());
      },
      (error: unknown) => {
        if (current) setProblem(problemOf(error).what);
      },
    );
    return () => {
      current = false;
    };
  }, [session]);

  const shut = (): void => {
    outlet.current?.timer?.close();
    outlet.current?.publisher.close();
    outlet.current = null;
    setRunning(false);
  };
  // Nothing goes on on a topic or type that is not shown any more.
  useEffect(() => {
    setSent(0);
    setProblem('');
    return shut;
  }, [session, topic, type]);
  useEffect(() => {
    if (!ready || type === '') setDraft('');
    // One that a link brings, and not what this panel has kept itself.
    else if (message !== '' && message !== kept.current) setDraft({ view: 'yaml', text: message });
    else if (message === '') setDraft(beginDraft(codec, type));
  }, [codec, type, message]);
  /** As it is when it is left: not at each key. */
  const keep = (): void => {
    if (!ready || typeof draft === 'string') return;
    const parsed = codec.types.get(type);
    if (typeof parsed === 'string') return;
    const text = draft.view === 'yaml' ? draft.text : toYaml(draft.value, parsed.shape, null);
    const usual = beginDraft(codec, type);
    const untouched = typeof usual !== 'string' && usual.view === 'form' && text === toYaml(usual.value, parsed.shape, null);
    kept.current = untouched ? '' : text;
    if (kept.current !== message) change({ message: kept.current });
  };

  const change = (next: { topic?: string; type?: string; rate?: number; message?: string }): void =>
    setState({ topic, type, rate, ...(message === '' ? {} : { message }), ...next });
  const chooseTopic = (name: string): void => {
    const found = topics.find((each) => each.name === name)?.type;
    change({ topic: name, ...(found === undefined || found === '' || found === type ? {} : { type: found, message: '' }) });
  };

  const send = async (through: Outlet): Promise<void> => {
    const message = newest.current;
    if (!ready || typeof message === 'string') return;
    const made = await draftBytes(codec, type, message, session.time.view().now);
    if (outlet.current !== through) return;
    const refused = made.kind === 'failed' ? refusal(made) : through.publisher.publish(made.bytes)?.message;
    setProblem(refused ?? '');
    if (refused === undefined) setSent((count) => count + 1);
  };
  const publish = (through: Outlet): void => {
    send(through).catch((error: unknown) => setProblem(problemOf(error).what));
  };
  const opened = (): Outlet | null => {
    if (outlet.current !== null) return outlet.current;
    const publisher = session.node().publisher(topic, type);
    if (publisher.problem !== undefined) {
      setProblem(publisher.problem.message);
      return null;
    }
    outlet.current = { publisher, timer: undefined };
    return outlet.current;
  };
  const once = (): void => {
    const through = opened();
    if (through !== null) publish(through);
  };
  const toggle = (): void => {
    if (outlet.current?.timer !== undefined) {
      outlet.current.timer.close();
      outlet.current.timer = undefined;
      setRunning(false);
      return;
    }
    const through = opened();
    if (through === null) return;
    through.timer = session.node().timer(1000 / rate, () => publish(through));
    setRunning(true);
  };
  const offers = useMemo(
    () => topics.filter((each) => !isHiddenTopic(each.name)).map((each) => each.name),
    [topics],
  );
  const able = ready && topic !== '' && typeof draft !== 'string';

  return (
    <PanelFrame id="publish" title={texts.panels.publish} icon="publish">
      <form
        class="work"
        onSubmit={(event) => {
          event.preventDefault();
          if (able) once();
        }}
      >
        <label class="editor-field">
          <span class="editor-name">{panelTexts.publish.topic}</span>
          <input
            type="text"
            class="field"
            list={`publish-topics-${instance}`}
            value={topic}
            autocomplete="off"
            autocapitalize="off"
            spellcheck={false}
            placeholder="/cmd_vel"
            onInput={(event) => chooseTopic(event.currentTarget.value)}
          />
        </label>
        <datalist id={`publish-topics-${instance}`}>
          {offers.map((name) => (
            <option key={name} value={name} />
          ))}
        </datalist>
        <label class="editor-field">
          <span class="editor-name">{panelTexts.publish.type}</span>
          <input
            type="text"
            class="field"
            list={`publish-types-${instance}`}
            value={type}
            autocomplete="off"
            autocapitalize="off"
            spellcheck={false}
            placeholder="geometry_msgs/msg/Twist"
            onInput={(event) => change({ type: event.currentTarget.value, message: '' })}
          />
        </label>
        <datalist id={`publish-types-${instance}`}>
          {allTypes.map((name) => (
            <option key={name} value={name} />
          ))}
        </datalist>
        {known !== '' && type !== '' && known !== type ? (
          <p class="hint">{panelTexts.publish.otherType(topic, known)}</p>
        ) : null}
        {typeof codec === 'string' ? <p class="hint">{codec}</p> : null}
        {codec === null ? <p class="hint">{texts.starting}</p> : null}
        {typeof draft === 'string' ? (
          draft === '' ? null : (
            <p class="hint">{draft}</p>
          )
        ) : !ready ? null : (
          <div onFocusOut={keep}>
            <MessageEditor
              codec={codec}
              type={type}
              draft={draft}
              onChange={setDraft}
              label={topic === '' ? type : topic}
            />
          </div>
        )}
        <div class="work-row">
          <button type="submit" class="button button-main" aria-disabled={able ? undefined : 'true'}>
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
                if (!(next >= 0.01 && next <= kMostRate)) return;
                change({ rate: next });
                if (outlet.current?.timer === undefined) return;
                const through = outlet.current;
                through.timer?.close();
                through.timer = session.node().timer(1000 / next, () => publish(through));
              }}
            />
          </label>
          <button
            type="button"
            class="button"
            aria-disabled={able || running ? undefined : 'true'}
            onClick={() => {
              if (able || running) toggle();
            }}
          >
            {running ? panelTexts.publish.stop : panelTexts.publish.repeat}
          </button>
          <span class="hint">{panelTexts.publish.sent(sent)}</span>
        </div>
        <WorkProblem text={problem} />
      </form>
    </PanelFrame>
  );
}
