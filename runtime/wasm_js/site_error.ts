// What can go wrong with a site before any node runs, in the form that the terminal and the page show.

export class SiteError extends Error {
  readonly code: string;
  readonly why: readonly string[];
  readonly fix: readonly string[];

  constructor(code: string, message: string, more: { readonly why?: string; readonly fix?: string } = {}) {
    super(message);
    this.name = 'SiteError';
    this.code = code;
    this.why = more.why === undefined ? [] : [more.why];
    this.fix = more.fix === undefined ? [] : [more.fix];
  }
}
