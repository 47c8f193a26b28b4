import { fromMatrix } from '../../math/quat.ts';

/** Equatorial axes → those of a sky: the celestial north pole at +Y, the vernal equinox at −Z. */
export const EQUATORIAL = fromMatrix([0, -1, 0, 0, 0, 1, -1, 0, 0]);
