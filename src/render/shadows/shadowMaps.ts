import { dot, length, max, uniform, vec3 } from 'three/tsl';
import { Vector3 } from 'three/webgpu';
import { normalize, scale } from '../../math/vec3.ts';
import { gamma } from '../../physics/lorentz/boost.ts';
import { lightSurfaceOf } from '../../physics/worldLines/hypersurface.ts';
import { distantLightRadius } from '../../scene/lights/sceneLights.ts';
import type { Float, Int } from '../../shaders/types.ts';
import type { Observation } from '../geometry/observation.ts';
import type { Gpu } from '../gpu/device.ts';
import type { Environment } from '../lights/environment.ts';
import { DynamicDistantShadows } from './distant/dynamicDistantShadows.ts';
import {
  type LightVisibility,
  type ReceiverEvent,
  type ShadowedLight,
  type ShadowReceiver,
  sliceNormal,
} from './distant/parallelReceiver.ts';
import { StaticDistantShadows } from './distant/staticDistantShadows.ts';
import { LocalShadows } from './local/localShadows.ts';
import type { Occluders } from './occluders.ts';

/** Number of distant lights that throw shadows: the first of the environment. */
const MAX_DISTANT_LIGHTS = 2;

/**
 * All shadows of a scene, in retarded time. Bodies at rest are on maps that are redrawn only when the observer has moved on; each moving body has maps of its
 * own, in coordinates that move with it: there light travels straight, and one projection is exact for receivers at any time. Bodies that turn are drawn as
 * they are at the event of their centre.
 */
export class ShadowMaps implements LightVisibility {
  private readonly distantLights: number;
  private readonly sampleCount: number;
  private readonly staticDistant: StaticDistantShadows;
  private readonly dynamicDistant: DynamicDistantShadows;
  private readonly local: LocalShadows;
  /** Of the hypersurface on which light travels. */
  private readonly timeGradient = { linear: uniform(new Vector3()), radial: uniform(-1) };
  private readonly observerU = uniform(new Vector3());
  private readonly observerGamma = uniform(1);
  private readonly drawingError = uniform(0);

  constructor(occluders: Occluders, lights: Pick<Environment, 'distantLights' | 'localLights'>, gpu: Gpu) {
    const distantLights = lights.distantLights.lights.slice(0, MAX_DISTANT_LIGHTS).map((light) => ({
      direction: normalize(scale(light.direction, -1)),
      radius: distantLightRadius(light),
    }));
    this.distantLights = distantLights.length;
    this.sampleCount = occluders.detail.taps;
    this.staticDistant = new StaticDistantShadows(occluders, distantLights, gpu);
    this.dynamicDistant = new DynamicDistantShadows(occluders, distantLights, gpu);
    this.local = new LocalShadows(occluders, lights.localLights, gpu);
  }

  ofDistantLight(index: number | undefined, receiver: ShadowReceiver): Float | undefined {
    if (index === undefined || index >= this.distantLights) return undefined;
    const event = this.eventOf(receiver);
    const staticVisibility = this.staticDistant.visibility(index, event, this.sampleCount);
    const dynamicVisibility = this.dynamicDistant.visibility(index, event, this.sampleCount);
    return staticVisibility && dynamicVisibility
      ? staticVisibility.mul(dynamicVisibility)
      : (staticVisibility ?? dynamicVisibility);
  }

  ofLocalLight(slot: Int | number | undefined, receiver: ShadowReceiver, light: ShadowedLight): Float | undefined {
    if (slot === undefined) return undefined;
    return this.local.visibility(slot, this.eventOf(receiver), light);
  }

  private eventOf(receiver: ShadowReceiver): ReceiverEvent {
    const { dx, time, velocity } = receiver;
    const { linear, radial } = this.timeGradient;
    const distance = length(dx).toVar();
    const shift = dot(this.observerU, dx).div(max(distance, 1e-20)).add(this.observerGamma);
    return {
      dx,
      time,
      normal: sliceNormal(receiver).toVar(),
      velocity: velocity ? velocity.xyz : vec3(0),
      timeGradient: linear.add(dx.mul(radial.div(max(distance, 1e-20)))).toVar(),
      drawingError: distance.mul(max(shift, 1)).mul(this.drawingError).toVar(),
    };
  }

  /** Updates the maps for a picture. Returns false if samples of a deforming mesh are not loaded yet. */
  update(observation: Observation): boolean {
    const { linear, radial } = lightSurfaceOf(observation).timeGradient(observation.u);
    this.timeGradient.linear.value.set(...linear);
    this.timeGradient.radial.value = radial;
    this.observerU.value.set(...observation.u);
    this.observerGamma.value = gamma(observation.u);
    const isLocalComplete = this.local.update(observation);
    if (this.distantLights === 0) return isLocalComplete;
    this.staticDistant.update(observation.position);
    return this.dynamicDistant.update(observation) && isLocalComplete;
  }

  /** Sets how far surfaces may be drawn beside those that are seen [rad]; receivers are lifted by as much, so that they do not shade themselves. */
  allowFor(drawingError: number): void {
    this.drawingError.value = drawingError;
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
