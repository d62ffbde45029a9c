// The paths that a plot or a timeline follows: each with its colour, its newest value and a button that leaves it out,
// and a field for one more, with the paths that the topics offer.

import { useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { parseFieldPath, pathsOf } from '../model/field_path.ts';
import type { FieldKind } from '../model/field_path.ts';
import { isHiddenTopic } from '../model/hidden_names.ts';
import { panelTexts } from '../texts_panels.ts';
import { IconButton } from './button.tsx';
import { Name } from './name.tsx';
import { useTopics } from './watch.ts';

export interface PathEntry {
  readonly path: string;
  /** Its newest value, or why there is none. */
  readonly words: string;
  /** 1 to 8; 0 for none. */
  readonly color: number;
}

export interface PathListProps {
  readonly session: Session;
  readonly codec: Codec | string | null;
  readonly kind: FieldKind;
  readonly instance: string;
  readonly entries: readonly PathEntry[];
  readonly onChange: (paths: readonly string[]) => void;
}

const MOST_PATHS = 16;
const MOST_OFFERS = 400;

export function PathList({ session, codec, kind, instance, entries, onChange }: PathListProps) {
  const [text, setText] = useState('');
  const [problem, setProblem] = useState('');
  const topics = useTopics(session);
  const paths = entries.map((entry) => entry.path);
  const offers = codec === null || typeof codec === 'string'
    ? []
    : topics
      .filter((topic) => !isHiddenTopic(topic.name) && topic.type !== '')
      .flatMap((topic) => {
        const type = codec.types.get(topic.type);
        return typeof type === 'string' ? [] : pathsOf(topic.name, type.shape, kind);
      })
      .filter((path) => !paths.includes(path))
      .slice(0, MOST_OFFERS);
  const add = (wanted: string): void => {
    const path = wanted.trim();
    if (parseFieldPath(path) === null) {
      setProblem(panelTexts.paths.wrong);
      return;
    }
    setProblem('');
    setText('');
    if (!paths.includes(path) && paths.length < MOST_PATHS) onChange([...paths, path]);
  };
  const list = `paths-${instance}`;
  return (
    <div class="paths">
      <ul class="path-list" role="list" aria-label={panelTexts.paths.shown}>
        {entries.map((entry) => (
          <li class="path" key={entry.path}>
            {entry.color === 0 ? null : <span class={`path-color plot-color-${entry.color}`} />}
            <span class="path-name">
              <Name text={entry.path} />
            </span>
            <span class="path-value">{entry.words}</span>
            <IconButton
              icon="close"
              label={panelTexts.paths.remove(entry.path)}
              onClick={() => onChange(paths.filter((path) => path !== entry.path))}
            />
          </li>
        ))}
      </ul>
      <form
        class="path-add"
        onSubmit={(event) => {
          event.preventDefault();
          add(text);
        }}
      >
        <input
          type="text"
          class="field"
          list={list}
          value={text}
          placeholder={panelTexts.paths.hint}
          aria-label={panelTexts.paths.add}
          autocomplete="off"
          autocapitalize="off"
          spellcheck={false}
          onInput={(event) => {
            const { value } = event.currentTarget;
            // One that was chosen from the list is meant as it is.
            if (offers.includes(value) && !text.startsWith(value)) add(value);
            else setText(value);
          }}
        />
        <datalist id={list}>
          {offers.map((path) => (
            <option key={path} value={path} />
          ))}
        </datalist>
        <button type="submit" class="button">
          {panelTexts.paths.addShort}
        </button>
      </form>
      {problem === '' ? null : (
        <p class="hint" role="alert">
          {problem}
        </p>
      )}
    </div>
  );
}
