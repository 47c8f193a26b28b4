import { describe, expect, it } from 'vitest';
import { scale } from '../../../math/vec3.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { OBSERVER_MARKS } from '../../../scene/frameGraph/effects.ts';
import { perspective } from '../../../scene/view/lenses/perspectiveLens.ts';
import { orbitCamera } from '../../../scene/view/outsideCamera.ts';
import { type AovName, DEFAULT_SETTINGS } from '../../../scene/view/view.ts';
import { applyEffect } from './applyEffect.ts';
import { FloatImage } from './effectInput.ts';

const SIZE = 201;
const CENTER = SIZE / 2;
const HEIGHT = 40;
const C = 10;
const FOV_Y = Math.PI / 3;
/** Pixels per metre at the observer, from the camera straight above him. */
const SCALE = SIZE / 2 / Math.tan(FOV_Y / 2) / HEIGHT;

/** From straight above: nothing, or a level surface that far below the observer [m], or above him. */
function fromAbove(args: readonly number[], beta: number, below = 0) {
  const { place, orientation } = orbitCamera(
    { distance: HEIGHT, azimuth: 0, elevation: Math.PI / 2, fovY: FOV_Y },
    [0, 1, 0],
  );
  const view = { t: 0, position: [3, 2, 1], u: properVelocity([0, 0, -beta]), lens: perspective(FOV_Y) } as const;
  const tangent = (i: number) => ((2 * i + 1) / SIZE - 1) * Math.tan(FOV_Y / 2);
  const depth = FloatImage.of(SIZE, SIZE, 1, (x, y) => [(HEIGHT + below) * Math.hypot(tangent(x), tangent(y), 1)]);
  const covered = FloatImage.of(SIZE, SIZE, 1, () => [below === 0 ? 0 : 1]);
  const aovs = new Map<AovName, Float64Array>([
    ['object', covered.values],
    ['depth', depth.values],
  ]);
  return applyEffect('observer-marks', args, {
    image: new FloatImage(SIZE, SIZE),
    aovs,
    view: { ...view, orientation },
    settings: { ...DEFAULT_SETTINGS, speedOfLight: C },
    zenith: [0, 1, 0],
    observer: scale(place, -1),
  });
}

/** Where the line from the middle to the right is brightest in red, between two radii [px]. */
function ringRadius(image: FloatImage, from: number, to: number): number {
  const values = Array.from(
    { length: Math.floor(to - from) },
    (_, i) => image.at(Math.floor(CENTER + from) + i, 100)[0]!,
  );
  const total = values.reduce((sum, value) => sum + value, 0);
  return values.reduce((sum, value, i) => sum + value * (i + Math.floor(from + CENTER) + 0.5 - CENTER), 0) / total;
}

describe('marks of the observer, from straight above', () => {
  it('are rings ncT about him, on the plane through him', () => {
    const image = fromAbove([1, 1, 0], 0);
    for (const n of [1, 2]) {
      const radius = n * C * SCALE;
      expect(ringRadius(image, radius - 6, radius + 6)).toBeCloseTo(radius, 1);
    }
    expect(Math.max(...image.values)).toBeLessThanOrEqual(1);
    expect(image.at(100, 100)).toEqual([0, 0, 0]);
  });

  it('on a floor below him are where it is ncT from him, √((ncT)² − h²) from below him', () => {
    const image = fromAbove([1, 1, 0], 0, 6);
    const radius = (Math.sqrt(C * C - 36) * SCALE * HEIGHT) / (HEIGHT + 6);
    // Across its width the distance is not quite linear in the picture.
    expect(Math.abs(ringRadius(image, radius - 5, radius + 5) - radius)).toBeLessThan(0.15);
  });

  it('are a disc where he is, and an arrow that ends βcT from him', () => {
    const image = fromAbove([1, 0, 5], 0.8);
    expect(image.at(100, 100)).toEqual([...OBSERVER_MARKS.body]);
    // −Z is up in the picture.
    const end = 0.8 * C * SCALE;
    expect(image.at(100, Math.floor(CENTER - end + 1))).toEqual([...OBSERVER_MARKS.arrow]);
    expect(image.at(100, Math.floor(CENTER - end - 3))).toEqual([0, 0, 0]);
    expect(image.at(100, Math.floor(CENTER + 8))).toEqual([0, 0, 0]);
    const rest = fromAbove([1, 0, 5], 0);
    expect(rest.at(100, Math.floor(CENTER - 8))).toEqual([0, 0, 0]);
  });

  it('are fainter behind surfaces', () => {
    const { body, edge, hidden } = OBSERVER_MARKS;
    const shown = fromAbove([1, 0, 5], 0, 6).at(100, 100);
    expect(shown).toEqual([...body]);
    const behind = fromAbove([1, 0, 5], 0, -6).at(100, 100);
    behind.forEach((value, k) => {
      expect(value).toBeCloseTo(hidden * body[k]! + (1 - hidden) * hidden * edge[k]!, 12);
    });
  });
});
