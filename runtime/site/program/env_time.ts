// The clock and calendar functions that Emscripten's C library leaves to JavaScript in programs with threads.
// Civil time is UTC, as in programs without threads, so that output is the same on every machine.

import type { SiteClock } from '../bus/clock.ts';
import type { ProgramMemory } from './program_memory.ts';

type TimeFunction = (...args: never[]) => unknown;

const days = ['Sunday', 'Monday', 'Tuesday', 'Wednesday', 'Thursday', 'Friday', 'Saturday'];
const months = [
  'January',
  'February',
  'March',
  'April',
  'May',
  'June',
  'July',
  'August',
  'September',
  'October',
  'November',
  'December',
];
const dayMs = 86_400_000;

/** The fields of C's struct tm, in the order of its words. */
export interface CivilTime {
  readonly sec: number;
  readonly min: number;
  readonly hour: number;
  readonly mday: number;
  readonly mon: number;
  /** Since 1900. */
  readonly year: number;
  readonly wday: number;
  readonly yday: number;
}

export function civilTime(seconds: number): CivilTime {
  const date = new Date(seconds * 1000);
  const year = date.getUTCFullYear();
  return {
    sec: date.getUTCSeconds(),
    min: date.getUTCMinutes(),
    hour: date.getUTCHours(),
    mday: date.getUTCDate(),
    mon: date.getUTCMonth(),
    year: year - 1900,
    wday: date.getUTCDay(),
    yday: Math.floor((date.getTime() - Date.UTC(year, 0, 1)) / dayMs),
  };
}

/** C's strftime in the "C" locale; conversions that C does not have stay as they are written. */
export function formatTime(format: string, time: CivilTime): string {
  const two = (value: number, fill = '0'): string => String(value).padStart(2, fill);
  const year = time.year + 1900;
  const hour12 = time.hour % 12 === 0 ? 12 : time.hour % 12;
  const day = days[time.wday] ?? '?';
  const month = months[time.mon] ?? '?';
  const conversions: Record<string, () => string> = {
    a: () => day.slice(0, 3),
    A: () => day,
    b: () => month.slice(0, 3),
    h: () => month.slice(0, 3),
    B: () => month,
    c: () => formatTime('%a %b %e %T %Y', time),
    C: () => two(Math.floor(year / 100)),
    d: () => two(time.mday),
    D: () => formatTime('%m/%d/%y', time),
    e: () => two(time.mday, ' '),
    F: () => formatTime('%Y-%m-%d', time),
    H: () => two(time.hour),
    I: () => two(hour12),
    j: () => String(time.yday + 1).padStart(3, '0'),
    m: () => two(time.mon + 1),
    M: () => two(time.min),
    n: () => '\n',
    p: () => (time.hour < 12 ? 'AM' : 'PM'),
    r: () => formatTime('%I:%M:%S %p', time),
    R: () => formatTime('%H:%M', time),
    S: () => two(time.sec),
    t: () => '\t',
    s: () => String(Date.UTC(year, time.mon, time.mday, time.hour, time.min, time.sec) / 1000),
    T: () => formatTime('%H:%M:%S', time),
    u: () => String(time.wday === 0 ? 7 : time.wday),
    w: () => String(time.wday),
    U: () => two(Math.floor((time.yday + 7 - time.wday) / 7)),
    W: () => two(Math.floor((time.yday + 7 - ((time.wday + 6) % 7)) / 7)),
    x: () => formatTime('%m/%d/%y', time),
    X: () => formatTime('%T', time),
    y: () => two(year % 100),
    Y: () => String(year),
    z: () => '+0000',
    Z: () => 'UTC',
    '%': () => '%',
  };
  return format.replace(/%[EO]?([A-Za-z%])/g, (whole, letter: string) => conversions[letter]?.() ?? whole);
}

/** Times are 32 bits wide in this C library. */
export function timeImports(memory: () => ProgramMemory, siteClock: SiteClock): Record<string, TimeFunction> {
  const fields = ['sec', 'min', 'hour', 'mday', 'mon', 'year', 'wday', 'yday'] as const;
  const put = (address: number, seconds: number): void => {
    const time = civilTime(seconds);
    fields.forEach((field, i) => {
      memory().set(address + 4 * i, time[field]);
    });
    memory().set(address + 32, 0); // no daylight saving
    memory().set(address + 36, 0); // no offset
  };
  const get = (address: number): CivilTime => {
    const word = (i: number): number => memory().u32(address + 4 * i) | 0;
    return {
      sec: word(0),
      min: word(1),
      hour: word(2),
      mday: word(3),
      mon: word(4),
      year: word(5),
      wday: word(6),
      yday: word(7),
    };
  };
  const seconds = (address: number): number => memory().u32(address) | 0;
  const strftime = (out: number, size: number, format: number, time: number): number => {
    const bytes = new TextEncoder().encode(formatTime(memory().cString(format), get(time)));
    if (bytes.length + 1 > size >>> 0) return 0;
    memory().u8.set(bytes, out >>> 0);
    memory().u8[(out >>> 0) + bytes.length] = 0;
    return bytes.length;
  };
  const clockGettime = (clock: number, out: number): number => {
    const now = clock === 0 ? siteClock.systemNs() : siteClock.steadyNs();
    memory().set(out, Math.floor(now / 1e9));
    memory().set(out + 4, Math.floor(now % 1e9));
    return 0;
  };
  const clockGetres = (_clock: number, out: number): number => {
    memory().set(out, 0);
    memory().set(out + 4, 1000);
    return 0;
  };
  const mktime = (time: number): number => {
    const { year, mon, mday, hour, min, sec } = get(time);
    const result = Date.UTC(year + 1900, mon, mday, hour, min, sec) / 1000;
    put(time, result);
    return result | 0;
  };
  return {
    clock_gettime: clockGettime,
    __clock_gettime: clockGettime,
    clock_getres: clockGetres,
    time: (out: number): number => {
      const now = Math.floor(siteClock.systemNs() / 1e9);
      if (out !== 0) memory().set(out, now);
      return now;
    },
    strftime,
    strftime_l: strftime,
    _tzset_js: (): void => undefined,
    _localtime_js: (time: number, out: number): void => {
      put(out, seconds(time));
    },
    _gmtime_js: (time: number, out: number): void => {
      put(out, seconds(time));
    },
    _mktime_js: mktime,
    _timegm_js: mktime,
  };
}
