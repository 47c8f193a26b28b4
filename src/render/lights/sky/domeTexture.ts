import {
  acos,
  atan,
  clamp,
  dot,
  float,
  floor,
  log2,
  max,
  min,
  mix,
  smoothstep,
  texture,
  uniform,
  vec2,
} from 'three/tsl';
import { type DataTexture, type Node, Vector3 } from 'three/webgpu';
import { domeAxes } from '../../../scene/lights/latLong.ts';
import type { DomeLight, Texture } from '../../../scene/types.ts';
import type { HalfAtlas, HalfTable } from '../../../shaders/tables/halfAtlas.ts';
import type { Float, Vec2, Vec3 } from '../../../shaders/types.ts';
import { uploadTexture } from '../../gpu/textures.ts';
import { BORDER } from './borderedMap.ts';
import { type DomeMaps, domeMaps } from './domeMaps.ts';
import { MEAN_SIZE, pictureMeans } from './pictureMeans.ts';
import { PREFILTER_SIZE, SPECULAR_LOBES } from './prefilteredDome.ts';
import type { SkyMeans } from './skyLobe.ts';
import { MEAN_RAPIDITIES } from './skyMeans.ts';

/** Names of tables in the atlas. */
const [LOBES, MEANS] = ['dome', 'dome means'];

/** A dome's texture on the GPU, with its prefiltered maps for diffuse and glossy surfaces. */
export class DomeTexture {
  private readonly image: DataTexture;
  private readonly maps: HalfTable;
  private readonly means: () => HalfTable;
  private readonly atlas: HalfAtlas;
  private shown: DomeMaps;
  private readonly tint: Node<'vec3'>;
  private readonly axes: readonly Node<'vec3'>[];

  /** `tint`: factor of its colours. */
  constructor(picture: NonNullable<DomeLight['texture']>, dome: DomeLight, tint: Vec3, atlas: HalfAtlas) {
    this.image = uploadTexture({ ...picture, wrapS: 'repeat', wrapT: 'clamp' }, false);
    this.image.generateMipmaps = false;
    this.shown = domeMaps(picture, 'none');
    this.image.mipmaps = [...this.shown.levels];
    this.atlas = atlas;
    this.maps = atlas.table(LOBES, () => this.shown.lobes);
    // Only what moves needs it.
    this.means = () =>
      atlas.table(MEANS, () => this.shown.means ?? pictureMeans({ ...picture, ...this.shown.levels[0] } as Texture));
    this.tint = tint;
    this.axes = domeAxes(dome).map((axis) => uniform(new Vector3(...axis)));
  }

  /** Shows another picture of the same size. */
  show(maps: DomeMaps): void {
    this.shown = maps;
    this.image.mipmaps = [...maps.levels];
    this.image.needsUpdate = true;
    this.atlas.replace(LOBES, maps.lobes);
    if (maps.means) this.atlas.replace(MEANS, maps.means);
  }

  /** Mean radiance from the direction n of the world, within an angle [rad]. */
  radiance(n: Vec3, angle: Float): Vec3 {
    const texels = angle.mul(this.image.image.height / Math.PI);
    return this.sampleImage(this.place(n), log2(max(texels, 1)));
  }

  /** `SkyMeans` by the tables of pictureMeans.ts. */
  meansAbout(axis: Vec3, rapidity: Float, direction: Vec3): ReturnType<SkyMeans> {
    const { first, step, count } = MEAN_RAPIDITIES;
    const place = this.place(axis).toVar();
    const level = clamp(rapidity.sub(first).div(step), 0, count - 1).toVar();
    const lower = min(floor(level), count - 2).toVar();
    const between = level.sub(lower).toVar();
    const x = place.x.mul(MEAN_SIZE.width).add(BORDER).toVar();
    const y = place.y
      .mul(MEAN_SIZE.height)
      .add(BORDER)
      .add(lower.mul(MEAN_SIZE.height + 2 * BORDER))
      .toVar();
    const moment = (k: number): Vec3 => {
      const across = x.add(k * (MEAN_SIZE.width + 2 * BORDER));
      const [near, next] = [y, y.add(MEAN_SIZE.height + 2 * BORDER)].map((row) =>
        this.means().sampleLinear(across, row),
      );
      return mix(near.xyz, next.xyz, between).mul(this.tint);
    };
    const along = this.axes.map((own, k) => moment(k + 1).mul(dot(own, direction)));
    return { mean: moment(0), along: along[0].add(along[1]).add(along[2]), even: () => moment(along.length + 1) };
  }

  /** Irradiance/π on a surface with the normal n. */
  irradiance(n: Vec3): Vec3 {
    return this.sampleMap(this.place(n), float(SPECULAR_LOBES.length)).mul(this.tint);
  }

  /** Prefiltered radiance around n for a surface of the given roughness. */
  specular(n: Vec3, roughness: Float): Vec3 {
    const place = this.place(n).toVar();
    const first = SPECULAR_LOBES[0].roughness;
    // Mip level at which a texel is as wide as the lobe: 2a, a = roughness².
    const texels = roughness.mul(roughness).mul(this.image.image.width / Math.PI);
    const nearly = this.sampleImage(place, log2(max(texels, 1)));
    const step = clamp(roughness.div(first).sub(1), 0, SPECULAR_LOBES.length - 1).toVar();
    const lower = floor(step).toVar();
    const upper = min(lower.add(1), SPECULAR_LOBES.length - 1);
    const rough = mix(this.sampleMap(place, lower), this.sampleMap(place, upper), step.sub(lower)).mul(this.tint);
    return mix(nearly, rough, smoothstep(first / 2, first, roughness));
  }

  dispose(): void {
    this.image.dispose();
  }

  /** Texture coordinates of a world direction (latLong.ts), u to the right and v down. */
  private place(n: Vec3): Vec2 {
    const [x, y, z] = this.axes;
    const right = float(0.5).sub(atan(dot(n, x), dot(n, z)).div(2 * Math.PI));
    const down = acos(clamp(dot(n, y), -1, 1)).div(Math.PI);
    return vec2(right, down);
  }

  /** At an explicit mip level, since u has no derivative at the seam at ±180°. */
  private sampleImage(place: Vec2, level: Float): Vec3 {
    return texture(this.image, place).level(level).rgb.mul(this.tint);
  }

  /** From a layer of the prefiltered maps, which have wrapped borders. */
  private sampleMap(place: Vec2, layer: Float): Vec3 {
    const x = place.x.mul(PREFILTER_SIZE.width).add(BORDER);
    const y = place.y.mul(PREFILTER_SIZE.height).add(BORDER);
    return this.maps.sampleLinear(x, y.add(layer.mul(PREFILTER_SIZE.height + 2 * BORDER))).xyz;
  }
}
