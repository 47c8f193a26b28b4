import { Fn, int, ivec2, screenCoordinate, select, textureLoad, uniform } from 'three/tsl';
import { FloatType, type Texture, Vector2 } from 'three/webgpu';
import type { Vec4 } from '../../shaders/types.ts';
import type { Gpu } from '../gpu/device.ts';
import type { PassCache } from '../gpu/passCache.ts';
import { dataTarget, type GBuffer } from './gbuffer.ts';
import { PIXEL_SOURCES, type PixelSource, type PixelTexels, readFloats } from './readback.ts';

/** Reads what one pixel holds in several targets with one read: a pass gathers the texels into a target of `PIXEL_SOURCES.length` × 1. */
export class PixelReader {
  private readonly gpu: Gpu;
  private readonly buffer: GBuffer;
  private readonly passes: PassCache;
  private readonly target = dataTarget(1, FloatType);
  private readonly pixel = uniform(new Vector2());

  constructor(gpu: Gpu, buffer: GBuffer, passes: PassCache) {
    this.gpu = gpu;
    this.buffer = buffer;
    this.passes = passes;
    this.target.setSize(PIXEL_SOURCES.length, 1);
  }

  /** `light`: the texture of the picture's light; x and y from the top left. */
  async read(light: Texture, x: number, y: number): Promise<PixelTexels> {
    this.pixel.value.set(x, y);
    this.passes.run(`pixel ${light.id}`, () => this.gathered(light), this.target);
    const region = { x: 0, y: 0, width: PIXEL_SOURCES.length, height: 1 };
    const texels = await readFloats(this.gpu, this.target, 0, region);
    const texel = (name: PixelSource) => texels.subarray(4 * PIXEL_SOURCES.indexOf(name)).subarray(0, 4);
    return { object: texel('object'), event: texel('event'), motion: texel('motion'), light: texel('light') };
  }

  /** Column k of the target has the texel of the source k. */
  private gathered(light: Texture): Vec4 {
    return Fn(() => {
      const pixel = ivec2(this.pixel).toVar();
      const column = int(screenCoordinate.x).toVar();
      const [first, ...others] = PIXEL_SOURCES.map((name) =>
        textureLoad(name === 'light' ? light : this.buffer.texture(name), pixel),
      );
      return others.reduce<Vec4>((found, texel, k) => select(column.equal(int(k + 1)), texel, found), first!);
    })();
  }

  dispose(): void {
    this.target.dispose();
  }
}
