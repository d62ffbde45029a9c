// Puts function names into crash reports: a program's names are a file of their own (`<program>.names`, a module that
// has the "name" section only), fetched when a node has crashed and never before. Pure.

const functionSubsection = 1;
const longestName = 160;

/** Reads the numbers and texts of a name section; reading past its end gives zeros and ends loops. */
class Cursor {
  private readonly bytes: Uint8Array;
  private readonly decoder = new TextDecoder();
  at = 0;

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
  }

  ended(): boolean {
    return this.at >= this.bytes.length;
  }

  number(): number {
    let value = 0;
    for (let scale = 1;; scale *= 128) {
      const byte = this.bytes[this.at++] ?? 0;
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
  }

  skip(size: number): undefined {
    this.at += size;
  }

  text(size: number): string {
    const begin = this.at;
    this.at += size;
    return this.decoder.decode(this.bytes.subarray(begin, this.at));
  }
}

/** The names of the functions `wanted`, by index. Damaged or absent entries have no name. */
export function functionNames(section: Uint8Array, wanted: ReadonlySet<number>): ReadonlyMap<number, string> {
  const names = new Map<number, string>();
  const cursor = new Cursor(section);
  while (!cursor.ended()) {
    const id = cursor.number();
    const size = cursor.number();
    if (id !== functionSubsection) {
      cursor.skip(size);
      continue;
    }
    for (let left = cursor.number(); left > 0 && !cursor.ended(); left -= 1) {
      const index = cursor.number();
      const length = cursor.number();
      const name = wanted.has(index) ? cursor.text(length) : cursor.skip(length);
      if (name !== undefined && name !== '') names.set(index, readable(name));
    }
    break;
  }
  return names;
}

/** A C++ name as people write it: std::string instead of its expansion; cut when it is very long. */
function readable(name: string): string {
  const short = name
    .replaceAll('std::__2::', 'std::')
    .replaceAll(/std::basic_string<char, std::char_traits<char>, std::allocator<char>\s*>/g, 'std::string');
  return short.length <= longestName ? short : `${short.slice(0, longestName - 1)}…`;
}

const frame = /\(?wasm-function\[(\d+)\]:(0x[0-9a-f]+)\)?/g;

/** The functions that a crash report knows by their numbers only. */
export function functionsIn(report: string): ReadonlySet<number> {
  return new Set(Array.from(report.matchAll(frame), ([, index]) => Number(index)));
}

/** The same report with names; `names` is the module of names. The report as it was when nothing fits. */
export async function withNames(report: string, names: BufferSource): Promise<string> {
  try {
    const [section] = WebAssembly.Module.customSections(await WebAssembly.compile(names), 'name');
    if (section === undefined) return report;
    const known = functionNames(new Uint8Array(section), functionsIn(report));
    return report.replaceAll(frame, (whole: string, index: string, offset: string) => {
      const name = known.get(Number(index));
      return name === undefined ? whole : `${name} (${offset})`;
    });
  } catch {
    // A damaged file of names: numbers are better than no report.
    return report;
  }
}
