import { type BufferGeometry, DoubleSide, FrontSide, Mesh, NodeMaterial, NormalBlending } from 'three/webgpu';
import type { Batch } from '../geometry/batches.ts';
import { disposeGeometry } from '../geometry/sharedGeometry.ts';
import type { VertexSources } from '../geometry/vertexStage.ts';
import type { SurfaceSources } from './surface.ts';

/** One draw call with the sources that its shaders read, and its materials, created on first use. */
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
  // Three.js knows only the positions that vertices were uploaded with, not where they are drawn.
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return { batch, mesh, vertex, surface, materials: new Map() };
}

export function disposeDrawCall({ mesh, materials }: DrawCall): void {
  for (const material of materials.values()) material.dispose();
  disposeGeometry(mesh.geometry);
}

/** How shaders read the corners of its triangles. */
export const cornerSources = ({ vertex: { kind, instances }, surface: { colored } }: DrawCall) => ({
  kind,
  instances,
  colored,
});

export const materialSide = (batch: Batch) => (batch.doubleSided ? DoubleSide : FrontSide);

/** Sets a material to draw a batch over the opaque picture, whose depth its shader compares itself. */
export function drawOver(material: NodeMaterial, batch: Batch): NodeMaterial {
  material.side = materialSide(batch);
  material.transparent = true;
  material.blending = NormalBlending;
  material.depthTest = false;
  material.depthWrite = false;
  return material;
}
