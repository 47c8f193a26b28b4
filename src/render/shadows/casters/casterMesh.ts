import { Discard, Fn, If, int, round, varyingProperty, vec4 } from 'three/tsl';
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  NoBlending,
  NodeMaterial,
} from 'three/webgpu';
import type { Material } from '../../../scene/types.ts';
import type { Bool, Float, Int, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { DrawCall } from '../../gbuffer/drawCall.ts';
import { MATERIAL_TEXELS } from '../../gbuffer/surface.ts';
import type { Batch } from '../../geometry/batches.ts';
import type { VertexInput } from '../../geometry/vertexInput.ts';
import { vUv } from '../../geometry/vertexStage.ts';
import { sampled } from '../../gpu/textures.ts';

/** Its place on the tile, and the material. */
const vShadow = varyingProperty('vec4', 'v_shadow');

/** On which layer a vertex is drawn, negative: on none; and where it is [m], from where the layer's places are measured. */
export type CasterPlacement = (input: VertexInput) => { readonly layer: Int; readonly x: () => Vec3 };

/** How occluders come onto the tiles of a map. */
export interface LayerProjection {
  /** Where a point of a layer is drawn, and what is between its corners to be known of it. */
  project(layer: Int, x: Vec3): { readonly clip: Vec4; readonly spot: Vec3 };
  /** What is left there, unless it is outside the tile. */
  heightOf(spot: Vec3): { readonly height: Float; readonly outside: Bool };
}

/** A batch drawn into shadow maps: whole, not cut, and from both sides, for a sheet throws a shadow from either. */
export function makeCaster(
  drawable: DrawCall,
  placing: CasterPlacement,
  projecting: LayerProjection,
  materials: readonly Material[],
): Mesh {
  const material = new NodeMaterial();
  material.name = `shadow ${drawable.batch.kind}`;
  material.vertexNode = casterVertexNode(drawable, placing, projecting);
  material.fragmentNode = heightNode(drawable, projecting, isCutOut(drawable.batch, materials));
  material.side = DoubleSide;
  material.blending = NoBlending;
  const mesh = new Mesh(casterGeometry(drawable), material);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

/** Shares the vertices; indices and instances that are drawn in the picture change with it. */
function casterGeometry({ batch, mesh }: DrawCall): BufferGeometry {
  const geometry = batch.instancing ? instancedGeometry(batch.instancing) : new BufferGeometry();
  for (const name of ['position', 'normal', 'uv', 'ids', 'color']) {
    const attribute = mesh.geometry.getAttribute(name);
    if (attribute) geometry.setAttribute(name, attribute);
  }
  geometry.setIndex(new BufferAttribute(batch.arrays.indices, 1));
  return geometry;
}

function instancedGeometry({ first, materials }: NonNullable<Batch['instancing']>): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.instanceCount = materials.length;
  const numbers = Float32Array.from(materials, (_, i) => first + i);
  return geometry.setAttribute('instance', new InstancedBufferAttribute(numbers, 1));
}

function casterVertexNode({ vertex }: DrawCall, placing: CasterPlacement, projecting: LayerProjection): Vec4 {
  return Fn(() => {
    const input = vertex.vertex();
    const clip = vec4(2, 2, 2, 1).toVar();
    const { layer, x } = placing(input);
    If(layer.greaterThanEqual(int(0)), () => {
      const placed = projecting.project(layer, x());
      vShadow.assign(vec4(placed.spot, input.material));
      vUv.assign(input.uv);
      clip.assign(placed.clip);
    });
    return clip;
  })();
}

/** Only then are its pictures looked at: nothing else in these maps is as dear. */
function isCutOut({ arrays, instancing: worn }: Batch, materials: readonly Material[]): boolean {
  const used = new Set(worn?.materials ?? arrays.ids.filter((_, i) => i % 2 === 1));
  return [...used].some((material) => materials[material].opacityThreshold > 0);
}

function heightNode(
  { surface: { materials, textures } }: DrawCall,
  projecting: LayerProjection,
  cutOut: boolean,
): Vec4 {
  return Fn(() => {
    const found = projecting.heightOf(vShadow.xyz);
    const outside = found.outside.toVar();
    if (cutOut && textures.baseColor) {
      const first = int(round(vShadow.w)).mul(int(MATERIAL_TEXELS)).toVar();
      const [opacity, threshold] = [0, 1].map((k) => materials.texel(first.add(int(k))).w);
      outside.assign(outside.or(opacity.mul(sampled(textures.baseColor, vUv).w).lessThan(threshold)));
    }
    Discard(outside);
    return vec4(found.height, 0, 0, 1);
  })();
}
