import { int, Loop } from 'three/tsl';
import { rotate } from '../math/quat.ts';
import { dot, length, normalize, scale, sub, type Vec3 } from '../math/vec3.ts';
import { oneMinusSquare } from '../physics/boost.ts';
import { type PolylineLine, positionAt, samplesUntil, velocityAt, type WorldLine } from '../physics/worldLine.ts';
import { shownArea } from '../scene/lamps.ts';
import { originLine, poseAt, samplePose } from '../scene/motion.ts';
import type { Lamp } from '../scene/types.ts';
import type { ColorMode } from '../scene/view.ts';
import type * as gpu from '../shaders/types.ts';
import type { ColoredLight } from '../spectrum/filterPairs.ts';
import type { FloatTable, TablePart } from './floatTable.ts';
import type { LampPath } from './lampEvent.ts';
import {
  coloredIndex,
  type ShineColors,
  type ShineKind,
  shineColors,
  shineKind,
  shineNumbers,
  sourceOf,
} from './lampShine.ts';
import type { LineTable } from './lineTable.ts';
import type { Source } from './radiance.ts';
import { shapingValues } from './shaping.ts';
import { meet, type RelativeEvent, rapidityFactor, type Sight } from './sight.ts';

/** A ball without a size is a point. */
type LampKind = Lamp['kind'] | 'point';

/** A lamp on the GPU, relative to one event of it, its anchor: where the observer sees it, if he does. */
export interface LampTexels {
  readonly kind: LampKind;
  readonly path: LampPath;
  /** Observer → anchor [m]. */
  readonly place: gpu.Vec3;
  readonly radius: gpu.Float;
  /** The filter of its radiance; of a point that of its intensity. */
  readonly color: gpu.Vec3;
  /** Absent of what shines alike to all sides. */
  readonly shape?: LampShape;
  /** Birth, death and the anchor's time after the observer's [m of light]; absent where it rests and always shines. */
  readonly life?: gpu.Vec3;
  /** Absent of daylight. */
  readonly source?: Source;
  /** As a passage's. */
  readonly colored?: number;
}

export interface LampShape {
  /** Half axes, of a sphere of length 1; of a tube X is one, and Y of length 1. Where the lamp turns, in its own axes. */
  readonly X: gpu.Vec3;
  readonly Y: gpu.Vec3;
  readonly inner: gpu.Float;
  readonly outer: gpu.Float;
  readonly focus: gpu.Float;
}

/** Lamps that one piece of code stands for. */
interface Group {
  readonly kind: LampKind;
  readonly motion: Lamp['motion']['kind'];
  readonly shine: ShineKind;
  readonly colored: number | undefined;
  readonly texels: readonly TexelName[];
  /** Texel of the first. */
  readonly first: number;
  /** The first of them throw shadows. */
  readonly lamps: KnownLamp[];
  readonly casting: number;
}

type TexelName = 'place' | 'color' | 'X' | 'Y' | 'life' | 'motion' | 'source';

export interface KnownLamp {
  readonly lamp: Lamp;
  readonly line: WorldLine;
  readonly shine: readonly [number, number];
  readonly colors: ShineColors;
}

/** A line is drawn as a tube of this part of its length. */
const LINE = 5e-4;
/** So many are written out one by one: a software GPU goes through the body of a loop once more than it need. */
const WRITTEN_OUT = { point: 4, sphere: 2, rect: 1, disk: 1, cylinder: 1 } as const;
/** So many lamps of a scene throw shadows. */
const MOST_CASTING = 8;
/** Longest table that is searched. */
const MOST_SAMPLES = 4096;
/** (place, time) relative to the anchor, orientation. */
const SAMPLE_TEXELS = 2;

const keptSamples = (line: WorldLine): number =>
  line.kind === 'polyline' ? Math.min(line.times.length, MOST_SAMPLES) : 0;

/** All lamps of a scene. Those of a kind that move alike lie together: each group has code of its own, and no more of it than it needs. */
export class LampTable {
  private readonly groups: readonly Group[];
  private readonly lamps: TablePart;
  private readonly samples: TablePart;

  private readonly lines: LineTable;

  /** `table`: where they lie; it is to be uploaded after `update`. */
  constructor(lamps: readonly Lamp[], colored: readonly ColoredLight[], lines: LineTable, table: FloatTable) {
    this.lines = lines;
    const alike = new Map<string, Lamp[]>();
    for (const lamp of lamps) {
      const key = [
        kindOf(lamp),
        lamp.motion.kind,
        shineKind(lamp),
        coloredIndex(lamp, colored),
        ...texelsOf(lamp),
      ].join(' ');
      alike.set(key, [...(alike.get(key) ?? []), lamp]);
    }
    let first = 0;
    const shares = sharedOut(
      [...alike.values()].map(({ length: count }) => count),
      MOST_CASTING,
    );
    this.groups = [...alike.values()].map((members, k) => {
      const texels = texelsOf(members[0]);
      const group = {
        kind: kindOf(members[0]),
        motion: members[0].motion.kind,
        shine: shineKind(members[0]),
        colored: coloredIndex(members[0], colored),
        texels,
        first,
        lamps: members.map((lamp) => known(lamp, lines)),
        casting: shares[k],
      };
      first += texels.length * members.length;
      return group;
    });
    this.lamps = table.part(first);
    const moved = this.groups.flatMap(({ lamps }) => lamps.map(({ line }) => line));
    this.samples = table.part(moved.reduce((sum, line) => sum + SAMPLE_TEXELS * keptSamples(line), 0));
  }

  /** `slot`: its place among those that throw shadows. */
  each(visit: (lamp: LampTexels, slot?: gpu.Int | number) => void): void {
    let slots = 0;
    for (const group of this.groups) {
      const [first, { casting }] = [slots, group];
      eachOf(group.kind, 0, casting, (i, k) =>
        visit(this.read(group, i), k === undefined ? i.add(int(first)) : first + k),
      );
      eachOf(group.kind, casting, group.lamps.length, (i) => visit(this.read(group, i)));
      slots += casting;
    }
  }

  /** Those that throw shadows, by their slots. */
  get casting(): readonly KnownLamp[] {
    return this.groups.flatMap(({ lamps, casting }) => lamps.slice(0, casting));
  }

  /** Where not all of a group throw shadows, those do that are brightest from where the observer is. */
  arrange(sight: Sight): void {
    for (const { lamps, casting } of this.groups) {
      if (casting === lamps.length) continue;
      const shown = new Map(lamps.map((lamp) => [lamp, illuminance(lamp, sight)]));
      lamps.sort((a, b) => shown.get(b)! - shown.get(a)!);
    }
  }

  private read({ kind, motion, shine, colored, texels, first }: Group, index: gpu.Int): LampTexels {
    const at = index.mul(int(texels.length)).add(int(first)).toVar();
    const texel = (name: TexelName): gpu.Vec4 | undefined => {
      const k = texels.indexOf(name);
      return k < 0 ? undefined : this.lamps.texel(at.add(int(k))).toVar();
    };
    const [place, color] = [texel('place')!, texel('color')!];
    const [X, Y, life, path, source] = (['X', 'Y', 'life', 'motion', 'source'] as const).map(texel);
    const made = source && sourceOf(shine, [source.x, source.y], this.lines);
    return {
      kind,
      path: { kind: motion, samples: this.samples, ...(path && life && { moving: { motion: path, w: life.w } }) },
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
  update(sight: Sight, colors: ColorMode): void {
    let used = 0;
    for (const { texels, first, lamps } of this.groups)
      lamps.forEach((lamp, i) => {
        const values = valuesOf(lamp, sight, colors);
        const motion =
          lamp.line.kind === 'polyline'
            ? this.placeSamples(lamp, lamp.line, values.anchor, sight, used)
            : values.motion;
        used += lamp.line.kind === 'polyline' ? SAMPLE_TEXELS * motion[1] : 0;
        texels.forEach((name, k) => {
          this.lamps.set(name === 'motion' ? motion : values[name], first + i * texels.length + k);
        });
      });
  }

  /** Those up to the anchor and one more, for no surface that is seen is lit by later ones; two texels each: (place, time) relative to the anchor, orientation. */
  private placeSamples(
    { lamp: { motion } }: KnownLamp,
    { times }: PolylineLine,
    anchor: RelativeEvent,
    sight: Sight,
    used: number,
  ): readonly number[] {
    if (motion.kind !== 'sampled') return [0, 0, 0, 0];
    const end = Math.max(2, Math.min(times.length, samplesUntil(times, sight.t + anchor.ahead / sight.c) + 1));
    const begin = Math.max(0, end - MOST_SAMPLES);
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
function eachOf(kind: LampKind, begin: number, end: number, visit: (i: gpu.Int, k?: number) => void): void {
  if (end - begin <= WRITTEN_OUT[kind]) for (let i = begin; i < end; i++) visit(int(i), i);
  else Loop({ start: int(begin), end: int(end), type: 'int', condition: '<' }, ({ i }) => visit(int(i)));
}

/** At most `most` in all, as evenly as there are some to give it to. */
function sharedOut(counts: readonly number[], most: number): readonly number[] {
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
function illuminance({ lamp, line }: KnownLamp, sight: Sight): number {
  const { offset } = lampEventFor(line, sight);
  return (Math.max(...lamp.color) * shownArea(lamp)) / Math.max(dot(offset, offset), 1e-6);
}

function texelsOf(lamp: Lamp): readonly TexelName[] {
  const { kind, motion, shaping, lifetime } = lamp;
  const mortal = Number.isFinite(lifetime.birth) || Number.isFinite(lifetime.death);
  return [
    'place',
    'color',
    ...(kind !== 'sphere' || shaping ? (['X', 'Y'] as const) : []),
    ...(mortal || motion.kind !== 'static' ? (['life'] as const) : []),
    ...(motion.kind === 'static' ? [] : (['motion'] as const)),
    ...(shineKind(lamp) === 'daylight' ? [] : (['source'] as const)),
  ];
}

const kindOf = (lamp: Lamp): LampKind => (lamp.kind === 'sphere' && lamp.radius === 0 ? 'point' : lamp.kind);

const known = (lamp: Lamp, lines: LineTable): KnownLamp => ({
  lamp,
  line: originLine(lamp.motion),
  shine: shineNumbers(lamp, lines),
  colors: shineColors(lamp),
});

function valuesOf(
  { lamp, line, shine, colors }: KnownLamp,
  sight: Sight,
  how: ColorMode,
): Readonly<Record<TexelName, readonly number[]>> & { readonly anchor: RelativeEvent } {
  const anchor = lampEventFor(line, sight);
  const time = sight.t + anchor.ahead / sight.c;
  const [inner, outer, focus] = shapingValues(lamp);
  const { x, y, radius, gain } = extents(lamp);
  const turns = lamp.motion.kind === 'sampled';
  const axis = (v: Vec3): Vec3 => (turns ? v : rotate(poseAt(lamp.motion, time, sight.c).orientation, v));
  const after = (t: number) => Math.max(-1e30, Math.min(1e30, sight.c * (t - sight.t)));
  const [motion, w] = motionOf(line, anchor, sight);
  return {
    anchor,
    place: [...anchor.offset, radius],
    color: [...scale(colors[how], gain), focus],
    X: [...axis([x, 0, 0]), inner],
    Y: [...axis([0, y, 0]), outer],
    life: [after(lamp.lifetime.birth), after(lamp.lifetime.death), anchor.ahead, w],
    motion,
    source: [...shine, 0, 0],
  };
}

/** A lamp as it is seen from an event. */
export const lampEventFor = (line: WorldLine, sight: Sight): RelativeEvent =>
  meet(line, sight) ?? atObserversTime(line, sight);

/** What is behind the observer's horizon may still light what he sees. */
const atObserversTime = (line: WorldLine, { t, position, c }: Sight): RelativeEvent => ({
  offset: sub(positionAt(line, t, c), position),
  ahead: 0,
});

function motionOf(
  line: WorldLine,
  anchor: RelativeEvent,
  sight: Sight,
): readonly [motion: readonly number[], w: number] {
  if (line.kind === 'uniform') {
    const v = scale(velocityAt(line, sight.t, sight.c), 1 / sight.c);
    return [[...v, oneMinusSquare(v)], 1];
  }
  if (line.kind !== 'hyperbolic') return [[0, 0, 0, 1], 1];
  const a = line.properAcceleration;
  const w = rapidityFactor(a, line.t0, anchor.ahead, sight);
  return [[...normalize(a, [1, 0, 0]), length(a) / (sight.c * sight.c)], w];
}

/** Half sizes along X and Y and the radius [m], and what the colour is multiplied with: to be a radiance, or of a point an intensity. */
function extents(light: Lamp): { x: number; y: number; radius: number; gain: number } {
  switch (light.kind) {
    case 'sphere':
      return { x: 1, y: 1, radius: light.radius, gain: 1 };
    case 'rect':
      return { x: light.width / 2, y: light.height / 2, radius: 0, gain: 1 };
    case 'disk':
      return { x: light.radius, y: light.radius, radius: light.radius, gain: 1 };
    case 'cylinder': {
      const radius = light.radius || LINE * light.length;
      return { x: light.length / 2, y: 1, radius, gain: light.radius > 0 ? 1 : 1 / (2 * radius) };
    }
  }
}
