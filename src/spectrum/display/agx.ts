import { multiply, transform } from '../../math/mat3.ts';
import type { Vec3 } from '../../math/vec3.ts';

/** Linear sRGB ↔ linear Rec. 2020, with the digits that the curve was fitted with. */
const FROM_SRGB = [0.6274, 0.3293, 0.0433, 0.0691, 0.9195, 0.0113, 0.0164, 0.088, 0.8956];
const TO_SRGB = [1.6605, -0.5876, -0.0728, -0.1246, 1.1329, -0.0083, -0.0182, -0.1006, 1.1187];

const INSET = [
  0.856627153315983, 0.0951212405381588, 0.0482516061458583, 0.137318972929847, 0.761241990602591, 0.101439036467562,
  0.11189821299995, 0.0767994186031903, 0.811302368396859,
];
const OUTSET = [
  1.1271005818144368, -0.11060664309660323, -0.016493938717834573, -0.1413297634984383, 1.157823702216272,
  -0.016493938717834257, -0.14132976349843826, -0.11060664309660294, 1.2519364065950405,
];

/**
 * AgX: log₂ of the light through a sigmoid, in primaries moved towards white, so that bright light fades to white as on film, without
 * the edges of clipping. `inset`: linear sRGB → those primaries, inside Rec. 2020; `outset`: back to Rec. 2020, where the curve's signal is
 * raised to the display's `exponent`; `toSrgb`: to linear sRGB. `stops`: range of log₂(light) that is shown [EV]; `sigmoid`: coefficients from
 * the constant up. docs/physics.md §8.1. Source: T. Sobotka, AgX (2022), with the primaries of Blender 4.0; polynomial by
 * B. Wrensch, "Minimal AgX Implementation" (iolite-engine.com, 2023).
 */
export const AGX = {
  inset: multiply(INSET, FROM_SRGB),
  stops: [-12.47393, 4.026069],
  sigmoid: [-0.00232, 0.1191, 0.4298, -6.868, 31.96, -40.14, 15.5],
  outset: OUTSET,
  exponent: 2.2,
  toSrgb: TO_SRGB,
} as const;

/** Exposed linear sRGB → linear sRGB to display, each in 0…1. */
export function agx(rgb: Vec3): Vec3 {
  const [least, most] = AGX.stops;
  const stops = each(transform(AGX.inset, rgb), (light) => Math.log2(Math.max(light, 1e-10)));
  const signal = each(stops, (ev) => sigmoid(clamp((ev - least) / (most - least))));
  const light = each(transform(AGX.outset, signal), (value) => Math.max(value, 0) ** AGX.exponent);
  return each(transform(AGX.toSrgb, light), clamp);
}

/** Position within the stops, 0…1 → display signal 0…1. */
export const sigmoid = (x: number): number =>
  AGX.sigmoid.reduceRight<number>((sum, coefficient) => sum * x + coefficient, 0);

const clamp = (value: number): number => Math.min(Math.max(value, 0), 1);
const each = ([a, b, c]: Vec3, f: (value: number) => number): Vec3 => [f(a), f(b), f(c)];
