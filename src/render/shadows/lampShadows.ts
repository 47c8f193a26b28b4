import { dot, length, uniform } from 'three/tsl';
import { Vector4 } from 'three/webgpu';
import { velocity } from '../../physics/boost.ts';
import type { Float, Int } from '../../shaders/types.ts';
import type { Gpu } from '../device.ts';
import type { LampTable } from '../lampTable.ts';
import type { Sight } from '../sight.ts';
import { GoingLamps } from './goingLamps.ts';
import type { Event, ShadowLamp } from './receiver.ts';
import { RestingLamps } from './restingLamps.ts';
import type { Occluders } from './shadowMaps.ts';

/** Which light of lamps things hold back from each other: a lamp's, from where it was when it sent it out, past where they were when it passed. */
export class LampShadows {
  private readonly lamps: LampTable;
  private readonly taps: number;
  private readonly resting: RestingLamps;
  private readonly going: GoingLamps;
  /** How much later than where it ends light was sent out, per metre: along x, y, z of the world, and in any direction. */
  private readonly later = uniform(new Vector4());

  constructor(occluders: Occluders, lamps: LampTable, gpu: Gpu) {
    this.lamps = lamps;
    this.taps = occluders.detail.taps;
    this.resting = new RestingLamps(occluders, lamps.casting, gpu);
    this.going = new GoingLamps(occluders, lamps.casting, gpu);
  }

  passing(slot: Int | number, event: Event, lamp: ShadowLamp): Float | undefined {
    const { later, taps } = this;
    const moves = lamp.path.kind !== 'static';
    const beam = {
      ...lamp,
      later: dot(later.xyz, lamp.offset)
        .add(later.w.mul(length(lamp.offset)))
        .toVar(),
    };
    const still = moves ? undefined : this.resting.passing(slot, event, beam, taps);
    const gone = this.going.passing(slot, moves, event, beam, taps);
    return still && gone ? still.mul(gone) : (still ?? gone);
  }

  /** Makes the maps that a picture needs; false where samples of a deforming mesh have still to come. */
  update(sight: Sight): boolean {
    this.lamps.arrange(sight);
    const { casting } = this.lamps;
    this.later.value.set(...laterPerMetre(sight));
    this.resting.update(casting, sight);
    return this.going.update(casting, sight);
  }

  get isComplete(): boolean {
    return this.going.isComplete;
  }

  dispose(): void {
    this.resting.dispose();
    this.going.dispose();
  }
}

const laterPerMetre = ({ surface, u }: Sight): readonly [number, number, number, number] =>
  surface === 'past-light-cone' ? [0, 0, 0, -1] : surface === 'slice' ? [...velocity(u), 0] : [0, 0, 0, 0];
