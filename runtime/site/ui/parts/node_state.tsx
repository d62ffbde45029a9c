// A node's state as people see it: a shape, a word and a colour that say the same.

import type { NodeMoment, NodeState, NodeView } from '../../contract/session.ts';
import { unreachable } from '../../contract/session.ts';
import { texts } from '../texts.ts';
import { Icon } from './icon.tsx';
import type { IconName } from './icon.tsx';

export type StateTone = 'idle' | 'busy' | 'good' | 'done' | 'bad';

export interface StateLook {
  readonly words: string;
  readonly icon: IconName;
  readonly tone: StateTone;
}

function waitingWords(on: NodeMoment): string {
  switch (on.event) {
    case 'start':
      return texts.state.waitsForStart(on.node);
    case 'exit':
      return texts.state.waitsForEnd(on.node);
    case 'output':
      return texts.state.waitsForLine(on.node);
    case 'transition':
      return texts.state.waitsForChange(on.name, on.goalState);
    default:
      return unreachable(on);
  }
}

export function stateLook(state: NodeState): StateLook {
  switch (state.kind) {
    case 'stopped':
      return { words: texts.state.stopped, icon: 'ring', tone: 'idle' };
    case 'waiting':
      return { words: waitingWords(state.on), icon: 'ring', tone: 'idle' };
    case 'starting':
      return { words: texts.state.starting, icon: 'arc', tone: 'busy' };
    case 'running':
      return { words: texts.state.running, icon: 'disc', tone: 'good' };
    case 'exited':
      return state.code === 0
        ? { words: texts.state.finished, icon: 'check', tone: 'done' }
        : { words: texts.state.exited(state.code), icon: 'warning', tone: 'bad' };
    case 'crashed':
      return { words: texts.state.crashed, icon: 'crash', tone: 'bad' };
    default:
      return unreachable(state);
  }
}

/** Its worker runs, its interpreter does not yet. */
const LOADING: StateLook = { words: texts.state.loading, icon: 'arc', tone: 'busy' };

/** Whether stopping makes sense. */
export function isAlive(state: NodeState): boolean {
  return state.kind === 'starting' || state.kind === 'running';
}

export function StateBadge({ node: { state, loading } }: { readonly node: Pick<NodeView, 'state' | 'loading'>; }) {
  const look = state.kind === 'running' && loading === true ? LOADING : stateLook(state);
  return (
    <span class={`state state-${look.tone}`}>
      <Icon name={look.icon} class={look.tone === 'busy' ? 'turning' : ''} />
      {look.words}
    </span>
  );
}
