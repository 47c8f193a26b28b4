import { invert, type Mat3, transform } from '../../math/mat3.ts';
import { add, addScaled, cross, dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { positionAt, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import { pointAt } from '../mesh/polygons.ts';
import { deforms, originWorldLine, pointSamples, vertexPositions, vertexWorldLine } from '../motion/motion.ts';
import { isStreamed } from '../streaming/samplePoints.ts';
import type { HyperbolicMotion, SceneObject } from '../types.ts';

/** An event on the surface of an object. */
export interface SurfaceEvent {
  /** World time [s]. */
  readonly time: number;
  /** World frame [m]. */
  readonly position: Vec3;
  /** Of the surface, world frame, units of c. */
  readonly velocity: Vec3;
}

/** The origin of a frame, and the tips of its axes. */
const AXES = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);

/**
 * The world line of the point of an object's surface that is at an event. The event may lie a little beside the surface. c [m/s].
 * undefined for meshes whose samples stay in their files.
 *
 * In rigid motion, points of the world and of the body are related by an affine map at each time; in a deforming mesh the point keeps its place in the
 * triangle nearest to the event. A Born-rigid body is the exception: its points keep their distance to the horizon (docs/physics.md §4.5).
 * @example
 * const ball = makeObject({ path: '/Ball', mesh: sphere(1), motion: restingAt([5, 0, 0]) });
 * surfaceLine(ball, { time: 2, position: [4, 0, 0], velocity: [0, 0, 0] }, 10); // { kind: 'static', position: [4, 0, 0] }
 */
export function surfaceLine(object: SceneObject, event: SurfaceEvent, c: number): WorldLine | undefined {
  const { motion, authoredIn } = object;
  if (motion.kind === 'hyperbolic') return hyperbolicLine(motion, authoredIn === 'rest', event, c);
  if (deforms(motion)) {
    const samples = pointSamples(motion);
    return samples && isStreamed(samples.points) ? undefined : deformingLine(object, event, c);
  }
  const { stretch: _, ...rest } = object;
  const axes = { ...rest, mesh: { ...object.mesh, positions: AXES } };
  const lines = [0, 1, 2, 3].map((i) => vertexWorldLine(axes, i, c));
  const [o, x, y, z] = lines.map((line) => positionAt(line, event.time, c));
  const own = coordinates([sub(x!, o!), sub(y!, o!), sub(z!, o!)], sub(event.position, o!));
  return own && combined(lines, [1 - own[0] - own[1] - own[2], ...own]);
}

/** k with r = Σ k_i a_i; undefined where the axes lie in a plane. */
function coordinates([a, b, c]: readonly [Vec3, Vec3, Vec3], r: Vec3): Vec3 | undefined {
  const inverse = invert([a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2]] satisfies Mat3);
  return inverse && transform(inverse, r);
}

/** In the rest frame at t0 the point is `o` from the origin along a; ((ℓ + o)² + (cΔt)²)^½, ℓ = c²/a, is its distance to the horizon at Δt. */
function hyperbolicLine(motion: HyperbolicMotion, isBornRigid: boolean, event: SurfaceEvent, c: number): WorldLine {
  const { t0, properAcceleration } = motion;
  const origin = originWorldLine(motion);
  const offset = sub(event.position, positionAt(origin, event.time, c));
  const a = length(properAcceleration);
  if (!isBornRigid || a === 0)
    return { kind: 'hyperbolic', position: add(motion.pose.position, offset), properAcceleration, t0 };
  const axis = scale(properAcceleration, 1 / a);
  const [l, s] = [(c * c) / a, c * (event.time - t0)];
  const along = dot(offset, axis);
  const reach = Math.hypot(l, s) + along;
  // (ℓ + o)² = reach² − s², and reach² − s² − ℓ² = along (2 √(ℓ² + s²) + along).
  const rest = Math.sqrt(Math.max(0, (reach - s) * (reach + s)));
  const o = (along * (2 * Math.hypot(l, s) + along)) / (rest + l);
  const position = add(motion.pose.position, addScaled(offset, axis, o - along));
  return { kind: 'hyperbolic', position, properAcceleration: scale(properAcceleration, l / (l + o)), t0 };
}

/** Of the triangle nearest to the event, with the weights of its point there. */
function deformingLine(object: SceneObject, { time, position }: SurfaceEvent, c: number): WorldLine | undefined {
  const places = vertexPositions(object, time, c);
  const { indices } = object.mesh;
  let nearest: { readonly corners: readonly number[]; readonly weights: Vec3; readonly distance: number } | undefined;
  for (let k = 0; k + 2 < indices.length; k += 3) {
    const corners = [indices[k]!, indices[k + 1]!, indices[k + 2]!];
    const [p, q, r] = corners.map((i) => pointAt(places, i));
    const weights = nearestWeights(p!, q!, r!, position);
    const at = add(add(scale(p!, weights[0]), scale(q!, weights[1])), scale(r!, weights[2]));
    const distance = length(sub(at, position));
    if (!(distance >= (nearest?.distance ?? Number.POSITIVE_INFINITY))) nearest = { corners, weights, distance };
  }
  if (!nearest) return undefined;
  return combined(
    nearest.corners.map((i) => vertexWorldLine(object, i, c)),
    nearest.weights,
  );
}

/** Barycentric weights of the point of a triangle that is nearest to x: its foot, or the nearest point of an edge. */
function nearestWeights(p: Vec3, q: Vec3, r: Vec3, x: Vec3): Vec3 {
  const [e, f, d] = [sub(q, p), sub(r, p), sub(x, p)];
  const own = coordinates([e, f, normalize(cross(e, f))], d);
  if (own && own[0] >= 0 && own[1] >= 0 && own[0] + own[1] <= 1) return [1 - own[0] - own[1], own[0], own[1]];
  const onEdge = (from: Vec3, to: Vec3): number => {
    const edge = sub(to, from);
    const square = dot(edge, edge);
    return square > 0 ? Math.min(1, Math.max(0, dot(edge, sub(x, from)) / square)) : 0;
  };
  const [s, t, w] = [onEdge(p, q), onEdge(q, r), onEdge(r, p)];
  const candidates: readonly Vec3[] = [
    [1 - s, s, 0],
    [0, 1 - t, t],
    [w, 0, 1 - w],
  ];
  const apart = ([a, b, g]: Vec3): number => length(sub(add(add(scale(p, a), scale(q, b)), scale(r, g)), x));
  return candidates.reduce((best, each) => (apart(each) < apart(best) ? each : best));
}

/** The line x(t) = Σ w_i x_i(t) of lines of one kind with the same times, Σ w_i = 1. */
function combined(lines: readonly WorldLine[], weights: readonly number[]): WorldLine | undefined {
  const vectors = (of: (line: WorldLine) => Vec3): Vec3 =>
    lines.reduce<Vec3>((sum, line, i) => addScaled(sum, of(line), weights[i]!), [0, 0, 0]);
  const arrays = (of: (line: WorldLine) => Float64Array): Float64Array =>
    of(lines[0]!).map((_, k) => lines.reduce((sum, line, i) => sum + weights[i]! * of(line)[k]!, 0));
  const [first] = lines;
  switch (first?.kind) {
    case 'static':
      return { kind: 'static', position: vectors((line) => as(line, 'static').position) };
    case 'uniform':
      return {
        kind: 'uniform',
        position: vectors((line) => as(line, 'uniform').position),
        velocity: vectors((line) => as(line, 'uniform').velocity),
      };
    case 'polyline':
      return { ...first, positions: arrays((line) => as(line, 'polyline').positions) };
    case 'cubic':
      return {
        ...first,
        positions: arrays((line) => as(line, 'cubic').positions),
        velocities: arrays((line) => as(line, 'cubic').velocities),
      };
    default:
      return undefined;
  }
}

function as<K extends WorldLine['kind']>(line: WorldLine, kind: K): Extract<WorldLine, { readonly kind: K }> {
  if (line.kind !== kind) throw new Error(`a ${line.kind} world line among those of kind ${kind}`);
  return line as Extract<WorldLine, { readonly kind: K }>;
}
