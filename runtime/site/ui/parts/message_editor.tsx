// A message being written: a form made from its type, or its YAML. Times may be `now`, which is the site's.

import { useEffect, useState } from 'preact/hooks';
import type { Codec, MessageValue } from '../../decode/codec.ts';
import { draftOf } from '../../decode/draft.ts';
import type { Field, Shape } from '../../decode/shape.ts';
import { isMessage, toYaml } from '../../decode/yaml.ts';
import { numberText, onto, readNumber } from '../model/draft_value.ts';
import type { DraftText } from '../model/draft_value.ts';
import { panelTexts } from '../texts_panels.ts';
import { IconButton } from './button.tsx';

/** Longer lists are edited as YAML. */
const MOST_ITEMS = 64;

export interface MessageEditorProps {
  readonly codec: Codec;
  readonly type: string;
  readonly draft: DraftText;
  readonly onChange: (draft: DraftText) => void;
  /** Names the fields among those of other editors. */
  readonly label: string;
}

/** A draft of a type, or why there is none. */
export function beginDraft(codec: Codec, type: string): DraftText | string {
  const made = codec.draft(type);
  return made.kind === 'value' ? { view: 'form', value: made.value } : made.reason;
}

export function MessageEditor({ codec, type, draft, onChange, label }: MessageEditorProps) {
  const [problem, setProblem] = useState('');
  const parsed = codec.types.get(type);
  if (typeof parsed === 'string') return <p class="hint">{parsed}</p>;
  const { shape } = parsed;
  const readForm = async (text: string): Promise<void> => {
    const { readMessage } = await import('../../decode/read_yaml.ts');
    const read = readMessage(text, shape);
    const begin = codec.draft(type);
    if (read.kind === 'failed') setProblem(read.reason);
    else if (begin.kind === 'failed') setProblem(begin.reason);
    else {
      setProblem('');
      onChange({ view: 'form', value: onto(begin.value, isMessage(read.value) ? read.value : {}) });
    }
  };
  const toForm = (text: string): void => {
    readForm(text).catch((error: unknown) => setProblem(String(error)));
  };
  return (
    <div class="editor">
      <div class="choice" role="group" aria-label={panelTexts.editor.view(label)}>
        <button
          type="button"
          aria-pressed={draft.view === 'form'}
          onClick={() => {
            if (draft.view === 'yaml') toForm(draft.text);
          }}
        >
          {panelTexts.editor.form}
        </button>
        <button
          type="button"
          aria-pressed={draft.view === 'yaml'}
          onClick={() => {
            if (draft.view === 'form')
              onChange({ view: 'yaml', text: toYaml(draft.value, shape, null) });
          }}
        >
          {panelTexts.editor.yaml}
        </button>
      </div>
      {draft.view === 'yaml'
        ? (
          <textarea
            class="editor-text"
            rows={8}
            spellcheck={false}
            aria-label={panelTexts.editor.yamlOf(label)}
            value={draft.text}
            onInput={(event) => onChange({ view: 'yaml', text: event.currentTarget.value })}
          />
        )
        : shape.length === 0
        ? (
          <p class="hint">{panelTexts.editor.empty}</p>
        )
        : (
          <Fields
            shape={shape}
            value={draft.value}
            path=""
            label={label}
            onChange={(value) => onChange({ view: 'form', value })}
          />
        )}
      {problem === '' ? null : (
        <p class="hint" role="alert">
          {problem}
        </p>
      )}
    </div>
  );
}

interface FieldsProps {
  readonly shape: Shape;
  readonly value: MessageValue;
  readonly path: string;
  readonly label: string;
  readonly onChange: (value: MessageValue) => void;
}

function Fields({ shape, value, path, label, onChange }: FieldsProps) {
  return (
    <div class="editor-fields">
      {shape.map((field) => (
        <FieldEditor
          key={field.name}
          field={field}
          name={field.name}
          value={Object.hasOwn(value, field.name) ? value[field.name] : undefined}
          path={path === '' ? field.name : `${path}.${field.name}`}
          label={label}
          onChange={(next) => onChange({ ...value, [field.name]: next })}
        />
      ))}
    </div>
  );
}

interface FieldEditorProps {
  readonly field: Field;
  readonly name: string;
  readonly value: unknown;
  readonly path: string;
  readonly label: string;
  readonly onChange: (value: unknown) => void;
}

function FieldEditor(props: FieldEditorProps) {
  const { field, name, value, path, label, onChange } = props;
  if (field.isArray) return <ListEditor {...props} />;
  if (field.shape !== null) {
    return (
      <fieldset class="editor-group">
        <legend>
          {name} <span class="editor-type">{field.type}</span>
        </legend>
        <Fields
          shape={field.shape}
          value={isMessage(value) ? value : {}}
          path={path}
          label={label}
          onChange={onChange}
        />
      </fieldset>
    );
  }
  if (field.type === 'time' || field.type === 'duration') return <TimeEditor {...props} />;
  return (
    <label class="editor-field">
      <span class="editor-name">
        {name} <span class="editor-type">{field.type}</span>
      </span>
      {field.type === 'bool'
        ? (
          <input
            type="checkbox"
            aria-label={panelTexts.editor.field(label, path)}
            checked={value === true}
            onChange={(event) => onChange(event.currentTarget.checked)}
          />
        )
        : field.type === 'string' || field.type === 'wstring'
        ? (
          <input
            type="text"
            class="field"
            aria-label={panelTexts.editor.field(label, path)}
            value={typeof value === 'string' ? value : numberText(value)}
            onInput={(event) => onChange(event.currentTarget.value)}
          />
        )
        : (
          <NumberInput
            type={field.type}
            label={panelTexts.editor.field(label, path)}
            value={value}
            onChange={onChange}
          />
        )}
    </label>
  );
}

interface NumberInputProps {
  readonly type: string;
  readonly label: string;
  readonly value: unknown;
  readonly onChange: (value: unknown) => void;
}

/** Keeps what is typed (`1.`, `-`) while it is not a number yet. */
function NumberInput({ type, label, value, onChange }: NumberInputProps) {
  const [text, setText] = useState(() => numberText(value));
  useEffect(() => {
    if (!Object.is(readNumber(text, type), value) && numberText(readNumber(text, type)) !== numberText(value))
      setText(numberText(value));
  }, [value]);
  return (
    <input
      type="text"
      inputMode={type.startsWith('float') ? 'decimal' : 'numeric'}
      class="field"
      autocomplete="off"
      aria-label={label}
      aria-invalid={typeof readNumber(text, type) === 'string'}
      value={text}
      onInput={(event) => {
        setText(event.currentTarget.value);
        onChange(readNumber(event.currentTarget.value, type));
      }}
    />
  );
}

function TimeEditor({ field, name, value, path, label, onChange }: FieldEditorProps) {
  const now = value === 'now';
  const parts = isMessage(value) ? value : { sec: 0, nanosec: 0 };
  return (
    <fieldset class="editor-group">
      <legend>
        {name} <span class="editor-type">{field.type}</span>
      </legend>
      {field.type === 'time'
        ? (
          <label class="check">
            <input
              type="checkbox"
              checked={now}
              aria-label={panelTexts.editor.now(label, path)}
              onChange={(event) => onChange(event.currentTarget.checked ? 'now' : { sec: 0, nanosec: 0 })}
            />
            <span aria-hidden="true">{panelTexts.editor.nowShort}</span>
          </label>
        )
        : null}
      {now
        ? null
        : ['sec', 'nanosec'].map((part) => (
          <label class="editor-field" key={part}>
            <span class="editor-name">{part}</span>
            <NumberInput
              type="int32"
              label={panelTexts.editor.field(label, `${path}.${part}`)}
              value={parts[part]}
              onChange={(next) => onChange({ ...parts, [part]: next })}
            />
          </label>
        ))}
    </fieldset>
  );
}

function ListEditor({ field, name, value, path, label, onChange }: FieldEditorProps) {
  const items = Array.isArray(value) ? (value as readonly unknown[]) : [];
  const one: Field = { ...field, isArray: false };
  const fixed = field.length !== undefined;
  const most = Math.min(field.mostItems ?? MOST_ITEMS, MOST_ITEMS);
  return (
    <fieldset class="editor-group">
      <legend>
        {name} <span class="editor-type">{panelTexts.editor.list(field.type, items.length)}</span>
      </legend>
      {items.length > MOST_ITEMS ? <p class="hint">{panelTexts.editor.long}</p> : null}
      {items.slice(0, MOST_ITEMS).map((item, index) => (
        <div class="editor-item">
          <FieldEditor
            field={one}
            name={String(index)}
            value={item}
            path={`${path}[${index}]`}
            label={label}
            onChange={(next) => onChange(items.map((each, at) => (at === index ? next : each)))}
          />
          {fixed ? null : (
            <IconButton
              icon="close"
              label={panelTexts.editor.remove(label, `${path}[${index}]`)}
              onClick={() => onChange(items.filter((_, at) => at !== index))}
            />
          )}
        </div>
      ))}
      {fixed || items.length >= most ? null : (
        <IconButton
          icon="plus"
          label={panelTexts.editor.add(label, path)}
          onClick={() => onChange([...items, draftOf([one])[field.name]])}
        />
      )}
    </fieldset>
  );
}
