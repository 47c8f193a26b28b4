import type { BoundingBox } from '../../../../scene/bounds/bounds.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { attribute, primSpec, uniform } from '../../layer/specs.ts';
import { floatTuples, ints, token } from '../../layer/values.ts';

type Segment = readonly [from: readonly number[], to: readonly number[]];

/** Thickness of lines, which OpenUSD draws a pixel wide, as a fraction of the longest one. */
const THICKNESS = 1 / 100;

/** Lines of length 1 along the axes. */
export const originAxes = (path: string, color: readonly number[]): PrimSpec =>
  lines(
    path,
    [0, 1, 2].map((axis) => [[0, 0, 0], [0, 1, 2].map((k) => (k === axis ? 1 : 0))]),
    color,
  );

/** The twelve edges of a box. */
export function boxEdges(path: string, { min, max }: BoundingBox, color: readonly number[]): PrimSpec {
  const corner = (i: number): number[] => [0, 1, 2].map((k) => ((i >> k) & 1 ? max : min)[k]);
  const segments: Segment[] = [];
  for (let i = 0; i < 8; i++)
    for (let k = 0; k < 3; k++) if (!((i >> k) & 1)) segments.push([corner(i), corner(i | (1 << k))]);
  return lines(path, segments, color);
}

function lines(path: string, segments: readonly Segment[], color: readonly number[]): PrimSpec {
  const longest = Math.max(...segments.map(([a, b]) => Math.hypot(...a.map((x, k) => x - b[k]!))));
  return primSpec(path, {
    type: 'BasisCurves',
    properties: [
      uniform('token', 'type', token('linear')),
      attribute('int[]', 'curveVertexCounts', ints(new Int32Array(segments.length).fill(2))),
      attribute('point3f[]', 'points', floatTuples('float3', Float32Array.from(segments.flat(2)))),
      attribute('float[]', 'widths', { type: 'float[]', data: Float32Array.of(longest * THICKNESS) }, CONSTANT),
      attribute('color3f[]', 'primvars:displayColor', floatTuples('float3', Float32Array.from(color)), CONSTANT),
    ],
  });
}

const CONSTANT = { metadata: new Map([['interpolation', token('constant')]]) };
