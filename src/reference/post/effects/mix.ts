import { saturate } from '../../../math/saturate.ts';
import { INSET, type MixMode, WIPE_WIDTH } from '../../../scene/frameGraph/effects.ts';
import type { FloatImage } from './effectInput.ts';

type ChannelBlend = (a: number, b: number) => number;

const above = (value: number): number => Math.max(value - 1, 0);

/** 1 − (1 − a)(1 − b) of the parts within 0 … 1, plus the parts above 1. */
const screen: ChannelBlend = (a, b) => 1 - (1 - saturate(a)) * (1 - saturate(b)) + above(a) + above(b);

/** `multiply` where a < ½, otherwise `screen`, of the parts within 0 … 1, plus the part of a above 1. */
const overlay: ChannelBlend = (a, b) => {
  const [p, q] = [saturate(a), saturate(b)];
  return (p < 0.5 ? 2 * p * q : 1 - 2 * (1 - p) * (1 - q)) + above(a);
};

const BLENDS: Readonly<Record<MixMode, ChannelBlend>> = {
  normal: (_, b) => b,
  multiply: (a, b) => a * b,
  add: (a, b) => a + b,
  screen,
  overlay,
  difference: (a, b) => Math.abs(a - b),
  split: (_, b) => b,
  wipe: (_, b) => b,
  inset: (_, b) => b,
};

/** (1 − m s) a + m s B(a, b), with the mask m and the mode's weight s at the fraction `across` of the width. The size is that of `a`. */
export function mixImages(mode: MixMode, alpha: number, a: FloatImage, b: FloatImage, mask?: FloatImage): FloatImage {
  const shown = mode === 'inset' ? insetPicture(alpha, a, b) : undefined;
  return a.map((x, y) => {
    if (shown) {
      const weight = saturate(mask?.at(x, y)[0] ?? 1);
      const over = shown(x, y) ?? a.at(x, y);
      return a.at(x, y).map((value, c) => (1 - weight) * value + weight * over[c]!);
    }
    const weight = weightAt(mode, alpha, (x + 0.5) / a.width) * saturate(mask?.at(x, y)[0] ?? 1);
    const over = b.at(x, y);
    return a.at(x, y).map((value, c) => (1 - weight) * value + weight * BLENDS[mode](value, over[c]!));
  });
}

/** `split`: a to the left of alpha, b to the right. `wipe`: b enters from the left, behind a soft border. Otherwise alpha. */
function weightAt(mode: MixMode, alpha: number, across: number): number {
  if (mode === 'split') return across < alpha ? 0 : 1;
  if (mode === 'wipe') return saturate((alpha * (1 + WIPE_WIDTH) - across) / WIPE_WIDTH);
  return alpha;
}

/** The colour of the inset at a pixel: the mean of `b` over what the pixel covers of it, or the border; undefined outside. */
function insetPicture(
  share: number,
  a: FloatImage,
  b: FloatImage,
): (x: number, y: number) => readonly number[] | undefined {
  const { margin, border, color, samples } = INSET;
  const scale = a.height / 1080;
  const [width, height] = [share * a.width, share * a.height];
  const [left, top] = [a.width - margin * scale - width, a.height - margin * scale - height];
  const offsets = Array.from({ length: samples }, (_, i) => (i + 0.5) / samples);
  return (x, y) => {
    const [u, v] = [x + 0.5 - left, y + 0.5 - top];
    const outside = Math.max(-u, u - width, -v, v - height);
    if (!(share > 0) || outside > border * scale) return undefined;
    if (outside > 0) return color;
    const sum = [0, 0, 0];
    for (const j of offsets)
      for (const i of offsets)
        b.at(Math.floor((x + i - left) / share), Math.floor((y + j - top) / share)).forEach((value, c) => {
          sum[c]! += value / samples ** 2;
        });
    return sum;
  };
}
