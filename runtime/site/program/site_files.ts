// The files that a site has for programs: the share trees of its packages, below /opt/ros/DISTRO. A program gets the list
// when it starts to use files, and the bytes of one when it first opens it (SPEC.md 3.4).

import { ErrorCode } from '../../protocol/generated/constants.ts';
import type { HostFunction } from './host_imports.ts';
import type { OutputGate } from './output_gate.ts';
import type { ProgramMemory } from './program_memory.ts';
import type { SiteDescription } from '../contract/session.ts';

export interface SiteFiles {
  readonly prefix: string;
  /** Where the site lies: its address, or its folder. */
  readonly place: string;
  /** Path below the prefix, which is also the one in the site, and size in bytes. */
  readonly files: readonly (readonly [path: string, size: number])[];
}

/** Without leaving the call. undefined: it cannot be had. */
export type ReadNow = (place: string, path: string) => Uint8Array | undefined;

const shared = 'share/';
const markers = 'share/ament_index/resource_index/packages/';

export function prefixOf(site: SiteDescription): string {
  return `/opt/ros/${site.distro}`;
}

export function siteFiles(site: SiteDescription, place: string): SiteFiles {
  const sizes = new Map(site.packages.map((name) => [`${markers}${name}`, 0]));
  for (const { path, size } of site.files) if (path.startsWith(shared)) sizes.set(path, size);
  return { prefix: prefixOf(site), place, files: [...sizes] };
}

/** Where programs begin. */
export const homeFolder = '/home/user';

/** The environment of each program; the variables of its node override it. */
export function siteEnvironment(site: SiteDescription): Readonly<Record<string, string>> {
  return {
    AMENT_PREFIX_PATH: prefixOf(site),
    HOME: homeFolder,
    PWD: homeFolder,
    USER: 'user',
    ROS_DISTRO: site.distro,
    ROS_PYTHON_VERSION: '3',
    ROS_VERSION: '2',
  };
}

export function fileImports(
  { prefix, place, files }: SiteFiles,
  readNow: ReadNow,
  memory: () => ProgramMemory,
  give: (path: string, bytes: Uint8Array<ArrayBuffer>) => void,
  gate: OutputGate,
): Record<string, HostFunction> {
  let encoded: Uint8Array | undefined;
  return {
    file_list: (buffer: number, capacity: number): number => {
      encoded ??= encodeList(prefix, files);
      if (encoded.length <= capacity) memory().u8.set(encoded, buffer >>> 0);
      return encoded.length;
    },
    file_read: (path: number, length: number, buffer: number, size: number): number => {
      const wanted = memory().text(path, length);
      const file = files.find(([name]) => `${prefix}/${name}` === wanted);
      const bytes = file === undefined ? undefined : readNow(place, file[0]);
      if (bytes === undefined || bytes.length !== size >>> 0) return ErrorCode.unsupported;
      memory().u8.set(bytes, buffer >>> 0);
      return bytes.length;
    },
    file_give: (path: number, length: number, data: number, size: number): void => {
      give(memory().text(path, length), memory().slice(data, size));
    },
    file_closed: (path: number, length: number, data: number, size: number): number => {
      const name = memory().text(path, length);
      const passes = gate.passes(name, size >>> 0);
      if (passes === 'later') return 0;
      if (passes === 'now') give(name, memory().slice(data, size));
      return 1;
    },
  };
}

function encodeList(prefix: string, files: SiteFiles['files']): Uint8Array {
  const paths = files.map(([path]) => new TextEncoder().encode(`${prefix}/${path}`));
  const bytes = new Uint8Array(4 + paths.reduce((sum, path) => sum + 8 + path.length, 0));
  const view = new DataView(bytes.buffer);
  view.setUint32(0, files.length, true);
  let at = 4;
  paths.forEach((path, i) => {
    view.setUint32(at, files[i]?.[1] ?? 0, true);
    view.setUint32(at + 4, path.length, true);
    bytes.set(path, at + 8);
    at += 8 + path.length;
  });
  return bytes;
}
