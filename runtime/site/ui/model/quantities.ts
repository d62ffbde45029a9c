// Numbers as people read them: rates, bandwidths, sizes, durations. Pure; units are in the result.

/** `2.00 Hz`, `29.7 Hz`, `1020 Hz`; an en dash when nothing comes. */
export function formatRate(hz: number): string {
  if (!(hz > 0)) return '\u2013';
  return `${threeDigits(hz)} Hz`;
}

/** `118 B/s`, `1.20 kB/s`, `3.40 MB/s`: decimal steps, as `ros2 topic bw` has them. */
export function formatBandwidth(bytesPerSecond: number): string {
  return bytesPerSecond > 0 ? `${formatBytes(bytesPerSecond)}/s` : '\u2013';
}

export function formatBytes(bytes: number): string {
  const units = ['B', 'kB', 'MB', 'GB'];
  let value = bytes;
  let unit = 0;
  while (value >= 999.5 && unit < units.length - 1) {
    value /= 1000;
    unit += 1;
  }
  return `${unit === 0 ? String(Math.round(value)) : threeDigits(value)} ${units[unit] ?? ''}`;
}

/** `12 ms`, `1.2 s`, then as durations: how long ago something was. A time in the future counts as 0. */
export function formatAge(seconds: number): string {
  if (!Number.isFinite(seconds)) return '\u2013';
  const ms = Math.max(0, seconds * 1000);
  if (ms < 999.5) return `${Math.round(ms)} ms`;
  return ms < 9950 ? `${(ms / 1000).toFixed(1)} s` : formatDuration(ms);
}

/** `4 s`, `2:05`, `1:02:03`. */
export function formatDuration(ms: number): string {
  const seconds = Math.max(0, Math.floor(ms / 1000));
  if (seconds < 60) return `${seconds} s`;
  const two = (n: number): string => String(n).padStart(2, '0');
  const minutes = Math.floor(seconds / 60);
  if (minutes < 60) return `${minutes}:${two(seconds % 60)}`;
  return `${Math.floor(minutes / 60)}:${two(minutes % 60)}:${two(seconds % 60)}`;
}

export function formatCount(count: number): string {
  return count.toLocaleString('en-US').replaceAll(',', '\u202f');
}

function threeDigits(value: number): string {
  if (value >= 99.95) return String(Math.round(value));
  return value >= 9.995 ? value.toFixed(1) : value.toFixed(2);
}
