import { attribute, Discard, Fn, float, If, int, round, varyingProperty, vec3, vec4 } from 'three/tsl';
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, NoBlending, NodeMaterial } from 'three/webgpu';
import type { Material } from '../../../scene/types.ts';
import type { Bool, Float, Int, Vec3, Vec4 } from '../../../shaders/types.ts';
import { cornerSources, type DrawCall } from '../../gbuffer/drawCall.ts';
import { MATERIAL_TEXELS } from '../../gbuffer/surface.ts';
import type { Batch } from '../../geometry/batches.ts';
import type { VertexInput } from '../../geometry/vertexInput.ts';
import { vUv } from '../../geometry/vertexStage.ts';
import { sampled } from '../../gpu/textures.ts';
import type { TriangleTable } from '../../tessellation/gpu/triangleTable.ts';
import { dividedTriangles, PART_FLOATS } from './dividedTriangles.ts';

/** (height or depth, place on the tile), from `LayerProjection.project`, and the material. */
const vShadow = varyingProperty('vec4', 'v_shadow');

/** On which layer a vertex is drawn (none if negative), and its place [m] relative to the layer's origin. */
export type CasterPlacement = (input: VertexInput) => { readonly layer: Int; readonly x: () => Vec3 };

/** How occluders are projected onto the tiles of an atlas. */
export interface LayerProjection {
  /** Clip-space position of a point on a layer, and what is interpolated across the triangle for `heightOf`. */
  project(layer: Int, x: Vec3): { readonly clip: Vec4; readonly spot: Vec3 };
  /** Height to write, and whether the fragment is outside its tile. */
  heightOf(spot: Vec3): { readonly height: Float; readonly outside: Bool };
}

/** The triangles of a draw call as shadow maps draw them: by its own vertices, or divided. */
export type CasterSource = Pick<DrawCall, 'batch' | 'surface'> & {
  readonly geometry: BufferGeometry;
  readonly vertex: () => VertexInput;
};

/** All triangles of a batch, as they are. */
export const wholeBatch = ({ batch, surface, mesh, vertex }: DrawCall): CasterSource => ({
  batch,
  surface,
  geometry: mesh.geometry,
  vertex: vertex.vertex,
});

/**
 * All triangles of a batch whose vertices have an event each, divided (dividedTriangles.ts): between the corners of a large triangle the surface that is seen is
 * curved, and drawn flat it would shade itself. Fine meshes are drawn as they are.
 */
export function dividedBatch(drawCall: DrawCall, table: TriangleTable): CasterSource {
  const { batch, surface } = drawCall;
  const radii = new Map(batch.bodies.map(({ id, radius }) => [id, radius]));
  const parts = dividedTriangles(batch.arrays, (id) => radii.get(id) ?? 0);
  const first = parts && table.firstTriangle(batch);
  if (!parts || first === undefined) return wholeBatch(drawCall);
  // Numbered as in the table, so that all batches share one shader.
  for (let i = 0; i < parts.length; i += PART_FLOATS) parts[i] += first;
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(parts, PART_FLOATS));
  const vertex = (): VertexInput => {
    const { x: triangle, y: second, z: third } = attribute<'vec3'>('position', 'vec3');
    const weights = vec3(second.oneMinus().sub(third), second, third).toVar();
    return table.interpolate(int(triangle), weights, cornerSources(drawCall), float(0));
  };
  return { batch, surface, geometry, vertex };
}

/** Draws triangles into shadow maps from both sides, because a sheet throws a shadow from either. */
export function makeCaster(
  source: CasterSource,
  placement: CasterPlacement,
  projection: LayerProjection,
  materials: readonly Material[],
): Mesh {
  const material = new NodeMaterial();
  material.name = `shadow ${source.batch.kind}`;
  material.vertexNode = casterVertexNode(source, placement, projection);
  material.fragmentNode = heightNode(source, projection, isCutOut(source.batch, materials));
  material.side = DoubleSide;
  material.blending = NoBlending;
  const mesh = new Mesh(source.geometry, material);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

function casterVertexNode({ vertex }: CasterSource, placement: CasterPlacement, projection: LayerProjection): Vec4 {
  return Fn(() => {
    const input = vertex();
    const clip = vec4(2, 2, 2, 1).toVar();
    const { layer, x } = placement(input);
    If(layer.greaterThanEqual(int(0)), () => {
      const placed = projection.project(layer, x());
      vShadow.assign(vec4(placed.spot, input.material));
      vUv.assign(input.uv);
      clip.assign(placed.clip);
    });
    return clip;
  })();
}

/** Base colour textures are read only if this is true: nothing else in shadow maps is as expensive. */
function isCutOut({ arrays, instancing }: Batch, materials: readonly Material[]): boolean {
  const used = new Set(instancing?.materials ?? arrays.ids.filter((_, i) => i % 2 === 1));
  return [...used].some((material) => materials[material].opacityThreshold > 0);
}

function heightNode(
  { surface: { materials, textures } }: CasterSource,
  projection: LayerProjection,
  cutOut: boolean,
): Vec4 {
  return Fn(() => {
    const fragment = projection.heightOf(vShadow.xyz);
    const outside = fragment.outside.toVar();
    if (cutOut && textures.baseColor) {
      const first = int(round(vShadow.w)).mul(int(MATERIAL_TEXELS)).toVar();
      const [opacity, threshold] = [0, 1].map((k) => materials.texel(first.add(int(k))).w);
      outside.assign(outside.or(opacity.mul(sampled(textures.baseColor, vUv).w).lessThan(threshold)));
    }
    Discard(outside);
    return vec4(fragment.height, 0, 0, 1);
  })();
}
