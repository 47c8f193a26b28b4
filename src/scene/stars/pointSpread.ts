/**
 * Point spread function of an eye or camera: a core (Gaussian) and wings (Moffat 1969), per square pixel at r [px]
 * from the centre; its integral is 1.
 */
export const POINT_SPREAD = { core: 0.6, wings: 0.12, reach: 1.3, fall: 2 } as const;

/** Displayed radiance below which a pixel looks black. */
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

/** Radius at which a star of this radiance per pixel, after exposure, falls below `MIN_VISIBLE_RADIANCE` [px]. */
export function spreadRadius(radiance: number): number {
  const { wings, reach, fall } = POINT_SPREAD;
  const most = (radiance * wings * (fall - 1)) / (Math.PI * reach * reach);
  const r = reach * Math.sqrt(Math.max((most / MIN_VISIBLE_RADIANCE) ** (1 / fall) - 1, 0));
  return Math.min(Math.max(r, MIN_SPREAD_RADIUS), MAX_SPREAD_RADIUS);
}
