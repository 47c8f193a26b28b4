import type { Mesh } from '../../src/scene/types.ts';
import { block, quad } from './parts.ts';

/** Centred at x = 0; `back` and `front` are along z [m]. */
export interface Room {
  readonly half: number;
  readonly back: number;
  readonly front: number;
}

/** Its floor at a height [m]; uv 0 … 1 over the given number of metres. */
export function floorOf({ half, back, front }: Room, y: number, pattern: number): Mesh {
  const [u, v] = [(2 * half) / pattern, (front - back) / pattern];
  return quad([-half, y, front], [half, y, front], [half, y, back], [-half, y, back], u, v);
}

/** Walls on all four sides from one height to another, inset from the edge [m]; starting below the floor, so that no light leaks. */
export function wallsOf({ half, back, front }: Room, bottom: number, top: number, within = 0, thick = 0.2): Mesh[] {
  const [width, length, out] = [2 * (half + thick), front - back, thick / 2 - within];
  return [
    ...[back - out, front + out].map((z) => block(width, top - bottom, thick, 1, [0, bottom, z])),
    ...[-1, 1].map((side) => block(thick, top - bottom, length, 1, [side * (half + out), bottom, (back + front) / 2])),
  ];
}
