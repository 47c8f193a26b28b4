import { degrees, radians } from '../../../../../math/angle.ts';
import type { UvSource } from '../uvs.ts';

/** uv′ = M uv + offset of a primvar; an empty name is the default set. */
export interface UvAffine {
  readonly name: string;
  /** Row by row. */
  readonly matrix: readonly [number, number, number, number];
  readonly offset: readonly [number, number];
}

type Pair = readonly [number, number];

export const uvOf = (name: string): UvAffine => ({ name, matrix: [1, 0, 0, 1], offset: [0, 0] });

export const scaledUv = ({ name, matrix: [a, b, c, d], offset: [u, v] }: UvAffine, [x, y]: Pair): UvAffine => ({
  name,
  matrix: [a * x, b * x, c * y, d * y],
  offset: [u * x, v * y],
});

export const movedUv = (uv: UvAffine, [x, y]: Pair): UvAffine => ({
  ...uv,
  offset: [uv.offset[0] + x, uv.offset[1] + y],
});

/** Rotated counter-clockwise [degrees]. */
export function rotatedUv({ name, matrix: [a, b, c, d], offset: [u, v] }: UvAffine, angle: number): UvAffine {
  const [cos, sin] = [Math.cos(radians(angle)), Math.sin(radians(angle))];
  return {
    name,
    matrix: [cos * a - sin * c, cos * b - sin * d, sin * a + cos * c, sin * b + cos * d],
    offset: [cos * u - sin * v, sin * u + cos * v],
  };
}

interface Place2d {
  readonly pivot: Pair;
  readonly scale: Pair;
  /** Clockwise [degrees]. */
  readonly rotate: number;
  readonly offset: Pair;
  /** 0: scale, rotate, translate; 1: translate, rotate, scale. */
  readonly operationorder: number;
}

/** The node place2d. */
export function place2d(uv: UvAffine, { pivot, scale, rotate, offset, operationorder }: Place2d): UvAffine {
  const minus = ([x, y]: Pair): Pair => [-x, -y];
  const inverse: Pair = [1 / scale[0], 1 / scale[1]];
  const centred = movedUv(uv, minus(pivot));
  const placed =
    operationorder === 1
      ? scaledUv(rotatedUv(movedUv(centred, minus(offset)), -rotate), inverse)
      : movedUv(rotatedUv(scaledUv(centred, inverse), -rotate), minus(offset));
  return movedUv(placed, pivot);
}

/** The lookup by these coordinates; `sheared` where a scale after a rotation is left out. Undefined: the default set as it is. */
export function uvSource({ name, matrix: [a, b, c, d], offset }: UvAffine): { uv?: UvSource; sheared: boolean } {
  if (a === 1 && b === 0 && c === 0 && d === 1 && offset[0] === 0 && offset[1] === 0)
    return { ...(name !== '' && { uv: { name } }), sheared: false };
  // M = R(angle) · diag(scale), unless its columns are not perpendicular.
  const angle = Math.atan2(c, a);
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const scale: Pair = [Math.hypot(a, c), cos * d - sin * b];
  const sheared = Math.abs(cos * b + sin * d) > 1e-6 * (Math.abs(b) + Math.abs(d));
  return { uv: { name: name || 'st', transform: { scale, rotation: degrees(angle), translation: offset } }, sheared };
}
