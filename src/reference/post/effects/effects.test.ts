import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../../math/quat.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { EFFECT_IDS, EFFECTS, type EffectId, MIX_MODES, type MixMode } from '../../../scene/frameGraph/effects.ts';
import { readShaderText } from '../../../scene/shaderText/shaderText.ts';
import { perspective } from '../../../scene/view/lenses/perspectiveLens.ts';
import { relativeLuminance } from '../../../scene/view/metering.ts';
import { type AovName, DEFAULT_SETTINGS, type ViewPoint } from '../../../scene/view/view.ts';
import { AOVS_OF_EFFECT_CHANNEL, AOVS_OF_SHADER_CHANNEL, applyEffect } from './applyEffect.ts';
import { type EffectInput, FloatImage, mirrorIndex } from './effectInput.ts';
import { mixImages } from './mix.ts';

const VIEW: ViewPoint = { t: 0, position: [1, 2, 3], u: [0, 0, 0], orientation: IDENTITY, lens: perspective(1) };
const BRIGHT = fc.double({ min: 0, max: 1e4, noNaN: true });

const pixels = (width: number, height: number) =>
  fc
    .array(BRIGHT, { minLength: 3 * width * height, maxLength: 3 * width * height })
    .map((values) => new FloatImage(width, height, 3, values));
const single = (width: number, height: number, x: number, y: number): FloatImage =>
  FloatImage.of(width, height, 3, (i, j) => (i === x && j === y ? [1, 1, 1] : [0, 0, 0]));
const flat = (width: number, height: number, value: number): FloatImage =>
  FloatImage.of(width, height, 3, () => [value, value, value]);

/** Everywhere a wall `depth` metres away along the axis that faces the observer, or nothing where that is 0. */
function wall(image: FloatImage, depth: (x: number, y: number) => number, view: ViewPoint = VIEW): EffectInput {
  const of = (channels: number, values: (d: number) => readonly number[]) =>
    FloatImage.of(image.width, image.height, channels, (x, y) => values(depth(x, y))).values;
  const aovs = new Map<AovName, Float64Array>([
    ['object', of(1, (d) => [d > 0 ? 1 : 0])],
    ['depth', of(1, (d) => [d])],
    ['normal', of(3, () => [0, 0, 1])],
    ['position', of(3, (d) => [view.position[0], view.position[1], view.position[2] - d])],
  ]);
  return { image, aovs, view, settings: DEFAULT_SETTINGS, zenith: [0, 1, 0] };
}

const effect = (
  id: EffectId,
  args: readonly number[],
  image: FloatImage,
  depth = (_x: number, _y: number) => 5,
): FloatImage => applyEffect(id, args, wall(image, depth));
const sum = ({ values }: FloatImage): number => values.reduce((a, b) => a + b, 0);
const expectEqual = (a: FloatImage, b: FloatImage, digits = 9): void =>
  a.values.forEach((value, i) => {
    expect(value / (1 + Math.abs(b.values[i]!)) - b.values[i]! / (1 + Math.abs(b.values[i]!))).toBeCloseTo(0, digits);
  });

describe('effects', () => {
  it('take at most four numbers, whose defaults are in their ranges', () => {
    for (const id of EFFECT_IDS) {
      expect(EFFECTS[id].args.length).toBeLessThanOrEqual(4);
      for (const { default: value, min, max } of EFFECTS[id].args) expect(value >= min && value <= max, id).toBe(true);
    }
  });

  it('read only the channels that they declare', () => {
    for (const id of EFFECT_IDS) {
      const input = wall(flat(6, 5, 1), () => 3);
      const names = new Set<AovName>(EFFECTS[id].reads.flatMap((channel) => AOVS_OF_EFFECT_CHANNEL[channel]));
      const aovs = new Map([...input.aovs].filter(([name]) => names.has(name)));
      const args = EFFECTS[id].args.map(({ default: value }) => value);
      expect(() => applyEffect(id, args, { ...input, aovs }), id).not.toThrow();
    }
  });

  it('clamp their numbers to their ranges', () => {
    const image = single(30, 30, 15, 15);
    expect(effect('gaussian-blur', [1e9, 0], image).values).toEqual(effect('gaussian-blur', [20, 0], image).values);
    expect(effect('bloom', [-1], image).values).toEqual(image.values);
  });

  it('written as text receive the channels that they read', () => {
    const input = wall(flat(6, 5, 1), (x) => (x < 3 ? 4 : 0));
    const program = readShaderText(`
fn effect(p: Pixel) -> vec4f {
  let o = vec2i(1, 0);
  return vec4f(depth(o) * arg2, dot(normal(o), vec3f(1)) + event(o).z, p.direction.x * 0 + image(o).x + p.position.y, 1);
}`);
    const names = new Set<AovName>(program.reads.flatMap((channel) => AOVS_OF_SHADER_CHANNEL[channel]));
    const aovs = new Map([...input.aovs].filter(([name]) => names.has(name)));
    const after = applyEffect(program, [0, 10], { ...input, aovs });
    expect(after.at(1, 2)).toEqual([40, 1 - 4, 3.5]);
    expect(after.at(2, 2)).toEqual([0, 0, 3.5]);
  });

  it('do nothing where the mask is 0, and apply fully where it is 1', () => {
    const image = single(8, 6, 3, 3);
    const mask = image.map((x) => [x < 4 ? 0 : 1, 0, 0]);
    const masked = applyEffect(
      'gaussian-blur',
      [1, 0],
      wall(image, () => 1),
      mask,
    );
    const whole = effect('gaussian-blur', [1, 0], image);
    for (let x = 0; x < 8; x++) expect(masked.at(x, 3)).toEqual((x < 4 ? image : whole).at(x, 3));
  });
});

describe('beyond its borders a picture', () => {
  it('is mirrored', () => {
    expect([-3, -2, -1, 0, 1, 2, 3, 4, 5].map((i) => mirrorIndex(i, 3))).toEqual([2, 1, 0, 0, 1, 2, 2, 1, 0]);
    expect([-1, 0, 1, 2].map((i) => mirrorIndex(i, 1))).toEqual([0, 0, 0, 0]);
  });
});

describe('the Gaussian', () => {
  it('preserves the sum, along rows and columns', () => {
    fc.assert(
      fc.property(pixels(16, 13), fc.constantFrom(0, 90, 180), fc.double({ min: 0, max: 4 }), (image, angle, sigma) => {
        expect(sum(effect('gaussian-blur', [sigma, angle], image)) / (sum(image) || 1)).toBeCloseTo(
          sum(image) ? 1 : 0,
          9,
        );
      }),
      { numRuns: 20 },
    );
  });

  it('along rows and then columns is the two-dimensional Gaussian', () => {
    const twice = effect('gaussian-blur', [2, 90], effect('gaussian-blur', [2, 0], single(31, 31, 15, 15)));
    const bell = (x: number) => Math.exp((-x * x) / 8);
    const norm = Array.from({ length: 13 }, (_, i) => bell(i - 6)).reduce((a, b) => a + b);
    for (const [x, y] of [
      [0, 0],
      [2, 1],
      [3, -5],
      [-6, 6],
    ] as const)
      expect(twice.at(15 + x, 15 + y)[0]).toBeCloseTo((bell(x) * bell(y)) / norm ** 2, 12);
    expect(twice.at(22, 15)).toEqual([0, 0, 0]);
  });

  it('has the same width in every direction', () => {
    for (const degrees of [0, 20, 45, 70, 90, 135]) {
      const blurred = effect('gaussian-blur', [3, degrees], single(41, 41, 20, 20));
      const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
      let [along, aside] = [0, 0];
      for (let y = 0; y < 41; y++)
        for (let x = 0; x < 41; x++) {
          const weight = blurred.at(x, y)[0]!;
          along += weight * ((x - 20) * c - (y - 20) * s) ** 2;
          aside += weight * ((x - 20) * s + (y - 20) * c) ** 2;
        }
      // Cut off at 3 σ, it is 1.4 % narrower.
      expect(Math.sqrt(along)).toBeCloseTo(3, 0);
      expect(Math.abs(Math.sqrt(along) / 3 - 0.986)).toBeLessThan(0.012);
      expect(Math.sqrt(aside)).toBeLessThan(0.5);
    }
  });
});

describe('the bilateral filter', () => {
  const step = (x: number) => (x < 8 ? 2 : 9);
  it('is the Gaussian without ranges', () => {
    fc.assert(
      fc.property(pixels(12, 9), (image) => {
        const gaussian = effect('gaussian-blur', [1.5, 90], effect('gaussian-blur', [1.5, 0], image));
        expectEqual(effect('bilateral-filter', [1.5, 0, 0], image, step), gaussian);
      }),
      { numRuns: 10 },
    );
  });

  it('smooths each side of an edge, and not across it', () => {
    const image = FloatImage.of(16, 9, 3, (x, y) => [0, 0, 0].map(() => (x < 8 ? 1 : 5) + ((x + y) % 2 ? 0.1 : -0.1)));
    const filtered = effect('bilateral-filter', [2, 0.05, 10], image, step);
    for (let x = 0; x < 16; x++) expect(Math.abs(filtered.at(x, 4)[0]! - (x < 8 ? 1 : 5))).toBeLessThan(0.02);
  });

  it('does not mix sky and surfaces', () => {
    const image = FloatImage.of(16, 9, 3, (x) => (x < 8 ? [1, 1, 1] : [7, 7, 7]));
    expectEqual(
      effect('bilateral-filter', [2, 1, 0], image, (x) => (x < 8 ? 2 : 0)),
      image,
    );
  });
});

describe('bloom', () => {
  it('conserves light', () => {
    fc.assert(
      fc.property(
        pixels(37, 22),
        fc.double({ min: 0, max: 1, noNaN: true }),
        fc.double({ min: 0, max: 1, noNaN: true }),
        (image, s, q) => {
          expect(sum(effect('bloom', [s, q], image)) / sum(image)).toBeCloseTo(1, 9);
        },
      ),
      { numRuns: 3 },
    );
  });

  it('at any size, wherever the light is', () => {
    const [width, height] = [83, 51];
    const image = flat(width, height, 2);
    expectEqual(effect('bloom', [0.5, 0.7], image), image);
    for (const [x, y] of [
      [0, 0],
      [40, 25],
      [82, 50],
      [82, 3],
    ] as const)
      expect(sum(effect('bloom', [1, 0.7], single(width, height, x, y)))).toBeCloseTo(3, 9);
  });

  it('is brightest at a light and falls off, symmetrically', () => {
    const glare = effect('bloom', [1, 0.7], single(128, 128, 63, 63));
    const along = [0, 4, 8, 16, 32, 60].map((r) => glare.at(63 + r, 63)[0]!);
    along.slice(1).forEach((value, i) => {
      expect(value).toBeLessThan(along[i]!);
    });
    expect(along[5]).toBeGreaterThan(0);
    expect(glare.at(64 + 9, 63)[0]! / glare.at(63, 64 + 9)[0]!).toBeCloseTo(1, 12);
  });
});

describe('sharpening', () => {
  it('does not change uniform areas, and without overshoot stays within the range of the neighbours', () => {
    expectEqual(effect('sharpen', [4, 1], flat(7, 7, 3)), flat(7, 7, 3));
    fc.assert(
      fc.property(pixels(7, 6), (image) => {
        const sharp = effect('sharpen', [3, 0], image);
        sharp.values.forEach((value, i) => {
          const [x, y] = [Math.floor(i / 3) % 7, Math.floor(i / 21)];
          const around = [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => image.at(x + dx, y + dy)[i % 3]!));
          expect(value >= Math.min(...around) - 1e-9 && value <= Math.max(...around) + 1e-9).toBe(true);
        });
      }),
      { numRuns: 10 },
    );
  });

  it('steepens an edge', () => {
    const ramp = FloatImage.of(9, 3, 3, (x) => [0, 0, 0].map(() => 1 / (1 + Math.exp(4 - x))));
    const sharp = effect('sharpen', [1, 1], ramp);
    expect(sharp.at(5, 1)[0]! - sharp.at(3, 1)[0]!).toBeGreaterThan(ramp.at(5, 1)[0]! - ramp.at(3, 1)[0]!);
  });
});

describe('a hue shift', () => {
  const shift = (angle: number, saturation: number, color: readonly number[]) =>
    effect(
      'hue-shift',
      [angle, saturation],
      FloatImage.of(1, 1, 3, () => color),
    ).at(0, 0) as [number, number, number];

  it('keeps the luminance, makes nothing negative, and leaves greys', () => {
    fc.assert(
      fc.property(
        fc.double({ min: -180, max: 180, noNaN: true }),
        fc.double({ min: 0, max: 4, noNaN: true }),
        pixels(3, 2),
        (angle, much, image) => {
          const after = effect('hue-shift', [angle, much], image);
          for (let i = 0; i < 6; i++) {
            const [before, turned] = [image, after].map(
              (of) => of.at(i % 3, Math.floor(i / 3)) as [number, number, number],
            );
            const light = relativeLuminance(...before!);
            expect(Math.abs(relativeLuminance(...turned!) - light)).toBeLessThanOrEqual(1e-9 * (1 + light));
            expect(Math.min(...turned!)).toBeGreaterThanOrEqual(-1e-9 * (1 + light));
          }
        },
      ),
    );
    for (const value of shift(77, 3, [0.4, 0.4, 0.4])) expect(value).toBeCloseTo(0.4, 12);
  });

  it('of 120° turns red to the green of the same luminance, and back', () => {
    // By hand: (r, g, b) → (b, r, g), then the grey that restores the luminance.
    const weights = [0.2126, 0.7152, 0.0722];
    const lightOf = (c: readonly number[]) => c.reduce((sum, x, k) => sum + x * weights[k]!, 0);
    const color = [0.5, 0.4, 0.45];
    const turned = [color[2]!, color[0]!, color[1]!];
    const gray = lightOf(color) - lightOf(turned);
    for (const [k, value] of shift(120, 1, color).entries()) expect(value).toBeCloseTo(turned[k]! + gray, 3);
    for (const [k, value] of shift(-70, 1, shift(70, 1, color)).entries()) expect(value).toBeCloseTo(color[k]!, 12);
    expect(shift(0, 0, color)[0]).toBeCloseTo(lightOf(color), 3);
  });
});

describe('fog', () => {
  it('transmits e^(−r/ℓ) of the light, r in the world frame', () => {
    const view = { ...VIEW, u: properVelocity([0, 0, -0.8]) };
    const input = wall(flat(3, 3, 10), () => 20, view);
    // The apparent distance, in the observer's frame, differs and is not used.
    const shifted = { ...input, aovs: new Map(input.aovs).set('depth', new Float64Array(9).fill(6.67)) };
    const [value] = applyEffect('fog', [10, 0, 0, 0], shifted).at(1, 1);
    expect(value).toBeCloseTo(10 * Math.exp(-2), 12);
  });

  it('hides distant surfaces, and the sky by the given opacity', () => {
    expect(effect('fog', [0.1, 2, 0, 0], flat(3, 3, 10), () => 1e3).at(1, 1)).toEqual([2, 2, 2]);
    expect(effect('fog', [10, 2, 0, 0.25], flat(3, 3, 10), () => 0).at(1, 1)).toEqual([8, 8, 8]);
  });

  it('takes a colour of its own, and leaves the sky to the sky background', () => {
    // I e^(−r/ℓ) + F (1 − e^(−r/ℓ)), by hand: r = ℓ ln 4, so a quarter of the light is left.
    const input = { ...wall(flat(3, 3, 10), (x) => (x < 2 ? 5 * Math.log(4) : 0)), fogColor: [1, 0.4, 0.2] } as const;
    const sky = applyEffect('sky-background', [1, 0.45, 0, 1], input).at(2, 1);
    for (const [k, color] of [1, 0.4, 0.2].entries()) {
      expect(applyEffect('fog', [5, 2, 0.5, 1], input).at(1, 1)[k]).toBeCloseTo(2.5 + 0.75 * 2 * color, 12);
      expect(applyEffect('fog', [5, 2, 0.5, 1], input).at(2, 1)[k]).toBeCloseTo(2 * color, 12);
      expect(applyEffect('sky-background', [2, 0.45, 5, 1], input).at(1, 1)[k]).toBeCloseTo(2.5 + 0.75 * 2 * color, 12);
      expect(applyEffect('sky-background', [2, 0.45, 5, 1], input).at(2, 1)[k]).toBeCloseTo(2 * sky[k]!, 12);
    }
  });

  it('fades into the colours of the scene’s sky: at infinity nothing is seen of a surface', () => {
    const sky = { zenith: [0.1, 0.2, 0.9], horizon: [0.9, 0.5, 0.3], ground: [0.05, 0.1, 0.02] } as const;
    const input = { ...wall(flat(9, 9, 10), () => 1e6), sky, fogColor: 'sky' } as const;
    const fogged = applyEffect('fog', [10, 1, 0.5, 1], input);
    for (const y of [0, 2, 6, 8]) {
      // Straight from the shape of the sky: the pixel's height is the sine of its elevation.
      const tangent = Math.tan(0.5) * (1 - (2 * y + 1) / 9);
      const height = tangent / Math.hypot(1, tangent);
      const fade = Math.min(-height / 0.35, 1);
      for (const [k, value] of fogged.at(4, y).entries()) {
        const up = sky.horizon[k]! + (sky.zenith[k]! - sky.horizon[k]!) * Math.max(height, 0) ** 0.45;
        const low = 0.8 * sky.horizon[k]!;
        const down = low + (sky.ground[k]! - low) * fade ** 2 * (3 - 2 * fade);
        expect(value).toBeCloseTo(height > 0 ? up : down, 9);
      }
    }
  });
});

describe('the sky background', () => {
  it('is drawn only where no surface is', () => {
    const sky = effect('sky-background', [1, 0.45, 0, 1], flat(9, 9, 0), (x) => (x < 4 ? 5 : 0));
    expect(sky.at(3, 4)).toEqual([0, 0, 0]);
    expect(relativeLuminance(...(sky.at(4, 4) as [number, number, number]))).toBeGreaterThan(0.2);
    expect(sky.at(8, 0)[2]! / sky.at(8, 0)[0]!).toBeGreaterThan(sky.at(8, 4)[2]! / sky.at(8, 4)[0]!);
  });

  it('fades surfaces into it with distance', () => {
    const faded = effect('sky-background', [0, 0.45, 10, 1], flat(3, 3, 1), () => 20);
    expect(faded.at(1, 1)[0]).toBeCloseTo(Math.exp(-2), 12);
  });
});

describe('the vignette', () => {
  it('is cos⁴ of the angle off the axis', () => {
    const dark = effect('vignette', [1, 4, 0], flat(3, 3, 1));
    const tan = Math.tan(0.5) * (2 / 3);
    expect(dark.at(1, 1)[0]).toBeCloseTo(1, 12);
    expect(dark.at(2, 1)[0]).toBeCloseTo(Math.cos(Math.atan(tan)) ** 4, 12);
    const corner = Math.hypot(tan, tan) / Math.hypot(Math.tan(0.5), Math.tan(0.5));
    const vignetted = effect('vignette', [1, 4, 60], flat(3, 3, 1)).at(2, 2)[0];
    expect(vignetted).toBeCloseTo(Math.cos(Math.atan(corner * Math.tan(Math.PI / 3))) ** 4, 12);
  });
});

describe('edges', () => {
  it('are at depth discontinuities, on the near side, and not on planes', () => {
    const lines = effect('edge', [0, 5, 0, 0], flat(12, 5, 1), (x) => (x < 6 ? 2 : 9));
    expect(Array.from({ length: 12 }, (_, x) => lines.at(x, 2)[0]! > 0.5)).toEqual(
      Array.from({ length: 12 }, (_, x) => x === 5),
    );
    // 1/z of a plane is linear in pixels.
    const plane = effect('edge', [0, 5, 0, 0], flat(12, 5, 1), (x) => 1 / (0.1 + 0.02 * x));
    for (let x = 1; x < 11; x++) expect(plane.at(x, 2)[0]).toBeCloseTo(0, 9);
  });

  it('of light do not depend on its brightness', () => {
    const image = (scale: number) => FloatImage.of(8, 4, 3, (x) => [0, 0, 0].map(() => (x < 4 ? 1 : 2) * scale));
    const [dim, bright] = [1e2, 1e4].map((scale) => effect('edge', [1, 0, 0, 0], image(scale)).at(4, 2)[0]!);
    expect(dim).toBeGreaterThan(0.1);
    expect(bright! / dim!).toBeCloseTo(1, 4);
  });
});

describe('depth of field', () => {
  const SIZE = 49;
  const focal = SIZE / (2 * Math.tan(0.5));
  /** A spot of 3 × 3 pixels in front of a wall, each at a depth along the axis. */
  const speck = (z: number, wallAt: number, args: readonly number[]) => {
    const middle = (SIZE - 1) / 2;
    const speckAt = (x: number, y: number) => Math.max(Math.abs(x - middle), Math.abs(y - middle)) <= 1;
    const image = FloatImage.of(SIZE, SIZE, 3, (x, y) => (speckAt(x, y) ? [1e4, 0, 0] : [0, 1, 0]));
    const along = (x: number, y: number) =>
      Math.hypot(
        1,
        ((x - middle) / middle) * Math.tan(0.5) * ((SIZE - 1) / SIZE),
        ((y - middle) / middle) * Math.tan(0.5) * ((SIZE - 1) / SIZE),
      );
    return effect('depth-of-field', args, image, (x, y) => (speckAt(x, y) ? z : wallAt * along(x, y)));
  };

  it('does not change surfaces in focus', () => {
    const image = FloatImage.of(9, 9, 3, (x, y) => [x, y, 1]);
    expectEqual(
      effect('depth-of-field', [5, 0, 16], image, () => 3),
      image,
    );
    const sharp = speck(5, 5, [5, 100, 16]);
    expect(sharp.at(24, 24)[0]).toBeCloseTo(1e4, 3);
    expect(sharp.at(27, 24)[0]).toBeCloseTo(0, 6);
  });

  it('spreads a spot to a disc of radius ½ A |1/f − 1/z| F', () => {
    const [z, f, aperture] = [2, 20, 0.8];
    const rho = (aperture / 2) * (1 / z - 1 / f) * focal;
    const disc = speck(z, 20, [f, 1000 * aperture, 24]);
    const lit = (from: number, to: number): number => {
      let count = 0;
      let all = 0;
      for (let y = 0; y < SIZE; y++)
        for (let x = 0; x < SIZE; x++) {
          const r = Math.hypot(x - 24, y - 24);
          if (r < from || r >= to) continue;
          all++;
          if (disc.at(x, y)[0]! > 0.01) count++;
        }
      return count / all;
    };
    expect(rho).toBeGreaterThan(7);
    expect(lit(0, rho - 1)).toBeGreaterThan(0.9);
    expect(lit(rho + 3, 24)).toBe(0);
  });

  it('does not spread a blurred background over a sharp foreground', () => {
    const image = FloatImage.of(33, 33, 3, (x) => (x < 16 ? [1, 0, 0] : [0, 9, 0]));
    const blurred = effect('depth-of-field', [2, 800, 12], image, (x) => (x < 16 ? 2 : 50));
    expect(blurred.at(14, 16)[1]).toBeLessThan(0.3);
    expect(blurred.at(20, 16)[1]).toBeGreaterThan(8);
  });
});

describe('mixing', () => {
  const same: readonly MixMode[] = ['normal', 'multiply', 'add', 'screen', 'overlay', 'difference'];
  it('gives the lower picture at alpha 0; mode normal gives the upper one at alpha 1', () => {
    fc.assert(
      fc.property(pixels(4, 3), pixels(4, 3), fc.constantFrom(...same), (a, b, mode) => {
        expect(mixImages(mode, 0, a, b).values).toEqual(a.values);
        expect(mixImages('normal', 1, a, b).values).toEqual(b.values);
      }),
      { numRuns: 30 },
    );
  });

  it('has the usual blend modes within 0 … 1', () => {
    const unit = fc.double({ min: 0, max: 1, noNaN: true });
    fc.assert(
      fc.property(unit, unit, (p, q) => {
        const of = (mode: MixMode) => mixImages(mode, 1, flat(1, 1, p), flat(1, 1, q)).values[0]!;
        expect(of('multiply')).toBeCloseTo(p * q, 12);
        expect(of('add')).toBeCloseTo(p + q, 12);
        expect(of('screen')).toBeCloseTo(p + q - p * q, 12);
        expect(of('overlay')).toBeCloseTo(p < 0.5 ? 2 * p * q : 1 - 2 * (1 - p) * (1 - q), 12);
        expect(of('difference')).toBeCloseTo(Math.abs(p - q), 12);
      }),
    );
  });

  it('never darkens light above 1 by screen or overlay', () => {
    fc.assert(
      fc.property(BRIGHT, BRIGHT, (p, q) => {
        const of = (mode: MixMode, a: number, b: number) => mixImages(mode, 1, flat(1, 1, a), flat(1, 1, b)).values[0]!;
        expect(of('screen', p, q)).toBeGreaterThanOrEqual(Math.max(p, q) * (1 - 1e-12) - 1e-12);
        expect(of('screen', p, q)).toBeCloseTo(of('screen', q, p), 9);
        expect(of('overlay', 1 + p, q)).toBeCloseTo(1 + p, 9);
      }),
    );
  });

  it('splits at a pixel, and wipes from one picture to the other', () => {
    const [a, b] = [flat(10, 2, 0), flat(10, 2, 1)];
    expect(Array.from({ length: 10 }, (_, x) => mixImages('split', 0.3, a, b).at(x, 0)[0])).toEqual([
      0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    ]);
    expect(mixImages('wipe', 0, a, b).values).toEqual(a.values);
    expect(mixImages('wipe', 1, a, b).values).toEqual(b.values);
    const half = mixImages('wipe', 0.5, flat(100, 1, 0), flat(100, 1, 1));
    expect([10, 90].map((x) => half.at(x, 0)[0])).toEqual([1, 0]);
    expect(half.at(50, 0)[0]).toBeCloseTo(0.45, 9);
  });

  it('applies a mask', () => {
    const [a, b] = [flat(4, 1, 1), flat(4, 1, 3)];
    const mask = new FloatImage(4, 1, 3, [-1, 0, 0, 0, 0, 0, 0.5, 0, 0, 2, 0, 0]);
    for (const mode of MIX_MODES.filter((m) => m === 'add' || m === 'normal'))
      expect(Array.from({ length: 4 }, (_, x) => mixImages(mode, 1, a, b, mask).at(x, 0)[0])).toEqual(
        mode === 'add' ? [1, 1, 2.5, 4] : [1, 1, 2, 3],
      );
  });
});
