// The seed of a stepped run. Setting one opens the page again, so that the link has the new seed.

import { useState } from 'preact/hooks';
import { isSeed, seedLink } from '../model/seed_link.ts';
import { runTexts } from '../texts_run.ts';

/** `seed`: of the run that goes on; undefined: nodes run side by side. */
export function SeedForm({ seed }: { readonly seed: number | undefined; }) {
  const [text, setText] = useState(String(seed ?? 1));
  const apply = (event: Event): void => {
    event.preventDefault();
    if (isSeed(text)) location.assign(seedLink(location.href, text));
  };
  return (
    <form class="launch-form" onSubmit={apply}>
      <div class="launch-field">
        <label class="launch-name" for="seed">
          {runTexts.seed.label}
        </label>
        <input
          id="seed"
          class="launch-value"
          type="text"
          inputmode="numeric"
          value={text}
          autocomplete="off"
          aria-invalid={!isSeed(text)}
          aria-describedby="seed-about"
          onInput={(event) => setText(event.currentTarget.value.trim())}
        />
        <p class="launch-about" id="seed-about">
          {isSeed(text) ? runTexts.seed.about : runTexts.seed.wrong}
        </p>
      </div>
      <p class="launch-tools">
        <button type="submit" class="button button-main" aria-disabled={!isSeed(text)}>
          {runTexts.seed.apply}
        </button>
        {seed === undefined ? null : (
          <button type="button" class="button" onClick={() => location.assign(seedLink(location.href, undefined))}>
            {runTexts.seed.leave}
          </button>
        )}
      </p>
    </form>
  );
}
