import { IDENTITY, type Mat4 } from '../../math/mat4.ts';
import { negate, type Vec3 } from '../../math/vec3.ts';
import { boostMatrix, gamma } from '../lorentz/boost.ts';
import { shallowPosition, slowed, slowedContraction } from '../worldLines/shallowCone.ts';
import { simultaneousPosition } from '../worldLines/simultaneity.ts';
import { apparentPosition } from './apparentPosition.ts';

/** Where a picture shows the events that it is made of. Δx: observer → event, world frame [m]; u: the observer's γβ; Δx′ on the world's axes carried by the pure boost. */
export interface Placement {
  /** Δx′. */
  position(dx: Vec3, u: Vec3): Vec3;
  /** Direction of the world's sky behind what is at Δx; any length. */
  skyDirection(dx: Vec3, u: Vec3): Vec3;
  /** The factor k of Y = Δx − k u (u·Δx), from which `boost` leads to Δx′. */
  contraction(u: Vec3): number;
  /** From (|Y|, Y) to (|Δx′|, Δx′). */
  boost(u: Vec3): Mat4;
}

/** As light brings it to the observer. docs/physics.md §3.3. */
const APPARENT: Placement = {
  position: apparentPosition,
  skyDirection: (dx) => dx,
  boost: (u) => boostMatrix(negate(u)),
  contraction: () => 0,
};

/** Where a moment of the observer's has it. docs/physics.md §5.5. */
const CONTRACTED: Placement = {
  position: simultaneousPosition,
  // A moment has the sky of the observer's own directions.
  skyDirection: simultaneousPosition,
  boost: () => IDENTITY,
  contraction(u) {
    const g = gamma(u);
    return 1 / (g * (g + 1));
  },
};

/** Where the world's frame has it. */
const PLAIN: Placement = {
  position: (dx) => dx,
  skyDirection: (dx) => dx,
  boost: () => IDENTITY,
  contraction: () => 0,
};

/** On the cone ct′ = −λr′. docs/physics.md §5.8. */
const shallow = (slope: number): Placement => ({
  position: (dx, u) => shallowPosition(dx, u, slope),
  // Infinitely far away is infinitely long ago, as in a moment.
  skyDirection: (dx, u) => shallowPosition(dx, u, slope),
  boost: (u) => boostMatrix(negate(slowed(u, slope))),
  contraction: (u) => slowedContraction(u, slope),
});

const PLACEMENTS = { apparent: APPARENT, contracted: CONTRACTED, plain: PLAIN } as const satisfies Readonly<
  Record<string, Placement>
>;
export type PlacementName = keyof typeof PLACEMENTS | 'shallow';

/** `coneSlope`: λ of the cone that `shallow` places on. */
export const placementOf = (name: PlacementName, coneSlope: number): Placement =>
  name === 'shallow' ? shallow(coneSlope) : PLACEMENTS[name];
