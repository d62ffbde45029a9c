// The trace of a headless run, under Node.js: each line is in the file as soon as it comes, and none is kept.

import { createHash } from 'node:crypto';
import { closeSync, openSync, writeSync } from 'node:fs';
import { MessageTrace, type RunningHash, type SentMessage } from './message_trace.ts';
import { SiteError } from '../contract/site_error.ts';

function nodeHash(): RunningHash {
  const hash = createHash('sha256');
  return { add: (bytes) => void hash.update(bytes), hex: () => hash.copy().digest('hex') };
}

export class TraceFile {
  private readonly file: number;
  private readonly trace = new MessageTrace(nodeHash());

  /** An existing file is overwritten. Throws SiteError R2W0721: it cannot be written. */
  constructor(path: string) {
    try {
      this.file = openSync(path, 'w');
    } catch (error) {
      throw new SiteError('R2W0721', `the trace cannot be written to ${path}: ${error instanceof Error ? error.message : String(error)}`);
    }
  }

  add(node: string, message: SentMessage): void {
    writeSync(this.file, this.trace.add(node, message));
  }

  /** How many messages there were, and the hash of the file. */
  close(): { readonly messages: number; readonly sha256: string; } {
    closeSync(this.file);
    return { messages: this.trace.messages, sha256: this.trace.sha256() };
  }
}
