// Files of Pyodide's file system whose bytes come when they are first read.

/** The part of Emscripten's file system that is used here. */
export interface FileSystem {
  readonly mkdirTree: (path: string) => void;
  readonly createFile: (folder: string, name: string, properties: object, read: boolean, write: boolean) => object;
  readonly unlink: (path: string) => void;
  readonly ErrnoError: new(number: number) => Error;
}

/** EIO of Emscripten. */
const inputError = 29;

/** `read` must return `size` bytes; otherwise reading the file fails with EIO, and the next read tries again. */
export function lateFile(system: FileSystem, path: string, size: number, read: () => Uint8Array | undefined): void {
  const at = path.lastIndexOf('/');
  system.mkdirTree(path.slice(0, at));
  const node = system.createFile(path.slice(0, at), path.slice(at + 1), {}, true, false);
  let bytes: Uint8Array | undefined;
  const contents = (): Uint8Array => {
    if (bytes !== undefined) return bytes;
    const found = read();
    if (found?.length !== size) throw new system.ErrnoError(inputError);
    bytes = found;
    return found;
  };
  Object.defineProperties(node, {
    contents: { get: contents },
    usedBytes: { get: () => size },
  });
}
