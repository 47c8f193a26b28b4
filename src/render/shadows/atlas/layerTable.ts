import { int, uniformArray } from 'three/tsl';
import { Vector4 } from 'three/webgpu';
import type { Int, Vec4 } from '../../../shaders/types.ts';

/**
 * The layers' projections for shaders, `texels` vectors each. They are uniforms because a texel fetch is expensive on a software GPU
 * (docs/adr/0006-software-gpu.md).
 */
export class LayerTable {
  private readonly vectors: readonly Vector4[];
  private readonly texels: number;
  private readonly node: { element(index: Int): Vec4 };

  constructor(layers: number, texels: number) {
    const vectors = Array.from({ length: texels * Math.max(1, layers) }, () => new Vector4());
    this.vectors = vectors;
    this.texels = texels;
    this.node = uniformArray<'vec4'>(vectors, 'vec4');
  }

  set(index: number, numbers: readonly number[]): void {
    for (let k = 0; k < this.texels; k++) this.vectors[this.texels * index + k].fromArray([...numbers], 4 * k);
  }

  /** Makes a layer whose places are never occluded. */
  clear(index: number): void {
    for (let k = 0; k < this.texels; k++) this.vectors[this.texels * index + k].set(0, 0, 0, -1);
  }

  /** The numbers of some layers as a string, to detect changes. */
  keyOf(first: number, count: number): string {
    const of = this.vectors.slice(this.texels * first, this.texels * (first + count));
    return of.map((vector) => vector.toArray().join()).join();
  }

  /** `layer`: preferably a number, if it is known when the shader is compiled. */
  texel(layer: Int | number, k: number): Vec4 {
    const { texels } = this;
    const index = typeof layer === 'number' ? int(texels * layer + k) : layer.mul(int(texels)).add(int(k));
    return this.node.element(index);
  }
}
