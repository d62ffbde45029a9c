// The tools behind `|`, one after the other. Pure.

import type { ShellStep } from '../model/shell_line.ts';
import { shellTexts } from '../texts_shell.ts';
import { textTool } from './text_tools.ts';
import type { LineSink, TextTool } from './text_tools.ts';

export interface Pipe {
  /** Takes one line or several. */
  readonly out: (text: string) => void;
  /** That was all: who waited for it writes what is left. The exit code of the last tool. */
  readonly end: () => number;
}

/** A text says what cannot be. `stop`: nothing more is needed. */
export function openPipe(filters: ShellStep['filters'], out: (text: string) => void, stop: () => void): Pipe | string {
  const parts: { readonly tool: TextTool; readonly sink: LineSink; }[] = [];
  let next = out;
  for (const words of filters.toReversed()) {
    const [program = ''] = words;
    const tool = textTool(words, { out: next, stop });
    if (tool === undefined) return shellTexts.notFilter(program);
    if (typeof tool === 'string') return tool;
    if (tool.files.length > 0) return shellTexts.pipedFile(program);
    const sink = tool.begin(undefined, false);
    next = (text) => text.split('\n').forEach((line) => sink.line(line));
    parts.unshift({ tool, sink });
  }
  const end = (): number => {
    let code = 0;
    for (const { tool, sink } of parts) {
      sink.end();
      code = tool.end(false);
    }
    return code;
  };
  return { out: next, end };
}
