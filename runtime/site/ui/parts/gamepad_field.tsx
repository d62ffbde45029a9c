// Whether Teleop drives by a gamepad, or that a node of the site reads it.

import { panelTexts } from '../texts_panels.ts';

export interface GamepadFieldProps {
  /** The name of the gamepad; empty: there is none. */
  readonly pad: string;
  readonly isForNode: boolean;
  readonly isUsed: boolean;
  readonly onUse: (isUsed: boolean) => void;
}

export function GamepadField({ pad, isForNode, isUsed, onUse }: GamepadFieldProps) {
  const words = panelTexts.teleop;
  if (isForNode) {
    return (
      <p class="hint" role="status">
        {pad === '' ? words.padWanted : words.padForNode(pad)}
      </p>
    );
  }
  return (
    <label class="check">
      <input type="checkbox" checked={isUsed} onChange={(event) => onUse(event.currentTarget.checked)} />
      {pad === '' ? words.gamepad : words.gamepadOf(pad)}
    </label>
  );
}
