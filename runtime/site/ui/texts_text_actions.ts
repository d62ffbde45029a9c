// Words of what the links of a lab sheet do. They come with the panel.

import type { CheckView, GoalStatus } from '../contract/session.ts';

const GOAL: Readonly<Record<GoalStatus, string>> = {
  unknown: 'waits for the server\u2026',
  accepted: 'accepted',
  executing: 'executing',
  canceling: 'canceling',
  succeeded: 'succeeded',
  canceled: 'canceled',
  aborted: 'aborted',
};

const CHECK: Readonly<Record<CheckView['state'], string>> = { waiting: 'Looking', passed: 'Passed', failed: 'Failed' };

export const textActionTexts = {
  nobody: (name: string): string => `no node offers ${name}`,
  calling: (name: string): string => `Calls ${name}\u2026`,
  replied: (name: string, reply: string): string => `Reply of ${name}:\n${reply}`,
  goal: (name: string, status: GoalStatus): string => `Goal of ${name}: ${GOAL[status]}`,
  result: (name: string, status: GoalStatus, result: string): string => `Goal of ${name}: ${GOAL[status]}\n${result}`,
  noCheck: (name: string): string => (name === '' ? 'This site has no checks.' : `This site has no check \u201c${name}\u201d.`),
  checks: (views: readonly CheckView[]): string =>
    views.map(({ state, title, seen }) => `${CHECK[state]}: ${title}${seen === '' ? '' : ` (${seen})`}`).join('\n'),
  paused: 'Time is held.',
  resumed: 'Time goes on.',
  stepped: (ms: number): string => `Time went on by ${ms} ms.`,
  runs: (line: string): string => `In the terminal: ${line}`,
  busy: 'The terminal runs another command. End it first (Ctrl-C).',
} as const;
