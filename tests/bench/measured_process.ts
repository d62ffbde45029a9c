// Runs a command and reads what the operating system says of it: wall time and peak memory.
// Python's resource module is used because Node.js does not report a child's peak memory.
import { spawnSync } from 'node:child_process';

export interface Measured {
  readonly wallMs: number;
  /** User plus system time of the command and its children. */
  readonly cpuMs: number;
  /** Largest resident set of any one process of the command, in kB. */
  readonly peakKb: number;
  readonly exitCode: number;
  readonly stderr: string;
}

const PROGRAM = `
import json, resource, subprocess, sys, time
before = resource.getrusage(resource.RUSAGE_CHILDREN)  # python3 may be a script that started others
began = time.perf_counter()
run = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
wall = time.perf_counter() - began
use = resource.getrusage(resource.RUSAGE_CHILDREN)
print(json.dumps({"wallMs": wall * 1e3, "cpuMs": (use.ru_utime + use.ru_stime - before.ru_utime - before.ru_stime) * 1e3,
                  "peakKb": use.ru_maxrss, "exitCode": run.returncode, "stderr": run.stderr[-4000:]}))
`;

export function measure(command: readonly string[], environment: NodeJS.ProcessEnv = process.env): Measured {
  const run = spawnSync('python3', ['-c', PROGRAM, ...command], { encoding: 'utf8', env: environment });
  if (run.status !== 0) throw new Error(run.stderr);
  return JSON.parse(run.stdout) as Measured;
}
