import { vec2, vec4 } from 'three/tsl';
import { fromHalf, toHalf } from '../../../src/math/half.ts';
import { cross, dot, length, scale, type Vec3 } from '../../../src/math/vec3.ts';
import {
  emissionOf,
  packEmission,
  packNormals,
  packRoughnessAndOcclusion,
  packSpecular,
  unpackEmission,
  unpackNormals,
  unpackSpecular,
} from '../../../src/render/gbuffer/surfacePacking.ts';
import { limitLight } from '../../../src/render/gpu/lightRange.ts';
import { encodeOctahedral, unpackGBufferNormal } from '../../../src/render/gpu/packNormal.ts';
import { absolute, always, relative, within } from '../../../src/shaders/twins/checks.ts';
import { logUniform, unitVector } from '../../../src/shaders/twins/inputs.ts';
import type { Check, Stratum, Twin, TwinCase } from '../../../src/shaders/twins/twin.ts';

/*
 * The packing of the G-buffer's halves: values are packed on the GPU, rounded as by a target, unpacked on the CPU and compared with the input; and
 * values packed and rounded on the CPU are unpacked on the GPU.
 */

type Numbers = readonly number[];

/** (normal, metallic), (emission, F₀), (uv, ir, temperature, 0). */
interface Content {
  readonly normal: Vec3;
  readonly metallic: number;
  readonly emission: Vec3;
  readonly F0: number;
  readonly invisible: readonly [number, number];
  readonly temperature: number;
}

const contentOf = (i: Numbers): Content => ({
  normal: [i[0], i[1], i[2]],
  metallic: i[3],
  emission: [i[4], i[5], i[6]],
  F0: i[7],
  invisible: [i[8], i[9]],
  temperature: i[10],
});

const NAMED: readonly Stratum[] = [
  { name: 'axes and edges of the octahedron, glass, whole metal', gamma: 1 },
  { name: 'anything, glowing hot', gamma: 1 },
  { name: 'anything', gamma: 1 },
  { name: 'brighter than halves', gamma: 1 },
];

const EDGES: readonly Vec3[] = [-1, 0, 1].flatMap((x) =>
  [-1, 0, 1].flatMap((y) =>
    [-1, 0, 1].filter((z) => x !== 0 || y !== 0 || z !== 0).map((z) => scale([x, y, z], 1 / Math.hypot(x, y, z))),
  ),
);

function cases(random: () => number): readonly TwinCase[] {
  const plain = EDGES.map((normal, k) => ({
    stratum: NAMED[0],
    input: [...normal, k % 2, 0, 0, 0, 0.04, 0, 1, 0, 0],
  }));
  const anything = [NAMED[1], NAMED[2], NAMED[3]].flatMap((stratum) =>
    Array.from({ length: 400 }, (_, i) => {
      const scale = stratum === NAMED[3] ? logUniform(random, 1e3, 1e15) : 1;
      const light = Array.from({ length: 3 }, (_, k) =>
        stratum === NAMED[3] && k < 2 && (i >> k) & 1 ? 0 : scale * logUniform(random, 1e-3, 1e3),
      );
      const heat = stratum === NAMED[1] || (stratum === NAMED[3] && i % 8 === 0) ? logUniform(random, 300, 1e6) : 0;
      return {
        stratum,
        input: [...unitVector(random), random(), ...light, 0.54 * random() ** 2, random(), random(), heat, 0],
      };
    }),
  );
  return [...plain, ...anything];
}

const rounded = (x: number): number => fromHalf(toHalf(x));
/** Rounding of a GPU that truncates. */
function cut(x: number): number {
  const near = toHalf(x);
  return Math.abs(fromHalf(near)) > Math.abs(x) ? fromHalf(near - 1) : fromHalf(near);
}

/** An independent `packSpecular`. */
function encodeFinish({ metallic, F0 }: Content): number {
  const step = Math.min(59, Math.round(80 * Math.sqrt(F0)));
  return (step >= 30 ? -1 : 1) * 2 ** ((step % 30) - 14) * (1 + (1020 * metallic + 2) / 1024);
}
function decodeFinish(code: number): readonly [metallic: number, F0: number] {
  const exponent = Math.floor(Math.log2(Math.abs(code)));
  const step = exponent + 14 + (code < 0 ? 30 : 0);
  return [((Math.abs(code) / 2 ** exponent - 1) * 1024 - 2) / 1020, (step / 80) ** 2];
}

/** Roughness to 1/1020 and occlusion to 1/59, as packed in the G-buffer. */
const pairs: Twin = {
  name: 'surfaceCode, pairs',
  texels: 1,
  outputs: 1,
  cases: (random) =>
    Array.from({ length: 400 }, (_, k) => ({
      stratum: NAMED[2],
      input: k < 4 ? [k & 1, k >> 1, 0, 0] : [random(), random(), 0, 0],
    })),
  cpu: (input) => input,
  gpu: (texel) => [vec4(packRoughnessAndOcclusion(texel(0).x, texel(0).y), 0, 0, 0)],
  checks: [0, 1].map((k) => ({
    name: ['roughness', 'occlusion'][k],
    error: (gpu: Numbers, _: Numbers, input: Numbers) => {
      const [fine, F0] = decodeFinish(rounded(gpu[0]));
      return Math.abs([fine, (80 * Math.sqrt(F0)) / 59][k] - input[k]);
    },
    tolerance: always([6e-4, 0.5 / 59 + 1e-6][k]),
  })),
};

/** What the G-buffer stores next to the lowest bits of a normal. */
const levelOf = (code: number): number => Math.floor((code + 2048) / 8) / 511;

/** An independent `packNormals`, by bit operations. */
function encodeNormal({ normal, invisible }: Content): readonly number[] {
  const fine = encodeOctahedral(...normal).map((p) => Math.round(32766 * (p / 2 + 0.5)));
  return [
    ...fine.map((x) => (x >> 3) - 2048),
    ...fine.map((x, k) => ((Math.round(511 * invisible[k]) << 3) | (x & 7)) - 2048),
  ];
}

/** The light that the three numbers of an emission stand for: a colour, or a luminance first. Independent of `unpackEmission`. */
function decodeEmission([x, y, z]: Numbers): Numbers {
  if (z < 0) return [x * 2 ** (16 * (Math.floor((-z - 1) / 128) - 6)), 0, 0];
  const scale = 2 ** (16 * ((x < 0 ? 1 : 0) + (y < 0 ? 2 : 0)));
  return [x, y, z].map((value) => Math.abs(value) * scale);
}

/** log₂ of the temperature over daylight's, from the same. */
const decodeHeat = ([, y, z]: Numbers): number => (128 * (y + 2048) + ((-z - 1) % 128)) / 2 ** 14 - 13;

/** An independent `packEmission`. */
function encodeEmission({ emission, temperature }: Content): Numbers {
  if (temperature > 0) {
    const step = Math.floor(Math.log2(luminance(emission) / 65_000) / 16) + 1;
    const bits = Math.round((Math.log2(temperature / 6504) + 13) * 2 ** 14);
    return [luminance(emission) / 2 ** (16 * step), (bits >> 7) - 2048, -1 - (bits & 127) - 128 * (step + 6)];
  }
  const steps = Math.max(0, Math.ceil(Math.log2(Math.max(...emission) / 65_000) / 16));
  const [r, g, b] = steps === 0 ? emission : emission.map((x) => Math.max(x / 2 ** (16 * steps), 2 ** -14));
  return [steps & 1 ? -r : r, steps & 2 ? -g : g, b];
}

const luminance = ([r, g, b]: Vec3): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;
const heatOf = ({ temperature }: Content): number => Math.log2(temperature / 6504);

const angle = (a: Vec3, b: Vec3): number => Math.atan2(length(cross(a, b)), dot(a, b));

const check = (name: string, error: (gpu: Numbers, content: Content) => number, bound: number): Check => ({
  name,
  error: (gpu, _, input) =>
    Math.max(error(gpu.map(rounded), contentOf(input)), error(gpu.map(cut), contentOf(input)) / 2),
  tolerance: always(bound),
});

const packing: Twin = {
  name: 'surfaceCode, packed',
  texels: 3,
  outputs: 2,
  cases,
  cpu: (input) => input,
  gpu: (texel) => [
    vec4(packEmission(emissionOf(texel(1).xyz, texel(2).z)), packSpecular({ metallic: texel(0).w, F0: texel(1).w })),
    packNormals(texel(0).xyz, vec2(texel(2).xy)),
  ],
  checks: [
    check('normal [rad]', (gpu, { normal }) => angle(unpackGBufferNormal(gpu.slice(4)), normal), 1.3e-4),
    check(
      'reflectance of invisible light',
      (gpu, { invisible }) => Math.max(...invisible.map((x, k) => Math.abs(levelOf(gpu[6 + k]) - x))),
      1e-3,
    ),
    check('metallic', (gpu, { metallic }) => Math.abs(decodeFinish(gpu[3])[0] - metallic), 6e-4),
    check('√F₀', (gpu, { F0 }) => Math.abs(Math.sqrt(decodeFinish(gpu[3])[1]) - Math.sqrt(F0)), 1 / 159),
    check('F₀ of glass', (gpu, { F0 }) => (F0 === 0.04 ? Math.abs(decodeFinish(gpu[3])[1] - 0.04) : 0), 1e-9),
    check(
      'emission, relative',
      (gpu, { emission, temperature }) =>
        temperature > 0
          ? Math.abs(decodeEmission(gpu)[0] / luminance(emission) - 1)
          : Math.max(
              ...emission.map(
                (x, k) => Math.abs(decodeEmission(gpu)[k] - x) / Math.max(x, 1e-3, 0.2 * Math.max(...emission)),
              ),
            ),
      6e-4,
    ),
    check(
      'heat',
      (gpu, content) => (content.temperature > 0 ? Math.abs(decodeHeat(gpu) - heatOf(content)) : 0),
      3.3e-5,
    ),
  ],
};

const unpacking: Twin = {
  name: 'surfaceCode, unpacked',
  texels: 2,
  outputs: 3,
  cases: (random) =>
    cases(random).map(({ stratum, input }) => {
      const content = contentOf(input);
      const codes = [...encodeEmission(content), encodeFinish(content), ...encodeNormal(content)];
      return { stratum, input: codes.map(rounded) };
    }),
  cpu: ([r, g, b, finish, ...normal]) => {
    const light = decodeEmission([r, g, b]);
    const emission = b < 0 ? [0, 0, 0, light[0]] : [...light, 0];
    const [metallic, F0] = decodeFinish(finish);
    const invisible = [levelOf(normal[2]), levelOf(normal[3])];
    return [...emission, ...unpackGBufferNormal(normal), b < 0 ? decodeHeat([r, g, b]) : 0, metallic, F0, ...invisible];
  },
  gpu: (texel) => {
    const { rgb, luminance, log2Temperature } = unpackEmission(texel(0).xyz);
    const { metallic, F0 } = unpackSpecular(texel(0).w);
    const { normal, invisible } = unpackNormals(texel(1));
    return [vec4(rgb, luminance), vec4(normal, log2Temperature), vec4(metallic, F0, invisible)];
  },
  checks: [
    within('emission, relative', 0, (cpu) => Math.max(...cpu.slice(0, 3), 1e-30), always(0)),
    relative('luminance', 3, always(2e-5)),
    absolute('the rest', 4, 8, always(2e-6)),
  ],
};

/** (light, largest channel): dimmed as a whole, in f64. */
const limited: Twin = {
  name: 'limitLight',
  texels: 1,
  outputs: 1,
  cases: (random) =>
    Array.from({ length: 200 }, (_, i) => ({
      stratum: NAMED[3],
      input: [...Array.from({ length: 3 }, () => (i % 5 === 0 ? -1 : 1) * logUniform(random, 1e-3, 1e30)), 1e18],
    })),
  cpu: ([r, g, b, most]) => {
    const peak = Math.max(r, g, b);
    return [r, g, b].map((x) => (peak > most ? (x * most) / peak : x)).concat(0);
  },
  gpu: (texel) => [vec4(limitLight(texel(0).xyz, 1e18), 0)],
  checks: [within('light, relative', 0, (cpu) => Math.hypot(...cpu.slice(0, 3)), always(1e-5))],
};

export const surfaceCodes: readonly Twin[] = [packing, pairs, unpacking, limited];
