// Paths as a shell writes them. Pure.

export const HOME = '/home/user';
/** Where the workspace of the site stands, as in every lab sheet. */
export const WORKSPACE = `${HOME}/ros2_ws`;

/** Absolute, without `.`, `..` and doubled slashes. */
export function resolvePath(folder: string, name: string): string {
  const whole = name === '~' || name.startsWith('~/') ? HOME + name.slice(1) : name.startsWith('/') ? name : `${folder}/${name}`;
  const parts: string[] = [];
  for (const part of whole.split('/')) {
    if (part === '..') parts.pop();
    else if (part !== '' && part !== '.') parts.push(part);
  }
  return `/${parts.join('/')}`;
}

/** With `~` for the home folder. */
export function shortPath(path: string): string {
  return path === HOME || path.startsWith(`${HOME}/`) ? `~${path.slice(HOME.length)}` : path;
}

export function parentOf(path: string): string {
  const end = path.lastIndexOf('/');
  return end <= 0 ? '/' : path.slice(0, end);
}

/** Where a file of the workspace stands. `file`: as the site names it. */
export function workspacePath(file: string): string {
  return resolvePath(file.startsWith('src/') ? WORKSPACE : `${WORKSPACE}/src`, file.replace(/^\/+/, ''));
}
