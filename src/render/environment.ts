import { float, int, Loop, uniform } from 'three/tsl';
import { Color } from 'three/webgpu';
import { normalize, scale, type Vec3 } from '../math/vec3.ts';
import { directLights, domeOf, nightSkyOf } from '../scene/daylight.ts';
import { skyIrradiance } from '../scene/skyGradient.ts';
import type { DistantLight, DomeLight, NightSky, Scene } from '../scene/types.ts';
import type { ColorMode } from '../scene/view.ts';
import type { HalfAtlas } from '../shaders/halfAtlas.ts';
import type * as gpu from '../shaders/types.ts';
import type { ColoredLight } from '../spectrum/filterPairs.ts';
import { DomePicture } from './domeTexture.ts';
import type { FloatTable, TablePart } from './floatTable.ts';
import {
  coloredIndex,
  coloredLights,
  domeKind,
  type ShineColors,
  type ShineKind,
  shineColors,
  shineKind,
  shineNumbers,
  sourceOf,
} from './lampShine.ts';
import { LampTable } from './lampTable.ts';
import { LineTable } from './lineTable.ts';
import { SKY, type Source } from './radiance.ts';
import type { Sight } from './sight.ts';

/** A distant light on the GPU. */
export interface SunTexels {
  /** Towards it, unit. */
  readonly direction: gpu.Vec3;
  /** The filter of its irradiance. */
  readonly color: gpu.Vec3;
  /** Absent of daylight. */
  readonly source?: Source;
  /** As a passage's. */
  readonly colored?: number;
}

interface KnownSun extends DistantLight {
  readonly shine: readonly [number, number];
  readonly colors: ShineColors;
}

/** Distant lights that one piece of code stands for. */
interface SunGroup {
  readonly shine: ShineKind;
  readonly colored: number | undefined;
  readonly suns: readonly KnownSun[];
}

/** Texels per distant light: (direction, x), (colour, y), with (x, y) of `shineNumbers`. */
const SUN_TEXELS = 2;
/** So many lights are written out one by one: a software GPU goes through the body of a loop once more than it need. */
const WRITTEN_OUT = 4;

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
  readonly picture: DomePicture | undefined;
  readonly lamps: LampTable;
  readonly night: NightSky | undefined;
  private readonly suns: readonly SunGroup[];
  /** What the sky's light is made of. */
  readonly skySource: Source;
  /** Whether it changes with height. */
  readonly hasGradient: boolean;
  private readonly dome: DomeLight;
  private skyMode: ColorMode | undefined;
  private readonly distant: TablePart;
  private readonly lines: LineTable;

  /** `table` and `atlas`: what the scene's shaders read; the first is to be uploaded after `update`. */
  constructor(scene: Scene, table: FloatTable, atlas: HalfAtlas) {
    this.lines = new LineTable(table);
    const dome = domeOf(scene);
    this.night = nightSkyOf(scene);
    const direct = directLights(scene);
    const known = coloredLights(scene);
    this.suns = this.grouped(
      direct.filter((light) => light.kind === 'distant'),
      known,
    );
    this.distant = table.part(SUN_TEXELS * this.distantLights.length);
    this.lamps = new LampTable(
      direct.filter((light) => light.kind !== 'distant'),
      known,
      this.lines,
      table,
    );
    const [x, y] = shineNumbers(dome, this.lines);
    this.skySource = sourceOf(domeKind(dome), [float(x), float(y)], this.lines) ?? SKY;
    this.dome = dome;
    this.hasGradient = dome.gradient !== undefined;
    if (dome.texture) this.picture = new DomePicture(dome.texture, dome, this.uniforms.zenithColor.rgb, atlas);
  }

  /** In the order in which `eachSun` counts them. */
  get distantLights(): readonly DistantLight[] {
    return this.suns.flatMap(({ suns }) => suns);
  }

  private grouped(suns: readonly DistantLight[], known: readonly ColoredLight[]): readonly SunGroup[] {
    const alike = new Map<string, DistantLight[]>();
    for (const sun of suns) {
      const key = `${shineKind(sun)} ${coloredIndex(sun, known)}`;
      alike.set(key, [...(alike.get(key) ?? []), sun]);
    }
    return [...alike.values()].map((members) => ({
      shine: shineKind(members[0]),
      colored: coloredIndex(members[0], known),
      suns: members.map((sun) => ({ ...sun, shine: shineNumbers(sun, this.lines), colors: shineColors(sun) })),
    }));
  }

  /** `index`: its place among the suns, where that is known before the shader runs. */
  eachSun(visit: (sun: SunTexels, index?: number) => void): void {
    let start = 0;
    for (const group of this.suns) {
      const [begin, end] = [start, start + group.suns.length];
      if (end - begin > WRITTEN_OUT)
        Loop({ start: int(begin), end: int(end), type: 'int', condition: '<' }, ({ i }) =>
          visit(this.sun(int(i), group)),
        );
      else for (let i = begin; i < end; i++) visit(this.sun(int(i), group), i);
      start = end;
    }
  }

  private sun(index: gpu.Int, { shine, colored }: SunGroup): SunTexels {
    const at = index.mul(int(SUN_TEXELS));
    const [direction, color] = [0, 1].map((k) => this.distant.texel(at.add(int(k))).toVar());
    const source = sourceOf(shine, [direction.w, color.w], this.lines);
    return {
      direction: direction.xyz,
      color: color.xyz,
      ...(source && { source }),
      ...(colored !== undefined && { colored }),
    };
  }

  /** Places are uploaded relative to the observer's event. */
  update(sight: Sight, colors: ColorMode): void {
    const suns = this.suns.flatMap((group) => group.suns);
    suns.forEach((sun, i) => {
      const [x, y] = sun.shine;
      const texels = [...normalize(scale(sun.direction, -1)), x, ...sun.colors[colors], y];
      this.distant.set(texels, SUN_TEXELS * i);
    });
    this.lamps.update(sight, colors);
    this.setSky(colors);
  }

  dispose(): void {
    this.picture?.dispose();
  }

  private setSky(mode: ColorMode): void {
    if (mode === this.skyMode) return;
    this.skyMode = mode;
    const shown = (color: Vec3): Vec3 => shineColors({ ...this.dome, color })[mode];
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
