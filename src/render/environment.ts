import { int, Loop, uniform } from 'three/tsl';
import { Color } from 'three/webgpu';
import { rotate } from '../math/quat.ts';
import { normalize, scale, type Vec3 } from '../math/vec3.ts';
import { DAY, type DirectLight, directLights, domeOf } from '../scene/daylight.ts';
import { shownArea } from '../scene/lamps.ts';
import type { AreaLight, DistantLight, DomeLight, Scene } from '../scene/types.ts';
import type * as gpu from '../shaders/types.ts';
import { AreaLights } from './areaLights.ts';
import { DomePicture } from './domeTexture.ts';
import { FloatTable } from './floatTable.ts';
import { lampSeen } from './lampSeen.ts';
import { type ShapingTexels, shapingValues } from './shaping.ts';
import type { Sight } from './sight.ts';

/** Direct light on the GPU: the direction to it (w = 0) or its place relative to the observer [m] (w = 1), and its colour. */
export interface LightTexels {
  readonly place: gpu.Vec4;
  readonly color: gpu.Vec3;
  /** Absent where no lamp of the scene is shaped. */
  readonly shaping?: ShapingTexels;
}

type Direct = Exclude<DirectLight, AreaLight>;

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
  /** The dome's, where it has one. */
  readonly picture: DomePicture | undefined;
  /** Lamps with a size; absent where there are none. */
  readonly areas: AreaLights | undefined;
  /** Distant ones first. */
  private readonly lights: readonly Direct[];
  /** Texels per light: twice as many where any is shaped. */
  private readonly stride: 2 | 4;
  private readonly table = new FloatTable(256);

  constructor(scene: Scene) {
    const dome = domeOf(scene);
    const direct = directLights(scene);
    const spheres = direct.filter((light) => light.kind === 'sphere');
    this.lights = [...direct.filter(isDistant), ...spheres];
    this.stride = spheres.some(({ shaping }) => shaping) ? 4 : 2;
    this.table.reserve(this.stride * this.lights.length);
    const areas = direct.filter(isArea);
    if (areas.length > 0) this.areas = new AreaLights(areas);
    if (dome) this.setDome(dome);
    else this.setDay();
    if (dome?.texture) this.picture = new DomePicture(dome.texture, scene.upAxis, dome.color);
  }

  private light(index: gpu.Int): LightTexels {
    const at = index.mul(int(this.stride));
    const texel = (k: number): gpu.Vec4 => this.table.texel(at.add(int(k))).toVar();
    const [place, color] = [texel(0), texel(1)];
    if (this.stride === 2) return { place, color: color.xyz };
    const [front, angles] = [texel(2), texel(3)];
    const shaping = { front: front.xyz, inner: front.w, outer: angles.x, focus: color.w };
    return { place, color: color.xyz, shaping };
  }

  /** Goes through all lights, or the distant ones. */
  each(which: 'all' | 'distant', visit: (light: LightTexels) => void): void {
    const count = which === 'all' ? this.lights.length : this.lights.filter(isDistant).length;
    if (count > WRITTEN_OUT)
      Loop({ start: int(0), end: int(count), type: 'int', condition: '<' }, ({ i }) => visit(this.light(int(i))));
    else for (let i = 0; i < count; i++) visit(this.light(int(i)));
  }

  /** Places are uploaded relative to the observer's event. */
  update(sight: Sight): void {
    this.lights.forEach((light, i) => {
      this.table.values.set(texelsOf(light, sight).slice(0, 4 * this.stride), 4 * this.stride * i);
    });
    this.table.upload();
    this.areas?.update(sight);
  }

  dispose(): void {
    this.table.dispose();
    this.areas?.dispose();
    this.picture?.dispose();
  }

  private setDay(): void {
    this.setSky(DAY.zenith, DAY.horizon, DAY.ground);
    this.uniforms.upperMean.value.setRGB(0.36, 0.48, 0.7);
    this.uniforms.lowerMean.value.setRGB(0.24, 0.22, 0.2);
  }

  private setDome({ color }: DomeLight): void {
    this.setSky(color, color, color);
    this.uniforms.upperMean.value.setRGB(...color);
    this.uniforms.lowerMean.value.setRGB(...color);
  }

  private setSky(zenith: Vec3, horizon: Vec3, ground: Vec3): void {
    this.uniforms.zenithColor.value.setRGB(...zenith);
    this.uniforms.horizonColor.value.setRGB(...horizon);
    this.uniforms.groundColor.value.setRGB(...ground);
  }
}

const isDistant = (light: DirectLight): light is DistantLight => light.kind === 'distant';
const isArea = (light: DirectLight): light is AreaLight => light.kind !== 'distant' && light.kind !== 'sphere';

/** A sphere's radiance L is the intensity πr²L; a point's colour is its intensity. */
function texelsOf(light: Direct, sight: Sight): readonly number[] {
  if (light.kind === 'distant') return [...normalize(scale(light.direction, -1)), 0, ...light.color, 0];
  const { position, orientation, color } = lampSeen(light, sight);
  const [inner, outer, focus] = shapingValues(light);
  const front = rotate(orientation, [0, 0, -1]);
  return [...position, 1, ...scale(color, shownArea(light)), focus, ...front, inner, outer];
}
