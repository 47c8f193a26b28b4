import { type BufferGeometry, DoubleSide, FrontSide, Mesh, NodeMaterial } from 'three/webgpu';
import type { Batch } from './batches.ts';
import type { SurfaceSources } from './surface.ts';
import type { VertexSources } from './vertexStage.ts';

/** One draw call with what its shaders read, and its materials, made when they are first asked for. */
export interface Drawable {
  readonly batch: Batch;
  readonly mesh: Mesh<BufferGeometry, NodeMaterial>;
  readonly vertex: VertexSources;
  readonly surface: SurfaceSources;
  readonly materials: Map<string, NodeMaterial>;
}

export function makeDrawable(
  geometry: BufferGeometry,
  { batch, vertex, surface }: Pick<Drawable, 'batch' | 'vertex' | 'surface'>,
): Drawable {
  const mesh = new Mesh(geometry, new NodeMaterial());
  // three knows only where vertices were uploaded, not where they are seen.
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return { batch, mesh, vertex, surface, materials: new Map() };
}

export function disposeDrawable({ mesh, materials }: Drawable): void {
  mesh.geometry.dispose();
  for (const material of materials.values()) material.dispose();
}

/** How the corners of its triangles are read. */
export const cornersOf = ({ vertex: { kind, instances }, surface: { colored } }: Drawable) => ({
  kind,
  instances,
  colored,
});

export const sideOf = (batch: Batch) => (batch.doubleSided ? DoubleSide : FrontSide);
