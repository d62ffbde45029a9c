// Processes that want a processor, those of others too: figures of a busy machine say little.
import { readFileSync } from 'node:fs';

export function machineLoad(): number {
  return Number(readFileSync('/proc/loadavg', 'utf8').split(' ')[0]);
}
