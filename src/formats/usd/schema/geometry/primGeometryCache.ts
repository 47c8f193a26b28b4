import type { Mesh } from '../../../../scene/types.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { PrimMaterials } from '../materials/materialBinding.ts';
import type { PrimGeometry } from './primGeometry.ts';

/** Shapes by what they are made of: prims with the same opinions and the same materials, as instances are, have one. */
export class PrimGeometryCache {
  private readonly known = new Map<string, PrimGeometry | undefined>();

  getOrCreate(prim: PrimSpec, surface: PrimMaterials, make: () => PrimGeometry | undefined): PrimGeometry | undefined {
    const key = keyOf(prim, surface);
    if (key === undefined) return make();
    if (!this.known.has(key)) this.known.set(key, make());
    return this.known.get(key);
  }
}

function keyOf({ content, children }: PrimSpec, { materials }: PrimMaterials): string | undefined {
  if (content === undefined) return undefined;
  const subsets = [...children.values()].map((child) => child.content);
  return [content, ...subsets, 'wears', ...materials].join(' ');
}

const WITH_OTHER_MATERIAL = new WeakMap<Mesh, Map<string, Mesh>>();

/** The mesh with one of its materials exchanged; the same one for the same. */
export function withMaterialReplaced(mesh: Mesh, from: number, to: number): Mesh {
  const known = WITH_OTHER_MATERIAL.get(mesh) ?? new Map<string, Mesh>();
  WITH_OTHER_MATERIAL.set(mesh, known);
  const key = `${from} ${to}`;
  const groups = mesh.groups.map((g) => (g.material === from ? { ...g, material: to } : g));
  const made = known.get(key) ?? { ...mesh, groups };
  known.set(key, made);
  return made;
}
