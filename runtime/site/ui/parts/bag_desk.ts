// The bags of a page: those of the site, those that were dropped on it and those that were recorded, the recording that
// goes on and the bag that is played; and the other files that nodes have written. One desk per session, which panel and terminal share.

import { fileName } from '../../contract/file_name.ts';
import { type Bag, type BagSource, openBag } from '../../bag/bag_file.ts';
import { bagName, withEnding } from '../../bag/bag_name.ts';
import type { BagSink } from '../../bag/bag_writer.ts';
import { BagPlayer } from '../../bag/player.ts';
import { Recorder } from '../../bag/recorder.ts';
import type { BagPlace } from '../../ros2cli/command.ts';
import { fetchOfSite } from '../../program/carried_files.ts';
import type { Session, Unsubscribe } from '../../contract/session.ts';
import { type Problem, problemOf } from '../model/problem.ts';

/** Parts of a recording are given to the browser at this size, which keeps them outside of the page's memory. */
const PART_BYTES = 4 << 20;

export interface ShelfBag {
  readonly name: string;
  readonly origin: 'site' | 'file' | 'recorded' | 'written';
  readonly size: number;
  readonly content: () => Promise<Blob>;
}

/** A file other than a bag that a node has written: the newest one of its path. */
export interface NodeFile {
  readonly node: string;
  readonly path: string;
  readonly content: Blob;
}

/** Collects what is written in blobs. */
export class BlobSink implements BagSink {
  private readonly blobs: Blob[] = [];
  private parts: Uint8Array<ArrayBuffer>[] = [];
  private size = 0;

  write(bytes: Uint8Array<ArrayBuffer>): void {
    this.parts.push(bytes);
    this.size += bytes.length;
    if (this.size >= PART_BYTES) this.pack();
  }

  blob(): Blob {
    this.pack();
    return new Blob(this.blobs, { type: 'application/octet-stream' });
  }

  private pack(): void {
    this.blobs.push(new Blob(this.parts));
    this.parts = [];
    this.size = 0;
  }
}

export class BagDesk {
  private readonly session: Session;
  private readonly listeners = new Set<() => void>();
  shelf: readonly ShelfBag[];
  files: readonly NodeFile[] = [];
  recorder: Recorder | undefined;
  private sink: BlobSink | undefined;
  private starting = false;
  private left = false;
  /** The bag in the player, or the one that is being opened for it. */
  loaded: ShelfBag | undefined;
  player: BagPlayer | undefined;
  problem: Problem | undefined;

  constructor(session: Session) {
    this.session = session;
    const listed = session.site.ui['bags'];
    const paths = Array.isArray(listed) ? listed.filter((path): path is string => typeof path === 'string') : [];
    this.shelf = paths.map((path) => ({
      name: path.split('/').at(-1) ?? path,
      origin: 'site',
      size: session.site.files.find((file) => file.path === path)?.size ?? 0,
      content: () => fetchFile(path),
    }));
    // As long as the session: a desk ends with it.
    session.written.onChange(() => this.takeWritten());
    this.takeWritten();
  }

  /** The bags and other files that nodes have written; what stands beside a bag in metadata.yaml is in the bag too. */
  private takeWritten(): void {
    for (const file of this.session.written.take()) {
      const { node, path, content } = file;
      if (path.endsWith('.mcap')) {
        this.put(fileName(path), content, 'written');
      } else if (!path.endsWith('/metadata.yaml')) {
        this.files = [...this.files.filter((one) => one.node !== node || one.path !== path), file];
        this.changed();
      }
    }
  }

  forget(file: NodeFile): void {
    this.files = this.files.filter((one) => one !== file);
    this.changed();
  }

  onChange(listener: () => void): Unsubscribe {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  private readonly changed = (): void => {
    for (const listener of [...this.listeners]) listener();
  };

  async record(wants: (name: string, type: string) => boolean): Promise<void> {
    this.left = false;
    if (this.recorder !== undefined || this.starting) return;
    this.starting = true;
    this.problem = undefined;
    const sink = new BlobSink();
    try {
      this.recorder = await Recorder.begin(this.session, sink, {
        wants,
        onTopic: this.changed,
        onEnd: (problem) => void this.stopRecording().then(() => this.fail(problem)),
      });
      this.sink = sink;
      this.changed();
      if (this.left) await this.stopRecording();
    } catch (error) {
      this.fail(error);
    } finally {
      this.starting = false;
    }
  }

  /** The bag, which lies on the shelf then. */
  async stopRecording(): Promise<ShelfBag | undefined> {
    const { recorder, sink } = this;
    if (recorder === undefined || sink === undefined) return undefined;
    this.recorder = undefined;
    try {
      await recorder.stop();
      const bag = this.put(bagName(recorder.startedAt), sink.blob(), 'recorded');
      return bag;
    } catch (error) {
      this.fail(error);
      return undefined;
    }
  }

  /** For the terminal. */
  readonly place: BagPlace = {
    open: async (name) => {
      // A node's bag is a folder with one file, mostly.
      const names = [name, withEnding(name), `${name.replace(/\/$/, '')}_0.mcap`];
      const bag = names.flatMap((one) => this.shelf.filter((kept) => kept.name === one)).at(0);
      return bag === undefined ? undefined : blobSource(bag.name, await bag.content());
    },
    create: (name) => {
      if (this.shelf.some((one) => one.name === name)) return Promise.resolve(undefined);
      const sink = new BlobSink();
      return Promise.resolve({
        write: (bytes) => sink.write(bytes),
        end: () => void this.put(name, sink.blob(), 'recorded'),
      });
    },
  };

  /** Another one of the same name stays, under that name. */
  put(name: string, blob: Blob, origin: 'file' | 'recorded' | 'written'): ShelfBag {
    let free = name;
    for (let i = 2; this.shelf.some((bag) => bag.name === free); i += 1) free = name.replace(/(\.\w+)?$/, `_${i}$1`);
    const bag: ShelfBag = { name: free, origin, size: blob.size, content: () => Promise.resolve(blob) };
    this.shelf = [...this.shelf, bag];
    this.changed();
    return bag;
  }

  remove(bag: ShelfBag): void {
    if (this.loaded === bag) this.unload();
    this.shelf = this.shelf.filter((one) => one !== bag);
    this.changed();
  }

  /** Puts it on the player. */
  async load(bag: ShelfBag): Promise<BagPlayer | undefined> {
    if (this.loaded === bag) return this.player;
    this.unload();
    this.problem = undefined;
    this.loaded = bag;
    this.changed();
    try {
      const opened = await this.open(bag);
      if (this.loaded !== bag) return undefined;
      this.player = new BagPlayer(this.session.unattended ?? this.session, opened, this.changed);
      this.changed();
    } catch (error) {
      if (this.loaded !== bag) return undefined;
      this.loaded = undefined;
      this.fail(error);
    }
    return this.player;
  }

  /** Opens a bag; the session knows its types afterwards. */
  async open(bag: ShelfBag): Promise<Bag> {
    const opened = await openBag(blobSource(bag.name, await bag.content()));
    await this.session.learn(opened.definitions);
    return opened;
  }

  private unload(): void {
    this.player?.close();
    this.player = undefined;
    this.loaded = undefined;
  }

  fail(error: unknown): void {
    this.problem = problemOf(error);
    this.changed();
  }

  /** Nobody sees it any more: what goes on ends, and its publishers are gone. */
  leave(): void {
    this.left = true;
    this.unload();
    void this.stopRecording();
  }
}

const desks = new WeakMap<Session, BagDesk>();

export function bagDesk(session: Session): BagDesk {
  const known = desks.get(session);
  if (known !== undefined) return known;
  const made = new BagDesk(session);
  desks.set(session, made);
  return made;
}

export function blobSource(name: string, blob: Blob): BagSource {
  return {
    name,
    size: blob.size,
    read: async (from, length) => new Uint8Array(await blob.slice(from, from + length).arrayBuffer()),
  };
}

async function fetchFile(path: string): Promise<Blob> {
  const response = await fetchOfSite(path);
  if (!response.ok) throw new Error(`HTTP ${response.status}`);
  return await response.blob();
}
