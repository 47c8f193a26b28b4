/**
 * How a picture spreads a point of light, as an eye or a camera does: a core (Gauss) and wings (Moffat 1969), per square pixel at r [px]
 * from its middle; over the plane 1.
 */
export const POINT_SPREAD = { core: 0.6, wings: 0.12, reach: 1.3, fall: 2 } as const;

/** A pixel with less than this, as it is displayed, looks dark. */
const MIN_VISIBLE_RADIANCE = 2e-4;
/** [px] */
export const MAX_SPREAD_RADIUS = 48;
const MIN_SPREAD_RADIUS = 2.5;

export function pointSpread(r: number): number {
  const { core, wings, reach, fall } = POINT_SPREAD;
  const gauss = Math.exp(-(r * r) / (2 * core * core)) / (2 * Math.PI * core * core);
  const moffat = ((fall - 1) / (Math.PI * reach * reach)) * (1 + (r / reach) ** 2) ** -fall;
  return (1 - wings) * gauss + wings * moffat;
}

/** Where a star, of which a pixel would have all this radiance after exposure, is lost in the dark [px]. */
export function spreadRadius(radiance: number): number {
  const { wings, reach, fall } = POINT_SPREAD;
  const most = (radiance * wings * (fall - 1)) / (Math.PI * reach * reach);
  const r = reach * Math.sqrt(Math.max((most / MIN_VISIBLE_RADIANCE) ** (1 / fall) - 1, 0));
  return Math.min(Math.max(r, MIN_SPREAD_RADIUS), MAX_SPREAD_RADIUS);
}
