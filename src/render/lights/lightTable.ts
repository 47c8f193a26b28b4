import { int, Loop } from 'three/tsl';
import { rotate } from '../../math/quat.ts';
import { dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { oneMinusBetaSquared } from '../../physics/lorentz/boost.ts';
import {
  type PolylineLine,
  positionAt,
  samplesUntil,
  velocityAt,
  type WorldLine,
} from '../../physics/worldLines/worldLine.ts';
import { projectedArea } from '../../scene/lights/lightKinds.ts';
import { isStatic, originWorldLine, poseAt } from '../../scene/motion/motion.ts';
import { samplePose } from '../../scene/motion/poses.ts';
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
import { intersect, type Observation, type RelativeEvent, rapidityFactor } from '../geometry/observation.ts';
import type { FloatTable, TablePart } from '../gpu/floatTable.ts';
import { lightShader, lightShapeOf } from './lightShaders.ts';
import { shapingValues } from './lightShaping.ts';
import type { LightTexels, LocalLightShape } from './lightTexels.ts';

/** Local lights that one piece of code stands for. */
interface LightGroup {
  readonly kind: LocalLightShape;
  readonly motion: LocalLight['motion']['kind'];
  readonly spectrumKind: SpectrumKind;
  readonly colored: number | undefined;
  readonly texels: readonly LightTexelName[];
  /** Texel of the first. */
  readonly first: number;
  /** The first of them cast shadows. */
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

/** So many local lights of a scene cast shadows. */
const MAX_SHADOW_CASTERS = 8;
/** Longest table that is searched. */
const MAX_SAMPLES = 4096;
/** (place, time) relative to the anchor, orientation. */
const SAMPLE_TEXELS = 2;

const keptSamples = (line: WorldLine): number =>
  line.kind === 'polyline' ? Math.min(line.times.length, MAX_SAMPLES) : 0;

/** All local lights of a scene. Those of a kind that move alike lie together: each group has code of its own, and no more of it than it needs. */
export class LightTable {
  private readonly groups: readonly LightGroup[];
  private readonly lights: TablePart;
  private readonly samples: TablePart;

  private readonly lines: LineTable;

  /** `table`: where they lie; it is to be uploaded after `update`. */
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
    const shares = shareEvenly(
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
        shadowCasterCount: shares[k],
      };
      first += texels.length * members.length;
      return group;
    });
    this.lights = table.part(first);
    const moved = this.groups.flatMap(({ lights }) => lights.map(({ line }) => line));
    this.samples = table.part(moved.reduce((sum, line) => sum + SAMPLE_TEXELS * keptSamples(line), 0));
  }

  /** `slot`: its place among those that cast shadows. */
  forEach(visit: (light: LightTexels, slot?: gpu.Int | number) => void): void {
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

  /** Those that cast shadows, by their slots. */
  get shadowCasters(): readonly LightEntry[] {
    return this.groups.flatMap(({ lights, shadowCasterCount }) => lights.slice(0, shadowCasterCount));
  }

  /** Where not all of a group cast shadows, those do that are brightest from where the observer is. */
  selectShadowCasters(sight: Observation): void {
    for (const { lights, shadowCasterCount } of this.groups) {
      if (shadowCasterCount === lights.length) continue;
      const illuminances = new Map(lights.map((entry) => [entry, illuminance(entry, sight)]));
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
    const [X, Y, life, path, source] = (['X', 'Y', 'life', 'motion', 'source'] as const).map(texel);
    const made = source && spectralSourceOf(spectrumKind, [source.x, source.y], this.lines);
    return {
      kind,
      motion: { kind: motion, samples: this.samples, ...(path && life && { moving: { motion: path, w: life.w } }) },
      place: place.xyz,
      radius: place.w,
      color: color.xyz,
      ...(X && Y && { shape: { X: X.xyz, Y: Y.xyz, inner: X.w, outer: Y.w, focus: color.w } }),
      ...(life && { life: life.xyz }),
      ...(made && { source: made }),
      ...(colored !== undefined && { colored }),
    };
  }

  /** Once per picture. */
  update(sight: Observation, colors: ColorMode): void {
    let used = 0;
    for (const { texels, first, lights } of this.groups)
      lights.forEach((entry, i) => {
        const values = texelValues(entry, sight, colors);
        const motion =
          entry.line.kind === 'polyline'
            ? this.writeSamples(entry, entry.line, values.anchor, sight, used)
            : values.motion;
        used += entry.line.kind === 'polyline' ? SAMPLE_TEXELS * motion[1] : 0;
        texels.forEach((name, k) => {
          this.lights.set(name === 'motion' ? motion : values[name], first + i * texels.length + k);
        });
      });
  }

  /** Those up to the anchor and one more, for no surface that is seen is lit by later ones; two texels each: (place, time) relative to the anchor, orientation. */
  private writeSamples(
    { light: { motion } }: LightEntry,
    { times }: PolylineLine,
    anchor: RelativeEvent,
    sight: Observation,
    used: number,
  ): readonly number[] {
    if (motion.kind !== 'sampled') return [0, 0, 0, 0];
    const end = Math.max(2, Math.min(times.length, samplesUntil(times, sight.t + anchor.ahead / sight.c) + 1));
    const begin = Math.max(0, end - MAX_SAMPLES);
    for (let k = begin; k < end; k++) {
      const { position, orientation } = samplePose(motion.poses, k);
      const time = sight.c * (times[k] - sight.t) - anchor.ahead;
      const place = sub(sub(position, sight.position), anchor.offset);
      this.samples.set([...place, time, ...orientation], used + SAMPLE_TEXELS * (k - begin));
    }
    return [used, end - begin, 0, 0];
  }
}

/** Those from `begin` to `end`: one by one, where that is cheaper, with the number that is known then. */
function forEachUnrolled(
  kind: LocalLightShape,
  begin: number,
  end: number,
  visit: (i: gpu.Int, k?: number) => void,
): void {
  if (end - begin <= lightShader(kind).maxUnrolled) for (let i = begin; i < end; i++) visit(int(i), i);
  else Loop({ start: int(begin), end: int(end), type: 'int', condition: '<' }, ({ i }) => visit(int(i)));
}

/** At most `most` in all, as evenly as there are some to give it to. */
function shareEvenly(counts: readonly number[], most: number): readonly number[] {
  const shares = counts.map(() => 0);
  const given = () => shares.reduce((a, b) => a + b, 0);
  for (let before = -1; before < given() && given() < most; ) {
    before = given();
    counts.forEach((count, k) => {
      if (shares[k] < count && given() < most) shares[k]++;
    });
  }
  return shares;
}

/** At the observer, but for what is in its way. */
function illuminance({ light, line }: LightEntry, sight: Observation): number {
  const { offset } = lightAnchor(line, sight);
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
  { light, line, spectrumParameters, colors }: LightEntry,
  sight: Observation,
  how: ColorMode,
): Readonly<Record<LightTexelName, readonly number[]>> & { readonly anchor: RelativeEvent } {
  const anchor = lightAnchor(line, sight);
  const time = sight.t + anchor.ahead / sight.c;
  const [inner, outer, focus] = shapingValues(light);
  const { x, y, radius, gain } = lightShader(lightShapeOf(light)).extents(light);
  const turns = light.motion.kind === 'sampled';
  const axis = (v: Vec3): Vec3 => (turns ? v : rotate(poseAt(light.motion, time, sight.c).orientation, v));
  const after = (t: number) => Math.max(-1e30, Math.min(1e30, sight.c * (t - sight.t)));
  const [motion, w] = motionTexel(line, anchor, sight);
  return {
    anchor,
    place: [...anchor.offset, radius],
    color: [...scale(colors[how], gain), focus],
    X: [...axis([x, 0, 0]), inner],
    Y: [...axis([0, y, 0]), outer],
    life: [after(light.lifetime.birth), after(light.lifetime.death), anchor.ahead, w],
    motion,
    source: [...spectrumParameters, 0, 0],
  };
}

/** A light as it is seen from an event. */
export const lightAnchor = (line: WorldLine, sight: Observation): RelativeEvent =>
  intersect(line, sight) ?? eventAtObserverTime(line, sight);

/** What is behind the observer's horizon may still light what he sees. */
const eventAtObserverTime = (line: WorldLine, { t, position, c }: Observation): RelativeEvent => ({
  offset: sub(positionAt(line, t, c), position),
  ahead: 0,
});

function motionTexel(
  line: WorldLine,
  anchor: RelativeEvent,
  sight: Observation,
): readonly [motion: readonly number[], w: number] {
  if (line.kind === 'uniform') {
    const v = scale(velocityAt(line, sight.t, sight.c), 1 / sight.c);
    return [[...v, oneMinusBetaSquared(v)], 1];
  }
  if (line.kind !== 'hyperbolic') return [[0, 0, 0, 1], 1];
  const a = line.properAcceleration;
  const w = rapidityFactor(a, line.t0, anchor.ahead, sight);
  return [[...normalize(a, [1, 0, 0]), length(a) / (sight.c * sight.c)], w];
}
