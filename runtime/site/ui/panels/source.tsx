// The Python files of the workspace: shown, changed in this browser, applied by a restart of the nodes that use them.
// State: {file, line}, the file as the workspace names it.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { NodeView, Sources, SourceView } from '../../contract/session.ts';
import { stripAnsi } from '../model/ansi.ts';
import { numberMember, textMember } from '../model/json.ts';
import { lineChanges } from '../model/line_diff.ts';
import { makePatch } from '../model/patch.ts';
import { nodeTrouble } from '../model/node_trouble.ts';
import type { NodeTrouble } from '../model/node_trouble.ts';
import { problemOf } from '../model/problem.ts';
import type { Problem } from '../model/problem.ts';
import { CopyButton } from '../parts/button.tsx';
import { openCodeEditor } from '../parts/code_editor.ts';
import type { CodeEditor } from '../parts/code_editor.ts';
import { Icon } from '../parts/icon.tsx';
import { isAlive } from '../parts/node_state.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { ProblemView } from '../parts/problem_view.tsx';
import { SearchField } from '../parts/search_field.tsx';
import { SourceSearch } from '../parts/source_search.tsx';
import { useNodeOutput } from '../parts/use_node_output.ts';
import type { NodeOutput } from '../parts/use_node_output.ts';
import { useNodes } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import { sourceTexts } from '../texts_source.ts';
import type { PanelProps } from './panel_props.ts';

const MOST_LINE = 1_000_000;
const SHOWN_HASH = 12;
/** Lines of output below the editor. */
const SHOWN_LINES = 6;
/** After the last key: what is typed is kept then. */
const KEEP_MS = 300;

export function SourcePanel(props: PanelProps) {
  const { sources } = props.session;
  const list = useSources(sources);
  if (sources === undefined || list.length === 0) {
    return (
      <PanelFrame id="source" title={texts.panels.source} icon="code">
        <p class="hint">{sourceTexts.none}</p>
      </PanelFrame>
    );
  }
  return <SourceFile {...props} sources={sources} list={list} />;
}

function useSources(sources: Sources | undefined): readonly SourceView[] {
  const [list, setList] = useState(() => sources?.list() ?? []);
  useEffect(() => {
    setList(sources?.list() ?? []);
    return sources?.onChange(() => setList(sources.list()));
  }, [sources]);
  return list;
}

/** The wanted file: by its whole name, or by its end when that is one file's only. */
function findSource(list: readonly SourceView[], wanted: string): SourceView | undefined {
  const ends = list.filter(({ file }) => file.endsWith(`/${wanted}`));
  return list.find(({ file }) => file === wanted) ?? (ends.length === 1 ? ends[0] : undefined);
}

interface SourceFileProps extends PanelProps {
  readonly sources: Sources;
  readonly list: readonly SourceView[];
}

function SourceFile({ session, state, setState, announce, sources, list }: SourceFileProps) {
  const nodes = useNodes(session);
  const wanted = textMember(state, 'file');
  const line = numberMember(state, 'line', 1, MOST_LINE, 0);
  const found = findSource(list, wanted);
  const first = list.find(({ file }) => !file.endsWith('__init__.py')) ?? list[0];
  const source = found ?? (wanted === '' ? first : undefined);
  const packed = usePacked(sources, list, source);
  const users = nodes.filter((node) => source !== undefined && node.usedSources?.includes(source.path));
  const [search, setSearch] = useState('');
  const [said, setSaid] = useState('');
  const say = (words: string): void => {
    setSaid(words);
    announce(words);
  };
  /** The typed text is not stored yet, or was refused. */
  const [unkept, setUnkept] = useState(false);
  const restart = (): void => {
    for (const node of users) session.restart(node.id);
    say(users.length === 0 ? sourceTexts.nobody : sourceTexts.applied(users.map(({ label }) => label)));
  };
  const apply = (): void => {
    if (editor.current?.keep() === false) say(sourceTexts.tooLong);
    else restart();
  };
  const isPacked = source?.state === 'packed' && !unkept;
  const reset = (): void => {
    if (source === undefined || isPacked) return;
    editor.current?.reset();
    if (source.state !== 'packed') sources.change(source.path, undefined);
    if (isChanged) restart();
  };
  const text = source === undefined ? undefined : packed.texts.get(source.path);
  const patch = (): string =>
    makePatch(
      list.flatMap(({ path, file, state: kind }) => {
        const before = packed.texts.get(path);
        const after = sources.changed(path);
        return kind !== 'changed' || before === undefined || after === undefined ? [] : [{ path: file, before, after }];
      }),
    );
  const isChanged = source?.state === 'changed';
  const outputs = useNodeOutput(session, users);
  const troubles = outputs.flatMap(({ node, lines }) => {
    const trouble = source === undefined ? null : nodeTrouble(lines, source.path);
    return trouble === null ? [] : [{ node, ...trouble }];
  });
  const editor = useRef<EditorHandle | null>(null);
  const begun = useRef(false);
  useEffect(() => {
    if (text !== undefined) begun.current = true;
  }, [text]);
  return (
    <PanelFrame id="source" title={texts.panels.source} icon="code">
      <div class="source-head">
        <label class="source-file">
          <span class="visually-hidden">{sourceTexts.file}</span>
          <select
            class="select"
            value={source?.file ?? ''}
            onChange={(event) => setState({ file: event.currentTarget.value })}
          >
            {source === undefined ? <option value="">{wanted}</option> : null}
            {list.map(({ path, file, state: kind }) => (
              <option key={path} value={file}>{`${file}${sourceTexts.option[kind]}`}</option>
            ))}
          </select>
        </label>
        <SearchField value={search} label={sourceTexts.search} onText={setSearch} />
        <div class="panel-tools">
          <button
            type="button"
            class="button button-main"
            title={sourceTexts.applyLong}
            onClick={apply}
          >
            <Icon name="restart" />
            {sourceTexts.apply}
          </button>
          <button
            type="button"
            class="button"
            title={sourceTexts.resetLong}
            aria-disabled={isPacked ? 'true' : undefined}
            onClick={reset}
          >
            {sourceTexts.reset}
          </button>
          <CopyButton label={sourceTexts.patchLong} words={sourceTexts.patch} text={patch} announce={announce} />
        </div>
      </div>
      {search.trim() === '' ? null : (
        <SourceSearch sources={sources} list={list} wanted={search} onHit={(file, at) => setState({ file, line: at })} />
      )}
      {source === undefined ? <p class="hint">{sourceTexts.unknown(wanted)}</p> : null}
      {source?.state === 'outdated'
        ? (
          <div class="source-note">
            <p>{sourceTexts.outdated}</p>
            <button type="button" class="button" onClick={() => sources.change(source.path, sources.changed(source.path))}>
              {sourceTexts.takeOver}
            </button>
            <button type="button" class="button" onClick={() => sources.change(source.path, undefined)}>
              {sourceTexts.drop}
            </button>
          </div>
        )
        : null}
      {packed.problem === null ? null : <ProblemView problem={packed.problem} announce={announce} />}
      {source === undefined || text === undefined ? null : (
        <SourceEditor
          key={source.path}
          source={source}
          packed={text}
          sources={sources}
          line={line}
          trouble={troubles[0]?.line ?? null}
          takesFocus={begun.current}
          handle={editor}
          onLine={(now) => setState({ file: source.file, line: now })}
          onApply={apply}
          onUnkept={setUnkept}
          say={setSaid}
        />
      )}
      {source === undefined ? null : (
        <SourceRun outputs={outputs} troubles={troubles} goTo={(at) => editor.current?.goTo(at)} />
      )}
      {source === undefined ? null : <SourceFacts source={source} users={users} said={said} />}
    </PanelFrame>
  );
}

interface PackedTexts {
  readonly texts: ReadonlyMap<string, string>;
  readonly problem: Problem | null;
}

/** The packed texts of what is shown and of what was changed, as far as they have come. */
function usePacked(sources: Sources, list: readonly SourceView[], shown: SourceView | undefined): PackedTexts {
  const [found, setFound] = useState<ReadonlyMap<string, string>>(() => new Map());
  const [problem, setProblem] = useState<{ readonly path: string; readonly problem: Problem; } | null>(null);
  const wanted = list.filter(({ path, state }) => state === 'changed' || path === shown?.path).map(({ path }) => path);
  const missing = wanted.filter((path) => !found.has(path)).join('\n');
  useEffect(() => {
    let current = true;
    for (const path of missing === '' ? [] : missing.split('\n')) {
      sources.packed(path).then(
        (text) => {
          if (current) setFound((before) => new Map(before).set(path, text));
        },
        (error: unknown) => {
          if (current) setProblem({ path, problem: problemOf(error) });
        },
      );
    }
    return () => {
      current = false;
    };
  }, [sources, missing]);
  return { texts: found, problem: problem !== null && problem.path === shown?.path ? problem.problem : null };
}

interface EditorHandle {
  /** Keeps at once what was typed. Is what stands there kept? */
  readonly keep: () => boolean;
  /** Back to the packed text; what was typed is not kept any more. */
  readonly reset: () => void;
  readonly goTo: (line: number) => void;
}

interface SourceEditorProps {
  readonly source: SourceView;
  readonly packed: string;
  readonly sources: Sources;
  /** To be shown; 0: none. */
  readonly line: number;
  /** Where a node's last error arose; null: nowhere. */
  readonly trouble: number | null;
  /** Not at first: a page that is opened leaves the keyboard where it is. */
  readonly takesFocus: boolean;
  readonly handle: { current: EditorHandle | null; };
  readonly onLine: (line: number) => void;
  readonly onApply: () => void;
  readonly onUnkept: (unkept: boolean) => void;
  readonly say: (words: string) => void;
}

function SourceEditor(props: SourceEditorProps) {
  const { source, packed, sources, line, handle } = props;
  const host = useRef<HTMLDivElement>(null);
  const editor = useRef<CodeEditor | null>(null);
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const refused = useRef(false);
  const lineTimer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const lineAt = useRef(0);
  const latest = useRef(props);
  latest.current = props;

  const mark = (): void => {
    const shown = editor.current;
    if (shown === null) return;
    const split = (text: string): string[] => text.split(/\r?\n/);
    const changes = lineChanges(split(latest.current.packed), split(shown.text()));
    // Where lines are gone, the one after them stands for them.
    shown.mark(changes.flatMap(({ newStart, newCount }) => Array.from({ length: Math.max(1, newCount) }, (_, i) => newStart + i + 1)));
  };
  const keep = (): boolean => {
    if (timer.current === undefined) return !refused.current;
    clearTimeout(timer.current);
    timer.current = undefined;
    const now = latest.current;
    const text = editor.current?.text();
    if (text === undefined) return true;
    const kept = now.sources.change(now.source.path, text === now.packed ? undefined : text);
    refused.current = kept === 'too_long';
    now.onUnkept(refused.current);
    now.say(kept === 'too_long' ? sourceTexts.tooLong : kept === 'visit' ? sourceTexts.visit : '');
    mark();
    return !refused.current;
  };
  const show = (text: string): void => {
    editor.current?.replace(text);
    // That was not typed.
    clearTimeout(timer.current);
    timer.current = undefined;
    refused.current = false;
    latest.current.onUnkept(false);
    mark();
  };

  const own = (): string => (source.state === 'changed' ? sources.changed(source.path) : undefined) ?? packed;

  useEffect(() => {
    if (host.current === null) return undefined;
    const made = openCodeEditor(host.current, own(), sourceTexts.label(source.file), {
      changed: () => {
        clearTimeout(timer.current);
        timer.current = setTimeout(keep, KEEP_MS);
        latest.current.onUnkept(true);
      },
      apply: () => latest.current.onApply(),
      line: (now) => {
        if (now === lineAt.current) return;
        lineAt.current = now;
        clearTimeout(lineTimer.current);
        lineTimer.current = setTimeout(() => latest.current.onLine(now), KEEP_MS);
      },
    });
    editor.current = made;
    handle.current = {
      keep,
      reset: () => {
        show(latest.current.packed);
        latest.current.say('');
      },
      goTo: (at) => made.goTo(at, true),
    };
    addEventListener('pagehide', keep);
    return () => {
      keep();
      latest.current.onUnkept(false);
      clearTimeout(lineTimer.current);
      removeEventListener('pagehide', keep);
      handle.current = null;
      editor.current = null;
      made.close();
    };
  }, []);

  // Changed elsewhere: by another tab, by the buttons.
  useEffect(() => {
    if (timer.current !== undefined) return;
    show(own());
  }, [source.changedSha256, source.state]);

  useEffect(() => {
    if (line === 0 || line === lineAt.current) return;
    lineAt.current = line;
    editor.current?.goTo(line, latest.current.takesFocus);
  }, [line]);

  useEffect(() => editor.current?.markTrouble(props.trouble), [props.trouble]);

  return <div class="source-editor" ref={host} />;
}

interface SourceRunProps {
  readonly outputs: readonly NodeOutput[];
  readonly troubles: readonly (NodeTrouble & { readonly node: NodeView; })[];
  readonly goTo: (line: number) => void;
}

/** The last output of the nodes that use the file, and the errors that lead into it. */
function SourceRun({ outputs, troubles, goTo }: SourceRunProps) {
  const printed = outputs.filter(({ lines }) => lines.length > 0);
  if (printed.length === 0) return null;
  return (
    <div class="source-run">
      {troubles.map(({ node, line, words }) => (
        <p key={node.id} class="source-trouble" role="alert">
          <button type="button" class="link" onClick={() => goTo(line)}>{sourceTexts.troubleAt(node.label, line)}</button>
          {` ${words}`}
        </p>
      ))}
      {printed.map(({ node, lines }) => (
        <pre key={node.id} class="source-output" tabIndex={0} aria-label={sourceTexts.output(node.label)}>
          {lines.slice(-SHOWN_LINES).map((text) => `${printed.length > 1 ? `[${node.label}] ` : ''}${stripAnsi(text)}`).join('\n')}
        </pre>
      ))}
    </div>
  );
}

interface SourceFactsProps {
  readonly source: SourceView;
  readonly users: readonly NodeView[];
  readonly said: string;
}

function SourceFacts({ source, users, said }: SourceFactsProps) {
  const { changedSha256, path, sha256, state } = source;
  const used = useMemo(
    () =>
      users.map(({ label, state: of, changedSources }) => {
        const words = isAlive(of) ? sourceTexts.runs : sourceTexts.ran;
        return `${label} ${changedSources?.includes(path) === true ? words.changed : words.packed}`;
      }),
    [users, path],
  );
  return (
    <div class="source-facts">
      <p>
        <strong class={`source-${state}`}>{sourceTexts.state[state]}</strong>
        {`. ${used.length === 0 ? sourceTexts.notYet : `${used.join(', ')}.`}`}
      </p>
      <details>
        <summary>{sourceTexts.more}</summary>
        <p>{`${sourceTexts.keys} ${sourceTexts.keptHere}`}</p>
        <p>
          <span title={sha256}>{sourceTexts.packedHash(sha256.slice(0, SHOWN_HASH))}</span>
          {changedSha256 === undefined ? null : (
            <>
              {', '}
              <span title={changedSha256}>{sourceTexts.changedHash(changedSha256.slice(0, SHOWN_HASH))}</span>
            </>
          )}
        </p>
      </details>
      {said === '' ? null : <p class="source-said">{said}</p>}
    </div>
  );
}
