// The services and actions of the graph: a form for each, the call with its reply, the goal with feedback and result.
// A row that has something to show stays when its server has gone. State: {name, request}, one that is opened with that
// request or goal, written as YAML.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { PageGoal, Session } from '../../contract/session.ts';
import type { Codec, Decoded } from '../../decode/codec.ts';
import { draftBytes, refusal } from '../model/draft_value.ts';
import type { DraftText } from '../model/draft_value.ts';
import { endpointsToCall } from '../model/callable.ts';
import type { Callable } from '../model/callable.ts';
import { textMember } from '../model/json.ts';
import { problemOf } from '../model/problem.ts';
import { GraphRow } from '../parts/graph_row.tsx';
import { beginDraft, MessageEditor } from '../parts/message_editor.tsx';
import { useCodec } from '../parts/message_feed.ts';
import { MessageView } from '../parts/message_view.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { SearchField } from '../parts/search_field.tsx';
import { useGraph } from '../parts/watch.ts';
import { WorkProblem } from '../parts/work_problem.tsx';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

export function ServicesPanel({ session, announce, state }: PanelProps) {
  const graph = useGraph(session);
  const codec = useCodec(session);
  const [all, setAll] = useState(false);
  const [text, setText] = useState('');
  const [opened, setOpened] = useState<ReadonlyMap<string, Callable>>(new Map());
  const asked = textMember(state, 'name');
  const request = textMember(state, 'request');
  const there = endpointsToCall(graph, all || asked !== '');
  const keys = new Set(there.map(keyOf));
  // An opened row stays with its contents, even after its service has gone.
  const rows = [...there, ...[...opened.values()].filter((each) => !keys.has(keyOf(each)))]
    .filter(({ name, type }) => `${name} ${type}`.toLowerCase().includes(text.toLowerCase()))
    .sort((a, b) => (a.name < b.name ? -1 : a.name > b.name ? 1 : 0));
  const found = there.find(({ name }) => name === asked);
  const wanted = found === undefined ? '' : keyOf(found);
  useEffect(() => {
    if (found !== undefined) setOpened((before) => new Map(before).set(wanted, found));
  }, [wanted, request]);
  const toggle = (row: Callable): void => {
    const next = new Map(opened);
    if (!next.delete(keyOf(row))) next.set(keyOf(row), row);
    setOpened(next);
  };
  const tools = (
    <>
      <label class="check">
        <input type="checkbox" checked={all} onChange={(event) => setAll(event.currentTarget.checked)} />
        {panelTexts.services.all}
      </label>
      <SearchField value={text} label={panelTexts.services.filter} onText={setText} />
    </>
  );
  return (
    <PanelFrame id="services" title={texts.panels.services} icon="call" tools={tools}>
      {rows.length === 0 ? <p class="hint">{panelTexts.services.none}</p> : null}
      {typeof codec === 'string' ? <p class="hint">{codec}</p> : null}
      <ul class="topics" role="list">
        {rows.map((row) => (
          <Row
            key={keyOf(row)}
            row={row}
            gone={!keys.has(keyOf(row))}
            asked={keyOf(row) === wanted}
            request={keyOf(row) === wanted ? request : ''}
            open={opened.has(keyOf(row))}
            onToggle={() => toggle(row)}
            session={session}
            codec={codec !== null && typeof codec !== 'string' ? codec : null}
            announce={announce}
          />
        ))}
      </ul>
    </PanelFrame>
  );
}

function keyOf({ kind, name, type }: Callable): string {
  return `${kind} ${name} ${type}`;
}

interface RowProps extends Pick<PanelProps, 'session' | 'announce'> {
  readonly row: Callable;
  readonly gone: boolean;
  /** A link or another panel asked for it, with what is sent. */
  readonly asked: boolean;
  readonly request: string;
  readonly open: boolean;
  readonly onToggle: () => void;
  readonly codec: Codec | null;
}

function Row({ row, gone, asked, request, open, onToggle, session, codec, announce }: RowProps) {
  const flow = (
    <>
      <span class="topic-rate">{row.kind === 'action' ? panelTexts.services.action : panelTexts.services.service}</span>
      {gone ? <span class="topic-ends">{panelTexts.services.gone}</span> : null}
    </>
  );
  const inside = () => {
    if (codec === null) return null;
    const View = row.kind === 'action' ? GoalView : CallView;
    return <View key={request} row={row} request={request} session={session} codec={codec} announce={announce} />;
  };
  return (
    <GraphRow
      id={`call-${encodeURIComponent(keyOf(row))}`}
      name={row.name}
      type={row.type}
      flow={flow}
      open={open}
      asked={asked}
      onToggle={onToggle}
      inside={inside}
    />
  );
}

interface ViewProps {
  readonly row: Callable;
  /** As YAML; empty: as the type begins. */
  readonly request: string;
  readonly session: Session;
  readonly codec: Codec;
  readonly announce: (text: string) => void;
}

/** The message to be sent, or why it cannot be. */
async function written(
  { session, codec }: ViewProps,
  type: string,
  draft: DraftText,
): Promise<Uint8Array<ArrayBuffer>> {
  const made = await draftBytes(codec, type, draft, session.time.view().now);
  if (made.kind === 'failed') throw new Error(refusal(made));
  return made.bytes;
}

function begun({ codec, request }: ViewProps, type: string): DraftText | string {
  return request === '' ? beginDraft(codec, type) : { view: 'yaml', text: request };
}

function CallView(props: ViewProps) {
  const { row, session, codec, announce } = props;
  const request = `${row.type}_Request`;
  const [draft, setDraft] = useState<DraftText | string>(() => begun(props, request));
  const [calling, setCalling] = useState(false);
  const [givenUp, setGivenUp] = useState(false);
  const [problem, setProblem] = useState('');
  const [reply, setReply] = useState<Decoded | null>(null);
  const abort = useRef<AbortController | null>(null);
  useEffect(() => () => abort.current?.abort(), []);
  if (typeof draft === 'string') return <p class="hint">{draft}</p>;
  const call = async (): Promise<void> => {
    const control = new AbortController();
    abort.current = control;
    setCalling(true);
    setGivenUp(false);
    setProblem('');
    const bytes = await written(props, request, draft);
    const client = session.node().client(row.name, row.type);
    try {
      const answer = await client.call(bytes, { signal: control.signal });
      setReply(codec.decode(`${row.type}_Response`, answer));
      announce(panelTexts.services.replied(row.name));
    } finally {
      client.close();
    }
  };
  const start = (): void => {
    if (calling) return;
    call()
      .catch((error: unknown) => {
        // The visitor's own cancellation is not a problem.
        if (abort.current?.signal.aborted !== true) setProblem(problemOf(error).what);
      })
      .finally(() => setCalling(false));
  };
  const giveUp = (): void => {
    abort.current?.abort();
    setGivenUp(true);
    announce(panelTexts.services.gaveUp);
  };
  return (
    <form
      class="work"
      onSubmit={(event) => {
        event.preventDefault();
        start();
      }}
    >
      <MessageEditor codec={codec} type={request} draft={draft} onChange={setDraft} label={row.name} />
      <div class="work-row">
        <button type="submit" class="button button-main" aria-disabled={calling ? 'true' : undefined}>
          {calling ? panelTexts.services.calling : panelTexts.services.call}
        </button>
        {calling
          ? (
            <button type="button" class="button" onClick={giveUp}>
              {panelTexts.services.giveUp}
            </button>
          )
          : null}
        {givenUp ? <span class="hint">{panelTexts.services.gaveUp}</span> : null}
      </div>
      <WorkProblem text={problem} />
      {reply === null ? null : <Answer title={panelTexts.services.reply} of={row.name} decoded={reply} announce={announce} />}
    </form>
  );
}

function GoalView(props: ViewProps) {
  const { row, session, codec, announce } = props;
  const type = `${row.type}_Goal`;
  const [draft, setDraft] = useState<DraftText | string>(() => begun(props, type));
  const [goal, setGoal] = useState<PageGoal | null>(null);
  const [state, setState] = useState('');
  const [problem, setProblem] = useState('');
  const [feedback, setFeedback] = useState<Decoded | null>(null);
  const [result, setResult] = useState<Decoded | null>(null);
  const close = useRef<() => void>(() => undefined);
  useEffect(() => () => close.current(), []);
  if (typeof draft === 'string') return <p class="hint">{draft}</p>;
  const send = async (): Promise<void> => {
    setProblem('');
    setFeedback(null);
    setResult(null);
    const bytes = await written(props, type, draft);
    const client = session.node().actionClient(row.name, row.type);
    close.current = () => client.close();
    try {
      setState(panelTexts.services.goalStates.unknown);
      const sent = client.sendGoal(bytes, {
        onFeedback: (data) => setFeedback(codec.decode(`${row.type}_Feedback`, data)),
        onStatus: (status) => setState(panelTexts.services.goalStates[status]),
      });
      setGoal(sent);
      // Its refusal is that of the result, too.
      sent.accepted.catch(() => undefined);
      const end = await sent.result;
      setState(panelTexts.services.goalStates[end.status]);
      setResult(codec.decode(`${row.type}_GetResult_Response`, end.bytes));
      announce(panelTexts.services.ended(row.name));
    } catch (error) {
      setState('');
      throw error;
    } finally {
      setGoal(null);
      client.close();
    }
  };
  const failed = (error: unknown): void => setProblem(problemOf(error).what);
  return (
    <form
      class="work"
      onSubmit={(event) => {
        event.preventDefault();
        if (goal === null) send().catch(failed);
      }}
    >
      <MessageEditor codec={codec} type={type} draft={draft} onChange={setDraft} label={row.name} />
      <div class="work-row">
        <button type="submit" class="button button-main" aria-disabled={goal === null ? undefined : 'true'}>
          {panelTexts.services.sendGoal}
        </button>
        {goal === null ? null : (
          <button type="button" class="button" onClick={() => void goal.cancel().catch(failed)}>
            {panelTexts.services.cancel}
          </button>
        )}
        {state === '' ? null : <span class="hint">{state}</span>}
      </div>
      <WorkProblem text={problem} />
      {feedback === null ? null : (
        <Answer title={panelTexts.services.feedback} of={row.name} decoded={feedback} announce={announce} />
      )}
      {result === null ? null : (
        <Answer title={panelTexts.services.result} of={row.name} decoded={result} announce={announce} />
      )}
    </form>
  );
}

interface AnswerProps {
  readonly title: string;
  readonly of: string;
  readonly decoded: Decoded;
  readonly announce: (text: string) => void;
}

function Answer({ title, of, decoded, announce }: AnswerProps) {
  if (decoded.kind === 'failed') return <WorkProblem text={decoded.reason} />;
  return (
    <MessageView
      title={title}
      message={decoded}
      label={panelTexts.services.answerOf(title, of)}
      copyLabel={panelTexts.services.copy(title, of)}
      announce={announce}
    />
  );
}
