import { isAtOrBelow } from '../motion/fly.ts';
import type { Mesh, Scene } from '../types.ts';

/**
 * Several scenes as one. Where two have things of one path those of the later get a number: `/Ball`, `/Ball2`. The first has the say
 * where there can be only one: which axis is up, units, title, suggestions; the range of time holds all of theirs.
 */
export function mergeScenes(scenes: readonly Scene[]): Scene {
  const [first, ...others] = scenes;
  if (!first) throw new RangeError('there is nothing to merge');
  return others.reduce(joined, first);
}

function joined(a: Scene, b: Scene): Scene {
  const named = renamed(b, pathsOf(a));
  const hints = { ...b.hints, ...a.hints };
  const variants = [...(a.variants ?? []), ...(b.variants ?? [])];
  return {
    ...a,
    ...rangeOf(a, b),
    objects: [...a.objects, ...named.objects.map((o) => ({ ...o, mesh: shifted(o.mesh, a.materials.length) }))],
    materials: [...a.materials, ...b.materials],
    lights: [...a.lights, ...named.lights],
    cameras: [...a.cameras, ...named.cameras],
    hints,
    ...(variants.length > 0 && { variants }),
    diagnostics: [...a.diagnostics, ...b.diagnostics],
  };
}

const shifted = (mesh: Mesh, by: number): Mesh => ({
  ...mesh,
  groups: mesh.groups.map((group) => ({ ...group, material: group.material + by })),
});

/** What does not move has no range of its own. */
function rangeOf(a: Scene, b: Scene): Pick<Scene, 'startTime' | 'endTime'> {
  if (b.endTime <= b.startTime) return { startTime: a.startTime, endTime: a.endTime };
  if (a.endTime <= a.startTime) return { startTime: b.startTime, endTime: b.endTime };
  return { startTime: Math.min(a.startTime, b.startTime), endTime: Math.max(a.endTime, b.endTime) };
}

const pathsOf = ({ objects, lights, cameras }: Scene): string[] =>
  [...objects, ...lights, ...cameras].map(({ path }) => path);

/** The scene with its top-level names changed where others have them. */
function renamed(scene: Scene, others: readonly string[]): Scene {
  const taken = new Set(others.map(rootOf));
  const names = new Map<string, string>();
  for (const root of new Set(pathsOf(scene).map(rootOf))) {
    const name = uniqueName(root, taken);
    taken.add(name);
    names.set(root, name);
  }
  const rename = <T extends { readonly path: string }>(thing: T): T => {
    const root = rootOf(thing.path);
    return { ...thing, path: names.get(root) + thing.path.slice(root.length) };
  };
  return {
    ...scene,
    objects: scene.objects.map(rename),
    lights: scene.lights.map(rename),
    cameras: scene.cameras.map(rename),
  };
}

/** `/World/Car/Wheel` → `/World` */
const rootOf = (path: string): string => path.slice(0, path.indexOf('/', 1) < 0 ? undefined : path.indexOf('/', 1));

/** The name, or with the least number from 2 on that makes it free. */
export function uniqueName(name: string, taken: ReadonlySet<string>): string {
  if (!taken.has(name)) return name;
  let number = 2;
  while (taken.has(`${name}${number}`)) number++;
  return `${name}${number}`;
}

/** The things at a path and below it; all where it is empty. */
export const matchesPath = (path: string, wanted: string): boolean => wanted === '' || isAtOrBelow(path, wanted);
