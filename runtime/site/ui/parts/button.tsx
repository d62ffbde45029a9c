// Buttons of the page. An icon button always carries its words as label and tooltip.

import { useState } from 'preact/hooks';
import { copyText } from '../model/clipboard.ts';
import { texts } from '../texts.ts';
import { Icon } from './icon.tsx';
import type { IconName } from './icon.tsx';

export interface IconButtonProps {
  readonly icon: IconName;
  readonly label: string;
  /** Seen below the icon on a phone, which shows no tooltip; a part of the label. */
  readonly words?: string;
  readonly onClick: () => void;
  readonly disabled?: boolean;
  readonly pressed?: boolean;
  readonly class?: string;
}

export function IconButton({
  icon,
  label,
  words,
  onClick,
  disabled,
  pressed,
  class: extra,
}: IconButtonProps) {
  return (
    <button
      type="button"
      class={`icon-button ${extra ?? ''}`}
      aria-label={label}
      title={label}
      aria-disabled={disabled === true ? 'true' : undefined}
      aria-pressed={pressed}
      onClick={() => {
        // A disabled button keeps the keyboard focus where it is: it only does nothing.
        if (disabled !== true) onClick();
      }}
    >
      <Icon name={icon} />
      <IconWords words={words} />
    </button>
  );
}

export function IconWords({ words }: { readonly words: string | undefined; }) {
  return words === undefined ? null : <span class="icon-words">{words}</span>;
}

export interface CopyButtonProps {
  readonly label: string;
  readonly text: () => string;
  readonly announce: (text: string) => void;
  /** Words beside the icon; without them it is an icon button. */
  readonly words?: string;
}

/** Copies, then shows a tick until the next time it is pressed or left. */
export function CopyButton({ label, text, announce, words }: CopyButtonProps) {
  const [done, setDone] = useState(false);
  const copy = (): void => {
    void copyText(text()).then((copied) => {
      setDone(copied);
      announce(copied ? texts.copied : texts.copyFailed);
    });
  };
  return (
    <button
      type="button"
      class={words === undefined ? 'icon-button' : 'button'}
      aria-label={words === undefined ? label : undefined}
      title={label}
      onClick={copy}
      onBlur={() => setDone(false)}
      onPointerLeave={() => setDone(false)}
    >
      <Icon name={done ? 'check' : 'copy'} />
      {words}
    </button>
  );
}
