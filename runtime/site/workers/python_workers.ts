// The workers of Python programs. They load what runs Python while the program and its archives are on their way; in a
// browser one that has done so waits for the next start, which takes a third less time then: a lab is edited and started again.

import { whenIdle } from '../contract/idle.ts';
import type { Platform, WorkerEvents, WorkerHandle } from './platform.ts';
import { folderOf, homeOf, type PythonFiles } from '../python/python_files.ts';

interface Spare {
  readonly program: string;
  readonly worker: WorkerHandle;
  /** The handlers of the node that gets this worker; undefined: it is still spare. */
  events: WorkerEvents | undefined;
}

export class PythonWorkers {
  readonly files: PythonFiles;
  private readonly platform: Platform;
  private spare: Spare | undefined;
  private closed = false;

  constructor(platform: Platform, files: PythonFiles) {
    this.platform = platform;
    this.files = files;
  }

  start(program: string, name: string, events: WorkerEvents): WorkerHandle {
    const { spare } = this;
    if (spare?.program === program) {
      this.spare = undefined;
      spare.events = events;
      return spare.worker;
    }
    return this.begun(program, name, events);
  }

  /** A program has made what it makes: the next one can have a worker at once. */
  settled(program: string): void {
    if (this.platform.kept === undefined) return;
    whenIdle(() => {
      if (this.closed || this.spare !== undefined) return;
      const worker = this.begun(program, 'python', {
        report: (report) => spare.events?.report(report),
        failed: (message, code) => {
          if (this.spare === spare) this.spare = undefined;
          spare.events?.failed(message, code);
        },
      });
      const spare: Spare = { program, worker, events: undefined };
      this.spare = spare;
    });
  }

  close(): void {
    this.closed = true;
    void this.spare?.worker.terminate();
    this.spare = undefined;
  }

  private begun(program: string, name: string, events: WorkerEvents): WorkerHandle {
    const worker = this.platform.startWorker(name, events);
    // Files that differ from the packed ones are not loaded; a node that asks for the program's parts gets the error.
    this.files.scripts(program).then(() => {
      worker.post({ t: 'python', base: folderOf(this.platform.place), home: homeOf(program) }, []);
    }, () => undefined);
    return worker;
  }
}
