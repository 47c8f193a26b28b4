import { int, Loop } from 'three/tsl';
import { normalize, scale } from '../../math/vec3.ts';
import type { ColorMode } from '../../scene/settings/settings.ts';
import type { DistantLight } from '../../scene/types.ts';
import type * as gpu from '../../shaders/types.ts';
import type { FilteredBlackbody } from '../../spectrum/doppler/filterPairs.ts';
import {
  coloredLightIndex,
  type LightColors,
  lightColorsOf,
  type SpectrumKind,
  spectralSourceOf,
  spectrumKindOf,
  spectrumParametersOf,
} from '../color/lightSpectra.ts';
import type { LineTable } from '../color/lineTable.ts';
import type { RadianceAccumulator } from '../color/radiance.ts';
import type { Observation } from '../geometry/observation.ts';
import type { FloatTable, TablePart } from '../gpu/floatTable.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { addDisc, addDistantLight, type DistantLightTexels } from './kinds/distantLight.ts';
import type { LitSurface } from './kinds/litSurface.ts';
import type { LightSet, SkyPixel } from './lightSet.ts';

interface DistantLightEntry extends DistantLight {
  readonly spectrumParameters: readonly [number, number];
  readonly colors: LightColors;
}

/** Distant lights that share shader code. */
interface DistantLightGroup {
  readonly spectrumKind: SpectrumKind;
  readonly colored: number | undefined;
  readonly lights: readonly DistantLightEntry[];
}

/** Texels per distant light: (direction, x), (colour, y), with (x, y) of `spectrumParametersOf`. */
const DISTANT_LIGHT_TEXELS = 2;
/** Up to this number the loop is unrolled: a software GPU runs the body of a loop once more than needed. */
const MAX_UNROLLED = 4;

/** All distant lights of a scene. */
export class DistantLightTable implements LightSet {
  private readonly groups: readonly DistantLightGroup[];
  private readonly table: TablePart;
  private readonly lines: LineTable;

  /** `table` holds their values; upload it after `update`. */
  constructor(
    lights: readonly DistantLight[],
    colored: readonly FilteredBlackbody[],
    lines: LineTable,
    table: FloatTable,
  ) {
    this.lines = lines;
    this.groups = groupsOf(lights, colored, lines);
    this.table = table.part(DISTANT_LIGHT_TEXELS * lights.length);
  }

  /** By their indices in the table. */
  get lights(): readonly DistantLight[] {
    return this.groups.flatMap(({ lights }) => lights);
  }

  addReflected(surface: LitSurface, accumulator: RadianceAccumulator): void {
    this.forEach((light, index) => {
      addDistantLight(surface, light, index, accumulator);
    });
  }

  addBackground({ n }: SkyPixel, _uniforms: FrameUniforms, accumulator: RadianceAccumulator): void {
    this.forEach((light) => {
      addDisc(light, n, accumulator);
    });
  }

  /** `index`: its place in `lights`, where that is known before the shader runs. */
  private forEach(visit: (light: DistantLightTexels, index?: number) => void): void {
    let start = 0;
    for (const group of this.groups) {
      const [begin, end] = [start, start + group.lights.length];
      if (end - begin > MAX_UNROLLED)
        Loop({ start: int(begin), end: int(end), type: 'int', condition: '<' }, ({ i }) =>
          visit(this.read(int(i), group)),
        );
      else for (let i = begin; i < end; i++) visit(this.read(int(i), group), i);
      start = end;
    }
  }

  private read(index: gpu.Int, { spectrumKind, colored }: DistantLightGroup): DistantLightTexels {
    const at = index.mul(int(DISTANT_LIGHT_TEXELS));
    const [direction, color] = [0, 1].map((k) => this.table.texel(at.add(int(k))).toVar());
    const source = spectralSourceOf(spectrumKind, [direction.w, color.w], this.lines);
    return {
      direction: direction.xyz,
      color: color.xyz,
      ...(source && { source }),
      ...(colored !== undefined && { colored }),
    };
  }

  update(_observation: Observation, colors: ColorMode): void {
    const entries = this.groups.flatMap((group) => group.lights);
    entries.forEach((light, i) => {
      const [x, y] = light.spectrumParameters;
      const texels = [...normalize(scale(light.direction, -1)), x, ...light.colors[colors], y];
      this.table.set(texels, DISTANT_LIGHT_TEXELS * i);
    });
  }
}

function groupsOf(
  lights: readonly DistantLight[],
  colored: readonly FilteredBlackbody[],
  lines: LineTable,
): readonly DistantLightGroup[] {
  const alike = new Map<string, DistantLight[]>();
  for (const light of lights) {
    const key = `${spectrumKindOf(light)} ${coloredLightIndex(light, colored)}`;
    alike.set(key, [...(alike.get(key) ?? []), light]);
  }
  return [...alike.values()].map((members) => ({
    spectrumKind: spectrumKindOf(members[0]),
    colored: coloredLightIndex(members[0], colored),
    lights: members.map((light) => ({
      ...light,
      spectrumParameters: spectrumParametersOf(light, lines),
      colors: lightColorsOf(light),
    })),
  }));
}
