import { restToWorld } from '../scene/resample.ts';
import { isTransparent } from '../scene/transparency.ts';
import type { Material, Mesh, Scene, SceneObject } from '../scene/types.ts';
import { HyperbolicTracer } from './hyperbolic.ts';
import { RigidTracer } from './rigid.ts';
import { SampledTracer } from './sampled.ts';
import { ShapeStore } from './samples.ts';
import { Search, type Tracer } from './search.ts';
import { TopLevel } from './topLevel.ts';
import { type TriangleTree, treeOfMesh } from './triangleTree.ts';
import type { Hit, RayFilter, SpacetimeRay } from './types.ts';

/** A scene that rays can be sent through. */
export interface TracedScene {
  readonly scene: Scene;
  /** [m/s] */
  readonly c: number;
  /** As `scene.objects`, in the same order; sampled ones that are authored at rest are brought into the world frame. */
  readonly objects: readonly SceneObject[];
  /** Materials that are blended with what is behind them. */
  readonly transparent: ReadonlySet<Material>;
  /** Objects that are opaque all over, by their place in `objects`. */
  readonly solid: readonly boolean[];
  readonly surfaces: TopLevel;
}

/** What is dear to make of a scene, and the same for every thread that traces it. Plain data. */
export interface Groundwork {
  readonly scene: Scene;
  readonly c: number;
  readonly objects: readonly SceneObject[];
  /** Of the meshes that keep their shape. */
  readonly trees: ReadonlyMap<Mesh, TriangleTree>;
}

export function groundwork(scene: Scene, c: number): Groundwork {
  const objects = scene.objects.map((object) => restToWorld(object, c));
  const trees = new Map<Mesh, TriangleTree>();
  for (const { mesh, motion } of objects)
    if (motion.kind !== 'sampled' && motion.kind !== 'sampled-points' && !trees.has(mesh))
      trees.set(mesh, treeOfMesh(mesh));
  return { scene, c, objects, trees };
}

/** Memory for the shapes of sampled objects at their samples [bytes], besides what the last ray's two need. */
const SHAPES = 256 * 2 ** 20;

/** Makes a scene ready for rays at the speed of light c [m/s]. */
export const traceable = (scene: Scene, c: number): TracedScene => traced(groundwork(scene, c));

/** Ready for rays, on what may be shared. What belongs to samples of a motion is made when a ray needs it, and kept in `shapes` bytes. */
export function traced({ scene, c, objects, trees }: Groundwork, shapes = SHAPES): TracedScene {
  const store = new ShapeStore(shapes);
  const tracers = objects.map((object, i) => tracerOf(object, i, trees, c, store));
  const transparent = new Set(scene.materials.filter(isTransparent));
  return {
    scene,
    c,
    objects,
    transparent,
    solid: objects.map(({ mesh }) =>
      mesh.groups.every(({ material }) => isSolid(scene.materials[material], transparent)),
    ),
    surfaces: new TopLevel(tracers, c),
  };
}

const isSolid = (material: Material, transparent: ReadonlySet<Material>): boolean =>
  material.opacityThreshold === 0 && !transparent.has(material);

function tracerOf(
  object: SceneObject,
  index: number,
  trees: Groundwork['trees'],
  c: number,
  store: ShapeStore,
): Tracer {
  const { mesh, motion } = object;
  if (motion.kind === 'sampled' || motion.kind === 'sampled-points')
    return new SampledTracer(index, { ...object, motion }, c, store);
  const tree = trees.get(mesh);
  if (!tree) throw new Error(`${object.path} has no tree`);
  return motion.kind === 'hyperbolic'
    ? new HyperbolicTracer(index, { ...object, motion }, tree, c)
    : new RigidTracer(index, { ...object, motion }, tree, c);
}

/**
 * The first event on the ray, from `begin` to `end`, at which it meets a surface within its lifetime, from either side. `accepts` is asked
 * about each that is nearer than all taken before, in no order of its own, and must not trace rays itself.
 */
export function nearestHit({ surfaces }: TracedScene, ray: SpacetimeRay, filter: RayFilter = {}): Hit | undefined {
  const search = new Search(ray, filter);
  surfaces.trace(ray, search);
  return search.nearest;
}
