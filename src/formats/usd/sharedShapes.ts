import type { Mesh } from '../../scene/types.ts';
import type { PrimSpec } from './layer.ts';
import type { Shape } from './shape.ts';
import type { Surface } from './surface.ts';

/** Shapes by what they are made of: prims with the same opinions and the same materials, as instances are, have one. */
export class SharedShapes {
  private readonly known = new Map<string, Shape | undefined>();

  of(prim: PrimSpec, surface: Surface, make: () => Shape | undefined): Shape | undefined {
    const key = keyOf(prim, surface);
    if (key === undefined) return make();
    if (!this.known.has(key)) this.known.set(key, make());
    return this.known.get(key);
  }
}

function keyOf({ content, children }: PrimSpec, { materials }: Surface): string | undefined {
  if (content === undefined) return undefined;
  const subsets = [...children.values()].map((child) => child.content);
  return [content, ...subsets, 'wears', ...materials].join(' ');
}

const REMADE = new WeakMap<Mesh, Map<string, Mesh>>();

/** The mesh with one of its materials exchanged; the same one for the same. */
export function remade(mesh: Mesh, from: number, to: number): Mesh {
  const known = REMADE.get(mesh) ?? new Map<string, Mesh>();
  REMADE.set(mesh, known);
  const key = `${from} ${to}`;
  const groups = mesh.groups.map((g) => (g.material === from ? { ...g, material: to } : g));
  const made = known.get(key) ?? { ...mesh, groups };
  known.set(key, made);
  return made;
}
