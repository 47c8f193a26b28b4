import { isAtOrBelow } from '../motion/fly.ts';
import type { Mesh, Scene } from '../types.ts';

/**
 * Merges scenes. Duplicate top-level names of later scenes are numbered: `/Ball`, `/Ball2`. The first scene determines up axis, units, title and hints; the time
 * range covers all.
 */
export function mergeScenes(scenes: readonly Scene[]): Scene {
  const [first, ...others] = scenes;
  if (!first) throw new RangeError('there is nothing to merge');
  return others.reduce(joined, first);
}

function joined(a: Scene, b: Scene): Scene {
  const renamedB = renamed(b, pathsOf(a));
  const hints = { ...b.hints, ...a.hints };
  const variants = [...(a.variants ?? []), ...(b.variants ?? [])];
  return {
    ...a,
    ...rangeOf(a, b),
    objects: [...a.objects, ...renamedB.objects.map((o) => ({ ...o, mesh: shifted(o.mesh, a.materials.length) }))],
    materials: [...a.materials, ...b.materials],
    lights: [...a.lights, ...renamedB.lights],
    cameras: [...a.cameras, ...renamedB.cameras],
    hints,
    ...(variants.length > 0 && { variants }),
    diagnostics: [...a.diagnostics, ...b.diagnostics],
  };
}

const shifted = (mesh: Mesh, by: number): Mesh => ({
  ...mesh,
  groups: mesh.groups.map((group) => ({ ...group, material: group.material + by })),
});

/** The time range of both; a scene without animation has none. */
function rangeOf(a: Scene, b: Scene): Pick<Scene, 'startTime' | 'endTime'> {
  if (b.endTime <= b.startTime) return { startTime: a.startTime, endTime: a.endTime };
  if (a.endTime <= a.startTime) return { startTime: b.startTime, endTime: b.endTime };
  return { startTime: Math.min(a.startTime, b.startTime), endTime: Math.max(a.endTime, b.endTime) };
}

const pathsOf = ({ objects, lights, cameras }: Scene): string[] =>
  [...objects, ...lights, ...cameras].map(({ path }) => path);

/** Renames top-level names that are already used by others. */
function renamed(scene: Scene, others: readonly string[]): Scene {
  const taken = new Set(others.map(rootOf));
  const names = new Map<string, string>();
  for (const root of new Set(pathsOf(scene).map(rootOf))) {
    const name = uniqueName(root, taken);
    taken.add(name);
    names.set(root, name);
  }
  const newPath = (path: string): string => names.get(rootOf(path)) + path.slice(rootOf(path).length);
  const rename = <T extends { readonly path: string; readonly pieceOf?: string }>(item: T): T => ({
    ...item,
    path: newPath(item.path),
    ...(item.pieceOf !== undefined && { pieceOf: newPath(item.pieceOf) }),
  });
  return {
    ...scene,
    objects: scene.objects.map(rename),
    lights: scene.lights.map(rename),
    cameras: scene.cameras.map(rename),
  };
}

/** `/World/Car/Wheel` → `/World` */
const rootOf = (path: string): string => path.slice(0, path.indexOf('/', 1) < 0 ? undefined : path.indexOf('/', 1));

/** The name, or if it is taken, followed by the smallest number from 2 on that makes it unique. */
export function uniqueName(name: string, taken: ReadonlySet<string>): string {
  if (!taken.has(name)) return name;
  let number = 2;
  while (taken.has(`${name}${number}`)) number++;
  return `${name}${number}`;
}

/** Whether `path` is `root` or below it; always true if `root` is empty. */
export const matchesPath = (path: string, root: string): boolean => root === '' || isAtOrBelow(path, root);
