// Texts of how the site is run: launch arguments, seeds, what nodes are told. They come when they are asked for.

export const runTexts = {
  launch: {
    title: 'Launch arguments',
    apply: 'Apply and restart',
    defaults: 'Back to defaults',
    usual: (value: string): string => (value === '' ? 'default: empty' : `default: ${value}`),
    none: 'no default',
    python: ({ program, tried }: { readonly program?: string; readonly tried: readonly string[]; }): string =>
      program !== undefined
        ? 'The launch file is written in Python: what only Python decides is asked of it again, in this page.'
        : tried.length === 0
        ? 'The launch file is written in Python: what only Python decides stays as it was packed.'
        : `The launch file is written in Python: what only Python decides was packed for each value of ${
          tried.join(', ')
        }; with other values it stays as it was packed.`,
    reran: 'Python was asked again for these values.',
    decided: 'Some of what runs was decided in Python when the site was packed, for other values of the arguments.',
  },
  seed: {
    label: 'Seed',
    about: 'One node runs at a time, and time is held at first: every run with this seed sends the same messages.',
    wrong: 'A seed is a whole number below 1,000,000,000.',
    apply: 'Restart with this seed',
    leave: 'Restart without a seed',
  },
  input: {
    label: (label: string): string => `Standard input of ${label}`,
    hint: 'Type a line, then Enter; Ctrl-C stops',
    keys: 'Keys go to the node at once; Tab leads on',
    send: 'Send',
  },
} as const;
