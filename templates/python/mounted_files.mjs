// A folder of this machine among Pyodide's files, to be read only. No link leads out of it, and nothing hidden is
// there. Paths that are looked at are recorded, in the words of bundler/launch/host/python_transcript.hpp.

import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, realpathSync, statSync } from 'node:fs';
import { join, sep } from 'node:path';

const [notPermitted, notThere, invalid, readOnly] = [2, 44, 28, 69]; // as Emscripten counts errors
const someTime = new Date(Date.UTC(2000, 0, 1));
const directory = 0o040555;
const regular = 0o100444;

// Held, so that no code of a workspace can put others in their place.
const call = Function.prototype.call;
const startsWith = call.bind(String.prototype.startsWith);
const slice = call.bind(String.prototype.slice);
const includes = call.bind(String.prototype.includes);

const isHidden = (name) => startsWith(name, '.');
/** Whether a real path is in a folder, by no hidden name. */
const isOpen = (root, path) => path === root || (startsWith(path, root + sep) && !includes(slice(path, root.length), `${sep}.`));

const digest = (bytes) => createHash('sha256').update(bytes).digest('hex');

/** For FS.mount(). `fs`: Pyodide's; options: `from`, a path without links, and `at`, where it is mounted. `seen`: a Map to fill. */
export function mountedFiles(fs, seen) {
  /** Records the state of a path. A more exact state, such as one with a hash, stays. */
  const note = (path, state) => {
    if (!startsWith(`${seen.get(path)} `, `${state} `)) seen.set(path, state);
  };
  const refuse = (code) => {
    throw new fs.ErrnoError(code);
  };
  const node = (parent, name, path, root, at, facts) => {
    const result = fs.createNode(parent, name, facts.isDirectory() ? directory : regular, 0);
    return Object.assign(result, { path, root, at, bytes: facts.isDirectory() ? 4096 : facts.size, node_ops: nodes, stream_ops: streams });
  };
  const nodes = {
    getattr: (of) => ({
      dev: 1,
      ino: of.id,
      mode: of.mode,
      nlink: 1,
      uid: 0,
      gid: 0,
      rdev: 0,
      size: of.bytes,
      atime: someTime,
      mtime: someTime,
      ctime: someTime,
      blksize: 4096,
      blocks: Math.ceil(of.bytes / 4096),
    }),
    lookup(parent, name) {
      let path;
      if (isHidden(name)) refuse(notThere);
      const at = `${parent.at}/${name}`;
      const refuseIt = () => {
        note(at, 'none');
        refuse(notThere);
      };
      try {
        path = realpathSync.native(join(parent.path, name));
      } catch {
        refuseIt();
      }
      if (!isOpen(parent.root, path)) refuseIt();
      const facts = statSync(path);
      if (!facts.isDirectory() && !facts.isFile()) refuseIt();
      note(at, facts.isDirectory() ? 'directory' : `file ${facts.size}`);
      return node(parent, name, path, parent.root, at, facts);
    },
    readdir(of) {
      let names;
      try {
        names = readdirSync(of.path);
      } catch {
        refuse(notPermitted);
      }
      const shown = names.filter((name) => !isHidden(name)).sort();
      note(`${of.at}/`, `names ${digest(shown.map((name) => `${name}\n`).join(''))}`);
      return ['.', '..', ...shown];
    },
    setattr: () => refuse(readOnly),
    mknod: () => refuse(readOnly),
    rename: () => refuse(readOnly),
    unlink: () => refuse(readOnly),
    rmdir: () => refuse(readOnly),
    symlink: () => refuse(readOnly),
    readlink: () => refuse(invalid),
  };
  const streams = {
    open(stream) {
      if ((stream.flags & 3) !== 0) refuse(readOnly);
      if (!fs.isFile(stream.node.mode)) return;
      stream.content = readFileSync(stream.node.path);
      note(stream.node.at, `file ${stream.content.length} ${digest(stream.content)}`);
    },
    read(stream, buffer, offset, length, position) {
      const part = stream.content.subarray(position, position + length);
      buffer.set(part, offset);
      return part.length;
    },
    write: () => refuse(notPermitted),
    llseek(stream, offset, whence) {
      const position = offset + (whence === 1 ? stream.position : whence === 2 ? stream.content.length : 0);
      if (position < 0) refuse(invalid);
      return position;
    },
  };
  // Not looked at: Node.js lets nobody look at a permitted folder, but at what lies in it, when its name is the beginning
  // of that of another permitted one, as `rcl` is of `rclcpp`.
  const top = { isDirectory: () => true, size: 0 };
  return { mount: (mount) => node(null, '/', mount.opts.from, mount.opts.from, mount.opts.at, top) };
}
