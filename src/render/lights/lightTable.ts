import { int, Loop } from 'three/tsl';
import { rotate } from '../../math/quat.ts';
import { dot, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { positionAt, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import { projectedArea } from '../../scene/lights/lightKinds.ts';
import { isStatic, originWorldLine } from '../../scene/motion/motion.ts';
import { motionKind } from '../../scene/motion/motions.ts';
import type { ColorMode } from '../../scene/settings/settings.ts';
import type { LocalLight } from '../../scene/types.ts';
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
import { intersect, type Observation, type RelativeEvent } from '../geometry/observation.ts';
import type { FloatTable, TablePart } from '../gpu/floatTable.ts';
import type { LitSurface } from './kinds/litSurface.ts';
import { lightMotionKind } from './lightMotions.ts';
import type { LightSet } from './lightSet.ts';
import { lightShader, lightShapeOf } from './lightShaders.ts';
import { shapingValues } from './lightShaping.ts';
import type { LightTexels, LocalLightShape } from './lightTexels.ts';
import { addLocalLight } from './localLight.ts';
import type { WrittenMotion } from './motions/lightMotionKind.ts';

/** Local lights that share shader code: of the same shape, motion, spectrum and texels. */
interface LightGroup {
  readonly kind: LocalLightShape;
  readonly motion: LocalLight['motion']['kind'];
  readonly spectrumKind: SpectrumKind;
  readonly colored: number | undefined;
  readonly texels: readonly LightTexelName[];
  /** First texel of the first light. */
  readonly first: number;
  /** The first `shadowCasterCount` of them cast shadows. */
  readonly lights: LightEntry[];
  readonly shadowCasterCount: number;
}

type LightTexelName = 'place' | 'color' | 'X' | 'Y' | 'life' | 'motion' | 'source';

export interface LightEntry {
  readonly light: LocalLight;
  readonly line: WorldLine;
  readonly spectrumParameters: readonly [number, number];
  readonly colors: LightColors;
}

/** How many local lights of a scene cast shadows at most. */
const MAX_SHADOW_CASTERS = 8;

/** All local lights of a scene, in groups that share shader code, which is no longer than the group needs. */
export class LightTable implements LightSet {
  private readonly groups: readonly LightGroup[];
  private readonly lights: TablePart;
  private readonly samples: TablePart;

  private readonly lines: LineTable;

  /** `table` holds their values; upload it after `update`. */
  constructor(
    lights: readonly LocalLight[],
    colored: readonly FilteredBlackbody[],
    lines: LineTable,
    table: FloatTable,
  ) {
    this.lines = lines;
    const alike = new Map<string, LocalLight[]>();
    for (const light of lights) {
      const key = [
        lightShapeOf(light),
        light.motion.kind,
        spectrumKindOf(light),
        coloredLightIndex(light, colored),
        ...texelsOf(light),
      ].join(' ');
      alike.set(key, [...(alike.get(key) ?? []), light]);
    }
    let first = 0;
    const shadowCasterCounts = divideEvenly(
      [...alike.values()].map(({ length: count }) => count),
      MAX_SHADOW_CASTERS,
    );
    this.groups = [...alike.values()].map((members, k) => {
      const texels = texelsOf(members[0]);
      const group = {
        kind: lightShapeOf(members[0]),
        motion: members[0].motion.kind,
        spectrumKind: spectrumKindOf(members[0]),
        colored: coloredLightIndex(members[0], colored),
        texels,
        first,
        lights: members.map((light) => makeLightEntry(light, lines)),
        shadowCasterCount: shadowCasterCounts[k],
      };
      first += texels.length * members.length;
      return group;
    });
    this.lights = table.part(first);
    this.samples = table.part(
      lights.reduce((sum, { motion }) => sum + lightMotionKind(motion).sampleTexels(motion), 0),
    );
  }

  addReflected(surface: LitSurface, accumulator: RadianceAccumulator): void {
    this.forEach((light, slot) => {
      addLocalLight(surface, light, slot, accumulator);
    });
  }

  /** They are not seen themselves. */
  addBackground(): void {}

  /** `slot`: index among the shadow casters. */
  private forEach(visit: (light: LightTexels, slot?: gpu.Int | number) => void): void {
    let slots = 0;
    for (const group of this.groups) {
      const [first, { shadowCasterCount }] = [slots, group];
      forEachUnrolled(group.kind, 0, shadowCasterCount, (i, k) =>
        visit(this.read(group, i), k === undefined ? i.add(int(first)) : first + k),
      );
      forEachUnrolled(group.kind, shadowCasterCount, group.lights.length, (i) => visit(this.read(group, i)));
      slots += shadowCasterCount;
    }
  }

  /** The lights that cast shadows, by slot. */
  get shadowCasters(): readonly LightEntry[] {
    return this.groups.flatMap(({ lights, shadowCasterCount }) => lights.slice(0, shadowCasterCount));
  }

  /** Where not all of a group cast shadows, the brightest at the observer do. */
  selectShadowCasters(observation: Observation): void {
    for (const { lights, shadowCasterCount } of this.groups) {
      if (shadowCasterCount === lights.length) continue;
      const illuminances = new Map(lights.map((entry) => [entry, illuminance(entry, observation)]));
      lights.sort((a, b) => illuminances.get(b)! - illuminances.get(a)!);
    }
  }

  private read({ kind, motion, spectrumKind, colored, texels, first }: LightGroup, index: gpu.Int): LightTexels {
    const at = index.mul(int(texels.length)).add(int(first)).toVar();
    const texel = (name: LightTexelName): gpu.Vec4 | undefined => {
      const k = texels.indexOf(name);
      return k < 0 ? undefined : this.lights.texel(at.add(int(k))).toVar();
    };
    const [place, color] = [texel('place')!, texel('color')!];
    const [X, Y, life, path, parameters] = (['X', 'Y', 'life', 'motion', 'source'] as const).map(texel);
    const source = parameters && spectralSourceOf(spectrumKind, [parameters.x, parameters.y], this.lines);
    const { samples } = this;
    return {
      kind,
      motion: { kind: motion, ...(path && life && { moving: { motion: path, w: life.w, samples } }) },
      place: place.xyz,
      radius: place.w,
      color: color.xyz,
      ...(X && Y && { shape: { X: X.xyz, Y: Y.xyz, inner: X.w, outer: Y.w, focus: color.w } }),
      ...(life && { life: life.xyz }),
      ...(source && { source }),
      ...(colored !== undefined && { colored }),
    };
  }

  update(observation: Observation, colors: ColorMode): void {
    let used = 0;
    for (const { texels, first, lights } of this.groups)
      lights.forEach((entry, i) => {
        const { motion } = entry.light;
        const anchor = lightAnchor(entry.line, observation);
        const written = lightMotionKind(motion).write(motion, anchor, observation, this.samples, used);
        used += written.used;
        const values = texelValues(entry, anchor, written, observation, colors);
        texels.forEach((name, k) => {
          this.lights.set(values[name], first + i * texels.length + k);
        });
      });
  }
}

/** Visits `begin` … `end` − 1: unrolled where that is cheaper, and then with the index as a constant `k`. */
function forEachUnrolled(
  kind: LocalLightShape,
  begin: number,
  end: number,
  visit: (i: gpu.Int, k?: number) => void,
): void {
  if (end - begin <= lightShader(kind).maxUnrolled) for (let i = begin; i < end; i++) visit(int(i), i);
  else Loop({ start: int(begin), end: int(end), type: 'int', condition: '<' }, ({ i }) => visit(int(i)));
}

/** Divides at most `max` among counts, as evenly as they allow. */
function divideEvenly(counts: readonly number[], max: number): readonly number[] {
  const parts = counts.map(() => 0);
  const total = () => parts.reduce((a, b) => a + b, 0);
  for (let before = -1; before < total() && total() < max; ) {
    before = total();
    counts.forEach((count, k) => {
      if (parts[k] < count && total() < max) parts[k]++;
    });
  }
  return parts;
}

/** Illuminance at the observer, unoccluded, up to a factor. */
function illuminance({ light, line }: LightEntry, observation: Observation): number {
  const { offset } = lightAnchor(line, observation);
  return (Math.max(...light.color) * projectedArea(light)) / Math.max(dot(offset, offset), 1e-6);
}

function texelsOf(light: LocalLight): readonly LightTexelName[] {
  const { motion, shaping, lifetime } = light;
  const mortal = Number.isFinite(lifetime.birth) || Number.isFinite(lifetime.death);
  return [
    'place',
    'color',
    ...(lightShader(lightShapeOf(light)).needsAxes || shaping ? (['X', 'Y'] as const) : []),
    ...(mortal || !isStatic(motion) ? (['life'] as const) : []),
    ...(isStatic(motion) ? [] : (['motion'] as const)),
    ...(spectrumKindOf(light) === 'daylight' ? [] : (['source'] as const)),
  ];
}

const makeLightEntry = (light: LocalLight, lines: LineTable): LightEntry => ({
  light,
  line: originWorldLine(light.motion),
  spectrumParameters: spectrumParametersOf(light, lines),
  colors: lightColorsOf(light),
});

function texelValues(
  { light, spectrumParameters, colors }: LightEntry,
  anchor: RelativeEvent,
  { motion, w }: WrittenMotion,
  observation: Observation,
  mode: ColorMode,
): Readonly<Record<LightTexelName, readonly number[]>> {
  const [inner, outer, focus] = shapingValues(light);
  const { x, y, radius, gain } = lightShader(lightShapeOf(light)).extents(light);
  const orientation = motionKind(light.motion).fixedOrientation(light.motion);
  const axis = (v: Vec3): Vec3 => (orientation ? rotate(orientation, v) : v);
  const after = (t: number) => Math.max(-1e30, Math.min(1e30, observation.c * (t - observation.t)));
  return {
    place: [...anchor.offset, radius],
    color: [...scale(colors[mode], gain), focus],
    X: [...axis([x, 0, 0]), inner],
    Y: [...axis([0, y, 0]), outer],
    life: [after(light.lifetime.birth), after(light.lifetime.death), anchor.ahead, w],
    motion,
    source: [...spectrumParameters, 0, 0],
  };
}

/** Where a light's world line meets the hypersurface; of one behind the observer's horizon, which may still light what he sees, its place at his time. */
export const lightAnchor = (line: WorldLine, observation: Observation): RelativeEvent =>
  intersect(line, observation) ?? eventAtObserverTime(line, observation);

const eventAtObserverTime = (line: WorldLine, { t, position, c }: Observation): RelativeEvent => ({
  offset: sub(positionAt(line, t, c), position),
  ahead: 0,
});
