// Where the file of a mesh lies in the site, by what a robot description, a marker or another file calls it. The names may
// be anything: only files below share/ are ever meant.

export type MeshKind = 'stl' | 'dae' | 'obj' | 'gltf' | 'glb';

const KINDS: ReadonlySet<string> = new Set<MeshKind>(['stl', 'dae', 'obj', 'gltf', 'glb']);
const MOST_CHARACTERS = 2000;

/** By its ending; null: none that can be read. */
export function meshKindOf(name: string): MeshKind | null {
  const ending = /\.([a-z0-9]+)$/i.exec(name)?.[1]?.toLowerCase() ?? '';
  return isKind(ending) ? ending : null;
}

function isKind(ending: string): ending is MeshKind {
  return KINDS.has(ending);
}

/**
 * `package://arm/meshes/hand.stl`, `file:///opt/ros/jazzy/share/arm/meshes/hand.stl`, `file://$(find arm)/meshes/hand.stl`:
 * share/arm/meshes/hand.stl. null: it is not of a site.
 */
export function sitePathOf(name: string): string | null {
  if (name.length > MOST_CHARACTERS) return null;
  const [, inPackage] = /^(?:package|model):\/\/(.+)$/.exec(name) ?? [];
  const [, found, below] = /^(?:file:\/\/)?\$\(find(?:-pkg-share)? +([^()\s]+)\)\/(.+)$/.exec(name) ?? [];
  const [, shared] = /^(?:file:\/\/)?\/(?:.*?\/)?share\/(.+)$/.exec(name) ?? [];
  const path = inPackage ?? (found === undefined ? shared : `${found}/${below ?? ''}`);
  return path === undefined ? null : normal(`share/${path}`);
}

/** The path of the file that the file at `path` refers to as `name`. null: it is not a file of a site. */
export function besidePath(path: string, name: string): string | null {
  if (name.length > MOST_CHARACTERS) return null;
  if (/^[a-z][a-z0-9+.-]+:/i.test(name) || name.startsWith('/')) return sitePathOf(name);
  return normal(`${path.slice(0, path.lastIndexOf('/') + 1)}${unescaped(name).replaceAll('\\', '/')}`);
}

function unescaped(name: string): string {
  try {
    return decodeURIComponent(name);
  } catch {
    return name; // a name with a percent sign
  }
}

/** null: it leaves share/. */
function normal(path: string): string | null {
  const parts: string[] = [];
  for (const part of path.split('/')) {
    if (part === '..') parts.pop();
    else if (part !== '' && part !== '.') parts.push(part);
    if (parts[0] !== 'share') return null;
  }
  return parts.length > 2 ? parts.join('/') : null;
}
