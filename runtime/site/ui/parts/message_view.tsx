// A message that came: its title, a button that copies it as YAML, and its values as a tree.

import type { ComponentChildren } from 'preact';
import type { Decoded } from '../../decode/decoder.ts';
import { toYaml } from '../../decode/yaml.ts';
import { CopyButton } from './button.tsx';
import { MessageTree } from './message_tree.tsx';
import type { TreeChange, TreeChoice } from './message_tree.tsx';

export interface MessageViewProps {
  readonly title: string;
  /** Beside the title: when it came, how large it is. */
  readonly facts?: string;
  readonly message: Extract<Decoded, { readonly kind: 'value'; }>;
  /** The label of the tree and of the button. */
  readonly label: string;
  readonly copyLabel: string;
  readonly announce: (text: string) => void;
  /** More buttons, before the one that copies. */
  readonly tools?: ComponentChildren;
  /** Between the title and the tree. */
  readonly children?: ComponentChildren;
  readonly change?: TreeChange | undefined;
  readonly choice?: TreeChoice | undefined;
}

export function MessageView({ title, facts, message, label, copyLabel, announce, tools, children, change, choice }: MessageViewProps) {
  const { value, shape } = message;
  return (
    <div class="message">
      <div class="message-head">
        <div class="message-words">
          <h3 class="message-title">{title}</h3>
          {facts === undefined ? null : <span class="message-facts">{facts}</span>}
        </div>
        {tools}
        <CopyButton label={copyLabel} text={() => toYaml(value, shape)} announce={announce} />
      </div>
      {children}
      <MessageTree label={label} value={value} shape={shape} change={change} choice={choice} />
    </div>
  );
}
