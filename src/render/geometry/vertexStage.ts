import {
  abs,
  bool,
  cameraProjectionMatrix,
  cameraViewMatrix,
  clamp,
  cross,
  Fn,
  float,
  If,
  int,
  inverseSqrt,
  max,
  mix,
  select,
  varyingProperty,
  vec3,
  vec4,
} from 'three/tsl';
import type { PlacementName } from '../../physics/optics/placement.ts';
import type { HypersurfaceName } from '../../physics/worldLines/hypersurface.ts';
import type { Solver } from '../../scene/settings/settings.ts';
import type { Motion } from '../../scene/types.ts';
import { cubicEmission } from '../../shaders/emission/cubicEmission.ts';
import { hyperbolicEmission } from '../../shaders/emission/hyperbolicEmission.ts';
import { newtonEmission } from '../../shaders/emission/newtonEmission.ts';
import { polylineEmission } from '../../shaders/emission/polylineEmission.ts';
import { staticEmission } from '../../shaders/emission/staticEmission.ts';
import { uniformEmission } from '../../shaders/emission/uniformEmission.ts';
import { apparentPosition } from '../../shaders/kinematics/apparentPosition.ts';
import { simultaneousPosition } from '../../shaders/kinematics/simultaneousPosition.ts';
import { cubicShallow } from '../../shaders/shallowCone/cubicShallow.ts';
import { hyperbolicShallow } from '../../shaders/shallowCone/hyperbolicShallow.ts';
import { polylineShallow } from '../../shaders/shallowCone/polylineShallow.ts';
import type { ShallowObserver } from '../../shaders/shallowCone/shallowObserver.ts';
import { shallowPosition } from '../../shaders/shallowCone/shallowPosition.ts';
import { uniformShallow } from '../../shaders/shallowCone/uniformShallow.ts';
import { cubicSlice } from '../../shaders/simultaneity/cubicSlice.ts';
import { hyperbolicSlice } from '../../shaders/simultaneity/hyperbolicSlice.ts';
import { newtonSlice } from '../../shaders/simultaneity/newtonSlice.ts';
import { polylineSlice } from '../../shaders/simultaneity/polylineSlice.ts';
import { uniformSlice } from '../../shaders/simultaneity/uniformSlice.ts';
import type { Bool, Float, Vec3, Vec4, VertexEvent, WorldLineAt } from '../../shaders/types.ts';
import { cubicPlace } from '../../shaders/worldLines/cubicPlace.ts';
import { hyperbolicPlace } from '../../shaders/worldLines/hyperbolicPlace.ts';
import { polylinePlace } from '../../shaders/worldLines/polylinePlace.ts';
import { uniformPlace } from '../../shaders/worldLines/uniformPlace.ts';
import type { FloatTable } from '../gpu/floatTable.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { blendedSamples } from './blendedSamples.ts';
import { OBJECT_TEXELS } from './objectTables.ts';
import { BlendStore } from './pointSamples/blendStore.ts';
import type { PointStore } from './pointSamples/pointStore.ts';
import type { VertexInput } from './vertexInput.ts';
import { pieceAt, pointSamples, poseSamples, type VertexSamples } from './vertexSamples.ts';

/** How a vertex finds its event, and where it is drawn; a shader is compiled for each pair that is used. */
export interface SpacetimeProjection {
  readonly event: 'emission' | 'newtonEmission' | 'slice' | 'newtonSlice' | 'shallow' | 'now';
  readonly place: PlacementName;
}

/** The solvers of events on each hypersurface. Newton's, for comparison, is for the two that its formulas are known for. */
const VERTEX_SOLVERS: Readonly<Record<HypersurfaceName, Readonly<Record<Solver, SpacetimeProjection['event']>>>> = {
  'past-light-cone': { exact: 'emission', newton: 'newtonEmission' },
  slice: { exact: 'slice', newton: 'newtonSlice' },
  now: { exact: 'now', newton: 'now' },
  'shallow-cone': { exact: 'shallow', newton: 'shallow' },
};

export const vertexSolverOf = (surface: HypersurfaceName, solver: Solver): SpacetimeProjection['event'] =>
  VERTEX_SOLVERS[surface][solver];

/** Whether vertices are searched for from the observer's own time on. */
export const startsAtNow = ({ event }: Pick<SpacetimeProjection, 'event'>): boolean =>
  event === 'newtonEmission' || event === 'newtonSlice';

/** Where shaders read the motions of a batch's bodies. */
export interface MotionSources {
  readonly kind: Motion['kind'];
  readonly objects: FloatTable;
  readonly samples: FloatTable;
  readonly points?: PointStore | BlendStore;
  /** Set for batches with instancing, whose mesh is in its own axes. */
  readonly instances?: FloatTable;
  readonly uniforms: FrameUniforms;
}

/** The part of the sources that determines a vertex's event. */
export interface EventSources extends Omit<MotionSources, 'uniforms'> {
  readonly uniforms: ShallowObserver & Pick<FrameUniforms, 'iterations' | 'damping'>;
}

/** An observer and the camera in his space. */
export interface CameraObserver extends ShallowObserver {
  /** From him to the camera [m]. */
  readonly vantage: Vec3;
}

export interface VertexSources extends MotionSources {
  /** Reads the vertex, inside the vertex stage's Fn. */
  readonly vertex: () => VertexInput;
}

/** Observer → event [m] and c(t − t_o) [m of light]. */
export const vEvent = varyingProperty('vec4', 'v_event');
/** Camera position: where the event is drawn, relative to the camera, on the world axes carried by the boost [m]. */
export const vCameraPosition = varyingProperty('vec3', 'v_shown');
/** (v, 1 − v²) of the surface in the world, in units of c. */
export const vMotion = varyingProperty('vec4', 'v_motion');
/** Normal in the surface's rest frame, and 1 where all vertices of the triangle exist (`triangleExists`). */
export const vNormal = varyingProperty('vec4', 'v_normal');
/** So large that no interpolation makes it 1 again: in perspective, a vertex that is a million times as far away as the others has a millionth of their weight. */
const NONEXISTENT = -1e20;
/** Whether the vertices of a fragment's triangle exist. */
export const triangleExists = (): Bool => abs(vNormal.w.sub(1)).lessThan(1e-4);
/** Time since birth and until death [m of light], object id, material. */
export const vLife = varyingProperty('vec4', 'v_life');
export const vUv = varyingProperty('vec2', 'v_uv');
/** Linear RGB of the vertex, if the mesh has colours. */
export const vColor = varyingProperty('vec3', 'v_color');

interface SolvedVertex extends VertexEvent {
  /** In the rest frame, on the world's axes; of any length. */
  readonly normal: Vec3;
  readonly exists: Bool;
}

/** The texels of an object (objectTables.ts) and one of its vertices. */
interface SolverInputs {
  readonly sources: EventSources;
  readonly anchor: Vec4;
  readonly motion: Vec4;
  readonly extra: Vec4;
  readonly vertex: VertexInput;
}

const objectTexel =
  ({ objects }: EventSources, object: Float) =>
  (k: number): Vec4 =>
    objects.texel(int(object).mul(int(OBJECT_TEXELS)).add(int(k))).toVar();

/** Clip-space position of a vertex; assigns the varyings above. */
export function vertexStage(sources: VertexSources, projection: SpacetimeProjection): Vec4 {
  return Fn(() => {
    const input = sources.vertex();
    const texel = objectTexel(sources, input.object);
    const anchor = texel(0);
    // The vertices of an object that cannot be seen all fall on one point outside the picture.
    const clip = vec4(2, 2, 2, 1).toVar();
    If(anchor.w.greaterThanEqual(0), () => {
      const vertex = solveVertex(
        { sources, anchor, motion: texel(1), extra: texel(3), vertex: rotatedVertex(sources, input, texel) },
        projection,
      );
      const lifetime = texel(2);
      const dx = vertex.dx.toVar();
      const s = vertex.s.toVar();
      vEvent.assign(vec4(dx, s.sub(lifetime.z)));
      vMotion.assign(vertex.velocity);
      vNormal.assign(vec4(vertex.normal, select(vertex.exists, float(1), float(NONEXISTENT))));
      vLife.assign(vec4(s.sub(lifetime.x), lifetime.y.sub(s), lifetime.w, input.material));
      vUv.assign(input.uv);
      if (input.color) vColor.assign(input.color);
      // Vertices behind a horizon are drawn on its edge: far from there they would make splinters, which software GPUs draw wrong.
      const position = cameraPosition(dx, projection.place, sources.uniforms).toVar();
      vCameraPosition.assign(position);
      clip.assign(cameraProjectionMatrix.mul(cameraViewMatrix.mul(vec4(position, 1))));
    });
    return clip;
  })();
}

/** The camera position of a vertex [m], and whether it exists. */
export function vertexCameraPosition(
  sources: MotionSources,
  projection: SpacetimeProjection,
  vertex: VertexInput,
): { position: Vec3; exists: Bool } {
  const { dx, exists } = vertexEvent(sources, projection, vertex);
  return { position: cameraPosition(dx, projection.place, sources.uniforms), exists };
}

/** The event of a vertex: relative to the observer [m], and its time after that of its object's anchor [m of light]. */
export function vertexEvent(
  sources: EventSources,
  { event }: Pick<SpacetimeProjection, 'event'>,
  vertex: VertexInput,
): Pick<SolvedVertex, 'dx' | 's' | 'exists'> {
  const texel = objectTexel(sources, vertex.object);
  const anchor = texel(0);
  const rotatedInput = rotatedVertex(sources, vertex, texel);
  return solveVertex({ sources, anchor, motion: texel(1), extra: texel(3), vertex: rotatedInput }, { event });
}

/** A vertex of a mesh with instancing, rotated as its body is; samples are rotated one by one. */
function rotatedVertex(
  { kind, instances }: EventSources,
  vertex: VertexInput,
  texel: (k: number) => Vec4,
): VertexInput {
  if (!instances || !VERTEX_MOTIONS[kind].turnsInstances) return vertex;
  const orientation = texel(4);
  return {
    ...vertex,
    offset: rotated(orientation, vertex.offset),
    get normal() {
      return rotated(orientation, vertex.normal);
    },
  };
}

/** Rotates v by a unit quaternion. */
function rotated(q: Vec4, v: Vec3): Vec3 {
  const t = cross(q.xyz, v).mul(2).toVar();
  return v.add(t.mul(q.w)).add(cross(q.xyz, t)).toVar();
}

/** The GPU's twins of `PLACEMENTS` (src/physics/optics/placement.ts). */
const PLACES: Readonly<Record<PlacementName, (dx: Vec3, observer: ShallowObserver) => Vec3>> = {
  apparent: (dx, { u, gamma }) => apparentPosition(dx, u, gamma),
  contracted: (dx, { u, gamma }) => simultaneousPosition(dx, u, gamma),
  shallow: shallowPosition,
  plain: (dx) => dx,
};

/** Where an event at Δx is drawn, relative to the observer, on the world axes carried by the boost [m]. */
export const observerPosition = (dx: Vec3, placement: SpacetimeProjection['place'], observer: ShallowObserver): Vec3 =>
  PLACES[placement](dx, observer);

/** The same relative to the camera, which may have stepped aside. */
export const cameraPosition = (dx: Vec3, placement: SpacetimeProjection['place'], observer: CameraObserver): Vec3 =>
  observerPosition(dx, placement, observer).sub(observer.vantage);

/** How a vertex finds its event, by the kind of its body's motion. */
interface VertexMotion {
  /** Whether bodies that share a mesh, which then is in its own axes, have one orientation each. */
  readonly turnsInstances: boolean;
  readonly solve: (inputs: SolverInputs, event: SpacetimeProjection['event']) => SolvedVertex;
}

const VERTEX_MOTIONS: { readonly [K in Motion['kind']]: VertexMotion } = {
  static: { turnsInstances: true, solve: staticVertex },
  uniform: { turnsInstances: true, solve: uniformVertex },
  hyperbolic: { turnsInstances: false, solve: hyperbolicVertex },
  sampled: { turnsInstances: false, solve: sampledVertex },
  'sampled-points': { turnsInstances: false, solve: sampledVertex },
};

const solveVertex = (inputs: SolverInputs, { event }: Pick<SpacetimeProjection, 'event'>): SolvedVertex =>
  VERTEX_MOTIONS[inputs.sources.kind].solve(inputs, event);

/** What is asked of a vertex's world line, which is built lazily: a shader takes one of these. */
interface WorldLineSolvers<Solved extends VertexEvent> {
  readonly place: () => WorldLineAt;
  /** The event on the past light cone. */
  readonly emission: () => Solved;
  /** The event on the slice of simultaneity of the frame with γβ = u. */
  readonly slice: (u: Vec3, gamma: Float) => Solved;
  /** The event on the cone ct′ = −λr′. */
  readonly shallow: (observer: ShallowObserver) => Solved;
}

type EventSolver = <Solved extends VertexEvent>(
  line: WorldLineSolvers<Solved>,
  anchor: Vec4,
  uniforms: EventSources['uniforms'],
) => Solved | VertexEvent;

/** By what a vertex's event is found on; the GPU's twins of `Hypersurface` (src/physics/worldLines/hypersurface.ts). */
const EVENT_SOLVERS: Readonly<Record<SpacetimeProjection['event'], EventSolver>> = {
  newtonEmission: ({ place }, anchor, { iterations, damping }) => newtonEmission(anchor, place(), iterations, damping),
  newtonSlice: ({ place }, anchor, { u, gamma, iterations, damping }) =>
    newtonSlice(anchor, place(), u, gamma, iterations, damping),
  emission: ({ emission }) => emission(),
  slice: ({ slice }, _, { u, gamma }) => slice(u, gamma),
  shallow: ({ shallow }, _, observer) => shallow(observer),
  now: ({ slice }) => slice(vec3(0), float(1)),
};

function staticVertex(inputs: SolverInputs, event: SpacetimeProjection['event']): SolvedVertex {
  const { anchor, vertex } = inputs;
  const solved = linear(inputs, vec4(0, 0, 0, 1), vertex.offset, event, () => staticEmission(anchor, vertex.offset));
  return { ...solved, normal: vertex.normal, exists: bool(true) };
}

const linear = (
  { anchor, sources }: SolverInputs,
  velocity: Vec4,
  offset: Vec3,
  event: SpacetimeProjection['event'],
  emission: () => VertexEvent,
): VertexEvent =>
  EVENT_SOLVERS[event](
    {
      place: () => uniformPlace(velocity, offset),
      emission,
      slice: (u, gamma) => uniformSlice(anchor, velocity, offset, u, gamma),
      shallow: (observer) => uniformShallow(anchor, velocity, offset, observer),
    },
    anchor,
    sources.uniforms,
  );

function uniformVertex(inputs: SolverInputs, event: SpacetimeProjection['event']): SolvedVertex {
  const { anchor, motion, extra } = inputs;
  const { offset, normal } = inputs.vertex;
  const bornRigid = extra.x.greaterThan(0.5);
  const contracted = select(bornRigid, contractAlongMotion(offset, motion), offset).toVar();
  const restNormal = select(bornRigid, normal, contractAlongMotion(normal, motion));
  const solved = linear(inputs, motion, contracted, event, () => uniformEmission(anchor, motion, contracted));
  return { ...solved, normal: restNormal, exists: bool(true) };
}

function hyperbolicVertex(inputs: SolverInputs, event: SpacetimeProjection['event']): SolvedVertex {
  const { anchor, motion, extra, sources } = inputs;
  const { normal } = inputs.vertex;
  const offset = inputs.vertex.offset.sub(motion.xyz.mul(extra.z)).toVar();
  const hyperbola = [motion, extra.x, extra.y, offset] as const;
  const solvers = {
    place: () => hyperbolicPlace(...hyperbola),
    emission: () => hyperbolicEmission(anchor, ...hyperbola),
    slice: (u: Vec3, gamma: Float) => hyperbolicSlice(anchor, ...hyperbola, u, gamma),
    shallow: (observer: ShallowObserver) => hyperbolicShallow(anchor, ...hyperbola, observer),
  };
  const solved = EVENT_SOLVERS[event](solvers, anchor, sources.uniforms);
  const velocity = solved.velocity.toVar();
  return {
    exists: bool(true),
    ...solved,
    velocity,
    normal: select(extra.y.greaterThan(0.5), normal, contractAlongMotion(normal, velocity)),
  };
}

function sampledVertex(inputs: SolverInputs, event: SpacetimeProjection['event']): SolvedVertex {
  const { anchor, sources } = inputs;
  const samples = samplesOf(inputs);
  const solved = sampled(anchor, samples, event, sources.uniforms);
  const [s, velocity] = [solved.s.toVar(), solved.velocity.toVar()];
  const { index, fraction } = pieceAt(samples, s);
  const normal = mix(samples.normal(index), samples.normal(index.add(int(1))), fraction).toVar();
  return { dx: solved.dx, s, velocity, normal: contractAlongMotion(normal, velocity), exists: bool(true) };
}

function samplesOf({ sources, motion, extra, vertex }: SolverInputs): VertexSamples {
  const first = int(extra.x).toVar();
  const count = int(extra.y).toVar();
  const window = { first, count, perC: extra.z };
  const { points, samples } = sources;
  if (points instanceof BlendStore) {
    const { table, hasShapes } = points;
    const source = { table, hasShapes, vertices: int(motion.w).toVar(), firstShape: int(extra.w).toVar() };
    return blendedSamples(samples, source, vertex.ofVertices, window, motion);
  }
  if (points) return pointSamples(samples, points, vertex.ofVertices, window, motion);
  return poseSamples(sources.samples, first, count, vertex.offset, vertex.normal);
}

function sampled(
  anchor: Vec4,
  { at, velocities, count }: VertexSamples,
  event: SpacetimeProjection['event'],
  uniforms: EventSources['uniforms'],
): VertexEvent {
  const solvers = velocities
    ? {
        place: () => cubicPlace(at, velocities, count),
        emission: () => cubicEmission(anchor, at, velocities, count),
        slice: (u: Vec3, gamma: Float) => cubicSlice(anchor, at, velocities, count, u, gamma),
        shallow: (observer: ShallowObserver) => cubicShallow(anchor, at, velocities, count, observer),
      }
    : {
        place: () => polylinePlace(at, count),
        emission: () => polylineEmission(anchor, at, count),
        slice: (u: Vec3, gamma: Float) => polylineSlice(anchor, at, count, u, gamma),
        shallow: (observer: ShallowObserver) => polylineShallow(anchor, at, count, observer),
      };
  return EVENT_SOLVERS[event](solvers, anchor, uniforms);
}

/**
 * x∥ → x∥/γ for the velocity (v, 1 − v²): maps an offset of the rest frame to the world's slice, and a normal in the world's slice to the rest frame (the
 * surface is a plane of events, whose normal has no time part in the rest frame; docs/physics.md §6.3).
 */
function contractAlongMotion(x: Vec3, velocity: Vec4): Vec3 {
  const gamma = inverseSqrt(clamp(velocity.w, 1e-20, 1)).toVar();
  return simultaneousPosition(x, velocity.xyz.mul(gamma), max(gamma, 1));
}
