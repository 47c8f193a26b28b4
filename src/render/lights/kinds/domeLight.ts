import { clamp, dot, float, If, int, max, mix, pow, smoothstep, sqrt, tanh, uniform } from 'three/tsl';
import { Color } from 'three/webgpu';
import type { Vec3 } from '../../../math/vec3.ts';
import { SKY_SHAPE, skyIrradiance } from '../../../scene/lights/skyGradient.ts';
import type { ColorMode } from '../../../scene/settings/settings.ts';
import type { DomeLight } from '../../../scene/types.ts';
import type { HalfAtlas } from '../../../shaders/tables/halfAtlas.ts';
import type * as gpu from '../../../shaders/types.ts';
import { lobeAxis, skyReflectance } from '../../brdf/skyReflectance.ts';
import { domeSpectrumKind, lightColorsOf, spectralSourceOf, spectrumParametersOf } from '../../color/lightSpectra.ts';
import type { LineTable } from '../../color/lineTable.ts';
import {
  RADIANCE_POWER,
  type RadianceAccumulator,
  SKY_SOURCE,
  type SpectralFilterNodes,
  type SpectralSource,
} from '../../color/radiance.ts';
import type { Observation } from '../../geometry/observation.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import { loopTimes } from '../../shadows/atlas/atlasLookups.ts';
import type { LightSet, SkyPixel } from '../lightSet.ts';
import { incidentSpectrumBetween, type RestFrameMotion, WORLD_FRAME } from '../restFrame.ts';
import type { DomeMaps } from '../sky/domeMaps.ts';
import type { DomeTexture } from '../sky/domeTexture.ts';
import { type LobeCone, type SkyMeans, skyLobe } from '../sky/skyLobe.ts';
import { GRADIENT_HEIGHTS, gradientMeans, MEAN_RAPIDITIES } from '../sky/skyMeans.ts';
import type { LitSurface } from './litSurface.ts';

/** Roughness from which on a moving surface's reflection is a cone of several D, and not one ray. */
const SHARP_TO_ROUGH = [0.12, 0.3] as const;
/** Least width of such a cone. */
const MIN_CONE = 0.1;

const colorUniform = () => uniform(new Color());

/** A dome light on the GPU: of one colour, a gradient from the horizon to the zenith, or a texture. */
export class DomeSky implements LightSet {
  private readonly uniforms = {
    zenithColor: uniform(new Color()),
    horizonColor: uniform(new Color()),
    groundColor: uniform(new Color()),
    /** Of `SkyIrradiance`. */
    skyLevel: uniform(new Color()),
    skyRise: uniform(new Color()),
    skyBend: uniform(new Color()),
  };
  /** Of blackbodies: of which channel of the dome's light each is, and the factor of its colour. */
  private readonly sources: readonly {
    readonly source: SpectralSource;
    readonly part?: { readonly channel: number; readonly factor: ReturnType<typeof colorUniform> };
  }[];
  private readonly dome: DomeLight;
  private readonly texture: DomeTexture | undefined;
  private readonly atlas: HalfAtlas;
  private colorMode: ColorMode | undefined;

  /** `Picture`: for a dome with a picture. */
  constructor(dome: DomeLight, lines: LineTable, atlas: HalfAtlas, Picture?: typeof DomeTexture) {
    const sourceOf = (light: Pick<DomeLight, 'spectrum'>): SpectralSource => {
      const [x, y] = spectrumParametersOf(light, lines);
      return spectralSourceOf(domeSpectrumKind(dome), [float(x), float(y)], lines) ?? SKY_SOURCE;
    };
    this.sources = dome.blackbodies?.map((light) => ({
      source: sourceOf(light),
      part: { channel: light.channel, factor: colorUniform() },
    })) ?? [{ source: sourceOf(dome) }];
    this.dome = dome;
    this.atlas = atlas;
    if (dome.texture && Picture) this.texture = new Picture(dome.texture, dome, this.uniforms.zenithColor.rgb, atlas);
  }

  /** Diffuse and specular reflection, times ambient occlusion and the material's own occlusion. */
  addReflected(surface: LitSurface, accumulator: RadianceAccumulator): void {
    const { motion } = surface.rest;
    const resting = (): void => this.addAtRest(surface, accumulator);
    if (motion) If(motion.moving, () => this.addMoving(surface, motion, accumulator)).Else(resting);
    else resting();
  }

  private addAtRest({ brdf, occlusion, openness, uniforms }: LitSurface, accumulator: RadianceAccumulator): void {
    const { diffuse, specular } = skyReflectance(brdf, openness);
    const { zenith } = uniforms;
    const add = (light: gpu.Vec3, reflectance: SpectralFilterNodes): void =>
      this.addLight(light, reflectance.mul(occlusion), {}, accumulator);
    add(this.irradiance(brdf.N, zenith), diffuse);
    add(this.specular(lobeAxis(brdf, brdf.lobe.cosine), zenith, brdf.roughness), specular);
  }

  /** By rings of the sky that each have one D: of the diffuse lobe, of the specular one, and the mirrored ray of smooth surfaces. */
  private addMoving(
    { brdf, rest, occlusion, openness, uniforms }: LitSurface,
    motion: RestFrameMotion,
    accumulator: RadianceAccumulator,
  ): void {
    const { zenith } = uniforms;
    const reflectance = skyReflectance(brdf, openness);
    const diffuse = reflectance.diffuse.mul(occlusion).toVar();
    const specular = reflectance.specular.mul(occlusion).toVar();
    const means: SkyMeans = (axis, rapidity, direction) => this.means(axis, rapidity, direction, zenith);
    const core = brdf.lobes.core(brdf.NV, brdf.roughness);
    const parts = brdf.lobes.parts(brdf.NV, brdf.roughness);
    const axis = lobeAxis(brdf, core.cosine).toVar();
    const rough = smoothstep(...SHARP_TO_ROUGH, brdf.roughness).toVar();
    const middle = specular.mul(rough.mul(core.share)).toVar();
    const tails = specular.mul(rough.mul(core.share.oneMinus())).toVar();
    const wide = tails.mul(parts.wide).toVar();
    const narrow = tails.sub(wide).toVar();
    const cones: readonly LobeCone[] = [
      { axis: brdf.N, width: float(1), rings: 4 },
      { axis: lobeAxis(brdf, parts.cosine).toVar(), width: max(parts.width, MIN_CONE), rings: 4 },
      { axis, width: max(core.width, MIN_CONE), rings: 2 },
    ];
    const lobes = cones.map((cone) => skyLobe(cone, motion, means));
    const wideWeight = lobes[0].wideWeight(brdf.NV);
    const mirrored = rest.out(axis).toVar();
    const mirroredShift = incidentSpectrumBetween(mirrored, rest, WORLD_FRAME).D ?? float(1);
    // A cone of the rest frame is wider by D in the world, and a cone's angle is 2 roughness².
    const sharp = this.specular(mirrored, zenith, clamp(brdf.roughness.mul(sqrt(mirroredShift)), 0, 1)).toVar();
    const starts = cones.map((_, k) => cones.slice(0, k).reduce((sum, { rings }) => sum + rings, 0));
    const count = cones.reduce((sum, { rings }) => sum + rings, 1);
    loopTimes(int(count), (i) => {
      const [D, radiance, share] = [mirroredShift.toVar(), sharp.toVar(), specular.mul(rough.oneMinus()).toVar()];
      lobes.forEach((lobe, k) => {
        const j = i.sub(int(starts[k])).toVar();
        If(j.greaterThanEqual(int(0)).and(j.lessThan(int(cones[k].rings))), () => {
          const ring = lobe.ring(j);
          D.assign(ring.D);
          radiance.assign(ring.radiance);
          share.assign(
            k === 0
              ? diffuse.mul(ring.weight).add(wide.mul(wideWeight(j)))
              : (k === 1 ? narrow : middle).mul(ring.weight),
          );
        });
      });
      this.addLight(radiance, share, { D }, accumulator);
    });
  }

  private addLight(
    light: gpu.Vec3,
    reflectance: SpectralFilterNodes,
    { D }: { readonly D?: gpu.Float },
    accumulator: RadianceAccumulator,
  ): void {
    for (const { source, color } of this.lightsOf(light)) {
      const incident = { ...(D && { D }), source, colored: 'picture' } as const;
      accumulator.addReflected(color, reflectance, incident, RADIANCE_POWER);
    }
  }

  addBackground({ n, angle }: SkyPixel, { zenith }: FrameUniforms, accumulator: RadianceAccumulator): void {
    const light = (this.texture ? this.texture.radiance(n, angle) : this.radiance(n, zenith)).toVar();
    for (const { source, color } of this.lightsOf(light)) accumulator.addEmitted(color, source);
  }

  /** By source: the light itself, or the part of each blackbody. */
  private lightsOf(light: gpu.Vec3): { source: SpectralSource; color: gpu.Vec3 }[] {
    const channels = [light.x, light.y, light.z];
    return this.sources.map(({ source, part }) => ({
      source,
      color: part ? part.factor.rgb.mul(channels[part.channel]) : light,
    }));
  }

  /** Radiance from the world direction `n` of a sky without a texture (skyGradient.ts). */
  private radiance(n: gpu.Vec3, zenith: gpu.Vec3): gpu.Vec3 {
    const { zenithColor, horizonColor, groundColor } = this.uniforms;
    if (!this.dome.gradient) return zenithColor.rgb;
    const { curve, dim, haze, seam } = SKY_SHAPE;
    const height = dot(n, zenith).toVar();
    const above = mix(horizonColor, zenithColor, pow(clamp(height, 0, 1), curve));
    const below = mix(horizonColor.mul(dim), groundColor, smoothstep(0, haze, height.negate()));
    return mix(below, above, smoothstep(-seam, seam, height));
  }

  /** Irradiance/π on a surface with the normal `n`. */
  private irradiance(n: gpu.Vec3, zenith: gpu.Vec3): gpu.Vec3 {
    if (this.texture) return this.texture.irradiance(n);
    const { zenithColor, skyLevel, skyRise, skyBend } = this.uniforms;
    if (!this.dome.gradient) return zenithColor.rgb;
    const height = dot(n, zenith).toVar();
    return skyBend.rgb.mul(height).add(skyRise).mul(height).add(skyLevel);
  }

  /** Prefiltered radiance around `n` for a surface of the given roughness. */
  private specular(n: gpu.Vec3, zenith: gpu.Vec3, roughness: gpu.Float): gpu.Vec3 {
    if (this.texture) return this.texture.specular(n, roughness);
    return mix(this.radiance(n, zenith), this.irradiance(n, zenith), roughness.sqrt());
  }

  private means(axis: gpu.Vec3, rapidity: gpu.Float, direction: gpu.Vec3, zenith: gpu.Vec3): ReturnType<SkyMeans> {
    if (this.texture) return this.texture.meansAbout(axis, rapidity, direction);
    const { zenithColor, horizonColor, groundColor } = this.uniforms;
    if (!this.dome.gradient) {
      // The mean n of a cone is (2 + c)/3 along its axis.
      const mean = tanh(rapidity).negate().add(2).div(3);
      return {
        mean: zenithColor.rgb,
        along: zenithColor.rgb.mul(mean.mul(dot(axis, direction))),
        even: () => zenithColor.rgb,
      };
    }
    const { first, step, count } = MEAN_RAPIDITIES;
    const table = this.atlas.table('gradient means', gradientMeans);
    const level = clamp(rapidity.sub(first).div(step), 0, count - 1)
      .add(0.5)
      .toVar();
    const height = clamp(dot(axis, zenith), -1, 1).toVar();
    const column = height
      .add(1)
      .mul((GRADIENT_HEIGHTS - 1) / 2)
      .add(0.5)
      .toVar();
    const moment = (k: number): gpu.Vec3 => {
      const { x, y, z } = table.sampleLinear(column, level.add(k * count));
      return zenithColor.rgb.mul(x).add(horizonColor.rgb.mul(y)).add(groundColor.rgb.mul(z));
    };
    const up = dot(direction, zenith).toVar();
    const across = dot(direction, axis)
      .sub(up.mul(height))
      .div(max(sqrt(height.mul(height).oneMinus()), 1e-4));
    return { mean: moment(0), along: moment(1).mul(up).add(moment(2).mul(across)), even: () => moment(3) };
  }

  /** Shows another picture of the same size. */
  show(maps: DomeMaps): void {
    this.texture?.show(maps);
  }

  update(_observation: Observation, mode: ColorMode): void {
    if (mode === this.colorMode) return;
    this.colorMode = mode;
    const inMode = (color: Vec3): Vec3 => lightColorsOf({ ...this.dome, color })[mode];
    const { color, gradient = { horizon: color, ground: color } } = this.dome;
    const sky = { zenith: inMode(color), horizon: inMode(gradient.horizon), ground: inMode(gradient.ground) };
    const { level, rise, bend } = skyIrradiance(sky);
    const { zenithColor, horizonColor, groundColor, skyLevel, skyRise, skyBend } = this.uniforms;
    zenithColor.value.setRGB(...sky.zenith);
    horizonColor.value.setRGB(...sky.horizon);
    groundColor.value.setRGB(...sky.ground);
    skyLevel.value.setRGB(...level);
    skyRise.value.setRGB(...rise);
    skyBend.value.setRGB(...bend);
    this.dome.blackbodies?.forEach(({ color, spectrum }, i) => {
      this.sources[i].part?.factor.value.setRGB(...lightColorsOf({ color, spectrum })[mode]);
    });
  }

  dispose(): void {
    this.texture?.dispose();
  }
}
