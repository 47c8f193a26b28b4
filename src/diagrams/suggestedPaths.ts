import { distance, length, sub, type Vec3 } from '../math/vec3.ts';
import { positionAt, type WorldLine } from '../physics/worldLines/worldLine.ts';
import { meshBoundingSphere } from '../scene/bounds/bounds.ts';
import { middleWorldLine } from '../scene/motion/middleWorldLine.ts';
import { deforms, isStatic } from '../scene/motion/motion.ts';
import type { Scene, SceneObject } from '../scene/types.ts';

/** Moments of the scene at which things are compared. */
const MOMENTS = 16;
/** What is carried has at most this share of the radius of what carries it, and is no farther from it than so many of its radii. */
const [SMALL, NEAR] = [0.5, 2];
/** By how much their offset may vary, as a share of that radius: of coordinates in 32 bits. */
const STEADY = 1e-3;

/** A thing of one rigid piece: its middle at the moments, world frame [m], and its radius [m]. */
interface RigidThing {
  readonly places: readonly Vec3[];
  readonly radius: number;
}

/**
 * Paths of things that diagrams and clocks show unless others are chosen: of what moves, else of everything, the first `limit`.
 * Pieces of one thing count once. What is carried by another is left out: small beside it, near it, and at all times at the same
 * offset, as a pointer or a wheel. c [m/s].
 */
export function suggestedPaths(scene: Scene, limit: number, c: number): readonly string[] {
  const moving = scene.objects.filter(({ motion }) => !isStatic(motion));
  const pieces = new Map<string, SceneObject[]>();
  for (const object of moving.length > 0 ? moving : scene.objects) {
    const path = object.pieceOf ?? object.path;
    pieces.set(path, [...(pieces.get(path) ?? []), object]);
  }
  let found: { readonly path: string; readonly thing: RigidThing | undefined }[] = [];
  for (const [path, objects] of pieces) {
    if (found.length >= limit) break;
    const thing = moving.length > 0 ? rigidThing(objects, scene, c) : undefined;
    if (thing && found.some((other) => other.thing && carries(other.thing, thing))) continue;
    found = [...found.filter((other) => !(thing && other.thing && carries(thing, other.thing))), { path, thing }];
  }
  return found.map(({ path }) => path);
}

function rigidThing([object, ...others]: readonly SceneObject[], scene: Scene, c: number): RigidThing | undefined {
  if (!object || others.length > 0 || deforms(object.motion)) return undefined;
  const line: WorldLine = middleWorldLine(object, c);
  const { startTime, endTime } = scene;
  const step = (endTime - startTime) / (MOMENTS - 1);
  const places = Array.from({ length: MOMENTS }, (_, i) => positionAt(line, startTime + i * step, c));
  return { places, radius: meshBoundingSphere(object.mesh).radius };
}

function carries({ places, radius }: RigidThing, other: RigidThing): boolean {
  const offsets = places.map((place, i) => sub(other.places[i]!, place));
  return (
    other.radius <= SMALL * radius &&
    length(offsets[0]!) <= NEAR * radius &&
    offsets.every((offset) => distance(offset, offsets[0]!) <= STEADY * radius)
  );
}
