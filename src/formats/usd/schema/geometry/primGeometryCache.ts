import type { Mesh } from '../../../../scene/types.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { PrimMaterials } from '../materials/materialBinding.ts';
import type { PrimGeometry } from './primGeometry.ts';

/** Caches geometry by its inputs: prims with the same opinions and materials, such as instances, share it. */
export class PrimGeometryCache {
  private readonly geometries = new Map<string, PrimGeometry | undefined>();

  /** `part`: which part of the prim's geometry, if it has several. */
  async getOrCreate(
    prim: PrimSpec,
    surface: PrimMaterials,
    part: string,
    make: () => Promise<PrimGeometry | undefined>,
  ): Promise<PrimGeometry | undefined> {
    const whole = keyOf(prim, surface);
    if (whole === undefined) return make();
    const key = `${whole} ${part}`;
    if (!this.geometries.has(key)) this.geometries.set(key, await make());
    return this.geometries.get(key);
  }
}

function keyOf({ content, children }: PrimSpec, { materials }: PrimMaterials): string | undefined {
  if (content === undefined) return undefined;
  const subsets = [...children.values()].map((child) => child.content);
  return [content, ...subsets, 'wears', ...materials].join(' ');
}

const WITH_OTHER_MATERIAL = new WeakMap<Mesh, Map<string, Mesh>>();

/** The mesh with one of its materials replaced; cached. */
export function withMaterialReplaced(mesh: Mesh, from: number, to: number): Mesh {
  const variants = WITH_OTHER_MATERIAL.get(mesh) ?? new Map<string, Mesh>();
  WITH_OTHER_MATERIAL.set(mesh, variants);
  const key = `${from} ${to}`;
  const groups = mesh.groups.map((g) => (g.material === from ? { ...g, material: to } : g));
  const made = variants.get(key) ?? { ...mesh, groups };
  variants.set(key, made);
  return made;
}
