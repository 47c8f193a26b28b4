import { describe, expect, it } from 'vitest';
import { NODE_KINDS } from './nodes.ts';

/** The result of a node for values in the order of its inputs; those that are left out have their default. */
function resultOf(name: string, size: number, args: readonly (readonly number[])[], output = 'out'): readonly number[] {
  const { inputs, compute } = NODE_KINDS.get(name)!;
  return compute(size, output)(inputs.map(([, fallback], k) => args[k] ?? [fallback]));
}

describe('nodes of MaterialX', () => {
  it.each([
    ['add', [[1, 2, 3], [10]], [11, 12, 13]],
    [
      'subtract',
      [
        [1, 2, 3],
        [3, 2, 1],
      ],
      [-2, 0, 2],
    ],
    ['divide', [[1, 2, 3], [4]], [0.25, 0.5, 0.75]],
    ['modulo', [[-1, 5.5, 4], [4]], [3, 1.5, 0]],
    ['safepower', [[-8, 8, 0], [1 / 3]], [-2, 2, 0]],
    ['invert', [[0.25, 1, 2]], [0.75, 0, -1]],
    ['clamp', [[-1, 0.5, 2]], [0, 0.5, 1]],
    ['smoothstep', [[0, 0.25, 2]], [0, 0.15625, 1]],
    ['contrast', [[0, 0.5, 1], [2]], [-0.5, 0.5, 1.5]],
    ['remap', [[0, 0.5, 2], [0], [2], [1], [3]], [1, 1.5, 3]],
    ['range', [[0, 0.25, 2], [0], [1], [0], [2], [2], [1]], [0, 1, 2]],
    ['mix', [[1, 1, 1], [0, 0.5, 1], [0.25]], [0.25, 0.625, 1]],
    [
      'screen',
      [
        [0.5, 1, 0],
        [0.5, 0.5, 0.5],
      ],
      [0.75, 1, 0.5],
    ],
    [
      'overlay',
      [
        [0.5, 0.25, 0.75],
        [0.25, 0.5, 0.75],
      ],
      [0.25, 0.25, 0.875],
    ],
    [
      'burn',
      [
        [0.5, 0, 1],
        [0.75, 0.5, 0.25],
      ],
      [0.5, 0, 0.25],
    ],
    [
      'dodge',
      [
        [0.5, 1, 0],
        [0.25, 0.5, 0.25],
      ],
      [0.5, 0, 0.25],
    ],
    ['difference', [[1, 0, 0.5], [0.25, 0.25, 0.5], [0.5]], [0.5, 0.25, 0.25]],
    ['ifgreater', [[2], [1], [1, 2, 3], [4, 5, 6]], [1, 2, 3]],
    ['ifequal', [[2], [1], [1, 2, 3], [4, 5, 6]], [4, 5, 6]],
    ['switch', [[1.5], [1, 1, 1], [2, 2, 2]], [2, 2, 2]],
    ['combine3', [[1], [2], [3]], [1, 2, 3]],
    ['convert', [[0.5]], [0.5, 0.5, 0.5]],
    [
      'crossproduct',
      [
        [1, 0, 0],
        [0, 1, 0],
      ],
      [0, 0, 1],
    ],
    ['normalize', [[3, 0, 4]], [0.6, 0, 0.8]],
    ['saturate', [[1, 0, 0], [0], [0.25, 0.5, 0.25]], [0.25, 0.25, 0.25]],
    // Corners and middles of the colour wheel.
    ['rgbtohsv', [[1, 0, 0]], [0, 1, 1]],
    ['rgbtohsv', [[0.25, 0.5, 0.5]], [0.5, 0.5, 0.5]],
    ['hsvtorgb', [[1 / 3, 1, 1]], [0, 1, 0]],
    ['hsvtorgb', [[0.75, 0.5, 1]], [0.75, 0.5, 1]],
    [
      'hsvadjust',
      [
        [1, 0.5, 0.5],
        [1 / 3, 0.5, 1],
      ],
      [0.75, 1, 0.75],
    ],
  ] as const)('%s of %j', (name, args, expected) => {
    const found = resultOf(name, 3, args);
    expect(found).toHaveLength(3);
    for (const [k, x] of found.entries()) expect(x).toBeCloseTo(expected[k], 12);
  });

  it.each([
    [
      'dotproduct',
      [
        [1, 2, 3],
        [4, 5, 6],
      ],
      'out',
      32,
    ],
    ['magnitude', [[2, 3, 6]], 'out', 7],
    [
      'distance',
      [
        [1, 1, 1],
        [3, 4, 7],
      ],
      'out',
      7,
    ],
    ['extract', [[5, 6, 7], [1]], 'out', 6],
    ['separate3', [[5, 6, 7]], 'outz', 7],
    ['separate3', [[5, 6, 7]], 'outr', 5],
    ['luminance', [[1, 1, 0]], 'out', 0.2722287 + 0.6740818],
    ['and', [[1], [0]], 'out', 0],
    ['xor', [[1], [0]], 'out', 1],
    ['not', [[0]], 'out', 1],
  ] as const)('%s of %j', (name, args, output, expected) => {
    const [found] = resultOf(name, 1, args, output);
    expect(found).toBeCloseTo(expected, 12);
  });
});
