import { acos, atan, clamp, dot, int, Loop, texture, uniform, vec2 } from 'three/tsl';
import { Color, type DataTexture, Vector3 } from 'three/webgpu';
import { normalize, scale, type Vec3 } from '../math/vec3.ts';
import { axesOf, DAY, directLights, domeOf, nightSkyOf } from '../scene/daylight.ts';
import type { DistantLight, DomeLight, NightSky, Scene, Texture } from '../scene/types.ts';
import type { ColorMode } from '../scene/view.ts';
import type * as gpu from '../shaders/types.ts';
import { FloatTable } from './floatTable.ts';
import { shineColor, shineKind, thermalTexel } from './lampShine.ts';
import { LampTable } from './lampTable.ts';
import type { ThermalSource } from './radiance.ts';
import type { Sight } from './sight.ts';
import { uploadTexture } from './textures.ts';

/** A distant light on the GPU. */
export interface SunTexels {
  /** Towards it, unit. */
  readonly direction: gpu.Vec3;
  /** The filter of its irradiance. */
  readonly color: gpu.Vec3;
  /** Absent of daylight. */
  readonly source?: ThermalSource;
}

/** Texels per distant light: (direction, temperature), (colour, luminance of a blackbody of that temperature over daylight's). */
const SUN_TEXELS = 2;
/** So many lights are written out one by one: a software GPU goes through the body of a loop once more than it need. */
const WRITTEN_OUT = 4;

/** Where light comes from: suns, lamps, and a sky (the scene's dome, or a clear day's). */
export class Environment {
  readonly uniforms = {
    zenithColor: uniform(new Color()),
    horizonColor: uniform(new Color()),
    groundColor: uniform(new Color()),
    upperMean: uniform(new Color()),
    lowerMean: uniform(new Color()),
  };
  /** Radiance of the dome's picture in a world direction. */
  readonly image: ((n: gpu.Vec3) => gpu.Vec3) | undefined;
  readonly lamps: LampTable;
  readonly night: NightSky | undefined;
  /** Those of daylight first. */
  readonly suns: readonly DistantLight[];
  private readonly table = new FloatTable(256);
  private readonly domeTexture: DataTexture | undefined;

  constructor(scene: Scene) {
    const dome = domeOf(scene);
    this.night = nightSkyOf(scene);
    const direct = directLights(scene);
    const suns = direct.filter((light) => light.kind === 'distant');
    this.suns = [...suns.filter(isDaylight), ...suns.filter((sun) => !isDaylight(sun))];
    this.table.reserve(SUN_TEXELS * this.suns.length);
    this.lamps = new LampTable(direct.filter((light) => light.kind !== 'distant'));
    if (dome) this.setDome(dome);
    else this.setDay();
    if (dome?.texture) {
      this.domeTexture = uploadTexture(dome.texture);
      this.image = domeImage(this.domeTexture, scene.upAxis, dome.color);
    }
  }

  /** `index`: its place among the suns, where that is known before the shader runs. */
  eachSun(visit: (sun: SunTexels, index?: number) => void): void {
    const day = this.suns.filter(isDaylight).length;
    for (const [start, end] of [
      [0, day],
      [day, this.suns.length],
    ]) {
      const read = (i: gpu.Int, index?: number) => visit(this.sun(i, start === day), index);
      if (end - start > WRITTEN_OUT)
        Loop({ start: int(start), end: int(end), type: 'int', condition: '<' }, ({ i }) => read(int(i)));
      else for (let i = start; i < end; i++) read(int(i), i);
    }
  }

  private sun(index: gpu.Int, thermal: boolean): SunTexels {
    const at = index.mul(int(SUN_TEXELS));
    const [direction, color] = [0, 1].map((k) => this.table.texel(at.add(int(k))).toVar());
    const sun = { direction: direction.xyz, color: color.xyz };
    return thermal ? { ...sun, source: { temperature: direction.w, luminance: color.w } } : sun;
  }

  /** Places are uploaded relative to the observer's event. */
  update(sight: Sight, colors: ColorMode): void {
    this.suns.forEach((sun, i) => {
      const [T, luminance] = thermalTexel(sun);
      const texels = [...normalize(scale(sun.direction, -1)), T, ...shineColor(sun, colors), luminance];
      this.table.values.set(texels, 4 * SUN_TEXELS * i);
    });
    this.table.upload();
    this.lamps.update(sight, colors);
  }

  dispose(): void {
    this.table.dispose();
    this.lamps.dispose();
    this.domeTexture?.dispose();
  }

  private setDay(): void {
    this.setSky(DAY.zenith, DAY.horizon, DAY.ground);
    this.uniforms.upperMean.value.setRGB(0.36, 0.48, 0.7);
    this.uniforms.lowerMean.value.setRGB(0.24, 0.22, 0.2);
  }

  private setDome({ color, texture: image }: DomeLight): void {
    this.setSky(color, color, color);
    const [upper, lower] = image ? halfMeans(image) : [WHITE, WHITE];
    this.uniforms.upperMean.value.setRGB(color[0] * upper[0], color[1] * upper[1], color[2] * upper[2]);
    this.uniforms.lowerMean.value.setRGB(color[0] * lower[0], color[1] * lower[1], color[2] * lower[2]);
  }

  private setSky(zenith: Vec3, horizon: Vec3, ground: Vec3): void {
    this.uniforms.zenithColor.value.setRGB(...zenith);
    this.uniforms.horizonColor.value.setRGB(...horizon);
    this.uniforms.groundColor.value.setRGB(...ground);
  }
}

const isDaylight = (light: DistantLight): boolean => shineKind(light) === 'daylight';
const WHITE: Vec3 = [1, 1, 1];

/** A latitude–longitude picture: its top row at the zenith, its middle column towards −Z (upAxis Y) or +Y (upAxis Z). */
function domeImage(image: DataTexture, upAxis: Scene['upAxis'], color: Vec3): (n: gpu.Vec3) => gpu.Vec3 {
  const tint = uniform(new Vector3(...color));
  const axes = axesOf(upAxis);
  const [up, ahead, right] = [axes.up, axes.ahead, axes.right].map((axis) => uniform(new Vector3(...axis)));
  return (n) => {
    const around = atan(dot(n, right), dot(n, ahead))
      .div(2 * Math.PI)
      .add(0.5);
    const down = acos(clamp(dot(n, up), -1, 1)).div(Math.PI);
    // The base level: the seam at ±180° has no derivative.
    return texture(image, vec2(around, down)).level(int(0)).rgb.mul(tint);
  };
}

/** Mean linear colour of the upper and the lower half of a latitude–longitude picture, rows weighted by their solid angle. */
function halfMeans({ width, height, data, colorSpace }: Texture): readonly [Vec3, Vec3] {
  const linear = (byte: number) => {
    const v = byte / 255;
    return colorSpace === 'srgb' ? (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4) : v;
  };
  const mean = (from: number, to: number): Vec3 => {
    const sum: [number, number, number] = [0, 0, 0];
    let weight = 0;
    for (let y = from; y < to; y++) {
      const w = Math.sin(((y + 0.5) / height) * Math.PI);
      for (let x = 0; x < width; x++, weight += w)
        for (let k = 0; k < 3; k++) sum[k] += w * linear(data[4 * (y * width + x) + k]);
    }
    return scale(sum, 1 / Math.max(weight, 1e-9));
  };
  const middle = Math.max(1, height >> 1);
  return [mean(0, middle), mean(Math.min(middle, height - 1), height)];
}
