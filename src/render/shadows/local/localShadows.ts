import { dot, length, uniform } from 'three/tsl';
import { Vector4 } from 'three/webgpu';
import { lightSurfaceOf } from '../../../physics/worldLines/hypersurface.ts';
import { isStatic } from '../../../scene/motion/motion.ts';
import type { Float, Int } from '../../../shaders/types.ts';
import type { Observation } from '../../geometry/observation.ts';
import type { Gpu } from '../../gpu/device.ts';
import type { LightTable } from '../../lights/lightTable.ts';
import type { ReceiverEvent, ShadowedLight } from '../distant/parallelReceiver.ts';
import type { Occluders } from '../occluders.ts';
import { DynamicLocalShadows } from './dynamicLocalShadows.ts';
import { StaticLocalShadows } from './staticLocalShadows.ts';

/** Shadows of local lights, in retarded time: from where a light was when it emitted, past where occluders were when its light passed them. */
export class LocalShadows {
  private readonly lights: LightTable;
  private readonly sampleCount: number;
  private readonly staticShadows: StaticLocalShadows;
  private readonly dynamicShadows: DynamicLocalShadows;
  /**
   * Emission time of light after that of the event it meets [m of light], per metre: a vector for the offset along x, y, z of the world, and a number for its
   * length.
   */
  private readonly emissionDelay = uniform(new Vector4());

  constructor(occluders: Occluders, lights: LightTable, gpu: Gpu) {
    this.lights = lights;
    this.sampleCount = occluders.detail.taps;
    this.staticShadows = new StaticLocalShadows(occluders, lights.shadowCasters, gpu);
    this.dynamicShadows = new DynamicLocalShadows(occluders, lights.shadowCasters, gpu);
  }

  visibility(slot: Int | number, event: ReceiverEvent, light: ShadowedLight): Float | undefined {
    const { emissionDelay, sampleCount } = this;
    const moves = !isStatic(light.motion);
    const incoming = {
      ...light,
      emissionDelay: dot(emissionDelay.xyz, light.offset)
        .add(emissionDelay.w.mul(length(light.offset)))
        .toVar(),
    };
    const staticVisibility = moves ? undefined : this.staticShadows.visibility(slot, event, incoming, sampleCount);
    const dynamicVisibility = this.dynamicShadows.visibility(slot, moves, event, incoming, sampleCount);
    return staticVisibility && dynamicVisibility
      ? staticVisibility.mul(dynamicVisibility)
      : (staticVisibility ?? dynamicVisibility);
  }

  /** Updates the maps for a picture. Returns false if samples of a deforming mesh are not loaded yet. */
  update(observation: Observation): boolean {
    this.lights.selectShadowCasters(observation);
    const { shadowCasters } = this.lights;
    this.emissionDelay.value.set(...emissionDelayPerMeter(observation));
    this.staticShadows.update(shadowCasters, observation);
    return this.dynamicShadows.update(shadowCasters, observation);
  }

  get isComplete(): boolean {
    return this.dynamicShadows.isComplete;
  }

  dispose(): void {
    this.staticShadows.dispose();
    this.dynamicShadows.dispose();
  }
}

function emissionDelayPerMeter(observation: Observation): readonly [number, number, number, number] {
  const { linear, radial } = lightSurfaceOf(observation).timeGradient(observation.u);
  return [...linear, radial];
}
