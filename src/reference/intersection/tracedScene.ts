import { isTransparent } from '../../scene/materials/transparency.ts';
import { quadricOf } from '../../scene/mesh/quadric.ts';
import { bakedObject } from '../../scene/mesh/stretch.ts';
import { restToWorld } from '../../scene/motion/motion.ts';
import type { Material, Mesh, Quadric, Scene, SceneObject } from '../../scene/types.ts';
import type { Hit, RayFilter, SpacetimeRay } from '../acceleration/ray.ts';
import { type ObjectIntersector, RayQuery } from '../acceleration/rayQuery.ts';
import { TopLevelBvh } from '../acceleration/topLevelBvh.ts';
import { meshBvh, type TriangleBvh } from '../acceleration/triangleBvh.ts';
import { nearestOnCurve } from './curveHit.ts';
import { motionTracer } from './motionTracers.ts';
import { RoundSolid } from './quadrics/roundSolid.ts';
import { ShapeCache } from './sampled/sampledShapes.ts';

/** A scene with the acceleration structures for tracing rays. */
export interface TracedScene {
  /** The scene itself. */
  readonly scene: Scene;
  /** [m/s] */
  readonly c: number;
  /** `scene.objects` in the same order; sampled meshes authored at rest are converted to the world frame. */
  readonly objects: readonly SceneObject[];
  /** Alpha-blended materials. */
  readonly transparentMaterials: ReadonlySet<Material>;
  /** Per index in `objects`: whether the object is opaque everywhere. */
  readonly opaqueObjects: readonly boolean[];
  /**
   * Finds the objects that a ray may meet.
   * @internal
   */
  readonly topLevel: TopLevelBvh;
}

/** The expensive part of a traced scene, as plain data that threads can share. */
export interface PreparedScene {
  readonly scene: Scene;
  readonly c: number;
  readonly objects: readonly SceneObject[];
  /** The BVHs of meshes of constant shape that are not round solids. */
  readonly trees: ReadonlyMap<Mesh, TriangleBvh>;
}

export function prepareScene(scene: Scene, c: number): PreparedScene {
  const objects = scene.objects.map((object) => (quadricOf(object) ? object : tracedObject(object, c)));
  const trees = new Map<Mesh, TriangleBvh>();
  for (const object of objects) {
    const { mesh, motion } = object;
    if (motionTracer(motion).keepsShape && !quadricOf(object) && !trees.has(mesh)) trees.set(mesh, meshBvh(mesh));
  }
  return { scene, c, objects, trees };
}

const tracedObject = (object: SceneObject, c: number): SceneObject =>
  motionTracer(object.motion).mapsToMesh ? object : restToWorld(bakedObject(object), c);

/** Budget of `ShapeCache` [bytes]. */
const SHAPE_CACHE_BYTES = 256 * 2 ** 20;

/**
 * Builds the acceleration structures of a scene for the speed of light c [m/s].
 * @example
 * import { makeObject, makeScene, sphere } from 'slowlight/scene';
 * const scene = makeScene({ name: 'ball', objects: [makeObject({ path: '/Ball', mesh: sphere(1) })] });
 * createTracedScene(scene, 10).opaqueObjects; // [true]
 */
export const createTracedScene = (scene: Scene, c: number): TracedScene => fromPreparedScene(prepareScene(scene, c));

/** A traced scene on shared prepared data. Shapes at samples of motions are evaluated lazily and cached in `shapes` bytes. */
export function fromPreparedScene(
  { scene, c, objects, trees }: PreparedScene,
  shapes = SHAPE_CACHE_BYTES,
): TracedScene {
  const store = new ShapeCache(shapes);
  const solids = new Map<Quadric, RoundSolid>();
  const tracers = objects.map((object, i) => createIntersector(object, i, trees, solids, c, store));
  const transparent = new Set(scene.materials.filter(isTransparent));
  return {
    scene,
    c,
    objects,
    transparentMaterials: transparent,
    opaqueObjects: objects.map(({ mesh }) =>
      mesh.groups.every(({ material }) => isOpaque(scene.materials[material], transparent)),
    ),
    topLevel: new TopLevelBvh(tracers, c),
  };
}

const isOpaque = (material: Material, transparent: ReadonlySet<Material>): boolean =>
  material.opacityThreshold === 0 && !transparent.has(material);

function createIntersector(
  object: SceneObject,
  index: number,
  trees: PreparedScene['trees'],
  solids: Map<Quadric, RoundSolid>,
  c: number,
  store: ShapeCache,
): ObjectIntersector {
  const tree = (): TriangleBvh => {
    const found = trees.get(object.mesh);
    if (!found) throw new Error(`${object.path} has no tree`);
    return found;
  };
  const quadric = quadricOf(object);
  const solid = quadric && (solids.get(quadric) ?? new RoundSolid(quadric));
  if (quadric && solid) solids.set(quadric, solid);
  return motionTracer(object.motion).createIntersector(object, { index, c, tree, solid, store });
}

/**
 * The first event on the ray, between `begin` and `end`, at which it meets a surface within its lifetime, from either side; of two at the same place that of the
 * object and triangle that the scene lists last, as pictures show what is drawn last. `accepts` is called
 * for each candidate nearer than all accepted before, in no particular order, and must not trace rays itself.
 * @example
 * import { box, IDENTITY_POSE, makeObject, makeScene } from 'slowlight/scene';
 * // A cube that flew past at 6 m/s with c = 10 m/s, and is seen where it was 0.5 s before.
 * const motion = { kind: 'uniform', pose: IDENTITY_POSE, velocity: [6, 0, 0] } as const;
 * const cube = makeObject({ path: '/Cube', mesh: box([2, 2, 2]), motion });
 * const scene = createTracedScene(makeScene({ name: 'cube', objects: [cube] }), 10);
 * const hit = nearestHit(scene, { t: 0.5, x: [0, 0, 6], dt: -1, dx: [0, 0, -1] });
 * hit; // { s: 5, time: 0, velocity: [0.6, 0, 0] }
 */
export function nearestHit({ topLevel }: TracedScene, ray: SpacetimeRay, filter: RayFilter = {}): Hit | undefined {
  const along = (straight: SpacetimeRay, own: RayFilter): Hit | undefined => {
    const search = new RayQuery(straight, own);
    topLevel.intersect(straight, search);
    return search.nearest;
  };
  return ray.curve ? nearestOnCurve(ray.curve, filter, along) : along(ray, filter);
}
