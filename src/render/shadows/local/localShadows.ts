import { dot, length, uniform } from 'three/tsl';
import { Vector4 } from 'three/webgpu';
import { HYPERSURFACES } from '../../../physics/worldLines/hypersurface.ts';
import { isStatic } from '../../../scene/motion/motion.ts';
import type { Float, Int } from '../../../shaders/types.ts';
import type { Observation } from '../../geometry/observation.ts';
import type { Gpu } from '../../gpu/device.ts';
import type { LightTable } from '../../lights/lightTable.ts';
import type { ReceiverEvent, ShadowedLight } from '../distant/parallelReceiver.ts';
import type { Occluders } from '../occluders.ts';
import { DynamicLocalShadows } from './dynamicLocalShadows.ts';
import { StaticLocalShadows } from './staticLocalShadows.ts';

/** Which light of local lights is occluded: each light's, from where it was when it sent it out, past where they were when it passed. */
export class LocalShadows {
  private readonly lights: LightTable;
  private readonly sampleCount: number;
  private readonly staticShadows: StaticLocalShadows;
  private readonly dynamicShadows: DynamicLocalShadows;
  /** How much later than where it ends light was sent out, per metre: along x, y, z of the world, and in any direction. */
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
    const beam = {
      ...light,
      emissionDelay: dot(emissionDelay.xyz, light.offset)
        .add(emissionDelay.w.mul(length(light.offset)))
        .toVar(),
    };
    const still = moves ? undefined : this.staticShadows.visibility(slot, event, beam, sampleCount);
    const gone = this.dynamicShadows.visibility(slot, moves, event, beam, sampleCount);
    return still && gone ? still.mul(gone) : (still ?? gone);
  }

  /** Makes the maps that a picture needs; false where samples of a deforming mesh have still to come. */
  update(sight: Observation): boolean {
    this.lights.selectShadowCasters(sight);
    const { shadowCasters } = this.lights;
    this.emissionDelay.value.set(...emissionDelayPerMeter(sight));
    this.staticShadows.update(shadowCasters, sight);
    return this.dynamicShadows.update(shadowCasters, sight);
  }

  get isComplete(): boolean {
    return this.dynamicShadows.isComplete;
  }

  dispose(): void {
    this.staticShadows.dispose();
    this.dynamicShadows.dispose();
  }
}

function emissionDelayPerMeter({ hypersurface, u }: Observation): readonly [number, number, number, number] {
  const { linear, radial } = HYPERSURFACES[hypersurface].timeGradient(u);
  return [...linear, radial];
}
