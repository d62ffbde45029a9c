// launch_evaluator.wasm by itself, for as many questions as one likes. JSON in, JSON out; of the world only what the place
// gives (bundler/render/launch_start.hpp).

import { SiteError } from '../contract/site_error.ts';

export type Evaluate = (question: string) => unknown;

/** Where launch files in Python can be run. */
export interface LaunchPlace {
  /** A line of JSON to Python, and its answer; `reply` answers what it asks meanwhile. */
  readonly python: (request: string, reply: (asked: string) => string) => string;
  /** The text of a file of the site, by its path. */
  readonly file: (path: string) => string | undefined;
}

interface EvaluatorExports {
  readonly memory: WebAssembly.Memory;
  readonly _initialize: () => void;
  readonly ros2wasm_question: (size: number) => number;
  readonly ros2wasm_evaluate: (question: number, size: number, isLive: number) => number;
  readonly ros2wasm_answer: () => number;
  readonly ros2wasm_reply: (asked: number, size: number) => number;
  readonly ros2wasm_reply_text: () => number;
}

/** Without a place, what Python answered when the site was packed stands. */
export async function openEvaluator(module: WebAssembly.Module, place?: LaunchPlace): Promise<Evaluate> {
  let failure: unknown;
  /** Nothing is thrown through the program, which could catch it. */
  const guarded = (run: () => string | undefined): number => {
    try {
      const text = failure === undefined ? run() : undefined;
      return text === undefined ? 0 : put(text)[0];
    } catch (error) {
      failure ??= error;
      return 0;
    }
  };
  const reply = (asked: string): string => {
    if (failure !== undefined) return '{}';
    try {
      const size = evaluator.ros2wasm_reply(...put(asked));
      return textAt(evaluator.ros2wasm_reply_text(), size);
    } catch (error) {
      failure ??= error;
      return '{}';
    }
  };
  const instance = await WebAssembly.instantiate(module, {
    env: { emscripten_notify_memory_growth: () => undefined },
    ros2wasm_launch: {
      python: (at: number, size: number) => guarded(() => place?.python(textAt(at, size), reply)),
      file: (at: number, size: number) => guarded(() => place?.file(textAt(at, size))),
    },
    wasi_snapshot_preview1: {
      proc_exit: (code: number) => {
        throw new SiteError('R2W0733', `the evaluation of the launch file ended with ${code}`, {
          why: 'it may need more memory than this browser gives',
          fix: 'leave the launch arguments out of the address',
        });
      },
      environ_get: () => 0,
      environ_sizes_get: (count: number, size: number) => {
        const words = new DataView(evaluator.memory.buffer);
        words.setUint32(count, 0, true);
        words.setUint32(size, 0, true);
        return 0;
      },
    },
  });
  const evaluator = instance.exports as unknown as EvaluatorExports;
  const textAt = (at: number, size: number): string => new TextDecoder().decode(new Uint8Array(evaluator.memory.buffer, at >>> 0, size >>> 0));
  const put = (text: string): [at: number, size: number] => {
    const bytes = new TextEncoder().encode(text);
    const at = evaluator.ros2wasm_question(bytes.length);
    new Uint8Array(evaluator.memory.buffer, at, bytes.length).set(bytes);
    return [at, bytes.length];
  };
  evaluator._initialize();
  return (question) => {
    const size = evaluator.ros2wasm_evaluate(...put(question), place === undefined ? 0 : 1);
    if (failure !== undefined) throw failure;
    return JSON.parse(textAt(evaluator.ros2wasm_answer(), size)) as unknown;
  };
}
