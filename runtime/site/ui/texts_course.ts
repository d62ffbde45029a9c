// Words of the page of a course about its labs' tasks.

export const courseTexts = {
  doneOf: (done: number, all: number): string => `${done} of ${all} tasks done in this browser`,
  labDone: (all: number): string => (all === 1 ? '\u2713 Its task is done' : `\u2713 All ${all} tasks done`),
  course: (done: number, all: number): string => `The whole course: ${done} of ${all} tasks done in this browser.`,
} as const;
