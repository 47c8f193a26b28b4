import type { Compute } from './expression.ts';

/** A node that computes values from values, alike everywhere. */
export interface NodeKind {
  /** Inputs in the order of `compute`, with the values of those that are not written. */
  readonly inputs: readonly (readonly [name: string, fallback: number])[];
  /** For results of `size` numbers; `output` is the name of the output. */
  compute(size: number, output: string): Compute;
}

type Values = readonly number[];

/** Applied to each component; a single number counts for all. */
const each = (inputs: NodeKind['inputs'], f: (...args: number[]) => number): NodeKind => ({
  inputs,
  compute: (size) => (args) =>
    Array.from({ length: size }, (_, k) => f(...args.map((values) => values[Math.min(k, values.length - 1)]))),
});

/** Applied to the inputs as a whole. */
const whole = (
  inputs: NodeKind['inputs'],
  f: (args: readonly Values[], size: number, output: string) => Values,
): NodeKind => ({ inputs, compute: (size, output) => (args) => f(args, size, output) });

const IN = [['in', 0]] as const;
const PAIR = [
  ['in1', 0],
  ['in2', 0],
] as const;
const RATIO = [
  ['in1', 0],
  ['in2', 1],
] as const;
const BLEND = [
  ['fg', 0],
  ['bg', 0],
  ['mix', 1],
] as const;
const COMPARED = [
  ['value1', 1],
  ['value2', 0],
  ['in1', 0],
  ['in2', 0],
] as const;
const RANGE = [
  ['in', 0],
  ['inlow', 0],
  ['inhigh', 1],
  ['outlow', 0],
  ['outhigh', 1],
] as const;

const clamp = (x: number, low: number, high: number): number => Math.min(Math.max(x, low), high);
const mix = (a: number, b: number, t: number): number => a * (1 - t) + b * t;
const remap = (x: number, a: number, b: number, c: number, d: number): number => c + ((x - a) * (d - c)) / (b - a);
const blend = (f: (fg: number, bg: number) => number) => each(BLEND, (fg, bg, t) => mix(bg, f(fg, bg), t));
const compared = (f: (a: number, b: number) => boolean) => each(COMPARED, (a, b, x, y) => (f(a, b) ? x : y));
const logic = (f: (a: boolean, b: boolean) => boolean) => each(PAIR, (a, b) => Number(f(a !== 0, b !== 0)));
const dotOf = (a: Values, b: Values): number => a.reduce((sum, x, k) => sum + x * (b[k] ?? 0), 0);
const luminance = ([color, weights]: readonly Values[]): number => dotOf(color.slice(0, 3), weights);
/** Weights of ACEScg, MaterialX's default for luminance. */
const LUMA: Values = [0.2722287, 0.6740818, 0.0536895];
const orLuma = (args: readonly Values[], k: number): Values => (args[k].length === 3 ? args[k] : LUMA);

const CHANNELS = 'rgbaxyzw';
/** `rgb`, `x`, `r01` … of a value. */
export const channelIndices = (channels: string): number[] => [...channels].map((c) => CHANNELS.indexOf(c) % 4);

const combined = (count: number): NodeKind =>
  whole(
    Array.from({ length: count }, (_, k) => [`in${k + 1}`, 0] as const),
    (args, size) => args.flat().slice(0, size),
  );

/** By the name of the node in MaterialX's standard library. */
export const NODE_KINDS: ReadonlyMap<string, NodeKind> = new Map<string, NodeKind>([
  ['constant', each([['value', 0]], (x) => x)],
  ['dot', each(IN, (x) => x)],
  ['add', each(PAIR, (a, b) => a + b)],
  ['subtract', each(PAIR, (a, b) => a - b)],
  ['multiply', each(RATIO, (a, b) => a * b)],
  ['divide', each(RATIO, (a, b) => a / b)],
  ['modulo', each(RATIO, (a, b) => a - b * Math.floor(a / b))],
  ['power', each(RATIO, (a, b) => a ** b)],
  ['safepower', each(RATIO, (a, b) => Math.sign(a) * Math.abs(a) ** b)],
  ['min', each(PAIR, Math.min)],
  ['max', each(PAIR, Math.max)],
  ['absval', each(IN, Math.abs)],
  ['floor', each(IN, Math.floor)],
  ['ceil', each(IN, Math.ceil)],
  ['round', each(IN, Math.round)],
  ['fract', each(IN, (x) => x - Math.floor(x))],
  ['sign', each(IN, Math.sign)],
  ['sin', each(IN, Math.sin)],
  ['cos', each(IN, Math.cos)],
  ['tan', each(IN, Math.tan)],
  ['asin', each(IN, Math.asin)],
  ['acos', each(IN, Math.acos)],
  [
    'atan2',
    each(
      [
        ['iny', 0],
        ['inx', 1],
      ],
      Math.atan2,
    ),
  ],
  ['sqrt', each(IN, Math.sqrt)],
  ['ln', each([['in', 1]], Math.log)],
  ['exp', each(IN, Math.exp)],
  [
    'invert',
    each(
      [
        ['in', 0],
        ['amount', 1],
      ],
      (x, amount) => amount - x,
    ),
  ],
  [
    'clamp',
    each(
      [
        ['in', 0],
        ['low', 0],
        ['high', 1],
      ],
      clamp,
    ),
  ],
  [
    'smoothstep',
    each(
      [
        ['in', 0],
        ['low', 0],
        ['high', 1],
      ],
      (x, low, high) => {
        const t = clamp((x - low) / (high - low), 0, 1);
        return t * t * (3 - 2 * t);
      },
    ),
  ],
  [
    'contrast',
    each(
      [
        ['in', 0],
        ['amount', 1],
        ['pivot', 0.5],
      ],
      (x, amount, pivot) => (x - pivot) * amount + pivot,
    ),
  ],
  ['remap', each(RANGE, remap)],
  [
    'range',
    each([...RANGE, ['gamma', 1], ['doclamp', 0]], (x, a, b, c, d, gamma, doClamp) => {
      const t = remap(x, a, b, 0, 1);
      const y = remap(Math.sign(t) * Math.abs(t) ** (1 / gamma), 0, 1, c, d);
      return doClamp ? clamp(y, c, d) : y;
    }),
  ],
  [
    'mix',
    each(
      [
        ['fg', 0],
        ['bg', 0],
        ['mix', 0],
      ],
      (fg, bg, t) => mix(bg, fg, t),
    ),
  ],
  ['plus', blend((fg, bg) => bg + fg)],
  ['minus', blend((fg, bg) => bg - fg)],
  ['difference', blend((fg, bg) => Math.abs(bg - fg))],
  ['screen', blend((fg, bg) => 1 - (1 - fg) * (1 - bg))],
  ['overlay', blend((fg, bg) => (bg >= 0.5 ? 1 - 2 * (1 - fg) * (1 - bg) : 2 * fg * bg))],
  ['burn', each(BLEND, (fg, bg, t) => (Math.abs(fg) < 1e-6 ? 0 : mix(bg, 1 - (1 - bg) / fg, t)))],
  ['dodge', each(BLEND, (fg, bg, t) => (Math.abs(1 - fg) < 1e-6 ? 0 : mix(bg, bg / (1 - fg), t)))],
  [
    'inside',
    each(
      [
        ['in', 0],
        ['mask', 1],
      ],
      (x, mask) => x * mask,
    ),
  ],
  [
    'outside',
    each(
      [
        ['in', 0],
        ['mask', 0],
      ],
      (x, mask) => x * (1 - mask),
    ),
  ],
  ['ifgreater', compared((a, b) => a > b)],
  ['ifgreatereq', compared((a, b) => a >= b)],
  ['ifequal', each([['value1', 0], ...COMPARED.slice(1)], (a, b, x, y) => (a === b ? x : y))],
  ['and', logic((a, b) => a && b)],
  ['or', logic((a, b) => a || b)],
  ['xor', logic((a, b) => a !== b)],
  ['not', each(IN, (x) => Number(x === 0))],
  [
    'switch',
    each(
      [['which', 0], ...Array.from({ length: 10 }, (_, k) => [`in${k + 1}`, 0] as const)],
      (which, ...cases) => cases[Math.floor(which)] ?? 0,
    ),
  ],
  ['combine2', combined(2)],
  ['combine3', combined(3)],
  ['combine4', combined(4)],
  [
    'extract',
    whole(
      [
        ['in', 0],
        ['index', 0],
      ],
      ([values, [index]]) => [values[Math.floor(index)] ?? 0],
    ),
  ],
  ...['separate2', 'separate3', 'separate4'].map(
    (name) => [name, whole(IN, ([values], _, output) => [values[channelIndices(output.slice(-1))[0]] ?? 0])] as const,
  ),
  [
    'convert',
    // A number fills all components; an added alpha is 1, as in convert_color3_color4.
    whole(IN, ([values], size) =>
      Array.from({ length: size }, (_, k) => (values.length === 1 ? values[0] : (values[k] ?? (k === 3 ? 1 : 0)))),
    ),
  ],
  ['dotproduct', whole(PAIR, ([a, b]) => [dotOf(a, b)])],
  [
    'crossproduct',
    whole(PAIR, ([a, b]) => [0, 1, 2].map((k) => a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])),
  ],
  ['magnitude', whole(IN, ([a]) => [Math.hypot(...a)])],
  ['distance', whole(PAIR, ([a, b]) => [Math.hypot(...a.map((x, k) => x - b[k]))])],
  ['normalize', whole(IN, ([a]) => a.map((x) => x / (Math.hypot(...a) || 1)))],
  [
    'luminance',
    whole(
      [
        ['in', 0],
        ['lumacoeffs', 0],
      ],
      (args, size) => {
        const grey = luminance([args[0], orLuma(args, 1)]);
        return Array.from({ length: size }, (_, k) => (k === 3 ? args[0][3] : grey));
      },
    ),
  ],
  [
    'saturate',
    whole(
      [
        ['in', 0],
        ['amount', 1],
        ['lumacoeffs', 0],
      ],
      (args) => {
        const grey = luminance([args[0], orLuma(args, 2)]);
        return args[0].map((x, k) => (k === 3 ? x : mix(grey, x, args[1][0])));
      },
    ),
  ],
  ['rgbtohsv', whole(IN, ([color]) => [...hsvOf(color), ...color.slice(3)])],
  ['hsvtorgb', whole(IN, ([color]) => [...rgbOf(color), ...color.slice(3)])],
  [
    'hsvadjust',
    whole(
      [
        ['in', 0],
        ['amount', 1],
      ],
      ([color, [dh, s, v]]) => {
        const [hue, saturation, value] = hsvOf(color);
        return [...rgbOf([hue + dh, saturation * s, value * v]), ...color.slice(3)];
      },
    ),
  ],
  ['premult', whole(IN, ([[r, g, b, a]]) => [r * a, g * a, b * a, a])],
  ['unpremult', whole(IN, ([[r, g, b, a]]) => (a === 0 ? [r, g, b, a] : [r / a, g / a, b / a, a]))],
]);

function hsvOf([r, g, b]: Values): [number, number, number] {
  const value = Math.max(r, g, b);
  const chroma = value - Math.min(r, g, b);
  if (chroma === 0) return [0, 0, value];
  const sector = value === r ? (g - b) / chroma : value === g ? 2 + (b - r) / chroma : 4 + (r - g) / chroma;
  const hue = sector / 6;
  return [hue - Math.floor(hue), value > 0 ? chroma / value : 0, value];
}

function rgbOf([hue, saturation, value]: Values): [number, number, number] {
  const at = (shift: number): number => {
    const k = (shift + 6 * (hue - Math.floor(hue))) % 6;
    return value - value * saturation * clamp(Math.min(k, 4 - k), 0, 1);
  };
  return [at(5), at(3), at(1)];
}

/** Patterns that have no texture, and their means, which stand for them. */
export const PATTERN_MEANS: ReadonlyMap<string, number> = new Map([
  ['noise2d', 0],
  ['noise3d', 0],
  ['fractal2d', 0],
  ['fractal3d', 0],
  ['cellnoise2d', 0.5],
  ['cellnoise3d', 0.5],
  ['worleynoise2d', 0.5],
  ['worleynoise3d', 0.5],
  ['unifiednoise2d', 0.5],
  ['unifiednoise3d', 0.5],
]);
