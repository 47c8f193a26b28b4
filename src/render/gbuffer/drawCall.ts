import { type BufferGeometry, DoubleSide, FrontSide, Mesh, NodeMaterial } from 'three/webgpu';
import type { Batch } from '../geometry/batches.ts';
import type { VertexSources } from '../geometry/vertexStage.ts';
import type { SurfaceSources } from './surface.ts';

/** One draw call with what its shaders read, and its materials, made when they are first asked for. */
export interface DrawCall {
  readonly batch: Batch;
  readonly mesh: Mesh<BufferGeometry, NodeMaterial>;
  readonly vertex: VertexSources;
  readonly surface: SurfaceSources;
  readonly materials: Map<string, NodeMaterial>;
}

export function makeDrawCall(
  geometry: BufferGeometry,
  { batch, vertex, surface }: Pick<DrawCall, 'batch' | 'vertex' | 'surface'>,
): DrawCall {
  const mesh = new Mesh(geometry, new NodeMaterial());
  // three knows only where vertices were uploaded, not where they are seen.
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return { batch, mesh, vertex, surface, materials: new Map() };
}

export function disposeDrawCall({ mesh, materials }: DrawCall): void {
  mesh.geometry.dispose();
  for (const material of materials.values()) material.dispose();
}

/** How the corners of its triangles are read. */
export const cornerSources = ({ vertex: { kind, instances }, surface: { colored } }: DrawCall) => ({
  kind,
  instances,
  colored,
});

export const materialSide = (batch: Batch) => (batch.doubleSided ? DoubleSide : FrontSide);
