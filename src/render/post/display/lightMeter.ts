import { Fn, floor, ivec2, screenCoordinate, select, textureLoad, uniform, vec2, vec4 } from 'three/tsl';
import { FloatType, type Texture, Vector2 } from 'three/webgpu';
import { type LightMeterReadings, METER_CELLS, type MeteredQuantities } from '../../../scene/view/metering.ts';
import type { PictureSize } from '../../../scene/view/pictureSize.ts';
import type { Vec4 } from '../../../shaders/types.ts';
import { relativeLuminance } from '../../color/luminance.ts';
import { dataTarget, type GBuffer } from '../../gbuffer/gbuffer.ts';
import { readFloats } from '../../gbuffer/readback.ts';
import type { Gpu } from '../../gpu/device.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import { FullScreenPass } from '../../gpu/fullScreenPass.ts';
import { skyDoppler } from './skyDoppler.ts';

/** Channels of the readings; the fourth is 1 where there is a surface. */
const [LIGHT, DOPPLER, TIME] = [0, 1, 2];

/** Samples pictures on the GPU at `METER_CELLS` × `METER_CELLS` positions, so that little is read back: 64 kB at any picture size. */
export class LightMeter {
  private readonly gpu: Gpu;
  private readonly buffer: GBuffer;
  private readonly uniforms: FrameUniforms;
  private readonly target = dataTarget(1, FloatType);
  private readonly size = uniform(new Vector2());
  private readonly passes = new Map<string, FullScreenPass>();

  constructor(gpu: Gpu, buffer: GBuffer, uniforms: FrameUniforms) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.buffer = buffer;
    this.target.setSize(METER_CELLS, METER_CELLS);
  }

  /** `light`: of the picture; `c` [m/s]. */
  async measure(
    light: Texture,
    { width, height }: PictureSize,
    c: number,
    quantities: MeteredQuantities,
  ): Promise<LightMeterReadings> {
    const key = `${light.id} ${quantities}`;
    const pass = this.passes.get(key) ?? new FullScreenPass(this.output(light, quantities), 'gauge');
    this.passes.set(key, pass);
    this.size.value.set(width, height);
    pass.render(this.gpu.renderer, this.target);
    const texels = await readFloats(this.gpu, this.target, 0, { x: 0, y: 0, width: METER_CELLS, height: METER_CELLS });
    const channel = (k: number, scale: number) =>
      Float32Array.from({ length: METER_CELLS * METER_CELLS }, (_, i) => {
        const isDefined = k === LIGHT || (quantities === 'all' && (k === DOPPLER || texels[4 * i + 3]! > 0.5));
        return isDefined ? scale * texels[4 * i + k]! : Number.NaN;
      });
    return { luminance: channel(LIGHT, 1), doppler: channel(DOPPLER, 1), time: channel(TIME, 1 / c) };
  }

  /** (luminance, D, c(t − t_o) [m], 1 if there is a surface) */
  private output(light: Texture, quantities: MeteredQuantities): Vec4 {
    const { buffer, size } = this;
    return Fn(() => {
      const pixel = ivec2(floor(screenCoordinate.div(METER_CELLS).mul(vec2(size)))).toVar();
      const at = (source: Texture): Vec4 => textureLoad(source, pixel);
      if (quantities === 'luminance') return vec4(relativeLuminance(at(light).rgb), 0, 0, 0);
      const hasSurface = at(buffer.texture('object')).x.greaterThan(0.5).toVar();
      return vec4(
        relativeLuminance(at(light).rgb),
        select(hasSurface, at(buffer.texture('motion')).w, skyDoppler(this.uniforms)),
        at(buffer.texture('event')).w,
        select(hasSurface, 1, 0),
      );
    })();
  }

  dispose(): void {
    for (const pass of this.passes.values()) pass.dispose();
    this.target.dispose();
  }
}
