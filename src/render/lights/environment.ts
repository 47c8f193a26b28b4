import { float, int, Loop, uniform } from 'three/tsl';
import { Color } from 'three/webgpu';
import { normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { directLights, sceneDome, sceneNightSky } from '../../scene/lights/sceneLights.ts';
import { skyIrradiance } from '../../scene/lights/skyGradient.ts';
import type { ColorMode } from '../../scene/settings/settings.ts';
import type { DistantLight, DomeLight, NightSky, Scene } from '../../scene/types.ts';
import type { HalfAtlas } from '../../shaders/tables/halfAtlas.ts';
import type * as gpu from '../../shaders/types.ts';
import type { FilteredBlackbody } from '../../spectrum/doppler/filterPairs.ts';
import {
  coloredLightIndex,
  coloredLights,
  domeSpectrumKind,
  type LightColors,
  lightColorsOf,
  type SpectrumKind,
  spectralSourceOf,
  spectrumKindOf,
  spectrumParametersOf,
} from '../color/lightSpectra.ts';
import { LineTable } from '../color/lineTable.ts';
import { SKY_SOURCE, type SpectralSource } from '../color/radiance.ts';
import type { Observation } from '../geometry/observation.ts';
import type { FloatTable, TablePart } from '../gpu/floatTable.ts';
import { DomeTexture } from './domeTexture.ts';
import { LightTable } from './lightTable.ts';

/** A distant light on the GPU. */
export interface DistantLightTexels {
  /** Towards it, unit. */
  readonly direction: gpu.Vec3;
  /** The filter of its irradiance. */
  readonly color: gpu.Vec3;
  /** Absent of daylight. */
  readonly source?: SpectralSource;
  /** As a passage's. */
  readonly colored?: number;
}

interface DistantLightEntry extends DistantLight {
  readonly spectrumParameters: readonly [number, number];
  readonly colors: LightColors;
}

/** Distant lights that one piece of code stands for. */
interface DistantLightGroup {
  readonly spectrumKind: SpectrumKind;
  readonly colored: number | undefined;
  readonly lights: readonly DistantLightEntry[];
}

/** Texels per distant light: (direction, x), (colour, y), with (x, y) of `spectrumParametersOf`. */
const DISTANT_LIGHT_TEXELS = 2;
/** So many lights are written out one by one: a software GPU goes through the body of a loop once more than it need. */
const MAX_UNROLLED = 4;

/** Where light comes from: suns, lamps, and a sky (the scene's dome, or a clear day's). */
export class Environment {
  readonly uniforms = {
    zenithColor: uniform(new Color()),
    horizonColor: uniform(new Color()),
    groundColor: uniform(new Color()),
    /** Of `SkyIrradiance`. */
    skyLevel: uniform(new Color()),
    skyRise: uniform(new Color()),
    skyBend: uniform(new Color()),
  };
  /** The dome's, where it has one. */
  readonly domeTexture: DomeTexture | undefined;
  readonly localLights: LightTable;
  readonly nightSky: NightSky | undefined;
  private readonly distantGroups: readonly DistantLightGroup[];
  /** What the sky's light is made of. */
  readonly skySource: SpectralSource;
  /** Whether it changes with height. */
  readonly hasGradient: boolean;
  private readonly dome: DomeLight;
  private skyColorMode: ColorMode | undefined;
  private readonly distantTable: TablePart;
  private readonly lines: LineTable;

  /** `table` and `atlas`: what the scene's shaders read; the first is to be uploaded after `update`. */
  constructor(scene: Scene, table: FloatTable, atlas: HalfAtlas) {
    this.lines = new LineTable(table);
    const dome = sceneDome(scene);
    this.nightSky = sceneNightSky(scene);
    const direct = directLights(scene);
    const known = coloredLights(scene);
    this.distantGroups = this.grouped(
      direct.filter((light) => light.kind === 'distant'),
      known,
    );
    this.distantTable = table.part(DISTANT_LIGHT_TEXELS * this.distantLights.length);
    this.localLights = new LightTable(
      direct.filter((light) => light.kind !== 'distant'),
      known,
      this.lines,
      table,
    );
    const [x, y] = spectrumParametersOf(dome, this.lines);
    this.skySource = spectralSourceOf(domeSpectrumKind(dome), [float(x), float(y)], this.lines) ?? SKY_SOURCE;
    this.dome = dome;
    this.hasGradient = dome.gradient !== undefined;
    if (dome.texture) this.domeTexture = new DomeTexture(dome.texture, dome, this.uniforms.zenithColor.rgb, atlas);
  }

  /** In the order in which `eachSun` counts them. */
  get distantLights(): readonly DistantLight[] {
    return this.distantGroups.flatMap(({ lights: suns }) => suns);
  }

  private grouped(suns: readonly DistantLight[], known: readonly FilteredBlackbody[]): readonly DistantLightGroup[] {
    const alike = new Map<string, DistantLight[]>();
    for (const sun of suns) {
      const key = `${spectrumKindOf(sun)} ${coloredLightIndex(sun, known)}`;
      alike.set(key, [...(alike.get(key) ?? []), sun]);
    }
    return [...alike.values()].map((members) => ({
      spectrumKind: spectrumKindOf(members[0]),
      colored: coloredLightIndex(members[0], known),
      lights: members.map((sun) => ({
        ...sun,
        spectrumParameters: spectrumParametersOf(sun, this.lines),
        colors: lightColorsOf(sun),
      })),
    }));
  }

  /** `index`: its place among the suns, where that is known before the shader runs. */
  forEachDistantLight(visit: (sun: DistantLightTexels, index?: number) => void): void {
    let start = 0;
    for (const group of this.distantGroups) {
      const [begin, end] = [start, start + group.lights.length];
      if (end - begin > MAX_UNROLLED)
        Loop({ start: int(begin), end: int(end), type: 'int', condition: '<' }, ({ i }) =>
          visit(this.readDistantLight(int(i), group)),
        );
      else for (let i = begin; i < end; i++) visit(this.readDistantLight(int(i), group), i);
      start = end;
    }
  }

  private readDistantLight(index: gpu.Int, { spectrumKind: shine, colored }: DistantLightGroup): DistantLightTexels {
    const at = index.mul(int(DISTANT_LIGHT_TEXELS));
    const [direction, color] = [0, 1].map((k) => this.distantTable.texel(at.add(int(k))).toVar());
    const source = spectralSourceOf(shine, [direction.w, color.w], this.lines);
    return {
      direction: direction.xyz,
      color: color.xyz,
      ...(source && { source }),
      ...(colored !== undefined && { colored }),
    };
  }

  /** Places are uploaded relative to the observer's event. */
  update(sight: Observation, colors: ColorMode): void {
    const suns = this.distantGroups.flatMap((group) => group.lights);
    suns.forEach((sun, i) => {
      const [x, y] = sun.spectrumParameters;
      const texels = [...normalize(scale(sun.direction, -1)), x, ...sun.colors[colors], y];
      this.distantTable.set(texels, DISTANT_LIGHT_TEXELS * i);
    });
    this.localLights.update(sight, colors);
    this.setSky(colors);
  }

  dispose(): void {
    this.domeTexture?.dispose();
  }

  private setSky(mode: ColorMode): void {
    if (mode === this.skyColorMode) return;
    this.skyColorMode = mode;
    const shown = (color: Vec3): Vec3 => lightColorsOf({ ...this.dome, color })[mode];
    const { color, gradient = { horizon: color, ground: color } } = this.dome;
    const sky = { zenith: shown(color), horizon: shown(gradient.horizon), ground: shown(gradient.ground) };
    const { level, rise, bend } = skyIrradiance(sky);
    const { zenithColor, horizonColor, groundColor, skyLevel, skyRise, skyBend } = this.uniforms;
    zenithColor.value.setRGB(...sky.zenith);
    horizonColor.value.setRGB(...sky.horizon);
    groundColor.value.setRGB(...sky.ground);
    skyLevel.value.setRGB(...level);
    skyRise.value.setRGB(...rise);
    skyBend.value.setRGB(...bend);
  }
}
