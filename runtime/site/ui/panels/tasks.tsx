// The tasks of a lab: each with its checks, a hint and a solution that are shown on request, and the progress of earlier
// visits. task_run.ts decides the checks.

import type { ComponentChildren } from 'preact';
import { useCallback, useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { Session, TaskCheckView } from '../../contract/session.ts';
import { unreachable } from '../../contract/session.ts';
import type { PageAction } from '../model/page_action.ts';
import { siteDigest } from '../model/link.ts';
import { problemOf } from '../model/problem.ts';
import { MOST_NAME } from '../model/progress_file.ts';
import { IconButton } from '../parts/button.tsx';
import { CheckLine } from '../parts/check_line.tsx';
import type { CheckLook } from '../parts/check_line.tsx';
import { handIn } from '../parts/hand_in.ts';
import { Icon } from '../parts/icon.tsx';
import { MarkdownView } from '../parts/markdown_view.tsx';
import { Name } from '../parts/name.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { taskDesk } from '../parts/task_desk.ts';
import type { DeskTask, TaskDesk } from '../parts/task_desk.ts';
import { usePageActions } from '../parts/use_page_actions.ts';
import { useNow } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import { handInTexts } from '../texts_hand_in.ts';
import { taskTexts } from '../texts_tasks.ts';
import type { PanelProps } from './panel_props.ts';

/** Paths in a task's text are relative to the manifest, as the site has its texts. */
const TEXT_FILE = 'text/tasks.md';

export function TasksPanel({ session, store, announce, instance, open }: PanelProps) {
  const [, setVersion] = useState(0);
  const [forgetting, setForgetting] = useState(false);
  const desk = taskDesk(session, store);
  useEffect(() => desk.onChange(() => setVersion((version) => version + 1)), [desk]);
  const { act: newestAct, said } = usePageActions(session, open);
  const acting = useRef(newestAct);
  acting.current = newestAct;
  // The same each time, so that texts are read once.
  const act = useCallback((action: PageAction) => acting.current(action), []);
  const files = useMemo(() => new Set(session.site.files.map((one) => one.path)), [session]);
  const tasks = desk.tasks();
  const done = tasks.filter(({ kept }) => kept.doneAt !== undefined).length;
  // The values of open checks change without an event.
  useNow(done < tasks.length);
  const forget = (): void => {
    desk.forget();
    setForgetting(false);
    announce(taskTexts.forgotten);
  };
  return (
    <PanelFrame
      id="tasks"
      title={texts.panels.tasks}
      icon="check"
      note={tasks.length === 0 ? '' : taskTexts.doneOf(done, tasks.length)}
      tools={tasks.some(({ kept }) => kept.doneAt !== undefined || kept.hintAt !== undefined || kept.solutionAt !== undefined)
        ? (
          <IconButton icon="restart" label={taskTexts.forget} onClick={() => setForgetting(!forgetting)} />
        )
        : undefined}
    >
      {forgetting
        ? (
          <div class="task-forget" role="group" aria-label={taskTexts.forget}>
            <p>{taskTexts.reallyForget}</p>
            <button type="button" class="button" onClick={forget}>
              {taskTexts.forgetNow}
            </button>
            <button type="button" class="button" onClick={() => setForgetting(false)}>
              {taskTexts.keepIt}
            </button>
          </div>
        )
        : null}
      {tasks.length === 0 ? <p class="hint">{taskTexts.none}</p> : null}
      {tasks.length === 0 ? null : (
        <div class="tasks" role="group" aria-label={texts.panels.tasks} tabIndex={0}>
          {session.tasks?.begun() === false ? <p class="task-begin">{taskTexts.begin}</p> : null}
          <ol class="task-list" role="list">
            {tasks.map((task, at) => (
              <TaskRow
                task={task}
                number={at + 1}
                instance={`${instance}-${at}`}
                files={files}
                act={act}
                reveal={(what) => desk.reveal(task.title, what)}
              />
            ))}
          </ol>
          <HandIn session={session} desk={desk} announce={announce} />
        </div>
      )}
      <p class="text-said" role="status">
        {said}
      </p>
    </PanelFrame>
  );
}

interface HandInProps {
  readonly session: Session;
  readonly desk: TaskDesk;
  readonly announce: (text: string) => void;
}

/** A file for who grades the lab. */
function HandIn({ session, desk, announce }: HandInProps) {
  const [name, setName] = useState('');
  const [said, setSaid] = useState('');
  const save = async (): Promise<string> => {
    const sha256 = await siteDigest();
    if (sha256 === null) return handInTexts.noSite;
    const { site } = session;
    const title = site.title === '' ? site.name : site.title;
    return handIn(name, undefined, [{ title, sha256, tasks: desk.progress() }]);
  };
  const submit = (event: Event): void => {
    event.preventDefault();
    save().then(
      (words) => {
        setSaid(words);
        announce(words);
      },
      (error: unknown) => setSaid(problemOf(error).what),
    );
  };
  return (
    <form class="task-hand-in" onSubmit={submit}>
      <label>
        {handInTexts.name}{' '}
        <input type="text" class="field" value={name} maxLength={MOST_NAME} autocomplete="name" onInput={(event) => setName(event.currentTarget.value)} />
      </label>
      <button type="submit" class="button">
        {handInTexts.save}
      </button>
      <p>{said === '' ? handInTexts.about : said}</p>
    </form>
  );
}

interface TaskRowProps {
  readonly task: DeskTask;
  readonly number: number;
  readonly instance: string;
  readonly files: ReadonlySet<string>;
  readonly act: (action: PageAction) => void;
  readonly reveal: (what: 'hintAt' | 'solutionAt') => void;
}

function TaskRow({ task, number, instance, files, act, reveal }: TaskRowProps) {
  const { title, checks, kept } = task;
  const done = kept.doneAt !== undefined;
  const markdown = (text: string, part: string): ComponentChildren => (
    <MarkdownView text={text} file={TEXT_FILE} files={files} instance={`${instance}-${part}`} act={act} />
  );
  const text = useMemo(() => markdown(task.text, 'text'), [task.text, files, instance, act]);
  return (
    <li class={`task ${done ? 'task-done' : 'task-open'}`}>
      <h3 class="task-title">
        <span class="visually-hidden">{taskTexts.number(number)}</span>
        <Name text={title} />
      </h3>
      <p class="node-state">
        <span class={`state state-${done ? 'good' : 'idle'}`}>
          <Icon name={done ? 'check' : 'ring'} />
          {kept.doneAt === undefined ? taskTexts.open : taskTexts.doneAt(new Date(kept.doneAt).toLocaleString())}
        </span>
      </p>
      {task.text === '' ? null : <div class="text task-text">{text}</div>}
      <ul class="task-checks" role="list" aria-label={taskTexts.checks(title)}>
        {checks.map((view) => (
          <CheckRow view={view} done={done} />
        ))}
      </ul>
      <Aid task={title} kind="hint" text={task.hint} reveal={() => reveal('hintAt')}>
        {(hint) => markdown(hint, 'hint')}
      </Aid>
      {task.hint !== '' && kept.hintAt === undefined ? null : (
        <Aid task={title} kind="solution" text={task.solution} reveal={() => reveal('solutionAt')}>
          {(solution) => markdown(solution, 'solution')}
        </Aid>
      )}
    </li>
  );
}

interface AidProps {
  readonly task: string;
  readonly kind: 'hint' | 'solution';
  /** Empty: there is none. */
  readonly text: string;
  readonly reveal: () => void;
  readonly children: (text: string) => ComponentChildren;
}

/** A text that is shown on request, and hidden again at a later visit. */
function Aid({ task, kind, text, reveal, children }: AidProps) {
  const [shown, setShown] = useState(false);
  if (text === '') return null;
  const [show, hide, name] = kind === 'hint'
    ? [taskTexts.showHint, taskTexts.hideHint, taskTexts.hint]
    : [taskTexts.showSolution, taskTexts.hideSolution, taskTexts.solution];
  const press = (): void => {
    if (!shown) reveal();
    setShown(!shown);
  };
  return (
    <div class={`task-aid task-${kind}`}>
      <button
        type="button"
        class="button"
        aria-expanded={shown}
        aria-label={taskTexts.of(shown ? hide : show, task)}
        onClick={press}
      >
        {shown ? hide : show}
      </button>
      {shown
        ? (
          <div class="text task-text" role="group" aria-label={taskTexts.of(name, task)}>
            {children(text)}
          </div>
        )
        : null}
    </div>
  );
}

function CheckRow({ view, done }: { readonly view: TaskCheckView; readonly done: boolean; }) {
  return (
    <CheckLine
      kind={`task-check check-${view.state}`}
      title={view.title}
      look={checkLook(view, done)}
      seen={taskTexts.seen(view.seen)}
      source={view.source}
    />
  );
}

function checkLook({ state }: TaskCheckView, done: boolean): CheckLook {
  if (done && state !== 'passed') return { words: taskTexts.earlier, icon: 'check', tone: 'done' };
  switch (state) {
    case 'open':
      return { words: taskTexts.waiting, icon: 'ring', tone: 'idle' };
    case 'already':
      return { words: taskTexts.already, icon: 'ring', tone: 'idle' };
    case 'passed':
      return { words: taskTexts.passed, icon: 'check', tone: 'good' };
    default:
      return unreachable(state);
  }
}
