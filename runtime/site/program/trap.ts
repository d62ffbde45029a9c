// A WebAssembly trap, made on purpose: the one way out of a program that no handler of the program catches.

// (module (func (export "t") unreachable))
const module = [
  0x00,
  0x61,
  0x73,
  0x6d,
  1,
  0,
  0,
  0, // "\0asm", version 1
  1,
  4,
  1,
  0x60,
  0,
  0, // a type: nothing to nothing
  3,
  2,
  1,
  0, // a function of it
  7,
  5,
  1,
  1,
  0x74,
  0,
  0, // its name outside
  10,
  5,
  1,
  3,
  0,
  0x00,
  0x0b, // its body
];

let instance: WebAssembly.Instance | undefined;

/** Throws a WebAssembly.RuntimeError that passes through programs. */
export function trap(): never {
  instance ??= new WebAssembly.Instance(new WebAssembly.Module(new Uint8Array(module)));
  (instance.exports['t'] as () => void)();
  throw new TypeError('a trap came back');
}

/** Thrown by emscripten_unwind_to_js_event_loop: the thread is done. */
export const unwound: unique symbol = Symbol('unwound');
