import { boundingBox } from '../../scene/bounds/bounds.ts';
import { AdaptivePath, SamplingBudget } from '../../scene/motion/adaptiveSampling.ts';
import { MATRIX } from '../../scene/streaming/blendedPoints.ts';
import { blendedPlaces, jointOutline, type OutlinedMesh } from './jointOutline.ts';
import { subsampleEvenly } from './subsample.ts';

/** Inside a piece a path is looked at here: in the middle and at two places that no periodic motion has in common. */
export const PATH_PROBES = [0.23, 0.5, 0.71];
/** A piece between two keys is halved at most this many times. */
export const MAX_HALVINGS = 12;
/** Following so many points takes as long as one curve. */
export const POINTS_PER_CURVE = 8;
/** For the paths of all that bends [curves, each at one time]: about two seconds. */
const BLEND_BUDGET = 2 ** 22;
/** Most bytes of joints in a scene. */
export const MAX_BLENDED = 2 ** 28;

/** Joints with all meshes that follow them. */
export interface BendingMeshes {
  readonly meshes: readonly OutlinedMesh[];
  /** Key times, increasing. */
  readonly knots: ArrayLike<number>;
  /** Ends of ramps that replace jumps. */
  readonly ramps?: ReadonlySet<number>;
  /** Curves that are evaluated for the joints at one time. */
  readonly cost: number;
  /** Greatest distance from chords, relative to half the diagonal of all. */
  readonly tolerance: number;
  /** By joint the matrix to the world, 12 numbers each; that of the rest of incomplete weights at the end. */
  framesAt(t: number): Float64Array;
}

/** Nodes of a time grid. */
export interface GridTimes {
  readonly times: Float64Array;
  /** Greatest remaining distance from a chord [m]. */
  readonly error: number;
  /** Whether that is within the tolerance, or was before nodes were left out for memory. */
  readonly isFollowed: boolean;
  /** Number of nodes that would meet the tolerance. */
  readonly needed: number;
  /** Nodes are left out because there is no memory for more. */
  readonly isCoarse: boolean;
}

/** Time and memory for all that bends in a scene, which each set of joints gets an even share of; what one does not need goes to the others. */
export class BlendBudget {
  /** For the joints of the scene [bytes]. */
  readonly bytes: number;
  private readonly sampling: SamplingBudget;
  private left: number;
  /** Sets of joints that are still to come. */
  private waiting: number;

  /** `sets`: number of sets of joints, and of meshes that bend by themselves. */
  constructor(sets: number, bytes = MAX_BLENDED) {
    this.sampling = new SamplingBudget(BLEND_BUDGET, sets);
    this.bytes = bytes;
    this.left = bytes;
    this.waiting = sets;
  }

  /** Greatest remaining distance from a chord so far [m]; undefined before the first grid. */
  get error(): number | undefined {
    return this.sampling.error;
  }

  /** Nodes at which joints are kept; every n-th, to fit in memory. */
  follow(bending: BendingMeshes): GridTimes {
    const { knots, ramps, framesAt, meshes } = bending;
    const [start] = [knots[0] ?? 0];
    const outline = jointOutline(meshes, framesAt);
    const first = framesAt(start);
    const tolerance = bending.tolerance * radiusOf(meshes, first, start);
    const numbers = first.length + meshes.reduce((sum, { shapes }) => sum + shapes.length, 0);
    const nodeBytes = 8 * Math.max(MATRIX, numbers);
    const most = Math.max(2, Math.floor(this.left / Math.max(1, this.waiting--) / nodeBytes));
    const how = { tolerance, fractions: PATH_PROBES, maxHalvings: MAX_HALVINGS, ...(ramps && { ramps }) };
    const path = new AdaptivePath(Float64Array.from(knots), outline, how);
    const cost = 1 + bending.cost + outline(start).length / 3 / POINTS_PER_CURVE;
    const { times: followed, error, needed } = this.sampling.sample(path, cost, most);
    const times = Float64Array.from(subsampleEvenly(followed, most));
    this.left -= times.length * nodeBytes;
    const isFollowed = !(error > tolerance) || followed.length >= most;
    return { times, error, needed, isFollowed, isCoarse: times.length >= most };
  }
}

/** Half the diagonal of all vertices at a time. */
function radiusOf(meshes: readonly OutlinedMesh[], frames: Float64Array, t: number): number {
  const ends = meshes.flatMap((mesh) => {
    const box = boundingBox(blendedPlaces(mesh, frames, t));
    return box ? [...box.min, ...box.max] : [];
  });
  const box = boundingBox(ends);
  return box ? Math.hypot(...box.max.map((x, k) => x - box.min[k])) / 2 : 0;
}
