// How the time of a site follows real time.

/** It was `siteNs` at `realNs`, grows by `rate`, and stands still at `limitNs`. */
export interface TimeLaw {
  readonly realNs: number;
  readonly siteNs: number;
  /** Above 0; a multiple of 1 / timeRateOne. */
  readonly rate: number;
  /** Infinity: it runs on. */
  readonly limitNs: number;
}

export const ordinaryTime: TimeLaw = { realNs: 0, siteNs: 0, rate: 1, limitNs: Infinity };
