import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import type { FileSource } from '../../src/formats/files/fileSource.ts';
import { openScene } from '../../src/formats/open.ts';
import { add, cross, dot, normalize, scale, sub, type Vec3 } from '../../src/math/vec3.ts';
import { apparentPosition } from '../../src/physics/optics/apparentPosition.ts';
import { pointAt } from '../../src/scene/mesh/polygons.ts';
import { vertexPositions } from '../../src/scene/motion/motion.ts';
import type { Scene, SceneObject } from '../../src/scene/types.ts';
import { observerFromCamera } from '../../src/scene/view/camera.ts';
import type { ProbeObserver } from '../../src/scene/views/viewRecord.ts';

/** The scenes of the gallery that are compared with the reference; the test scenes of the sources are in testScenes.test.ts. */
export const NAMES = [
  'street',
  'dice',
  'wheel',
  'lattice',
  'sphere',
  'hall',
  'lamps',
  'prism',
  'sunset',
  'starfield',
  'saturn',
  'gallery',
  'ladder',
] as const;
export type ExampleName = (typeof NAMES)[number];

/** The files of examples/. */
export const files: FileSource = {
  read: async (path) =>
    new Uint8Array(await readFile(fileURLToPath(new URL(`../../examples/${path}`, import.meta.url)))),
};

const opened = new Map<ExampleName, Promise<Scene>>();

/** The scene of the repository; cached. */
export function openExample(name: ExampleName): Promise<Scene> {
  const scene = opened.get(name) ?? openScene(files, `${name}.usdc`);
  opened.set(name, scene);
  return scene;
}

export const speedOfLight = (scene: Scene): number => {
  if (scene.hints.speedOfLight === undefined) throw new Error(`${scene.name} suggests no speed of light`);
  return scene.hints.speedOfLight;
};

/** The object at a path, or the one below it. */
export function objectAt(scene: Scene, path: string): SceneObject {
  const found = scene.objects.find((object) => object.path === path || object.path.startsWith(`${path}/`));
  if (!found) throw new Error(`${scene.name} has no ${path}; it has ${scene.objects.map((o) => o.path).join(', ')}`);
  return found;
}

export const vertexCount = (object: SceneObject): number => object.mesh.positions.length / 3;

/** World positions of all vertices at t. */
export function worldPositions(object: SceneObject, t: number, c: number): Vec3[] {
  const all = vertexPositions(object, t, c);
  return Array.from({ length: vertexCount(object) }, (_, i) => pointAt(all, i));
}

export const mean = (points: readonly Vec3[]): Vec3 =>
  scale(
    points.reduce((sum, p) => add(sum, p), [0, 0, 0]),
    1 / points.length,
  );

/** Distance of p from the line through a and b. */
export function distanceFromLine(p: Vec3, a: Vec3, b: Vec3): number {
  const [u, v] = [sub(b, a), sub(p, a)];
  const along = (u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / (u[0] ** 2 + u[1] ** 2 + u[2] ** 2);
  return Math.hypot(...sub(v, scale(u, along)));
}

/** The scene's camera at each of its samples. */
export function ridden(scene: Scene): ProbeObserver[] {
  const [camera] = scene.cameras;
  const times = camera.motion.kind === 'sampled' ? [...camera.motion.times] : [scene.startTime];
  return times.map((t) => ({ t, ...observerFromCamera(camera, t, speedOfLight(scene)) }));
}

/** The scene's camera at its fastest moment. */
export const topOfFlight = (scene: Scene): ProbeObserver =>
  ridden(scene).reduce((best, other) => (Math.hypot(...other.u) > Math.hypot(...best.u) ? other : best));

/** Apparent position of the world point p, at rest [m]. */
export const seenAt = (p: Vec3, observer: ProbeObserver): Vec3 =>
  apparentPosition(sub(p, observer.position), observer.u);

/** Triple product of three directions from the observer: 0 if the line through the points looks straight. */
export function curvature(a: Vec3, b: Vec3, d: Vec3): number {
  const [na, nb, nd] = [normalize(a), normalize(b), normalize(d)];
  return Math.abs(dot(na, cross(nb, nd)));
}
