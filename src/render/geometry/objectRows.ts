import { length, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { oneMinusBetaSquared } from '../../physics/lorentz/boost.ts';
import { type SampledLine, samplePosition } from '../../physics/worldLines/samples.ts';
import { asPolyline, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import { bendFactor, isCubic } from '../../scene/motion/cubicPoints.ts';
import { samplePose } from '../../scene/motion/poses.ts';
import type { Motion, SampledPointsMotion } from '../../scene/types.ts';
import type { FloatTable } from '../gpu/floatTable.ts';
import { type Body, hyperbolicLineOfCenter } from './bodies.ts';
import {
  type Observation,
  type RelativeEvent,
  rapidityFactor,
  relativeTo,
  sampleWindow,
  trailingPoint,
  type WorldTubeSection,
} from './observation.ts';
import { BlendStore } from './pointSamples/blendStore.ts';
import type { PointStore } from './pointSamples/pointStore.ts';

/** Longest window of samples that a vertex searches. */
const MAX_SAMPLES = 4096;

/** The tables that shaders read objects' motions from, written by `ObjectTableWriter`; `points`: samples of deforming meshes, by object id. */
export interface ObjectTables {
  readonly objects: FloatTable;
  readonly samples: FloatTable;
  readonly points: ReadonlyMap<number, PointStore | BlendStore>;
}

/** An object at the event of its anchor, whose rows are to be written. */
export interface ObjectRow {
  readonly body: Body;
  readonly line: WorldLine;
  readonly section: WorldTubeSection;
  readonly anchor: RelativeEvent;
  /** From the centre to the point whose event the anchor is. */
  readonly anchorPoint: Vec3;
  readonly observation: Observation;
  /** Index of the object's first float in the object table. */
  readonly at: number;
}

/** What `write` returns: the number of sample texels used so far, and whether all needed samples are on the GPU. */
interface Written {
  readonly used: number;
  readonly complete: boolean;
}

/** How one kind of motion is written to the object and sample tables. */
interface ObjectRows<M extends Motion> {
  /** The point of the bounding sphere, relative to the centre, that comes out first from behind a horizon; undefined if all points come out together. */
  trailingPoint(motion: M, body: Body): Vec3 | undefined;
  /** `used`: texels of the sample table that are in use already. */
  write(motion: M, row: ObjectRow, tables: ObjectTables, used: number): Written;
}

const noTrailingPoint = (): undefined => undefined;

const isRestAuthored = ({ object }: Body): number => (object.authoredIn === 'rest' ? 1 : 0);

/** The samples that are needed, [first, first + count), and their times after the anchor [m of light]. */
function windowOf(line: SampledLine, { section, observation, anchor }: ObjectRow, max: number) {
  const [first, count] = sampleWindow(line, section, observation, max);
  const after = (k: number) => observation.c * (line.times[k] - observation.t) - anchor.ahead;
  return { first, count, after };
}

const OBJECT_ROWS: { readonly [K in Motion['kind']]: ObjectRows<Extract<Motion, { readonly kind: K }>> } = {
  static: {
    trailingPoint: noTrailingPoint,
    write: (_motion, _row, _tables, used) => ({ used, complete: true }),
  },
  uniform: {
    trailingPoint: noTrailingPoint,
    write: (motion, { body, observation, at }, { objects }, used) => {
      const v = scale(motion.velocity, 1 / observation.c);
      objects.values.set([...v, oneMinusBetaSquared(v)], at + 4);
      objects.values.set([isRestAuthored(body), 0, 0, 0], at + 12);
      return { used, complete: true };
    },
  },
  hyperbolic: {
    // The points of a Born-rigid body have one horizon.
    trailingPoint: ({ properAcceleration }, { object, radius }) =>
      object.authoredIn === 'rest' ? undefined : trailingPoint(properAcceleration, radius),
    write: (motion, { body, anchor, anchorPoint, observation, at }, { objects }, used) => {
      const { c } = observation;
      const { properAcceleration: a, t0 } = hyperbolicLineOfCenter(body, motion, c, anchorPoint);
      const shift = -length(anchorPoint);
      objects.values.set([...normalize(a, [1, 0, 0]), length(a) / (c * c)], at + 4);
      const factor = rapidityFactor(a, t0, anchor.ahead, observation);
      objects.values.set([factor, isRestAuthored(body), shift, 0], at + 12);
      return { used, complete: true };
    },
  },
  sampled: {
    trailingPoint: noTrailingPoint,
    write: ({ poses }, row, { objects, samples }, used) => {
      const line = asPolyline(row.line);
      if (!line) return { used, complete: true };
      const { first, count, after } = windowOf(line, row, MAX_SAMPLES);
      objects.values.set([used, count], row.at + 12);
      samples.reserve(used + 2 * count);
      let next = used;
      for (let k = first; k < first + count; k++) {
        const place = relativeTo(samplePosition(line, k), row.observation, row.anchor);
        samples.values.set([...place, after(k)], 4 * next++);
        samples.values.set(samplePose(poses, k).orientation, 4 * next++);
      }
      return { used: next, complete: true };
    },
  },
  'sampled-points': {
    trailingPoint: noTrailingPoint,
    write: (motion, row, tables, used) => {
      const { objects, samples, points } = tables;
      const { body, observation, anchor, at } = row;
      const line = asPolyline(row.line);
      const store = points.get(body.id);
      if (!line || !store) return { used, complete: true };
      if (store instanceof BlendStore) return writeBlended(motion, line, store, row, tables, used);
      const { first, count, after } = windowOf(line, row, Math.min(MAX_SAMPLES, store.capacity));
      objects.values.set([used, count], at + 12);
      const complete = store.ensureResident(first, count);
      samples.reserve(used + count);
      objects.values.set([...relativeTo(motion.origin, observation, anchor), store.stride], at + 4);
      const bendOf = isCubic(motion)
        ? (k: number) => (k + 1 < line.times.length ? bendFactor(motion, k, observation.c) : 0)
        : () => 0;
      objects.values[at + 14] = 1 / observation.c;
      let next = used;
      for (let k = first; k < first + count; k++)
        samples.values.set([store.slot(k), bendOf(k), 0, after(k)], 4 * next++);
      return { used: next, complete };
    },
  },
};

/** The joints of the samples that are needed, behind their times. */
function writeBlended(
  { origin }: SampledPointsMotion,
  line: SampledLine,
  store: BlendStore,
  row: ObjectRow,
  { objects, samples, points }: ObjectTables,
  used: number,
): Written {
  const { observation, anchor, at } = row;
  const { first, count, after } = windowOf(line, row, Math.min(MAX_SAMPLES, store.capacity(points.size)));
  objects.values.set([...relativeTo(origin, observation, anchor), store.vertices], at + 4);
  objects.values.set([used, count, 1 / observation.c, store.firstShape], at + 12);
  let next = used + count;
  for (let i = 0; i < count; i++) {
    const written = store.writeSample(first + i, samples, next);
    samples.values.set([next, written.shapes, 0, after(first + i)], 4 * (used + i));
    next = written.next;
  }
  return { used: next, complete: true };
}

/** The rows of a motion's kind. */
export const objectRows = (motion: Motion): ObjectRows<Motion> => OBJECT_ROWS[motion.kind];
