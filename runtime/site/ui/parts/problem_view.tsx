// A problem on the page, in the same form as in the terminal: code, what, where, why, way out.

import type { ComponentChildren } from 'preact';
import { problemText } from '../model/problem.ts';
import type { Problem } from '../model/problem.ts';
import { texts } from '../texts.ts';
import { CopyButton } from './button.tsx';

export interface ProblemViewProps {
  readonly problem: Problem;
  readonly announce: (text: string) => void;
  /** A next step or further information; not part of the report. */
  readonly hint?: string;
  /** More buttons. */
  readonly children?: ComponentChildren;
}

export function ProblemView({ problem, announce, hint, children }: ProblemViewProps) {
  // The lines after the first one have a layout of their own: a stack, what() of an exception.
  const [head, ...rest] = problem.what.split('\n');
  return (
    <div class="problem">
      <p class="problem-what">
        <strong class="problem-code">
          error[{problem.code}]<span class="problem-colon">:</span>
        </strong>{' '}
        {head}
      </p>
      {rest.length === 0 ? null : <pre class="problem-detail">{rest.join('\n')}</pre>}
      {problem.place === null ? null : <p class="problem-place">{`--> ${problem.place}`}</p>}
      {problem.why.length + problem.fix.length === 0 ? null : (
        <dl class="problem-reasons">
          {problem.why.map((why) => (
            <div>
              <dt>{texts.problem.why}</dt>
              <dd>{why}</dd>
            </div>
          ))}
          {problem.fix.map((fix) => (
            <div>
              <dt>{texts.problem.fix}</dt>
              <dd>{fix}</dd>
            </div>
          ))}
        </dl>
      )}
      {hint === undefined ? null : <p class="problem-hint">{hint}</p>}
      <div class="problem-actions">
        {children}
        <CopyButton
          label={texts.problem.copy}
          words={texts.copy}
          text={() => problemText(problem)}
          announce={announce}
        />
      </div>
    </div>
  );
}
