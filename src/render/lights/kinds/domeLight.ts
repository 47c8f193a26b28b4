import { clamp, dot, float, mix, pow, smoothstep, uniform } from 'three/tsl';
import { Color } from 'three/webgpu';
import type { Vec3 } from '../../../math/vec3.ts';
import { SKY_SHAPE, skyIrradiance } from '../../../scene/lights/skyGradient.ts';
import type { ColorMode } from '../../../scene/settings/settings.ts';
import type { DomeLight } from '../../../scene/types.ts';
import type { HalfAtlas } from '../../../shaders/tables/halfAtlas.ts';
import type * as gpu from '../../../shaders/types.ts';
import { domeSpectrumKind, lightColorsOf, spectralSourceOf, spectrumParametersOf } from '../../color/lightSpectra.ts';
import type { LineTable } from '../../color/lineTable.ts';
import { SKY_SOURCE, type SpectralSource } from '../../color/radiance.ts';
import { DomeTexture } from '../domeTexture.ts';

/** A dome light on the GPU: of one colour, a gradient from the horizon to the zenith, or a picture. */
export class DomeSky {
  private readonly uniforms = {
    zenithColor: uniform(new Color()),
    horizonColor: uniform(new Color()),
    groundColor: uniform(new Color()),
    /** Of `SkyIrradiance`. */
    skyLevel: uniform(new Color()),
    skyRise: uniform(new Color()),
    skyBend: uniform(new Color()),
  };
  /** The spectrum of its light. */
  readonly source: SpectralSource;
  private readonly dome: DomeLight;
  private readonly texture: DomeTexture | undefined;
  private colorMode: ColorMode | undefined;

  constructor(dome: DomeLight, lines: LineTable, atlas: HalfAtlas) {
    const [x, y] = spectrumParametersOf(dome, lines);
    this.source = spectralSourceOf(domeSpectrumKind(dome), [float(x), float(y)], lines) ?? SKY_SOURCE;
    this.dome = dome;
    if (dome.texture) this.texture = new DomeTexture(dome.texture, dome, this.uniforms.zenithColor.rgb, atlas);
  }

  /** Radiance from the world direction `n` (skyGradient.ts). */
  radiance(n: gpu.Vec3, zenith: gpu.Vec3): gpu.Vec3 {
    if (this.texture) return this.texture.radiance(n);
    const { zenithColor, horizonColor, groundColor } = this.uniforms;
    if (!this.dome.gradient) return zenithColor.rgb;
    const { curve, dim, haze, seam } = SKY_SHAPE;
    const height = dot(n, zenith).toVar();
    const above = mix(horizonColor, zenithColor, pow(clamp(height, 0, 1), curve));
    const below = mix(horizonColor.mul(dim), groundColor, smoothstep(0, haze, height.negate()));
    return mix(below, above, smoothstep(-seam, seam, height));
  }

  /** Irradiance/π of all of it on a surface whose normal is `n`. */
  irradiance(n: gpu.Vec3, zenith: gpu.Vec3): gpu.Vec3 {
    if (this.texture) return this.texture.irradiance(n);
    const { zenithColor, skyLevel, skyRise, skyBend } = this.uniforms;
    if (!this.dome.gradient) return zenithColor.rgb;
    const height = dot(n, zenith).toVar();
    return skyBend.rgb.mul(height).add(skyRise).mul(height).add(skyLevel);
  }

  /** What a surface of a roughness mirrors of it from about `n`. */
  specular(n: gpu.Vec3, zenith: gpu.Vec3, roughness: gpu.Float): gpu.Vec3 {
    if (this.texture) return this.texture.specular(n, roughness);
    return mix(this.radiance(n, zenith), this.irradiance(n, zenith), roughness.sqrt());
  }

  update(mode: ColorMode): void {
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
