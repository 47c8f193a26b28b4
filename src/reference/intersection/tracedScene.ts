import { isTransparent } from '../../scene/materials/transparency.ts';
import { restToWorld } from '../../scene/motion/motion.ts';
import type { Material, Mesh, Scene, SceneObject } from '../../scene/types.ts';
import type { Hit, RayFilter, SpacetimeRay } from '../acceleration/ray.ts';
import { type ObjectIntersector, RayQuery } from '../acceleration/rayQuery.ts';
import { TopLevelBvh } from '../acceleration/topLevelBvh.ts';
import { meshBvh, type TriangleBvh } from '../acceleration/triangleBvh.ts';
import { motionTracer } from './motionTracers.ts';
import { ShapeCache } from './sampledShapes.ts';

/** A scene that rays can be sent through. */
export interface TracedScene {
  readonly scene: Scene;
  /** [m/s] */
  readonly c: number;
  /** As `scene.objects`, in the same order; sampled ones that are authored at rest are brought into the world frame. */
  readonly objects: readonly SceneObject[];
  /** Materials that are blended with what is behind them. */
  readonly transparentMaterials: ReadonlySet<Material>;
  /** Objects that are opaque all over, by their place in `objects`. */
  readonly opaqueObjects: readonly boolean[];
  readonly topLevel: TopLevelBvh;
}

/** What is dear to make of a scene, and the same for every thread that traces it. Plain data. */
export interface PreparedScene {
  readonly scene: Scene;
  readonly c: number;
  readonly objects: readonly SceneObject[];
  /** Of the meshes that keep their shape. */
  readonly trees: ReadonlyMap<Mesh, TriangleBvh>;
}

export function prepareScene(scene: Scene, c: number): PreparedScene {
  const objects = scene.objects.map((object) => restToWorld(object, c));
  const trees = new Map<Mesh, TriangleBvh>();
  for (const { mesh, motion } of objects)
    if (motionTracer(motion).keepsShape && !trees.has(mesh)) trees.set(mesh, meshBvh(mesh));
  return { scene, c, objects, trees };
}

/** Memory for the shapes of sampled objects at their samples [bytes], besides what the last ray's two need. */
const SHAPE_CACHE_BYTES = 256 * 2 ** 20;

/** Makes a scene ready for rays at the speed of light c [m/s]. */
export const createTracedScene = (scene: Scene, c: number): TracedScene => fromPreparedScene(prepareScene(scene, c));

/** Ready for rays, on what may be shared. What belongs to samples of a motion is made when a ray needs it, and kept in `shapes` bytes. */
export function fromPreparedScene(
  { scene, c, objects, trees }: PreparedScene,
  shapes = SHAPE_CACHE_BYTES,
): TracedScene {
  const store = new ShapeCache(shapes);
  const tracers = objects.map((object, i) => createIntersector(object, i, trees, c, store));
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
  c: number,
  store: ShapeCache,
): ObjectIntersector {
  const tree = (): TriangleBvh => {
    const found = trees.get(object.mesh);
    if (!found) throw new Error(`${object.path} has no tree`);
    return found;
  };
  return motionTracer(object.motion).createIntersector(object, { index, c, tree, store });
}

/**
 * The first event on the ray, from `begin` to `end`, at which it meets a surface within its lifetime, from either side. `accepts` is asked
 * about each that is nearer than all taken before, in no order of its own, and must not trace rays itself.
 */
export function nearestHit({ topLevel }: TracedScene, ray: SpacetimeRay, filter: RayFilter = {}): Hit | undefined {
  const search = new RayQuery(ray, filter);
  topLevel.intersect(ray, search);
  return search.nearest;
}
