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
import { encodeOctahedral, unpackGBufferNormal } from '../../../src/render/gpu/packNormal.ts';
import { absolute, always } from '../../../src/shaders/twins/checks.ts';
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
  const anything = [NAMED[1], NAMED[2]].flatMap((stratum) =>
    Array.from({ length: 400 }, () => {
      const light = Array.from({ length: 3 }, () => logUniform(random, 1e-3, 1e3));
      const heat = stratum === NAMED[1] ? logUniform(random, 300, 1e6) : 0;
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
          ? Math.abs(gpu[0] / luminance(emission) - 1) + (gpu[2] === -1 ? 0 : 1)
          : Math.max(...emission.map((x, k) => Math.abs(gpu[k] - x) / Math.max(x, 1e-3))),
      6e-4,
    ),
    check('heat', (gpu, content) => (content.temperature > 0 ? Math.abs(gpu[1] - heatOf(content)) : 0), 2.1e-3),
  ],
};

const unpacking: Twin = {
  name: 'surfaceCode, unpacked',
  texels: 2,
  outputs: 3,
  cases: (random) =>
    cases(random).map(({ stratum, input }) => {
      const content = contentOf(input);
      const [r, g, b] = content.emission;
      const glow = content.temperature > 0 ? [luminance(content.emission), heatOf(content), -1] : [r, g, b];
      const codes = [...glow, encodeFinish(content), ...encodeNormal(content)];
      return { stratum, input: codes.map(rounded) };
    }),
  cpu: ([r, g, b, finish, ...normal]) => {
    const emission = b < 0 ? [0, 0, 0, r, 0] : [r, g, b, 0, 0];
    const [metallic, F0] = decodeFinish(finish);
    const invisible = [levelOf(normal[2]), levelOf(normal[3])];
    return [...emission.slice(0, 4), ...unpackGBufferNormal(normal), b < 0 ? g : 0, metallic, F0, ...invisible];
  },
  gpu: (texel) => {
    const { rgb, luminance, log2Temperature } = unpackEmission(texel(0).xyz);
    const { metallic, F0 } = unpackSpecular(texel(0).w);
    const { normal, invisible } = unpackNormals(texel(1));
    return [vec4(rgb, luminance), vec4(normal, log2Temperature), vec4(metallic, F0, invisible)];
  },
  checks: [absolute('emission', 0, 4, always(0)), absolute('the rest', 4, 8, always(2e-6))],
};

export const surfaceCodes: readonly Twin[] = [packing, pairs, unpacking];
