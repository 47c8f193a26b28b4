import { normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { sunRadius } from '../../scene/daylight.ts';
import type { Material } from '../../scene/types.ts';
import type { Float, Int } from '../../shaders/types.ts';
import type { Body } from '../bodies.ts';
import type { Gpu } from '../device.ts';
import type { Drawable } from '../drawable.ts';
import type { Environment } from '../environment.ts';
import type { FrameTables } from '../frame.ts';
import type { Sight } from '../sight.ts';
import type { ShadowDetail } from './detail.ts';
import { LampShadows } from './lampShadows.ts';
import { MovingShadows } from './movingShadows.ts';
import { type Receiver, type Shadowing, type ShadowLamp, sliceNormal } from './receiver.ts';
import { RestingShadows } from './restingShadows.ts';

/** So many suns throw shadows: the environment's first. */
const MOST_SUNS = 2;

/** What may be between a light and a surface. */
export interface Occluders {
  readonly bodies: readonly Body[];
  /** Of whole batches. */
  readonly drawables: readonly Drawable[];
  readonly materials: readonly Material[];
  readonly points: FrameTables['points'];
  readonly detail: ShadowDetail;
  /** Of the scene [m]. */
  readonly radius: number;
}

/** Unit, towards it; and the radius of its disc [rad]. */
export interface ShadowSun {
  readonly direction: Vec3;
  readonly radius: number;
}

/**
 * Which sunlight things hold back from each other, in retarded time. What rests is on maps that are made anew only where the observer has gone on;
 * every moving body has its own, in coordinates that move with it: there the light's way is straight, and one projection is right for the events
 * of all receivers, whenever they are. Bodies that turn, deform or accelerate are taken as they are at the event of their centre.
 */
export class ShadowMaps implements Shadowing {
  private readonly suns: number;
  private readonly taps: number;
  private readonly resting: RestingShadows;
  private readonly moving: MovingShadows;
  private readonly lamps: LampShadows;

  constructor(occluders: Occluders, lights: Pick<Environment, 'distantLights' | 'lamps'>, gpu: Gpu) {
    const suns = lights.distantLights.slice(0, MOST_SUNS).map((light) => ({
      direction: normalize(scale(light.direction, -1)),
      radius: sunRadius(light),
    }));
    this.suns = suns.length;
    this.taps = occluders.detail.taps;
    this.resting = new RestingShadows(occluders, suns, gpu);
    this.moving = new MovingShadows(occluders, suns, gpu);
    this.lamps = new LampShadows(occluders, lights.lamps, gpu);
  }

  share(sun: number | undefined, receiver: Receiver): Float | undefined {
    if (sun === undefined || sun >= this.suns) return undefined;
    const event = { dx: receiver.dx, time: receiver.time, normal: sliceNormal(receiver).toVar() };
    const still = this.resting.passing(sun, event, this.taps);
    const moving = this.moving.passing(sun, event, this.taps);
    return still && moving ? still.mul(moving) : (still ?? moving);
  }

  ofLamp(slot: Int | number | undefined, receiver: Receiver, lamp: ShadowLamp): Float | undefined {
    if (slot === undefined) return undefined;
    const event = { dx: receiver.dx, time: receiver.time, normal: sliceNormal(receiver).toVar() };
    return this.lamps.passing(slot, event, lamp);
  }

  /** Makes the maps that a picture needs; false where samples of a deforming mesh have still to come. */
  update(sight: Sight): boolean {
    const lamps = this.lamps.update(sight);
    if (this.suns === 0) return lamps;
    this.resting.update(sight.position);
    return this.moving.update(sight) && lamps;
  }

  /** Whether all samples that the last maps need are on the GPU. */
  get isComplete(): boolean {
    return this.moving.isComplete && this.lamps.isComplete;
  }

  dispose(): void {
    this.resting.dispose();
    this.moving.dispose();
    this.lamps.dispose();
  }
}
