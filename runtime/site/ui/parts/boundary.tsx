// Keeps a mistake in one panel inside that panel: instead of a blank page it shows what failed.

import { Component } from 'preact';
import type { ComponentChildren } from 'preact';
import { problemOf, type Problem } from '../model/problem.ts';
import { texts } from '../texts.ts';
import { ProblemView } from './problem_view.tsx';

export interface BoundaryProps {
  readonly title: string;
  readonly announce: (text: string) => void;
  readonly children: ComponentChildren;
}

interface BoundaryState {
  readonly failed: boolean;
  readonly thrown: unknown;
}

export class Boundary extends Component<BoundaryProps, BoundaryState> {
  constructor(props: BoundaryProps) {
    super(props);
    this.state = { failed: false, thrown: null };
  }

  override componentDidCatch(thrown: unknown): void {
    this.setState({ failed: true, thrown });
  }

  override render({ title, announce, children }: BoundaryProps, { failed, thrown }: BoundaryState) {
    if (!failed) return children;
    const known = problemOf(thrown);
    const problem: Problem = {
      ...known,
      code: 'R2W0790',
      what: `${texts.problem.panelTitle(title)}: ${known.what}`,
      why: [texts.problem.panelWhy],
      fix: [texts.problem.panelFix],
    };
    return (
      <div class="panel boundary" role="alert">
        <ProblemView problem={problem} announce={announce}>
          <button
            type="button"
            class="button"
            onClick={() => this.setState({ failed: false, thrown: null })}
          >
            {texts.problem.reload}
          </button>
        </ProblemView>
      </div>
    );
  }
}
