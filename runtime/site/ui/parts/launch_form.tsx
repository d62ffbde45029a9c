// The launch arguments of the site as a form. Applying them opens the page again, so that the link has the new values.

import { useState } from 'preact/hooks';
import type { LaunchArgument, LaunchView } from '../../contract/session.ts';
import { isGiven, launchLink, valuesOf } from '../model/launch_link.ts';
import { runTexts } from '../texts_run.ts';

export function LaunchForm({ launch }: { readonly launch: LaunchView; }) {
  const [values, setValues] = useState<ReadonlyMap<string, string>>(
    () => new Map(launch.arguments.map(({ name, value }) => [name, value])),
  );
  const given = isGiven(location.href);
  const apply = (event: Event): void => {
    event.preventDefault();
    location.assign(launchLink(location.href, launch.arguments, values));
  };
  return (
    <details class="launch" open={given}>
      <summary class="launch-title">{runTexts.launch.title}</summary>
      <form class="launch-form" onSubmit={apply}>
        {launch.arguments.map((one) => (
          <Field
            key={one.name}
            argument={one}
            value={values.get(one.name) ?? ''}
            onValue={(value) => setValues((before) => new Map(before).set(one.name, value))}
          />
        ))}
        {launch.python === undefined ? null : <p class="hint">{runTexts.launch.python(launch.python)}</p>}
        {launch.reran ? <p class="hint">{runTexts.launch.reran}</p> : null}
        {launch.decided ? <p class="hint">{runTexts.launch.decided}</p> : null}
        {launch.notes.map((note) => (
          <p class="hint">{note}</p>
        ))}
        <p class="launch-tools">
          <button type="submit" class="button button-main">
            {runTexts.launch.apply}
          </button>
          {given
            ? (
              <button
                type="button"
                class="button"
                onClick={() => location.assign(launchLink(location.href, [], new Map()))}
              >
                {runTexts.launch.defaults}
              </button>
            )
            : null}
        </p>
      </form>
    </details>
  );
}

interface FieldProps {
  readonly argument: LaunchArgument;
  readonly value: string;
  readonly onValue: (value: string) => void;
}

function Field({ argument, value, onValue }: FieldProps) {
  const { name, description, default: usual } = argument;
  const choices = valuesOf(argument);
  const id = `launch-${name}`;
  const about = [description, usual === undefined ? runTexts.launch.none : runTexts.launch.usual(usual)];
  return (
    <div class="launch-field">
      <label class="launch-name" for={id}>
        {name}
      </label>
      {choices === undefined
        ? (
          <input
            id={id}
            class="launch-value"
            type="text"
            value={value}
            autocomplete="off"
            spellcheck={false}
            aria-describedby={`${id}-about`}
            onInput={(event) => onValue(event.currentTarget.value)}
          />
        )
        : (
          <select
            id={id}
            class="launch-value"
            value={value}
            aria-describedby={`${id}-about`}
            onChange={(event) => onValue(event.currentTarget.value)}
          >
            {choices.map((choice) => (
              <option key={choice} value={choice}>
                {choice}
              </option>
            ))}
          </select>
        )}
      <p class="launch-about" id={`${id}-about`}>
        {about.filter((text) => text !== '').join(' \u00b7 ')}
      </p>
    </div>
  );
}
