import { conjugate, rotate } from '../../src/math/quat.ts';
import { bisect } from '../../src/math/roots.ts';
import { dot, length, sub, type Vec3 } from '../../src/math/vec3.ts';
import { boost, properVelocity, velocity } from '../../src/physics/lorentz/boost.ts';
import { fourVector, spatial } from '../../src/physics/lorentz/fourVector.ts';
import { apparentPosition } from '../../src/physics/optics/apparentPosition.ts';
import { dopplerFactor } from '../../src/physics/optics/doppler.ts';
import { simultaneousPosition } from '../../src/physics/worldLines/simultaneity.ts';
import type { Hit } from '../../src/reference/acceleration/ray.ts';
import { cameraRay } from '../../src/reference/camera/cameraRay.ts';
import { visibleHit } from '../../src/reference/camera/visibleHit.ts';
import type { TracedScene } from '../../src/reference/intersection/tracedScene.ts';
import { surfaceAt } from '../../src/reference/materials/surface.ts';
import type { Motion } from '../../src/scene/types.ts';
import { perspectiveOf } from '../../src/scene/view/lenses/lenses.ts';
import { frustumOf, pixelsPerTangent } from '../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../src/scene/view/view.ts';

/*
 * Judges rasterized pixels. A pixel claims that an event of an object's surface is seen at its centre; it is right if that event is truly seen
 * within `MAX_DISPLACEMENT` pixels of the centre, and background likewise. Where it is seen follows from its position by the formulas of physics/;
 * that the surface is there at that time, and unoccluded, follows from rays of the reference.
 */

/** Greatest allowed distance of the true position from the pixel's centre [px]: the renderer's goal. */
export const MAX_DISPLACEMENT = 0.5;

/** A rasterized picture with its scene and view. */
export interface RasterizedPicture {
  readonly scene: TracedScene;
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  readonly width: number;
  readonly height: number;
}

/** The claim of a pixel: its data AOVs. */
export interface PixelSample {
  /** Index in `Scene.objects` plus one; 0: background. */
  readonly object: number;
  readonly position: Vec3;
  readonly time: number;
  /** Apparent distance [m]. */
  readonly depth: number;
  readonly doppler: number;
  /** World frame [c]. */
  readonly velocity: Vec3;
  readonly albedo: Vec3;
}

export interface PixelVerdict {
  readonly right: boolean;
  /** From the pixel's centre to where the claimed event is truly seen [px]; 0 for background, infinite behind the camera. */
  readonly displacement: number;
  /** Errors of a right pixel's data. Time: relative to the light path, c|Δt|/|Δx|; depth and D: relative; velocity [c]. */
  readonly time: number;
  readonly depth: number;
  readonly doppler: number;
  readonly velocity: number;
  /** Whether the surface's velocity varies: the rasterizer evaluates it at the emission event of each vertex, and interpolates. */
  readonly changing: boolean;
}

/** The claimed event as an event of the picture, with the time that its position implies. */
interface Truth {
  /** Observer → event, world frame [m]. */
  readonly dx: Vec3;
  /** [s] */
  readonly time: number;
  /** Position in the picture, from its top left [px]. */
  readonly x: number;
  readonly y: number;
  /** Apparent position on the camera's axes [m]. */
  readonly seen: Vec3;
}

const STEADY: readonly Motion['kind'][] = ['static', 'uniform'];

const NO_ERRORS = { time: 0, depth: 0, doppler: 0, velocity: 0, changing: false };
const WRONG: PixelVerdict = { right: false, displacement: Number.POSITIVE_INFINITY, ...NO_ERRORS };
const BACKGROUND: PixelVerdict = { right: true, displacement: 0, ...NO_ERRORS };

/** Half a step of f32, twice: both CPU and GPU round. */
const F32 = 2 ** -23;

/** Offsets of the ring search from the centre [px], on circles up to `MAX_DISPLACEMENT`. */
const RING: readonly (readonly [number, number])[] = [0.2, 0.35, 0.5].flatMap((share, k) =>
  Array.from({ length: 8 + 4 * k }, (_, i) => {
    const angle = (2 * Math.PI * (i + k / 3)) / (8 + 4 * k);
    return [2 * share * MAX_DISPLACEMENT * Math.cos(angle), 2 * share * MAX_DISPLACEMENT * Math.sin(angle)] as const;
  }),
);

/** Judges pixels of one picture by several rasterizers; rays are cached between them. */
export class PixelOracle {
  private readonly picture: RasterizedPicture;
  private readonly centers = new Map<number, Hit | undefined>();

  constructor(picture: RasterizedPicture) {
    this.picture = picture;
  }

  /** `pixel`: index, row by row. */
  judge(pixel: number, claim: PixelSample): PixelVerdict {
    const center = this.center(pixel);
    if (claim.object === 0) return this.judgeBackground(pixel, center);
    const own = center?.object === claim.object - 1 ? center : undefined;
    const truth = this.truth(claim);
    const [x, y] = this.placeOf(pixel);
    const displacement = truth.seen[2] < 0 ? Math.hypot(truth.x - x, truth.y - y) : Number.POSITIVE_INFINITY;
    if (!(displacement <= MAX_DISPLACEMENT)) return { ...WRONG, displacement };
    const hit = this.meeting(claim, truth, pixel, own);
    return hit ? this.compare(claim, truth, hit, displacement) : { ...WRONG, displacement };
  }

  /**
   * Whether a base colour is between the darkest and the brightest of the surface within a pixel, give or take `slack`: about the width of the
   * GPU's texture filter. Returns undefined if the pixel's neighbourhood is not of one object.
   */
  albedoFits(pixel: number, { object, albedo }: PixelSample, slack: number): boolean | undefined {
    const [x, y] = this.placeOf(pixel);
    const low = [1, 1, 1];
    const high = [0, 0, 0];
    for (let i = 0; i < 49; i++) {
      const hit = this.trace(x + (i % 7) / 3 - 1, y + Math.floor(i / 7) / 3 - 1);
      if (hit?.object !== object - 1) return undefined;
      const color = surfaceAt(this.picture.scene, hit).albedo;
      for (let k = 0; k < 3; k++) {
        low[k] = Math.min(low[k], color[k]);
        high[k] = Math.max(high[k], color[k]);
      }
    }
    return albedo.every((value, k) => value >= low[k] - slack && value <= high[k] + slack);
  }

  private judgeBackground(pixel: number, center: Hit | undefined): PixelVerdict {
    if (!center) return BACKGROUND;
    const [x, y] = this.placeOf(pixel);
    return RING.some(([dx, dy]) => !this.trace(x + dx, y + dy)) ? BACKGROUND : WRONG;
  }

  /** A ray within reach that hits the claimed point: at its true position, at the centre, or on a ring around the centre. */
  private meeting(claim: PixelSample, truth: Truth, pixel: number, own: Hit | undefined): Hit | undefined {
    if (own && this.samePoint(claim, truth, own)) return own;
    const [x, y] = this.placeOf(pixel);
    for (const [px, py] of [[truth.x, truth.y], ...RING.map(([dx, dy]) => [x + dx, y + dy])]) {
      const hit = this.trace(px, py);
      if (hit && hit.object === claim.object - 1 && this.samePoint(claim, truth, hit)) return hit;
    }
    return undefined;
  }

  /**
   * Whether the claimed point is on the hit surface: no farther from its plane, in its rest frame, than the footprint of `MAX_DISPLACEMENT` pixels.
   * (Along the plane it is as near as the two positions in the picture; lengths perpendicular to the line of sight are the same in all frames.)
   */
  private samePoint({ position }: PixelSample, { time, seen }: Truth, hit: Hit): boolean {
    const { view, settings, width, height } = this.picture;
    const between = fourVector(settings.speedOfLight * (time - hit.time), sub(position, hit.position));
    const offPlane = dot(hit.normal, spatial(boost(between, properVelocity(hit.velocity))));
    const pixel = 1 / pixelsPerTangent(frustumOf(perspectiveOf(view.lens), width, height), width, height);
    return Math.abs(offPlane) <= MAX_DISPLACEMENT * pixel * -seen[2];
  }

  private compare(claim: PixelSample, { dx, time, seen }: Truth, hit: Hit, displacement: number): PixelVerdict {
    const { scene, view, settings } = this.picture;
    const D = settings.view === 'light-cone' ? dopplerFactor(dx, view.u, properVelocity(hit.velocity)) : 1;
    // The AOV is f32, and world times can be large.
    const late = Math.max(0, Math.abs(claim.time - time) - F32 * Math.abs(time));
    return {
      right: true,
      displacement,
      time: (settings.speedOfLight * late) / length(dx),
      depth: Math.abs(claim.depth / length(seen) - 1),
      doppler: Math.abs(claim.doppler / D - 1),
      velocity: length(sub(claim.velocity, hit.velocity)),
      changing: !STEADY.includes(scene.objects[hit.object].motion.kind),
    };
  }

  private truth({ position }: PixelSample): Truth {
    const { view, settings } = this.picture;
    const dx = sub(position, view.position);
    const time = view.t + delayOf(dx, view.u, settings) / settings.speedOfLight;
    const seen = rotate(conjugate(view.orientation), shownAt(dx, view.u, settings));
    return { dx, time, seen, ...this.project(seen) };
  }

  private project([x, y, z]: Vec3): { x: number; y: number } {
    const { view, width, height } = this.picture;
    const { tanX, tanY, center } = frustumOf(perspectiveOf(view.lens), width, height);
    const [right, up] = [(x / -z - center[0]) / tanX, (y / -z - center[1]) / tanY];
    return { x: (width / 2) * (1 + right), y: (height / 2) * (1 - up) };
  }

  private center(pixel: number): Hit | undefined {
    if (!this.centers.has(pixel)) this.centers.set(pixel, this.trace(...this.placeOf(pixel)));
    return this.centers.get(pixel);
  }

  private placeOf(pixel: number): readonly [x: number, y: number] {
    const { width } = this.picture;
    return [(pixel % width) + 0.5, Math.floor(pixel / width) + 0.5];
  }

  private trace(x: number, y: number): Hit | undefined {
    const { scene, view, settings, width, height } = this.picture;
    return visibleHit(scene, cameraRay(view, settings, x, y, width, height)!);
  }
}

/** c(t − t_o) of an event at Δx on the view's light cone or slice [m]. */
function delayOf(dx: Vec3, u: Vec3, { view, lightDelay, coneSlope }: RenderSettings): number {
  if (view === 'simultaneity') return dot(velocity(u), dx);
  if (view === 'slice-to-cone') return timeOnCone(dx, u, coneSlope);
  return view === 'light-cone' && lightDelay ? -length(dx) : 0;
}

/** The time at which ct′ = −λr′ for an event at Δx, between the light cone and the slice. */
const timeOnCone = (dx: Vec3, u: Vec3, slope: number): number =>
  bisect(
    (ct) => {
      const [later, ...place] = boost(fourVector(ct, dx), u);
      return later + slope * length(place);
    },
    -length(dx),
    dot(velocity(u), dx),
  );

/** Position relative to the observer, on the world axes carried by the boost [m]. */
export function shownAt(dx: Vec3, u: Vec3, { view, aberration, coneSlope }: RenderSettings): Vec3 {
  if (view === 'simultaneity') return simultaneousPosition(dx, u);
  if (view === 'slice-to-cone') return spatial(boost(fourVector(timeOnCone(dx, u, coneSlope), dx), u));
  return view === 'light-cone' && aberration ? apparentPosition(dx, u) : dx;
}
