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
import type { Material } from '../../scene/types.ts';
import type { Bool, Float, Int, Vec3, Vec4 } from '../../shaders/types.ts';
import type { Batch } from '../batches.ts';
import type { Drawable } from '../drawable.ts';
import { MATERIAL_TEXELS } from '../surface.ts';
import { sampled } from '../textures.ts';
import type { VertexInput } from '../vertexInput.ts';
import { vUv } from '../vertexStage.ts';

/** Its place on the tile, and the material. */
const vShadow = varyingProperty('vec4', 'v_shadow');

/** On which layer a vertex is drawn, negative: on none; and where it is [m], from where the layer's places are measured. */
export type Placing = (input: VertexInput) => { readonly layer: Int; readonly x: () => Vec3 };

/** How occluders come onto the tiles of a map. */
export interface Projecting {
  /** Where a point of a layer is drawn, and what is between its corners to be known of it. */
  project(layer: Int, x: Vec3): { readonly clip: Vec4; readonly spot: Vec3 };
  /** What is left there, unless it is outside the tile. */
  heightOf(spot: Vec3): { readonly height: Float; readonly outside: Bool };
}

/** A batch drawn into shadow maps: whole, not cut, and from both sides, for a sheet throws a shadow from either. */
export function makeCaster(
  drawable: Drawable,
  placing: Placing,
  projecting: Projecting,
  materials: readonly Material[],
): Mesh {
  const material = new NodeMaterial();
  material.name = `shadow ${drawable.batch.kind}`;
  material.vertexNode = casterStage(drawable, placing, projecting);
  material.fragmentNode = heightOutput(drawable, projecting, isCutOut(drawable.batch, materials));
  material.side = DoubleSide;
  material.blending = NoBlending;
  const mesh = new Mesh(wholeGeometry(drawable), material);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

/** Shares the vertices; indices and instances that are drawn in the picture change with it. */
function wholeGeometry({ batch, mesh }: Drawable): BufferGeometry {
  const geometry = batch.worn ? instances(batch.worn) : new BufferGeometry();
  for (const name of ['position', 'normal', 'uv', 'ids', 'color']) {
    const attribute = mesh.geometry.getAttribute(name);
    if (attribute) geometry.setAttribute(name, attribute);
  }
  geometry.setIndex(new BufferAttribute(batch.arrays.indices, 1));
  return geometry;
}

function instances({ first, materials }: NonNullable<Batch['worn']>): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.instanceCount = materials.length;
  const numbers = Float32Array.from(materials, (_, i) => first + i);
  return geometry.setAttribute('instance', new InstancedBufferAttribute(numbers, 1));
}

function casterStage({ vertex }: Drawable, placing: Placing, projecting: Projecting): Vec4 {
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
function isCutOut({ arrays, worn }: Batch, materials: readonly Material[]): boolean {
  const used = new Set(worn?.materials ?? arrays.ids.filter((_, i) => i % 2 === 1));
  return [...used].some((material) => materials[material].opacityThreshold > 0);
}

function heightOutput({ surface: { materials, textures } }: Drawable, projecting: Projecting, cutOut: boolean): Vec4 {
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
