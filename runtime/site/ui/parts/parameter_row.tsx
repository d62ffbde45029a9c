// One parameter: its name, type and description, an editor that fits its type, and why the node did not take a value.

import { useId, useRef, useState } from 'preact/hooks';
import type { ReadValue } from '../../decode/read_yaml.ts';
import type { SetResult } from '../../ros2cli/parameter_calls.ts';
import { kindOf } from '../../ros2cli/parameters.ts';
import type { ParameterValue } from '../../ros2cli/parameters.ts';
import { needsYaml, parameterText, rangeText, readParameter, sliderRange } from '../model/parameter_text.ts';
import type { SliderRange } from '../model/parameter_text.ts';
import { problemOf } from '../model/problem.ts';
import { panelTexts } from '../texts_panels.ts';
import { Name } from './name.tsx';
import type { KnownParameter } from './parameter_store.ts';
import { WorkProblem } from './work_problem.tsx';

/** Longer texts are shown, cut, and not edited. */
const MOST_TEXT = 10_000;

export interface ParameterRowProps {
  readonly node: string;
  readonly name: string;
  readonly parameter: KnownParameter;
  /** Is the node there to be asked? */
  readonly here: boolean;
  readonly set: (value: ParameterValue) => Promise<SetResult>;
  readonly announce: (text: string) => void;
}

interface Setting {
  /** The value that the node has been asked to set; null: none. */
  readonly asked: ParameterValue | null;
  readonly problem: string;
  readonly setProblem: (problem: string) => void;
  readonly ask: (value: ParameterValue) => void;
}

/** One question at a time: what is asked meanwhile (a slider that moves) is asked next, the newest only. */
function useSetting(
  set: (value: ParameterValue) => Promise<SetResult>,
  taken: (value: ParameterValue) => void,
): Setting {
  const [asked, setAsked] = useState<ParameterValue | null>(null);
  const [problem, setProblem] = useState('');
  const next = useRef<ParameterValue | null>(null);
  const busy = useRef(false);
  const newest = useRef({ set, taken });
  newest.current = { set, taken };
  const run = async (first: ParameterValue): Promise<void> => {
    for (let value: ParameterValue | null = first; value !== null; value = next.current) {
      next.current = null;
      try {
        const { successful, reason } = await newest.current.set(value);
        setProblem(successful ? '' : panelTexts.parameters.refused(shortText(value), reason));
        if (successful) newest.current.taken(value);
      } catch (error) {
        setProblem(panelTexts.parameters.notSet(shortText(value), problemOf(error).what));
      }
    }
  };
  const ask = (value: ParameterValue): void => {
    setAsked(value);
    if (busy.current) {
      next.current = value;
      return;
    }
    busy.current = true;
    void run(value).finally(() => {
      busy.current = false;
      setAsked(null);
    });
  };
  return { asked, problem, setProblem, ask };
}

function shortText(value: ParameterValue): string {
  const text = parameterText(value);
  return text.length > 80 ? `${text.slice(0, 80)}\u2026` : text;
}

export function ParameterRow({ node, name, parameter, here, set, announce }: ParameterRowProps) {
  const { descriptor } = parameter;
  const about = useId();
  const { asked, problem, setProblem, ask } = useSetting(set, () => announce(panelTexts.parameters.set(name, node)));
  const value = asked ?? parameter.value;
  const fixed = !here || descriptor?.read_only === true;
  const words = [rangeText(descriptor), descriptor?.additional_constraints ?? ''].filter((each) => each !== '');
  return (
    <li class="parameter" aria-busy={asked !== null}>
      <div class="parameter-words">
        <span class="parameter-name">
          <Name text={name} />
        </span>{' '}
        <span class="editor-type">{kindOf(parameter.value).name}</span>
        {descriptor?.read_only === true ? <span class="parameter-tag">{panelTexts.parameters.readOnly}</span> : null}
      </div>
      <div class="parameter-editor">
        <Editor
          value={value}
          label={panelTexts.editor.field(node, name)}
          about={about}
          fixed={fixed}
          anyType={descriptor?.dynamic_typing === true}
          declared={descriptor?.type ?? 0}
          slider={fixed ? null : sliderRange(descriptor, Number(value['type']))}
          ask={ask}
          setProblem={setProblem}
        />
        {asked === null ? null : <span class="parameter-asked">{panelTexts.parameters.asked}</span>}
      </div>
      <p class="parameter-about" id={about}>
        {[descriptor?.description ?? '', ...words].filter((each) => each !== '').map((each) => (
          <span>{each}</span>
        ))}
      </p>
      <WorkProblem text={problem} />
    </li>
  );
}

interface EditorProps {
  readonly value: ParameterValue;
  readonly label: string;
  /** Id of what describes it. */
  readonly about: string;
  /** Cannot be changed. */
  readonly fixed: boolean;
  readonly anyType: boolean;
  /** The type in the descriptor, for one that is not set. */
  readonly declared: number;
  readonly slider: SliderRange | null;
  readonly ask: (value: ParameterValue) => void;
  readonly setProblem: (problem: string) => void;
}

function Editor(props: EditorProps) {
  const { value, label, about, fixed, anyType, declared, slider, ask } = props;
  const { field } = kindOf(value);
  if (field === 'byte_array_value') {
    const count = (value[field] as ArrayLike<number>).length;
    return (
      <span class="parameter-bytes" role="group" aria-label={label}>
        <code>{parameterText(value)}</code> <span class="editor-type">{panelTexts.parameters.bytes(count)}</span>
      </span>
    );
  }
  if (field === 'bool_value' && !anyType) {
    return (
      <input
        type="checkbox"
        aria-label={label}
        aria-describedby={about}
        disabled={fixed}
        checked={value[field] === true}
        onChange={(event) => ask({ type: 1, bool_value: event.currentTarget.checked })}
      />
    );
  }
  return (
    <>
      {slider === null ? null : (
        <input
          type="range"
          class="parameter-slider"
          aria-label={panelTexts.parameters.slider(label)}
          aria-describedby={about}
          min={slider.least}
          max={slider.most}
          step={slider.step === 0 ? 'any' : slider.step}
          value={String(value[field])}
          onInput={(event) =>
            ask(
              field === 'integer_value'
                ? { type: 2, integer_value: BigInt(Math.round(Number(event.currentTarget.value))) }
                : { type: 3, double_value: Number(event.currentTarget.value) },
            )}
        />
      )}
      <TextEditor {...props} type={anyType ? 0 : field === '' ? declared : Number(value['type'])} />
    </>
  );
}

const noYaml = (): ReadValue => ({ kind: 'failed', reason: '' });

/** Typed text is set at Enter or when the field is left; Escape restores the value. */
function TextEditor({ value, label, about, fixed, type, ask, setProblem }: EditorProps & { readonly type: number; }) {
  const [draft, setDraft] = useState<string | null>(null);
  const [wrong, setWrong] = useState(false);
  const whole = parameterText(value);
  const long = whole.length > MOST_TEXT;
  const shown = draft ?? (long ? `${whole.slice(0, MOST_TEXT)}\u2026` : whole);
  const take = async (text: string): Promise<void> => {
    const yaml = needsYaml(type) ? (await import('../../decode/read_yaml.ts')).readYaml : noYaml;
    const read = readParameter(text, type, yaml);
    setWrong(read.kind === 'failed');
    if (read.kind === 'failed') {
      setProblem(panelTexts.parameters.notSet(text.slice(0, 80), read.reason));
      return;
    }
    setDraft(null);
    setProblem('');
    ask(read.value);
  };
  const given = {
    'aria-label': label,
    'aria-describedby': about,
    'aria-invalid': wrong,
    readOnly: fixed || long,
    value: shown,
    autocomplete: 'off',
    autocapitalize: 'off',
    spellcheck: false,
  } as const;
  const commit = (): void => {
    if (draft === null || fixed) return;
    if (draft === whole && !wrong) {
      setDraft(null);
      return;
    }
    take(draft).catch((error: unknown) => setProblem(problemOf(error).what));
  };
  const escape = (): void => {
    setDraft(null);
    setWrong(false);
    setProblem('');
  };
  if (type === 4 && whole.includes('\n')) {
    return (
      <textarea
        {...given}
        class="editor-text parameter-lines"
        rows={4}
        onInput={(event) => setDraft(event.currentTarget.value)}
        onBlur={commit}
        onKeyDown={(event) => {
          if (event.key === 'Escape') escape();
        }}
      />
    );
  }
  return (
    <input
      {...given}
      type="text"
      class="field"
      inputMode={type === 3 ? 'decimal' : undefined}
      placeholder={kindOf(value).field === '' ? panelTexts.parameters.notGiven : undefined}
      onInput={(event) => setDraft(event.currentTarget.value)}
      onBlur={commit}
      onKeyDown={(event) => {
        if (event.key === 'Escape') escape();
        else if (event.key === 'Enter') {
          event.preventDefault();
          commit();
        }
      }}
    />
  );
}
