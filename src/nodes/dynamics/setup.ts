import type { Springs } from '../../dynamics/forces/springs.ts';
import { meshSprings } from '../../dynamics/meshSprings.ts';
import { type KinematicPoint, makeSystem, momenta, momentum, type State, type System } from '../../dynamics/system.ts';
import { add, cross, length, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { positionAt, velocityAt, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import { boundingBox } from '../../scene/bounds/bounds.ts';
import { recoverQuads } from '../../scene/compose/recoverQuads.ts';
import { weld } from '../../scene/compose/weld.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { bakedObject } from '../../scene/mesh/stretch.ts';
import { originWorldLine, vertexWorldLine } from '../../scene/motion/motion.ts';
import type { RigidMotion, Scene, SceneObject } from '../../scene/types.ts';
import { nodeRefusal } from '../common/params.ts';
import {
  forcesOn,
  type PlacedObstacle,
  type PointCollection,
  type ProximityContact,
  type SimulatedSphere,
} from './forces.ts';
import type { ColliderMatter, FieldMatter, InitialConditions, MassSpringMatter, Matter, Rods } from './matter.ts';
import { isMoving, meshBounds, meshCenter, START_TIME, trajectoryOf } from './objects.ts';
import { carrierPositions, obstacleOf } from './obstacles.ts';
import { pinnedPoints } from './pins.ts';

/** An object and the points of the system that it follows. */
export type SimulatedBody =
  | { readonly kind: 'net'; readonly object: SceneObject; readonly pointOfVertex: Uint32Array }
  | { readonly kind: 'ball'; readonly object: SceneObject; readonly point: number }
  | { readonly kind: 'rod'; readonly of: SceneObject; readonly ends: readonly [number, number]; readonly width: number }
  /** Its motion is prescribed; `points`: kinematic points that move with it. */
  | { readonly kind: 'fixed'; readonly object: SceneObject; readonly points: readonly number[] };

/** The bodies of one part, with the scene that their materials belong to. */
export interface BodyGroup {
  readonly scene: Scene;
  readonly bodies: readonly SimulatedBody[];
}

/** The system to simulate, and the bodies that display it. */
export interface SimulationSetup {
  readonly system: System;
  readonly start: State;
  readonly bodyGroups: readonly BodyGroup[];
}

/** Vertices nearer than this fraction of their object's size are one point. */
const WELD_TOLERANCE = 1e-6;

/** The system that parts make together. Throws a NodeRefusal that names the part, or a SystemError. */
export function setUpSimulation(parts: readonly Matter[], c: number, contact: ProximityContact): SimulationSetup {
  const builder = new SystemBuilder(c);
  const bodyGroups = parts.flatMap((part): BodyGroup[] => {
    if (part.kind === 'field') return [];
    const bodies = part.kind === 'net' ? builder.net(part) : builder.solid(part);
    return [{ scene: part.scene, bodies }];
  });
  const fields = parts.filter((part) => part.kind === 'field');
  return { ...builder.finish(fields, contact), bodyGroups };
}

/** Collects points, springs and obstacles. */
class SystemBuilder implements PointCollection {
  private readonly c: number;
  readonly x: number[] = [];
  private readonly v: number[] = [];
  readonly masses: number[] = [];
  readonly pinned: number[] = [];
  readonly charges: number[] = [];
  readonly bodies: number[] = [];
  readonly nets: Springs[] = [];
  readonly spheres: SimulatedSphere[] = [];
  readonly obstacles: PlacedObstacle[] = [];
  /** With initial velocity [m/s]. */
  private readonly kinematic: (KinematicPoint & { readonly v: Vec3 })[] = [];
  private bodyCount = 0;

  constructor(c: number) {
    this.c = c;
  }

  net(part: MassSpringMatter): SimulatedBody[] {
    const up = part.scene.upAxis === 'Y' ? 1 : 2;
    let held = 0;
    const bodies = part.scene.objects.map((given): SimulatedBody => {
      const object = bakedObject(given);
      const { points, velocities, pointOfVertex, net, lineOf } = massSpringMesh(object, part, this.c);
      const count = points.length / 3;
      const filled = part.stiffness.filling > 0;
      const middle = boundsCenter(points);
      const pins = pinnedPoints(points, pointOfVertex, part, up, object.path);
      held += pins.size;
      const first = this.masses.length;
      const fraction = 1 / (count + Number(filled));
      const body = this.bodyCount++;
      for (let i = 0; i < count; i++) {
        const at = pointAt(points, i);
        const v = add(add(pointAt(velocities, i), part.velocity), cross(part.spin, sub(at, middle)));
        const point = this.point(at, v, part, fraction, pins.has(i), body);
        if (pins.has(i) && isMoving(object)) this.leadAlong(point, lineOf(i));
      }
      this.springsFrom(first, net);
      if (filled) this.fill(first, points, middle, part, fraction);
      return { kind: 'net', object, pointOfVertex: pointOfVertex.map((point) => first + point) };
    });
    if (part.pins.kind === 'box' && held === 0)
      throw nodeRefusal(
        'pins.none',
        `${part.node}.pinCenter`,
        msg`no point is in the box that holds points; put it on some`,
      );
    return bodies;
  }

  /** Adds a center point with springs to all others. */
  private fill(first: number, points: Float64Array, middle: Vec3, part: MassSpringMatter, fraction: number): void {
    const count = points.length / 3;
    const center = this.point(middle, part.velocity, part, fraction, false, -1);
    const ends = Uint32Array.from({ length: 2 * count }, (_, k) => (k % 2 === 0 ? center : first + (k >> 1)));
    const lengths = Float64Array.from(
      { length: count },
      (_, i) => part.tension * length(sub(pointAt(points, i), middle)),
    );
    this.nets.push({ ends, stiffness: new Float64Array(count).fill(part.stiffness.filling), lengths });
  }

  private springsFrom(first: number, net: Springs): void {
    if (net.lengths.length > 0) this.nets.push({ ...net, ends: net.ends.map((point) => first + point) });
  }

  solid(part: ColliderMatter): SimulatedBody[] {
    if (part.shape !== 'ball') {
      return part.scene.objects.map((object) => prescribedBody(object, this.obstacle(object, part)));
    }
    const spheres = part.scene.objects.map((object) => ({ object, ...this.sphere(object, part) }));
    const shown = spheres.map(
      ({ object, point }): SimulatedBody =>
        part.free ? { kind: 'ball', object, point } : prescribedBody(object, [point]),
    );
    return [...shown, ...(part.free?.rods ? this.rods(spheres, part.free.rods) : [])];
  }

  private sphere(object: SceneObject, part: ColliderMatter): { readonly point: number; readonly center: Vec3 } {
    const { min, max } = meshBounds(object);
    const center = trajectoryOf(object, meshCenter(object), this.c)(START_TIME);
    const radius = Math.max(...sub(max, min)) / 2;
    const { node, charge, free = { mass: 1, velocity: ZERO } } = part;
    const point = this.point(center, free.velocity, { ...free, node, charge }, 1, !part.free, -1);
    if (isMoving(object)) this.leadWith(point, object, meshCenter(object));
    this.spheres.push({ point, radius, of: part });
    return { point, center };
  }

  /** A moving obstacle is carried by kinematic points, whose indices are returned. */
  private obstacle(object: SceneObject, part: ColliderMatter): readonly number[] {
    const obstacle = obstacleOf(object, part, this.c);
    if (!isMoving(object)) {
      this.obstacles.push({ obstacle, of: part });
      return [];
    }
    const carriers = carrierPositions(object, obstacle, this.c).map((place) => {
      const carrier = this.point(trajectoryOf(object, place, this.c)(START_TIME), ZERO, PINNED_POINT, 1, true, -1);
      this.leadWith(carrier, object, place);
      return carrier;
    });
    this.obstacles.push({ obstacle, of: part, carriers });
    return carriers;
  }

  private leadAlong(point: number, line: WorldLine): void {
    const { c } = this;
    this.kinematic.push({ point, positionAt: (t) => positionAt(line, t, c), v: velocityAt(line, START_TIME, c) });
  }

  /** Makes a point follow a point of an object, given in the object's frame. */
  private leadWith(point: number, object: SceneObject, place: Vec3): void {
    const { c } = this;
    const v = velocityAt(originWorldLine(object.motion as RigidMotion), START_TIME, c);
    this.kinematic.push({ point, positionAt: trajectoryOf(object, place, c), v });
  }

  private rods(
    spheres: readonly { readonly object: SceneObject; readonly point: number; readonly center: Vec3 }[],
    rods: Rods,
  ): SimulatedBody[] {
    return spheres.flatMap(({ object, point, center }, i): SimulatedBody[] => {
      const before = rods.to === 'chain' ? spheres[i - 1] : undefined;
      const place = before?.center ?? add(center, rods.pivot);
      const held = before?.point ?? this.point(place, ZERO, PINNED_POINT, 1, true, -1);
      const lengths = Float64Array.of(length(sub(place, center)));
      this.nets.push({ ends: Uint32Array.of(point, held), stiffness: Float64Array.of(rods.stiffness), lengths });
      return rods.thickness > 0 ? [{ kind: 'rod', of: object, ends: [point, held], width: rods.thickness }] : [];
    });
  }

  private point(
    at: Vec3,
    v: Vec3,
    start: InitialConditions & { readonly node: string },
    fraction: number,
    pin: boolean,
    body: number,
  ): number {
    const speed = length(v);
    if (!pin && !(speed < this.c)) {
      const message = msg`it begins at ${speed.toPrecision(3)} m/s, not below the speed of light, ${this.c} m/s; let it begin slower, or raise the speed of light of the simulation`;
      throw nodeRefusal('simulate.light', start.node, message);
    }
    this.x.push(...at);
    this.v.push(...v);
    this.charges.push(start.charge * fraction);
    this.pinned.push(Number(pin));
    this.bodies.push(body);
    return this.masses.push(start.mass * fraction) - 1;
  }

  finish(fields: readonly FieldMatter[], contact: ProximityContact): Pick<SimulationSetup, 'system' | 'start'> {
    const { c, kinematic, v, x } = this;
    const system = makeSystem({
      ...{ c, masses: Float64Array.from(this.masses), pinned: Uint8Array.from(this.pinned) },
      ...forcesOn(this, fields, contact),
      ...(kinematic.length > 0 && { kinematic }),
    });
    const p = momenta(system, v);
    for (const each of kinematic) p.set(momentum(system.masses[each.point], each.v, c), 3 * each.point);
    return { system, start: { t: START_TIME, x: Float64Array.from(x), p } };
  }
}

/** An object with prescribed motion keeps the size that it has in the world. */
const prescribedBody = (object: SceneObject, points: readonly number[]): SimulatedBody => ({
  kind: 'fixed',
  object: isMoving(object) ? { ...object, authoredIn: 'world' } : object,
  points,
});

/** Properties of pinned points without an object. */
const PINNED_POINT = { node: '', mass: 1, velocity: ZERO, charge: 0 };

/** Points of an object in the world at the start, and the springs between them. */
function massSpringMesh(object: SceneObject, { stiffness, tension }: MassSpringMatter, c: number) {
  const { positions, indices } = object.mesh;
  const { min, max } = meshBounds(object);
  const { pointOfVertex, vertexOfPoint } = weld(positions, WELD_TOLERANCE * length(sub(max, min)));
  const lineOf = (point: number): WorldLine => vertexWorldLine(object, vertexOfPoint[point], c);
  const points = new Float64Array(3 * vertexOfPoint.length);
  const velocities = new Float64Array(points.length);
  vertexOfPoint.forEach((_, i) => {
    const line = lineOf(i);
    points.set(positionAt(line, START_TIME, c), 3 * i);
    velocities.set(velocityAt(line, START_TIME, c), 3 * i);
  });
  const faces = recoverQuads(
    points,
    indices.map((vertex) => pointOfVertex[vertex]),
  );
  return { points, velocities, pointOfVertex, lineOf, net: meshSprings(points, faces, stiffness, tension) };
}

const boundsCenter = (points: Float64Array): Vec3 => {
  const { min, max } = boundingBox(points)!;
  return scale(add(min, max), 0.5);
};
