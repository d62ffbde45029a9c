// The field of a panel's tools that says what is shown.

import { Icon } from './icon.tsx';

export interface SearchFieldProps {
  readonly value: string;
  /** The purpose of the field, in words. */
  readonly label: string;
  readonly onText: (text: string) => void;
}

export function SearchField({ value, label, onText }: SearchFieldProps) {
  return (
    <label class="search">
      <Icon name="search" />
      <input
        type="search"
        value={value}
        placeholder={label}
        aria-label={label}
        // Wide enough for its words; a narrow panel makes it narrower.
        style={{ width: `${Math.max(13, label.length * 0.9)}ch` }}
        onInput={(event) => onText(event.currentTarget.value)}
      />
    </label>
  );
}
