// An error of a site that is found before any node runs, in the form that the terminal and the page show.

import type { DiagnosticCode } from './diagnostic_codes.ts';

type Texts = string | readonly string[];

const listed = (texts: Texts | undefined): readonly string[] => (typeof texts === 'string' ? [texts] : texts ?? []);

export class SiteError extends Error {
  readonly code: DiagnosticCode;
  readonly why: readonly string[];
  readonly fix: readonly string[];
  /** `file:line:column` of what is to blame. */
  readonly place: string | undefined;

  constructor(code: DiagnosticCode, message: string, more: { readonly why?: Texts; readonly fix?: Texts; readonly place?: string; } = {}) {
    super(message);
    this.name = 'SiteError';
    this.code = code;
    this.why = listed(more.why);
    this.fix = listed(more.fix);
    this.place = more.place;
  }
}
