import { float, uniform, vec2 } from 'three/tsl';
import { type Mesh, PerspectiveCamera, Scene, type Texture, Vector2 } from 'three/webgpu';
import type { Float, Int, Vec2 } from '../../../shaders/types.ts';
import { disposeGeometry } from '../../geometry/sharedGeometry.ts';
import type { Gpu } from '../../gpu/device.ts';
import { type EdgeLayout, EdgeMap } from './edgeMap.ts';
import { shadowAtlasTarget } from './shadowAtlasTarget.ts';

/** One draw of the atlas's scene, with the layer that its shaders read, or the first of several. */
export interface AtlasDraw {
  readonly layer: number;
  /** Called before the draw. */
  readonly prepare?: () => void;
}

/** A texture of tiles with the heights of occluders, and below them the map of their edges (`EdgeMap`). */
export class ShadowAtlas {
  /** The occluders of all layers. */
  readonly scene = new Scene();
  readonly cell: number;
  /** Uniform: the layer that is being drawn, or the first of several. */
  readonly layer: Int;
  /** Row of the texture at which the cells of the edge map begin. */
  readonly edgeRow: Int;
  private readonly at = { layer: uniform(0, 'int'), size: uniform(new Vector2(1, 1)), edges: uniform(0, 'int') };
  private readonly cells = uniform(new Vector2(1, 1));
  private readonly gpu: Gpu;
  private readonly target = shadowAtlasTarget(true);
  private readonly edgeMap: EdgeMap;
  private readonly camera = new PerspectiveCamera();

  /** `cell`, `threshold`: see `EdgeLayout`. */
  constructor(gpu: Gpu, { cell, threshold }: Pick<EdgeLayout, 'cell' | 'threshold'>) {
    this.gpu = gpu;
    this.cell = cell;
    this.layer = this.at.layer;
    this.edgeRow = this.at.edges;
    const layout = {
      cell,
      threshold,
      size: this.cells,
      row: this.at.edges,
      clipOf: (texels: Vec2) => this.clipOf(texels),
    };
    this.edgeMap = new EdgeMap(this.target.texture, layout);
  }

  /** Per texel the height of the highest occluder, 0 where there is none; from `edgeRow` on the cells of the edge map. */
  get heights(): Texture {
    return this.target.texture;
  }

  /** Redraws everything. */
  render(width: number, height: number, drawings: readonly AtlasDraw[]): void {
    const { renderer } = this.gpu;
    const [columns, rows] = [width / this.cell, height / this.cell];
    this.target.setSize(width, height + rows);
    this.at.size.value.set(width, height + rows);
    this.at.edges.value = height;
    this.cells.value.set(columns, rows);
    renderer.setMRT(null);
    renderer.setRenderTarget(this.target);
    for (const [k, { layer, prepare }] of drawings.entries()) {
      prepare?.();
      this.at.layer.value = layer;
      renderer.autoClear = k === 0;
      renderer.render(this.scene, this.camera);
    }
    renderer.autoClear = true;
    this.edgeMap.render(renderer, this.target, columns, rows);
  }

  /** Texels of the texture → clip space; for homogeneous coordinates `w` is the last of them. */
  clipOf(texels: Vec2, w: Float = float(1)): Vec2 {
    const at = texels.div(this.at.size).mul(2).sub(w);
    return vec2(at.x, at.y.negate());
  }

  /** Clip-space depth of a height from 0 to 1, or of a height from 0 to w, times w: higher is nearer, in the convention of the backend and its depth buffer. */
  depthOf(height: Float, w: Float = float(1)): Float {
    const { backend, renderer } = this.gpu;
    if (renderer.reversedDepthBuffer) return height;
    return backend === 'webgl' ? w.sub(height.mul(2)) : w.sub(height);
  }

  dispose(): void {
    for (const { geometry, material } of this.scene.children as Mesh[]) {
      for (const each of [material].flat()) each.dispose();
      disposeGeometry(geometry);
    }
    this.target.dispose();
    this.edgeMap.dispose();
  }
}
