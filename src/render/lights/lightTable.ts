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
import type { SpectralSource } from '../color/radiance.ts';
import { intersect, type Observation, type RelativeEvent, rapidityFactor } from '../geometry/observation.ts';
import type { FloatTable, TablePart } from '../gpu/floatTable.ts';
import type { LightMotion } from './lightEvent.ts';
import { shapingValues } from './lightShaping.ts';

/** A ball without a size is a point. */
type LocalLightKind = LocalLight['kind'] | 'point';

/** A lamp on the GPU, relative to one event of it, its anchor: where the observer sees it, if he does. */
export interface LightTexels {
  readonly kind: LocalLightKind;
  readonly motion: LightMotion;
  /** Observer → anchor [m]. */
  readonly place: gpu.Vec3;
  readonly radius: gpu.Float;
  /** The filter of its radiance; of a point that of its intensity. */
  readonly color: gpu.Vec3;
  /** Absent of what shines alike to all sides. */
  readonly shape?: LightShape;
  /** Birth, death and the anchor's time after the observer's [m of light]; absent where it rests and always shines. */
  readonly life?: gpu.Vec3;
  /** Absent of daylight. */
  readonly source?: SpectralSource;
  /** As a passage's. */
  readonly colored?: number;
}

export interface LightShape {
  /** Half axes, of a sphere of length 1; of a tube X is one, and Y of length 1. Where the lamp turns, in its own axes. */
  readonly X: gpu.Vec3;
  readonly Y: gpu.Vec3;
  readonly inner: gpu.Float;
  readonly outer: gpu.Float;
  readonly focus: gpu.Float;
}

/** Lamps that one piece of code stands for. */
interface LightGroup {
  readonly kind: LocalLightKind;
  readonly motion: LocalLight['motion']['kind'];
  readonly spectrumKind: SpectrumKind;
  readonly colored: number | undefined;
  readonly texels: readonly LightTexelName[];
  /** Texel of the first. */
  readonly first: number;
  /** The first of them throw shadows. */
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

/** A line is drawn as a tube of this part of its length. */
const LINE_RADIUS_RATIO = 5e-4;
/** So many are written out one by one: a software GPU goes through the body of a loop once more than it need. */
const MAX_UNROLLED = { point: 4, sphere: 2, rect: 1, disk: 1, cylinder: 1 } as const;
/** So many lamps of a scene throw shadows. */
const MAX_SHADOW_CASTERS = 8;
/** Longest table that is searched. */
const MAX_SAMPLES = 4096;
/** (place, time) relative to the anchor, orientation. */
const SAMPLE_TEXELS = 2;

const keptSamples = (line: WorldLine): number =>
  line.kind === 'polyline' ? Math.min(line.times.length, MAX_SAMPLES) : 0;

/** All lamps of a scene. Those of a kind that move alike lie together: each group has code of its own, and no more of it than it needs. */
export class LightTable {
  private readonly groups: readonly LightGroup[];
  private readonly lights: TablePart;
  private readonly samples: TablePart;

  private readonly lines: LineTable;

  /** `table`: where they lie; it is to be uploaded after `update`. */
  constructor(
    lamps: readonly LocalLight[],
    colored: readonly FilteredBlackbody[],
    lines: LineTable,
    table: FloatTable,
  ) {
    this.lines = lines;
    const alike = new Map<string, LocalLight[]>();
    for (const lamp of lamps) {
      const key = [
        lightKindOf(lamp),
        lamp.motion.kind,
        spectrumKindOf(lamp),
        coloredLightIndex(lamp, colored),
        ...texelsOf(lamp),
      ].join(' ');
      alike.set(key, [...(alike.get(key) ?? []), lamp]);
    }
    let first = 0;
    const shares = shareEvenly(
      [...alike.values()].map(({ length: count }) => count),
      MAX_SHADOW_CASTERS,
    );
    this.groups = [...alike.values()].map((members, k) => {
      const texels = texelsOf(members[0]);
      const group = {
        kind: lightKindOf(members[0]),
        motion: members[0].motion.kind,
        spectrumKind: spectrumKindOf(members[0]),
        colored: coloredLightIndex(members[0], colored),
        texels,
        first,
        lights: members.map((lamp) => makeLightEntry(lamp, lines)),
        shadowCasterCount: shares[k],
      };
      first += texels.length * members.length;
      return group;
    });
    this.lights = table.part(first);
    const moved = this.groups.flatMap(({ lights: lamps }) => lamps.map(({ line }) => line));
    this.samples = table.part(moved.reduce((sum, line) => sum + SAMPLE_TEXELS * keptSamples(line), 0));
  }

  /** `slot`: its place among those that throw shadows. */
  forEach(visit: (lamp: LightTexels, slot?: gpu.Int | number) => void): void {
    let slots = 0;
    for (const group of this.groups) {
      const [first, { shadowCasterCount: casting }] = [slots, group];
      forEachUnrolled(group.kind, 0, casting, (i, k) =>
        visit(this.read(group, i), k === undefined ? i.add(int(first)) : first + k),
      );
      forEachUnrolled(group.kind, casting, group.lights.length, (i) => visit(this.read(group, i)));
      slots += casting;
    }
  }

  /** Those that throw shadows, by their slots. */
  get shadowCasters(): readonly LightEntry[] {
    return this.groups.flatMap(({ lights: lamps, shadowCasterCount: casting }) => lamps.slice(0, casting));
  }

  /** Where not all of a group throw shadows, those do that are brightest from where the observer is. */
  selectShadowCasters(sight: Observation): void {
    for (const { lights: lamps, shadowCasterCount: casting } of this.groups) {
      if (casting === lamps.length) continue;
      const shown = new Map(lamps.map((lamp) => [lamp, illuminance(lamp, sight)]));
      lamps.sort((a, b) => shown.get(b)! - shown.get(a)!);
    }
  }

  private read({ kind, motion, spectrumKind: shine, colored, texels, first }: LightGroup, index: gpu.Int): LightTexels {
    const at = index.mul(int(texels.length)).add(int(first)).toVar();
    const texel = (name: LightTexelName): gpu.Vec4 | undefined => {
      const k = texels.indexOf(name);
      return k < 0 ? undefined : this.lights.texel(at.add(int(k))).toVar();
    };
    const [place, color] = [texel('place')!, texel('color')!];
    const [X, Y, life, path, source] = (['X', 'Y', 'life', 'motion', 'source'] as const).map(texel);
    const made = source && spectralSourceOf(shine, [source.x, source.y], this.lines);
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
    for (const { texels, first, lights: lamps } of this.groups)
      lamps.forEach((lamp, i) => {
        const values = texelValues(lamp, sight, colors);
        const motion =
          lamp.line.kind === 'polyline'
            ? this.writeSamples(lamp, lamp.line, values.anchor, sight, used)
            : values.motion;
        used += lamp.line.kind === 'polyline' ? SAMPLE_TEXELS * motion[1] : 0;
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
  kind: LocalLightKind,
  begin: number,
  end: number,
  visit: (i: gpu.Int, k?: number) => void,
): void {
  if (end - begin <= MAX_UNROLLED[kind]) for (let i = begin; i < end; i++) visit(int(i), i);
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

function texelsOf(lamp: LocalLight): readonly LightTexelName[] {
  const { kind, motion, shaping, lifetime } = lamp;
  const mortal = Number.isFinite(lifetime.birth) || Number.isFinite(lifetime.death);
  return [
    'place',
    'color',
    ...(kind !== 'sphere' || shaping ? (['X', 'Y'] as const) : []),
    ...(mortal || !isStatic(motion) ? (['life'] as const) : []),
    ...(isStatic(motion) ? [] : (['motion'] as const)),
    ...(spectrumKindOf(lamp) === 'daylight' ? [] : (['source'] as const)),
  ];
}

const lightKindOf = (lamp: LocalLight): LocalLightKind =>
  lamp.kind === 'sphere' && lamp.radius === 0 ? 'point' : lamp.kind;

const makeLightEntry = (lamp: LocalLight, lines: LineTable): LightEntry => ({
  light: lamp,
  line: originWorldLine(lamp.motion),
  spectrumParameters: spectrumParametersOf(lamp, lines),
  colors: lightColorsOf(lamp),
});

function texelValues(
  { light, line, spectrumParameters, colors }: LightEntry,
  sight: Observation,
  how: ColorMode,
): Readonly<Record<LightTexelName, readonly number[]>> & { readonly anchor: RelativeEvent } {
  const anchor = lightAnchor(line, sight);
  const time = sight.t + anchor.ahead / sight.c;
  const [inner, outer, focus] = shapingValues(light);
  const { x, y, radius, gain } = extents(light);
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

/** A lamp as it is seen from an event. */
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

/** Half sizes along X and Y and the radius [m], and what the colour is multiplied with: to be a radiance, or of a point an intensity. */
function extents(light: LocalLight): { x: number; y: number; radius: number; gain: number } {
  switch (light.kind) {
    case 'sphere':
      return { x: 1, y: 1, radius: light.radius, gain: 1 };
    case 'rect':
      return { x: light.width / 2, y: light.height / 2, radius: 0, gain: 1 };
    case 'disk':
      return { x: light.radius, y: light.radius, radius: light.radius, gain: 1 };
    case 'cylinder': {
      const radius = light.radius || LINE_RADIUS_RATIO * light.length;
      return { x: light.length / 2, y: 1, radius, gain: light.radius > 0 ? 1 : 1 / (2 * radius) };
    }
  }
}
