import { abs, Fn, float, floor, int, ivec2, Loop, max, screenCoordinate, textureLoad, vec4 } from 'three/tsl';
import {
  FloatType,
  NearestFilter,
  NoColorSpace,
  RedFormat,
  RenderTarget,
  type Texture,
  type WebGPURenderer,
} from 'three/webgpu';
import type { Int, Vec4 } from '../../shaders/types.ts';
import { FullScreen } from '../fullScreen.ts';

/** A bend of the surface over three texels that may be the edge of a shadow [texels]. */
const BEND = 1;

/**
 * Where the edges of shadows can be: per cell of a map, how high the highest edge is within a cell's width of it, 0 where there is none. A point that
 * is farther from all edges above it than the filter is wide is wholly in light or wholly in shadow.
 */
export class EdgeMap {
  private readonly own = singleChannel();
  private readonly around = singleChannel();
  private readonly passes: readonly [FullScreen, FullScreen];

  private readonly cell: number;

  /** `cell`: its side [texels of the map], as far as the filter looks. */
  constructor(heights: Texture, cell: number) {
    this.cell = cell;
    this.passes = [
      new FullScreen(Fn(() => highestEdge(heights, cell))(), 'edges of cells'),
      new FullScreen(Fn(() => highestAround(this.own.texture))(), 'edges near cells'),
    ];
  }

  get texture(): Texture {
    return this.around.texture;
  }

  /** Of heights that have changed. */
  make(renderer: WebGPURenderer, width: number, height: number): void {
    [this.own, this.around].forEach((target, k) => {
      target.setSize(width / this.cell, height / this.cell);
      this.passes[k].render(renderer, target);
    });
  }

  dispose(): void {
    for (const each of [...this.passes, this.own, this.around]) each.dispose();
  }
}

/** Upper ends of the bends within a cell, along its rows and columns. */
function highestEdge(heights: Texture, cell: number): Vec4 {
  const corner = ivec2(floor(screenCoordinate)).mul(int(cell)).toVar();
  const highest = float(0).toVar();
  const load = (x: Int, y: Int) => textureLoad(heights, corner.add(ivec2(x, y))).x.toVar();
  for (const at of [(i: Int, j: Int) => load(i, j), (i: Int, j: Int) => load(j, i)])
    Loop({ start: int(0), end: int(cell), type: 'int', condition: '<' }, ({ i: j }) => {
      const before = at(int(-1), int(j));
      const here = at(int(0), int(j));
      Loop({ start: int(0), end: int(cell), type: 'int', condition: '<' }, ({ i }) => {
        const after = at(int(i).add(int(1)), int(j));
        const bent = abs(before.add(after).sub(here.mul(2))).greaterThan(BEND);
        highest.assign(max(highest, bent.select(max(before, max(here, after)), float(0))));
        before.assign(here);
        here.assign(after);
      });
    });
  return vec4(highest, 0, 0, 1);
}

function highestAround(edges: Texture): Vec4 {
  const here = ivec2(floor(screenCoordinate)).toVar();
  const highest = float(0).toVar();
  for (const y of [-1, 0, 1])
    for (const x of [-1, 0, 1]) highest.assign(max(highest, textureLoad(edges, here.add(ivec2(x, y))).x));
  return vec4(highest, 0, 0, 1);
}

const singleChannel = (): RenderTarget =>
  new RenderTarget(1, 1, {
    type: FloatType,
    format: RedFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: false,
    colorSpace: NoColorSpace,
  });
