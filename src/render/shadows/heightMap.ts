import { uniform } from 'three/tsl';
import {
  FloatType,
  type Mesh,
  NearestFilter,
  NoColorSpace,
  PerspectiveCamera,
  RedFormat,
  RenderTarget,
  Scene,
  type Texture,
  Vector2,
} from 'three/webgpu';
import type { Float } from '../../shaders/types.ts';
import type { Gpu } from '../device.ts';
import { EdgeMap } from './edges.ts';

/** A texture of tiles on which occluders have left how high they are, and where between them edges are. */
export class HeightMap {
  /** Occluders in any of the layers. */
  readonly scene = new Scene();
  /** What their shaders read: the layer that is drawn, or the first of several, and the size of the map [texels]. */
  readonly at = { layer: uniform(0, 'int'), size: uniform(new Vector2(1, 1)) };
  readonly cell: number;
  private readonly gpu: Gpu;
  private readonly target = heightTarget();
  private readonly edgeMap: EdgeMap;
  private readonly camera = new PerspectiveCamera();

  /** `cell`: as of edges.ts [texels]. */
  constructor(gpu: Gpu, cell: number) {
    this.gpu = gpu;
    this.cell = cell;
    this.edgeMap = new EdgeMap(this.target.texture, cell);
  }

  /** Of the highest occluder of each texel, 0 where none is [texels]. */
  get heights(): Texture {
    return this.target.texture;
  }
  /** Of cells: edges.ts. */
  get edges(): Texture {
    return this.edgeMap.texture;
  }

  /** Draws all anew: the scene once for each of the numbers of layers. */
  make(width: number, height: number, layers: readonly number[]): void {
    const { renderer } = this.gpu;
    this.target.setSize(width, height);
    this.at.size.value.set(width, height);
    renderer.setMRT(null);
    renderer.setRenderTarget(this.target);
    for (const [k, layer] of layers.entries()) {
      this.at.layer.value = layer;
      renderer.autoClear = k === 0;
      renderer.render(this.scene, this.camera);
    }
    renderer.autoClear = true;
    this.edgeMap.make(renderer, width, height);
  }

  /** Clip-space depth of a height from 0 to 1: nearer to the sun is nearer, as the backend and its depth buffer count. */
  depthOf(height: Float): Float {
    const { backend, renderer } = this.gpu;
    if (renderer.reversedDepthBuffer) return height;
    return backend === 'webgl' ? height.mul(-2).add(1) : height.oneMinus();
  }

  dispose(): void {
    for (const { geometry, material } of this.scene.children as Mesh[]) {
      geometry.dispose();
      for (const each of [material].flat()) each.dispose();
    }
    this.target.dispose();
    this.edgeMap.dispose();
  }
}

const heightTarget = (): RenderTarget =>
  new RenderTarget(1, 1, {
    type: FloatType,
    format: RedFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: true,
    colorSpace: NoColorSpace,
  });
