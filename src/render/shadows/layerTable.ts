import { int, uniformArray } from 'three/tsl';
import { Vector4 } from 'three/webgpu';
import type { Int, Vec4 } from '../../shaders/types.ts';
import { LAYER_TEXELS, type Layer, layerTexels } from './layer.ts';

/** Layers as shaders read them: uniforms, for on a software GPU a texel is dear to fetch (docs/adr/0006-software-gpu.md). */
export class LayerTable {
  private readonly vectors: readonly Vector4[];
  private readonly node: { element(index: Int): Vec4 };

  constructor(layers: number) {
    const vectors = Array.from({ length: LAYER_TEXELS * Math.max(1, layers) }, () => new Vector4());
    this.vectors = vectors;
    this.node = uniformArray<'vec4'>(vectors, 'vec4');
  }

  set(index: number, layer: Layer): void {
    const numbers = layerTexels(layer);
    for (let k = 0; k < LAYER_TEXELS; k++) this.vectors[LAYER_TEXELS * index + k].fromArray([...numbers], 4 * k);
  }

  /** Nothing is behind it. */
  clear(index: number): void {
    for (let k = 0; k < LAYER_TEXELS; k++) this.vectors[LAYER_TEXELS * index + k].set(0, 0, 0, -1);
  }

  /** The numbers of some layers, to tell whether they are those of before. */
  keyOf(first = 0, count = this.vectors.length / LAYER_TEXELS): string {
    const of = this.vectors.slice(LAYER_TEXELS * first, LAYER_TEXELS * (first + count));
    return of.map((vector) => vector.toArray().join()).join();
  }

  /** `layer`: best a number, where it is known before the shader runs. */
  texel(layer: Int | number, k: number): Vec4 {
    const index = typeof layer === 'number' ? int(LAYER_TEXELS * layer + k) : layer.mul(int(LAYER_TEXELS)).add(int(k));
    return this.node.element(index);
  }
}
