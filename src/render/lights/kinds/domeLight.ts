import { clamp, dot, float, mix, normalize, pow, reflect, smoothstep, uniform } from 'three/tsl';
import { Color } from 'three/webgpu';
import type { Vec3 } from '../../../math/vec3.ts';
import { SKY_SHAPE, skyIrradiance } from '../../../scene/lights/skyGradient.ts';
import type { ColorMode } from '../../../scene/settings/settings.ts';
import type { DomeLight } from '../../../scene/types.ts';
import type { HalfAtlas } from '../../../shaders/tables/halfAtlas.ts';
import type * as gpu from '../../../shaders/types.ts';
import { skyReflectance } from '../../brdf/skyReflectance.ts';
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
import { DomeTexture } from '../domeTexture.ts';
import type { LightSet } from '../lightSet.ts';
import { incidentSpectrumBetween, WORLD_FRAME } from '../restFrame.ts';
import type { LitSurface } from './litSurface.ts';

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
  private readonly source: SpectralSource;
  private readonly dome: DomeLight;
  private readonly texture: DomeTexture | undefined;
  private colorMode: ColorMode | undefined;

  constructor(dome: DomeLight, lines: LineTable, atlas: HalfAtlas) {
    const [x, y] = spectrumParametersOf(dome, lines);
    this.source = spectralSourceOf(domeSpectrumKind(dome), [float(x), float(y)], lines) ?? SKY_SOURCE;
    this.dome = dome;
    if (dome.texture) this.texture = new DomeTexture(dome.texture, dome, this.uniforms.zenithColor.rgb, atlas);
  }

  /** Diffuse and specular reflection, times ambient occlusion and the material's own occlusion. */
  addReflected({ brdf, rest, occlusion, openness, uniforms }: LitSurface, accumulator: RadianceAccumulator): void {
    const { diffuse, specular } = skyReflectance(brdf, openness);
    const { zenith } = uniforms;
    const { N, V } = brdf;
    const diffuseRadiance = (n: gpu.Vec3) => this.irradiance(n, zenith);
    const specularRadiance = (n: gpu.Vec3) => this.specular(n, zenith, brdf.roughness);
    const addReflection = (
      nPrime: gpu.Vec3,
      radiance: (n: gpu.Vec3) => gpu.Vec3,
      reflectance: SpectralFilterNodes,
    ): void => {
      const n = rest.out(nPrime);
      const spectrum = {
        ...incidentSpectrumBetween(n, rest, WORLD_FRAME),
        source: this.source,
        colored: 'picture',
      } as const;
      accumulator.addReflected(radiance(n), reflectance.mul(occlusion), spectrum, RADIANCE_POWER);
    };
    addReflection(N, diffuseRadiance, diffuse);
    addReflection(normalize(reflect(V.negate(), N)).toVar(), specularRadiance, specular);
  }

  addBackground(n: gpu.Vec3, { zenith }: FrameUniforms, accumulator: RadianceAccumulator): void {
    accumulator.addEmitted(this.radiance(n, zenith), this.source);
  }

  /** Radiance from the world direction `n` (skyGradient.ts). */
  private radiance(n: gpu.Vec3, zenith: gpu.Vec3): gpu.Vec3 {
    if (this.texture) return this.texture.radiance(n);
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
  }

  dispose(): void {
    this.texture?.dispose();
  }
}
