import type { Vec3 } from '../../math/vec3.ts';
import { aberrate, unaberrate } from '../../physics/optics/aberration.ts';
import { observerDoppler } from '../../physics/optics/doppler.ts';

/** The rest frame of something with proper velocity u = γβ: transforms directions n (unit, towards the source) from and to the world; D of light from n. */
export interface RestFrame {
  readonly u: Vec3;
  fromWorld(n: Vec3): Vec3;
  toWorld(nPrime: Vec3): Vec3;
  doppler(n: Vec3): number;
}

/** The rest frame of objects at rest in the world. */
export const WORLD_FRAME: RestFrame = { u: [0, 0, 0], fromWorld: (n) => n, toWorld: (n) => n, doppler: () => 1 };

/** Computes nothing for u = 0, since most surfaces are at rest. */
export const restFrame = (u: Vec3): RestFrame =>
  u[0] === 0 && u[1] === 0 && u[2] === 0
    ? WORLD_FRAME
    : {
        u,
        fromWorld: (n) => aberrate(n, u),
        toWorld: (n) => unaberrate(n, u),
        doppler: (n) => observerDoppler(n, u),
      };

/** D of light from n, emitted at rest in `source` and received at rest in `receiver`. */
export const dopplerBetween = (n: Vec3, receiver: RestFrame, source: RestFrame): number =>
  receiver === source ? 1 : receiver.doppler(n) / source.doppler(n);
