import { acos, atan, clamp, dot, int, Loop, texture, uniform, vec2, vec3 } from 'three/tsl';
import { Color, type DataTexture, Vector3 } from 'three/webgpu';
import { normalize, scale, type Vec3, ZERO } from '../math/vec3.ts';
import { axesOf, DAY, type DirectLight, directLights, domeOf } from '../scene/daylight.ts';
import { originLine } from '../scene/motion.ts';
import type { DomeLight, Scene, SphereLight, Texture } from '../scene/types.ts';
import type * as gpu from '../shaders/types.ts';
import { FloatTable } from './floatTable.ts';
import { meet, type Sight } from './sight.ts';
import { uploadTexture } from './textures.ts';

/** Direct light on the GPU: the direction to it (w = 0) or its place relative to the observer [m] (w = 1), and its colour. */
export interface LightTexels {
  readonly place: gpu.Vec4;
  readonly color: gpu.Vec3;
}

/** So many lights are written out one by one: a software GPU goes through the body of a loop once more than it need. */
const WRITTEN_OUT = 4;

/** Where light comes from: distant and sphere lights in a table, and a sky (the scene's dome, or a clear day's). */
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
  /** Distant ones first. */
  private readonly lights: readonly DirectLight[];
  private readonly table = new FloatTable(256);
  private readonly domeTexture: DataTexture | undefined;

  constructor(scene: Scene) {
    const dome = domeOf(scene);
    const direct = directLights(scene);
    this.lights = [...direct.filter(isDistant), ...direct.filter((light) => !isDistant(light))];
    this.table.reserve(2 * this.lights.length);
    if (dome) this.setDome(dome);
    else this.setDay();
    if (dome?.texture) {
      this.domeTexture = uploadTexture(dome.texture);
      this.image = domeImage(this.domeTexture, scene.upAxis, dome.color);
    }
  }

  private light(index: gpu.Int): LightTexels {
    const at = index.mul(int(2));
    return { place: this.table.texel(at).toVar(), color: this.table.texel(at.add(int(1))).xyz.toVar() };
  }

  /** Adds up what `of` gives for each light, or for the distant ones. */
  sum(which: 'all' | 'distant', of: (light: LightTexels) => gpu.Vec3): gpu.Vec3 {
    const count = which === 'all' ? this.lights.length : this.lights.filter(isDistant).length;
    const total = vec3(0).toVar();
    const add = (i: gpu.Int): void => {
      total.addAssign(of(this.light(i)));
    };
    if (count > WRITTEN_OUT)
      Loop({ start: int(0), end: int(count), type: 'int', condition: '<' }, ({ i }) => add(int(i)));
    else for (let i = 0; i < count; i++) add(int(i));
    return total;
  }

  /** Places are uploaded relative to the observer's event. */
  update(sight: Sight): void {
    this.lights.forEach((light, i) => {
      const distant = light.kind === 'distant';
      const [place, color] = distant ? [normalize(scale(light.direction, -1)), light.color] : lampSeen(light, sight);
      this.table.values.set([...place, distant ? 0 : 1, ...color, 0], 8 * i);
    });
    this.table.upload();
  }

  dispose(): void {
    this.table.dispose();
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

const isDistant = ({ kind }: DirectLight): boolean => kind === 'distant';
const WHITE: Vec3 = [1, 1, 1];

/**
 * Where the observer sees the lamp, and its intensity: that is taken for where it shines from on all surfaces, as if its light took no time to them
 * and had no shift of its own (docs/model.md). A sphere's radiance L is the intensity πr²L; a point's colour is its intensity.
 */
function lampSeen(
  { motion, lifetime, radius, color }: SphereLight,
  sight: Sight,
): readonly [place: Vec3, intensity: Vec3] {
  const event = meet(originLine(motion), sight);
  if (!event) return [ZERO, ZERO];
  const time = sight.t + event.ahead / sight.c;
  const shines = lifetime.birth <= time && time <= lifetime.death;
  const area = radius === 0 ? 1 : Math.PI * radius * radius;
  return [event.offset, shines ? scale(color, area) : ZERO];
}

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
