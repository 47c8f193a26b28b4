import { random } from '../../src/math/random.ts';
import { sphere } from '../../src/scene/mesh/primitives.ts';
import { type Part, paint } from './builder.ts';
import { join, moved, sized, turned } from './parts.ts';

/** A poplar or cypress: a trunk and a tall, slightly irregular crown. */
export function poplar(height: number, bark: number, leaf: number, seed = 1): Part {
  const next = random(seed);
  const outline = [
    [0.12, 0.1],
    [0.62, 0.17],
    [0.9, 0.3],
    [1, 0.44],
    [0.92, 0.58],
    [0.72, 0.73],
    [0.44, 0.87],
    [0.16, 0.97],
    [0, 1],
  ].map(([r, h]): [number, number] => [r * 0.095 * height * (0.93 + 0.14 * next()), h * height]);
  const trunk = turned(
    [
      [0.028 * height, 0],
      [0.018 * height, 0.2 * height],
    ],
    7,
  );
  return [paint(trunk, bark), paint(turned(outline, 11), leaf)];
}

/** A broad tree: a trunk and a crown of several spheres. */
export function broadTree(height: number, bark: number, leaf: number, seed = 1): Part {
  const next = random(seed);
  const trunk = turned(
    [
      [0.05 * height, 0],
      [0.03 * height, 0.2 * height],
      [0.025 * height, 0.6 * height],
    ],
    8,
  );
  const crown = Array.from({ length: 6 }, (_, i) => {
    const a = i * 2.4 + next();
    const out = i === 0 ? 0 : 0.2 * height;
    const r = (i === 0 ? 0.3 : 0.2 + 0.07 * next()) * height;
    const ball = sized(sphere(r, { segments: 12, rings: 7, axis: 'Y' }), [1, 0.82, 1]);
    return moved(ball, [out * Math.cos(a), (0.6 + 0.14 * next() + (i === 0 ? 0.1 : 0)) * height, out * Math.sin(a)]);
  });
  return [paint(trunk, bark), paint(join(crown), leaf)];
}
