import { normalize, scale } from '../../math/vec3.ts';
import { distantLightRadius } from '../../scene/lights/sceneLights.ts';
import type { Float, Int } from '../../shaders/types.ts';
import type { Observation } from '../geometry/observation.ts';
import type { Gpu } from '../gpu/device.ts';
import type { Environment } from '../lights/environment.ts';
import { DynamicDistantShadows } from './distant/dynamicDistantShadows.ts';
import {
  type LightVisibility,
  type ShadowedLight,
  type ShadowReceiver,
  sliceNormal,
} from './distant/parallelReceiver.ts';
import { StaticDistantShadows } from './distant/staticDistantShadows.ts';
import { LocalShadows } from './local/localShadows.ts';
import type { Occluders } from './occluders.ts';

/** So many suns throw shadows: the environment's first. */
const MAX_DISTANT_LIGHTS = 2;

/**
 * Which sunlight things hold back from each other, in retarded time. What rests is on maps that are made anew only where the observer has gone on;
 * every moving body has its own, in coordinates that move with it: there the light's way is straight, and one projection is right for the events
 * of all receivers, whenever they are. Bodies that turn, deform or accelerate are taken as they are at the event of their centre.
 */
export class ShadowMaps implements LightVisibility {
  private readonly distantLights: number;
  private readonly sampleCount: number;
  private readonly staticDistant: StaticDistantShadows;
  private readonly dynamicDistant: DynamicDistantShadows;
  private readonly local: LocalShadows;

  constructor(occluders: Occluders, lights: Pick<Environment, 'distantLights' | 'localLights'>, gpu: Gpu) {
    const suns = lights.distantLights.lights.slice(0, MAX_DISTANT_LIGHTS).map((light) => ({
      direction: normalize(scale(light.direction, -1)),
      radius: distantLightRadius(light),
    }));
    this.distantLights = suns.length;
    this.sampleCount = occluders.detail.taps;
    this.staticDistant = new StaticDistantShadows(occluders, suns, gpu);
    this.dynamicDistant = new DynamicDistantShadows(occluders, suns, gpu);
    this.local = new LocalShadows(occluders, lights.localLights, gpu);
  }

  ofDistantLight(sun: number | undefined, receiver: ShadowReceiver): Float | undefined {
    if (sun === undefined || sun >= this.distantLights) return undefined;
    const event = { dx: receiver.dx, time: receiver.time, normal: sliceNormal(receiver).toVar() };
    const still = this.staticDistant.visibility(sun, event, this.sampleCount);
    const moving = this.dynamicDistant.visibility(sun, event, this.sampleCount);
    return still && moving ? still.mul(moving) : (still ?? moving);
  }

  ofLocalLight(slot: Int | number | undefined, receiver: ShadowReceiver, light: ShadowedLight): Float | undefined {
    if (slot === undefined) return undefined;
    const event = { dx: receiver.dx, time: receiver.time, normal: sliceNormal(receiver).toVar() };
    return this.local.visibility(slot, event, light);
  }

  /** Makes the maps that a picture needs; false where samples of a deforming mesh have still to come. */
  update(sight: Observation): boolean {
    const isLocalComplete = this.local.update(sight);
    if (this.distantLights === 0) return isLocalComplete;
    this.staticDistant.update(sight.position);
    return this.dynamicDistant.update(sight) && isLocalComplete;
  }

  /** Whether all samples that the last maps need are on the GPU. */
  get isComplete(): boolean {
    return this.dynamicDistant.isComplete && this.local.isComplete;
  }

  dispose(): void {
    this.staticDistant.dispose();
    this.dynamicDistant.dispose();
    this.local.dispose();
  }
}
