import { conjugate, rotate } from '../../src/math/quat.ts';
import { addScaled, dot, length, scale, sub, type Vec3 } from '../../src/math/vec3.ts';
import { apparentPosition } from '../../src/physics/apparent.ts';
import { boost, properVelocity } from '../../src/physics/boost.ts';
import { dopplerFactor } from '../../src/physics/doppler.ts';
import { fourVector, spatial } from '../../src/physics/fourVector.ts';
import { pastLightCone } from '../../src/physics/lightCone.ts';
import { simultaneitySlice, simultaneousPosition } from '../../src/physics/simultaneity.ts';
import { cameraRay } from '../../src/reference/camera.ts';
import { surfaceAt } from '../../src/reference/surface.ts';
import type { TracedScene } from '../../src/reference/trace.ts';
import type { Hit } from '../../src/reference/types.ts';
import { visibleHit } from '../../src/reference/visible.ts';
import type { RenderSettings, ViewPoint } from '../../src/scene/view.ts';

/*
 * Is a rasterized pixel right? It claims that an event of an object's surface (place, time, velocity) is seen at the pixel's centre. It is right
 * where that very point of the material is truly seen within `REACH` pixels of the centre; background likewise. Where the point is truly
 * seen follows from its world line alone, by the formulas of physics/; that the surface is there, and that nothing hides it, from rays of the reference.
 */

/** How far from the pixel's centre what it shows may truly be [px]: the goal of the whole renderer. */
export const REACH = 0.5;

/** One rasterized picture and what it is a picture of. */
export interface Picture {
  readonly scene: TracedScene;
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  readonly width: number;
  readonly height: number;
}

/** What a pixel says: its data AOVs. */
export interface Claim {
  /** Place in `Scene.objects` plus one; 0: background. */
  readonly object: number;
  readonly position: Vec3;
  readonly time: number;
  readonly doppler: number;
  /** World frame, units of c. */
  readonly velocity: Vec3;
  readonly albedo: Vec3;
}

export interface Verdict {
  readonly right: boolean;
  /** From the pixel's centre to where the claimed point is truly seen [px]; 0 for background, infinite where it is behind the camera. */
  readonly displacement: number;
  /** Errors of a right pixel's data. Time: of light's own way, c|Δt|/distance; D: relative; velocity: in units of c. */
  readonly time: number;
  readonly doppler: number;
  readonly velocity: number;
}

/** Where, when and how fast the claimed point of the material truly passes the surface of events that the picture is made of. */
interface Truth {
  /** Observer → event, world frame [m]. */
  readonly dx: Vec3;
  /** t − t_o [m of light]. */
  readonly ahead: number;
  /** In the picture, from its top left [px]. */
  readonly x: number;
  readonly y: number;
  /** Along the view's axis [m]; negative behind the camera. */
  readonly depth: number;
}

const WRONG: Verdict = { right: false, displacement: Number.POSITIVE_INFINITY, time: 0, doppler: 0, velocity: 0 };
const BACKGROUND: Verdict = { right: true, displacement: 0, time: 0, doppler: 0, velocity: 0 };

/** Where the ring search looks [px from the centre]: on circles up to `REACH`. */
const RING: readonly (readonly [number, number])[] = [0.2, 0.35, 0.5].flatMap((share, k) =>
  Array.from({ length: 8 + 4 * k }, (_, i) => {
    const angle = (2 * Math.PI * (i + k / 3)) / (8 + 4 * k);
    return [2 * share * REACH * Math.cos(angle), 2 * share * REACH * Math.sin(angle)] as const;
  }),
);

/** Judges the pixels of pictures of one thing by several rasterizers; a ray that two of them need is traced once. */
export class Judge {
  private readonly picture: Picture;
  private readonly centres = new Map<number, Hit | undefined>();

  constructor(picture: Picture) {
    this.picture = picture;
  }

  /** `pixel`: its place in the picture's rows. */
  judge(pixel: number, claim: Claim): Verdict {
    const centre = this.centre(pixel);
    if (claim.object === 0) return this.judgeBackground(pixel, centre);
    const own = centre?.object === claim.object - 1 ? centre : undefined;
    const truth = this.truth(claim, own?.velocity ?? claim.velocity);
    const [x, y] = this.placeOf(pixel);
    const displacement = truth.depth > 0 ? Math.hypot(truth.x - x, truth.y - y) : Number.POSITIVE_INFINITY;
    if (!(displacement <= REACH)) return { ...WRONG, displacement };
    const hit = this.meeting(claim, truth, pixel, own);
    return hit ? this.compare(claim, truth, hit, displacement) : { ...WRONG, displacement };
  }

  /**
   * Whether a base colour lies between the darkest and the brightest of the surface within a pixel around, give or take `slack`: the GPU reads
   * textures through a filter that is about so wide. undefined where the pixel's neighbourhood is not of one object.
   */
  albedoFits(pixel: number, { object, albedo }: Claim, slack: number): boolean | undefined {
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

  private judgeBackground(pixel: number, centre: Hit | undefined): Verdict {
    if (!centre) return BACKGROUND;
    const [x, y] = this.placeOf(pixel);
    return RING.some(([dx, dy]) => !this.trace(x + dx, y + dy)) ? BACKGROUND : WRONG;
  }

  /** A ray within reach that meets the claimed point: at the centre, where it is truly seen, else on a ring round the centre. */
  private meeting(claim: Claim, truth: Truth, pixel: number, own: Hit | undefined): Hit | undefined {
    if (own && this.samePoint(claim, truth, own)) return own;
    const [x, y] = this.placeOf(pixel);
    for (const [px, py] of [[truth.x, truth.y], ...RING.map(([dx, dy]) => [x + dx, y + dy])]) {
      const hit = this.trace(px, py);
      if (hit && hit.object === claim.object - 1 && this.samePoint(claim, truth, hit)) return hit;
    }
    return undefined;
  }

  /**
   * Whether the claimed point lies in the surface that the ray has met: no farther from its plane, in its rest frame, than the footprint of
   * `REACH` pixels. (Along the plane it is as near as the two places in the picture are; lengths across the line of sight are the same in all frames.)
   */
  private samePoint({ position, time }: Claim, { depth }: Truth, hit: Hit): boolean {
    const { view, settings, height } = this.picture;
    const between = fourVector(settings.speedOfLight * (time - hit.time), sub(position, hit.position));
    const offPlane = dot(hit.normal, spatial(boost(between, properVelocity(hit.velocity))));
    const pixel = (2 * Math.tan(view.fovY / 2)) / height;
    return Math.abs(offPlane) <= REACH * pixel * depth;
  }

  private compare(claim: Claim, { dx, ahead }: Truth, hit: Hit, displacement: number): Verdict {
    const { view, settings } = this.picture;
    const D = settings.view === 'light-cone' ? dopplerFactor(dx, view.u, properVelocity(hit.velocity)) : 1;
    const late = settings.speedOfLight * (claim.time - view.t) - ahead;
    return {
      right: true,
      displacement,
      time: Math.abs(late) / length(dx),
      doppler: Math.abs(claim.doppler / D - 1),
      velocity: length(sub(claim.velocity, hit.velocity)),
    };
  }

  /** The claimed point goes on as it went: over the tiny time between the claimed and the true event that is its world line. */
  private truth({ position, time }: Claim, beta: Vec3): Truth {
    const { view, settings } = this.picture;
    const c = settings.speedOfLight;
    const velocity = scale(beta, c);
    const line = { kind: 'uniform', position: addScaled(position, velocity, -time), velocity } as const;
    const { dx, ahead } = eventOf(line, view, settings);
    const seen = rotate(conjugate(view.orientation), shownAt(dx, view.u, settings));
    return { dx, ahead, ...this.project(seen), depth: -seen[2] };
  }

  private project([x, y, z]: Vec3): { x: number; y: number } {
    const { view, width, height } = this.picture;
    const focal = height / (2 * Math.tan(view.fovY / 2));
    return { x: width / 2 + (focal * x) / -z, y: height / 2 - (focal * y) / -z };
  }

  private centre(pixel: number): Hit | undefined {
    if (!this.centres.has(pixel)) this.centres.set(pixel, this.trace(...this.placeOf(pixel)));
    return this.centres.get(pixel);
  }

  private placeOf(pixel: number): readonly [x: number, y: number] {
    const { width } = this.picture;
    return [(pixel % width) + 0.5, Math.floor(pixel / width) + 0.5];
  }

  private trace(x: number, y: number): Hit | undefined {
    const { scene, view, settings, width, height } = this.picture;
    return visibleHit(scene, cameraRay(view, settings, x, y, width, height));
  }
}

type UniformLine = Extract<Parameters<typeof pastLightCone>[0], { kind: 'uniform' }>;

function eventOf(line: UniformLine, view: ViewPoint, settings: RenderSettings): { dx: Vec3; ahead: number } {
  const c = settings.speedOfLight;
  const seen = settings.view === 'light-cone' && settings.lightDelay ? pastLightCone(line, view, c) : undefined;
  if (seen) return { dx: seen.offset, ahead: -seen.delay };
  const { offset, ahead } = simultaneitySlice(line, view, settings.view === 'simultaneity' ? view.u : [0, 0, 0], c);
  return { dx: offset, ahead };
}

/** From the observer, on the world axes that the boost carries [m]. */
function shownAt(dx: Vec3, u: Vec3, { view, aberration }: RenderSettings): Vec3 {
  if (view === 'simultaneity') return simultaneousPosition(dx, u);
  return view === 'light-cone' && aberration ? apparentPosition(dx, u) : dx;
}
