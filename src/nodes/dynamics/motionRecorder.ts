import { type EarlyStop, NO_STEPS, type RunOptions, type RunTally, type SimulationFrame } from '../../dynamics/run.ts';
import { type RunRecord, RunRecorder } from '../../dynamics/runRecord.ts';
import { type State, velocities } from '../../dynamics/system.ts';
import { fromAxisAngle, rotate, shortestRotation } from '../../math/quat.ts';
import { add, length, normalize, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { type CubicPiece, cubicAt, subluminalBend, withBend } from '../../physics/worldLines/cubicPiece.ts';
import { perpendicularTo } from '../../scene/compose/arrange.ts';
import { mergeScenes } from '../../scene/compose/mergeScenes.ts';
import { FOREVER } from '../../scene/defaults.ts';
import { deformedNormals, smoothingGroups } from '../../scene/mesh/normals.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { withoutQuadric } from '../../scene/mesh/quadric.ts';
import { MAX_CONTROL_SPEED } from '../../scene/motion/cubicPoints.ts';
import type { Diagnostic, Mesh, Motion, Scene, SceneObject } from '../../scene/types.ts';
import { initialPose } from './objects.ts';
import type { BodyGroup, SimulatedBody } from './setup.ts';

/** The recorded part of a run as plain data, from which recording can continue. */
export interface RecordedMotion {
  /** Records of the frames, without their states. */
  readonly rows: readonly RecordedRow[];
  /** State at the last frame, bit-exact. */
  readonly last: State;
  /** Per body, the samples of all frames. */
  readonly tracks: readonly MotionTrack[];
}
type RecordedRow = Omit<SimulationFrame, 'state'>;

/**
 * For a deforming body its vertices relative to its origin; for a sphere its center alone, relative to its initial
 * position.
 */
interface MotionTrack {
  readonly points: Float32Array[];
  /** [m/s] */
  readonly velocities: Float32Array[];
  /** Absent for spheres. */
  readonly normals: Float32Array[];
}

/** Line segments that approximate the cubic between two frames of a sphere. */
const SEGMENTS_PER_FRAME = 4;
/** Sides of a rod's tube. */
const ROD_SIDES = 8;

/** Records the frames of a run and turns them into motions of the scene's objects. */
export class MotionRecorder {
  private readonly options: RunOptions;
  private readonly rows: RecordedRow[];
  private readonly tracks: readonly MotionTrack[];
  private last: State;
  private readonly bodyGroups: readonly BodyGroup[];
  private readonly bodyRecorders: readonly BodyRecorder[];
  private readonly books: RunRecorder;
  private readonly v: Float64Array;

  /** `before`: a recording to continue. */
  constructor(options: RunOptions, bodyGroups: readonly BodyGroup[], before?: RecordedMotion) {
    this.options = options;
    this.bodyGroups = bodyGroups;
    this.v = new Float64Array(options.start.x.length);
    this.books = new RunRecorder(options);
    this.bodyRecorders = bodyGroups.flatMap(({ bodies }) => bodies.map((body) => bodyRecorder(body, options.start.x)));
    this.rows = before?.rows.slice() ?? [];
    this.last = before?.last ?? options.start;
    this.tracks =
      before?.tracks.map(copyTrack) ?? this.bodyRecorders.map(() => ({ points: [], velocities: [], normals: [] }));
    this.rows.forEach((row, k) => void this.books.addFrame({ ...row, state: { ...this.last, t: this.timeOf(k) } }));
  }

  /** Number of recorded frames. */
  get length(): number {
    return this.rows.length;
  }

  /** State of the last recorded frame, or the initial one, and the tally so far. */
  get latest(): { readonly state: State; readonly tally: RunTally } {
    return { state: this.last, tally: this.rows.at(-1) ?? NO_STEPS };
  }

  /** The recording so far. */
  recordedMotion = (): RecordedMotion => ({
    rows: this.rows.slice(),
    last: this.last,
    tracks: this.tracks.map(copyTrack),
  });

  /** World time of frame k [s], computed from the frame rate, whose few digits give short numbers in files. */
  timeOf = (k: number): number => this.options.start.t + k / this.rate;

  /** Frames per second. */
  private get rate(): number {
    return Number((1 / this.options.every).toPrecision(12));
  }

  addFrame({ state: { x, p }, ...row }: SimulationFrame): void {
    // A resumed run accumulates time from another start and would differ in the last digit.
    const state = { t: this.timeOf(this.length), x, p };
    this.books.addFrame({ ...row, state });
    velocities(this.options.system, state.p, this.v);
    this.rows.push(row);
    this.last = state;
    this.bodyRecorders.forEach((recorder, i) => void recorder.addSample(this.tracks[i], state.x, this.v));
  }

  record = (stop?: EarlyStop): RunRecord => this.books.record(stop);

  /** All objects with their motion so far; `notes`: diagnostics to add; `end`: the state after the last frame in which the run ended early. */
  scene(notes: readonly Diagnostic[], end?: State): Scene {
    const until = end && end.t > this.timeOf(this.length - 1) ? end : undefined;
    const tracks = until ? this.tracksUntil(until) : this.tracks;
    const times = Float64Array.from([...this.rows.map((_, k) => this.timeOf(k)), ...(until ? [until.t] : [])]);
    let i = 0;
    const parts = this.bodyGroups.map(({ scene, bodies }): Scene => {
      const objects = bodies.map((): SceneObject => {
        const at = i++;
        return this.bodyRecorders[at].toObject(tracks[at], times, this.options.system.c);
      });
      return { ...scene, objects };
    });
    const merged = mergeScenes(parts);
    return {
      ...merged,
      startTime: this.timeOf(0),
      endTime: Math.max(this.timeOf(Math.max(1, this.length - 1)), until?.t ?? 0),
      timeCodesPerSecond: this.rate,
      diagnostics: [...merged.diagnostics, ...notes],
    };
  }

  /** The tracks with one more sample. */
  private tracksUntil({ x, p }: State): readonly MotionTrack[] {
    const v = new Float64Array(x.length);
    velocities(this.options.system, p, v);
    const tracks = this.tracks.map(copyTrack);
    this.bodyRecorders.forEach((recorder, i) => void recorder.addSample(tracks[i], x, v));
    return tracks;
  }
}

const copyTrack = ({ points, velocities, normals }: MotionTrack): MotionTrack => ({
  points: points.slice(),
  velocities: velocities.slice(),
  normals: normals.slice(),
});

/** How a body is recorded. */
interface BodyRecorder {
  addSample(track: MotionTrack, x: Float64Array, v: Float64Array): void;
  toObject(track: MotionTrack, times: Float64Array, c: number): SceneObject;
}

function bodyRecorder(body: SimulatedBody, start: Float64Array): BodyRecorder {
  switch (body.kind) {
    case 'fixed':
      return { addSample: () => {}, toObject: () => body.object };
    case 'ball':
      return sphereRecorder(body, start);
    case 'net':
      return meshRecorder(body, start);
    case 'rod':
      return rodRecorder(body, start);
  }
}

/** Repeats a single sample, so that the body rests. */
const atLeastTwo = <T>(all: readonly T[]): readonly T[] => (all.length === 1 ? [all[0], all[0]] : all.slice());
const withRestSample = (times: Float64Array): Float64Array =>
  times.length === 1 ? Float64Array.of(times[0], times[0] + 1) : times;

function meshRecorder(
  { object, pointOfVertex }: Extract<SimulatedBody, { kind: 'net' }>,
  start: Float64Array,
): BodyRecorder {
  const origin = pointAt(start, pointOfVertex[0] ?? 0);
  const { mesh } = object;
  const groups = smoothingGroups(mesh);
  const gather = (values: Float64Array, from: Vec3): Float32Array => {
    const out = new Float32Array(3 * pointOfVertex.length);
    for (let i = 0; i < pointOfVertex.length; i++)
      for (let k = 0; k < 3; k++) out[3 * i + k] = values[3 * pointOfVertex[i] + k] - from[k];
    return out;
  };
  return {
    addSample({ points, velocities, normals }, x, v) {
      const at = gather(x, origin);
      points.push(at);
      velocities.push(gather(v, ZERO));
      normals.push(deformedNormals(at, mesh.indices, groups));
    },
    toObject: (track, times) => ({ ...object, ...deformingMotion(mesh, origin, track, times) }),
  };
}

function deformingMotion(mesh: Mesh, origin: Vec3, { points, velocities, normals }: MotionTrack, times: Float64Array) {
  const motion: Motion = {
    kind: 'sampled-points',
    times: withRestSample(times),
    origin,
    points: atLeastTwo(points),
    velocities: times.length === 1 ? [0, 1].map(() => new Float32Array(points[0].length)) : velocities.slice(),
    normals: atLeastTwo(normals),
  };
  return { mesh: { ...withoutQuadric(mesh), positions: points[0], normals: normals[0] }, motion };
}

/** A rigid sphere is translated only. */
function sphereRecorder(
  { object, point }: Extract<SimulatedBody, { kind: 'ball' }>,
  start: Float64Array,
): BodyRecorder {
  const pose = initialPose(object, Number.POSITIVE_INFINITY);
  const first = pointAt(start, point);
  return {
    addSample({ points, velocities }, x, v) {
      points.push(Float32Array.from(sub(pointAt(x, point), first)));
      velocities.push(Float32Array.from(pointAt(v, point)));
    },
    toObject(track, times, c) {
      const trajectory = sampleTrajectory(track, withRestSample(times), c);
      const poses = new Float64Array(7 * trajectory.length);
      trajectory.forEach(({ x }, k) => void poses.set([...add(pose.position, x), ...pose.orientation], 7 * k));
      return { ...object, motion: { kind: 'sampled', times: Float64Array.from(trajectory, ({ t }) => t), poses } };
    },
  };
}

/** Position of a sphere at frames and between them. */
function sampleTrajectory(
  { points, velocities }: MotionTrack,
  times: Float64Array,
  c: number,
): { readonly t: number; readonly x: Vec3 }[] {
  const trajectory = [{ t: times[0], x: pointAt(points[0], 0) }];
  for (let k = 0; k + 1 < times.length; k++) {
    const [a, b] = [points[k], points[k + 1] ?? points[k]].map((each) => pointAt(each, 0));
    const [va, vb] = [velocities[k], velocities[k + 1] ?? velocities[k]].map((each) => pointAt(each, 0));
    const span = times[k + 1] - times[k];
    const piece: CubicPiece = points[k + 1] ? { a, b, va, vb, span } : { a, b, va: ZERO, vb: ZERO, span };
    const slow = withBend(piece, Number.isFinite(c) ? subluminalBend(piece, MAX_CONTROL_SPEED * c) : 1);
    for (let j = 1; j <= SEGMENTS_PER_FRAME; j++) {
      const s = (span * j) / SEGMENTS_PER_FRAME;
      trajectory.push(
        j === SEGMENTS_PER_FRAME ? { t: times[k + 1], x: b } : { t: times[k] + s, x: cubicAt(slow, s).x },
      );
    }
  }
  return trajectory;
}

/** A thin tube between two points. Its vertices move with the ends. */
function rodRecorder({ of, ends, width }: Extract<SimulatedBody, { kind: 'rod' }>, start: Float64Array): BodyRecorder {
  const [from, to] = ends.map((end) => pointAt(start, end));
  const rest = normalize(sub(to, from), [0, 1, 0]);
  const round = Array.from({ length: ROD_SIDES }, (_, k) =>
    scale(rotate(fromAxisAngle(rest, (2 * Math.PI * k) / ROD_SIDES), perpendicularTo(rest)), width / 2),
  );
  const mesh = tubeMesh(of.mesh.groups[0]?.material ?? 0);
  const path = `${of.path}/Rod`;
  return {
    addSample({ points, velocities, normals }, x, v) {
      const trajectory = sub(pointAt(x, ends[1]), pointAt(x, ends[0]));
      const turn = shortestRotation(rest, length(trajectory) > 0 ? normalize(trajectory) : rest);
      const out = round.map((each) => rotate(turn, each));
      const at = (values: Float64Array, offsets: readonly Vec3[]): Float32Array =>
        Float32Array.from(ends.flatMap((end) => offsets.flatMap((offset) => [...add(pointAt(values, end), offset)])));
      points.push(
        at(
          x,
          out.map((offset) => sub(offset, from)),
        ),
      );
      velocities.push(
        at(
          v,
          out.map(() => ZERO),
        ),
      );
      const n = out.map((offset) => normalize(offset));
      normals.push(Float32Array.from([...n, ...n].flat()));
    },
    toObject: (track, times) => ({
      ...{ path, lifetime: FOREVER, authoredIn: 'world' },
      ...deformingMotion(mesh, from, track, times),
    }),
  };
}

/** Topology of a tube with two rings of vertices; positions are set later. */
function tubeMesh(material: number): Mesh {
  const indices = Uint32Array.from(
    Array.from({ length: ROD_SIDES }, (_, k) => {
      const next = (k + 1) % ROD_SIDES;
      return [k, next, ROD_SIDES + next, k, ROD_SIDES + next, ROD_SIDES + k];
    }).flat(),
  );
  const nowhere = new Float32Array(6 * ROD_SIDES);
  return {
    positions: nowhere,
    normals: nowhere,
    uvs: new Float32Array(4 * ROD_SIDES),
    indices,
    groups: [{ start: 0, count: indices.length, material }],
    doubleSided: false,
  };
}
