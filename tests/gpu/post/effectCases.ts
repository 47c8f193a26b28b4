import { IDENTITY } from '../../../src/math/quat.ts';
import { random } from '../../../src/math/random.ts';
import { normalize, type Vec3 } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { createTracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { DEFAULT_LIGHT } from '../../../src/reference/lights/lightOptions.ts';
import { applyEffect } from '../../../src/reference/post/effects/applyEffect.ts';
import { type EffectInput, FloatImage } from '../../../src/reference/post/effects/effectInput.ts';
import { mixImages } from '../../../src/reference/post/effects/mix.ts';
import { renderTile } from '../../../src/reference/tile.ts';
import { makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import type { EffectId, FogColor, MixMode } from '../../../src/scene/frameGraph/effects.ts';
import { plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import { readShaderText } from '../../../src/scene/shaderText/shaderText.ts';
import { domeLens } from '../../../src/scene/view/lenses/fisheyeLens.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { type AovName, DEFAULT_SETTINGS, type ViewPoint } from '../../../src/scene/view/view.ts';

/** The input of both twins. */
export interface EffectCase {
  readonly name: string;
  readonly of: EffectId | { readonly mode: MixMode } | { readonly text: string };
  readonly args: readonly number[];
  readonly fogColor?: FogColor;
  readonly picture: keyof typeof PICTURES;
  readonly masked?: boolean;
  /** From the camera to the observer [m]; absent: it is at his eye. */
  readonly observer?: Vec3;
}

const VIEW: ViewPoint = {
  t: 3,
  position: [0.5, 1, 2],
  u: properVelocity([0.1, 0, -0.6]),
  orientation: IDENTITY,
  lens: perspective(1),
};
const SETTINGS = { ...DEFAULT_SETTINGS, speedOfLight: 1 };
const ZENITH = [0, 1, 0] as const;

const DATA = [
  ...(['object', 'depth', 'normal', 'position', 'emission_time', 'velocity', 'doppler'] as const),
  ...(['albedo', 'roughness', 'metallic'] as const),
] as const;

/** Light over six decades, and unrelated random surfaces with holes. */
function noise(): EffectInput {
  const [width, height] = [61, 47];
  const next = random(7);
  const image = FloatImage.of(width, height, 3, () => [0, 0, 0].map(() => 10 ** (6 * next() - 4)));
  const of = (channels: number, values: () => readonly number[]) =>
    Float32Array.from(FloatImage.of(width, height, channels, values).values);
  const object = of(1, () => [next() < 0.2 ? 0 : 1 + Math.floor(3 * next())]);
  const aovs = new Map<AovName, Float32Array>([
    ['object', object],
    ['depth', of(1, () => [10 ** (3 * next() - 1)])],
    ['normal', of(3, () => normalize([next() - 0.5, next() - 0.5, next() - 0.5]))],
    ['position', of(3, () => [0, 0, 0].map(() => 20 * (next() - 0.5)))],
    ['emission_time', of(1, () => [3 - 20 * next()])],
    ['velocity', of(3, () => [0, 0, 0].map(() => next() - 0.5))],
    ['doppler', of(1, () => [4 ** (2 * next() - 1)])],
    ['albedo', of(3, () => [next(), next(), next()])],
    ['roughness', of(1, () => [next()])],
    ['metallic', of(1, () => [next()])],
  ]);
  return { image, aovs, view: VIEW, settings: SETTINGS, zenith: ZENITH };
}

/** A floor, a ball at rest and a passing one, rendered by the reference for a moving observer. */
function scene(): EffectInput {
  const [width, height] = [96, 72];
  const objects = [
    makeObject({ path: '/floor', mesh: plane(30, 30), motion: restingAt([0, -1.2, -8]) }),
    makeObject({ path: '/still', mesh: sphere(1), motion: restingAt([-1.5, 0, -6]) }),
    makeObject({
      path: '/fast',
      mesh: sphere(0.8),
      authoredIn: 'rest',
      motion: { kind: 'uniform', pose: { position: [6, 0.5, -7], orientation: IDENTITY }, velocity: [0.6, 0, 0] },
    }),
  ];
  const layers = [...DATA, 'beauty'] as const;
  const request = { view: VIEW, settings: SETTINGS, width, height, layers, samples: 1, seed: 0, light: DEFAULT_LIGHT };
  const data = renderTile(createTracedScene(makeScene({ name: 'balls', objects }), 1), request, {
    x0: 0,
    y0: 0,
    x1: width,
    y1: height,
  });
  const aovs = new Map(layers.map((name) => [name, data[name] ?? new Float32Array()]));
  return {
    image: new FloatImage(width, height, 3, data.beauty),
    aovs,
    view: VIEW,
    settings: SETTINGS,
    zenith: ZENITH,
    sky: { zenith: [0.5, 0.1, 0.3], horizon: [1.2, 0.4, 0.1], ground: [0.02, 0.05, 0.01] },
  };
}

/** Hard slanted edges between a few dark and bright colours, up to the borders, and single pixels. */
function shapes(): EffectInput {
  const [width, height] = [90, 70];
  const colors = [
    [0.02, 0.02, 0.02],
    [0.7, 0.1, 0.05],
    [30, 25, 20],
    [0.3, 0.3, 0.35],
  ] as const;
  const image = FloatImage.of(width, height, 3, (x, y) => {
    const disc = Math.hypot(x - 60.3, y - 30.8) < 19 ? 1 : 0;
    const wedge = y > 0.11 * x + 20 && x < 0.31 * y + 40 ? 2 : 0;
    return colors[x % 17 === 3 && y % 13 === 5 ? 2 : disc + wedge]!;
  });
  return { ...noise(), image };
}

const PICTURES = {
  noise,
  scene,
  shapes,
  /** Through other lenses. */
  dome: (): EffectInput => ({ ...shapes(), view: { ...VIEW, lens: domeLens(3.5, 0.3) } }),
  around: (): EffectInput => ({ ...shapes(), view: { ...VIEW, lens: { kind: 'equirectangular' } } }),
  cube: (): EffectInput => ({ ...shapes(), view: { ...VIEW, lens: { kind: 'cube', layout: '3x2' } } }),
};
const taken = new Map<string, EffectInput>();

export function pictureOf({ picture, fogColor, observer }: EffectCase): EffectInput {
  const cached = taken.get(picture) ?? PICTURES[picture]();
  taken.set(picture, cached);
  return { ...cached, ...(fogColor && { fogColor }), ...(observer && { observer }) };
}

/** A ramp from 0 at the left to 1 and beyond at the right. */
export const maskOf = ({ image }: EffectInput): FloatImage => image.map((x) => [(1.4 * x) / image.width - 0.2, 0, 0]);

/** The upper picture of a mix, and the second of a text: the mirrored picture, dimmed. */
export const overOf = ({ image }: EffectInput): FloatImage =>
  image.map((x, y) => image.at(image.width - 1 - x, y).map((value) => 0.3 * value));

const expectations = new WeakMap<EffectCase, FloatImage>();

/** In f64; remembered, since both backends are compared with it. */
export function expected(of: EffectCase): FloatImage {
  const image = expectations.get(of) ?? computed(of);
  expectations.set(of, image);
  return image;
}

function computed(of: EffectCase): FloatImage {
  const picture = pictureOf(of);
  const mask = of.masked ? maskOf(picture) : undefined;
  if (typeof of.of === 'string') return applyEffect(of.of, of.args, picture, mask);
  if ('text' in of.of) return applyEffect(readShaderText(of.of.text), of.args, picture, mask, overOf(picture));
  return mixImages(of.of.mode, of.args[0] ?? 0, picture.image, overOf(picture), mask);
}

const both = (of: EffectCase['of'], args: readonly number[]): EffectCase[] =>
  (['noise', 'scene'] as const).map((picture) => ({
    name: `${typeof of === 'string' ? of : 'mode' in of ? `mix ${of.mode}` : 'text'} ${args.join(' ')}, ${picture}`,
    of,
    args,
    picture,
  }));

/** Realistic effect texts, and texts that cover every construct. */
const TEXTS: Readonly<Record<string, string>> = {
  'a blur in two dimensions': `
const R = 3;
fn weight(x: i32, y: i32) -> f32 { return exp(-f32(x * x + y * y) / (2 * arg1 * arg1)); }
fn effect(p: Pixel) -> vec4f {
  var sum = vec4f(0);
  for (var y = -R; y <= R; y++) {
    for (var x = -R; x <= R; x++) {
      let w = weight(x, y);
      sum += vec4f(image(vec2i(x, y)).rgb, 1) * w;
    }
  }
  return vec4f(sum.rgb / sum.w, 1);
}`,
  'early returns, breaks and rounds left out': `
fn nearest(from: i32) -> f32 {
  var best = 1e9;
  for (var i = 0; i < 9; i++) {
    if (i % 3 == 1) { continue; }
    let d = depth(vec2i(from + i, 0));
    if (d > 100) { break; }
    for (var j = 4; j > 0; j -= 2) {
      if (d * f32(j) < 1.5) { return d; }
      best = min(best, d + f32(j));
    }
    if (i > 6) { return -best; }
  }
  return best;
}
fn effect(p: Pixel) -> vec4f {
  if (there(vec2i(0)) < 0.5) { return vec4f(p.uv, 0.5, 1); }
  let a = nearest(1);
  if (a < 0) { return vec4f(0, -a, 0, 1); } else if (a > 50) { return vec4f(0, 0, a, 1); }
  var v = vec4f(a, 0, nearest(-3), 1);
  v.y = v.x + 1;
  v[2] *= 0.5;
  return v;
}`,
  'numbers, vectors and matrices': `
const M = mat3x3f(1, 2, 3, 4, 5, 6, 7, 8, 10);
fn turned(v: vec2<f32>, angle: f32) -> vec2f {
  let m = mat2x2f(cos(angle), sin(angle), -sin(angle), cos(angle));
  return m * v + v * m;
}
fn effect(p: Pixel) -> vec4f {
  let c = p.color.rgb;
  let q = M * c + c * M - (M * mat3x3(1, 0, 0, 0, 1, 0, 0, 0, 1))[1];
  let n = i32(p.position.x) * 7 - 100;
  let whole = vec2i(n / 6, n % 6) * 2 + vec2i(abs(-3), max(n, 4));
  let t = turned(p.uv, arg1);
  var k = select(0.0, 1.0, n > 3 && !(n == 9) || n < -50);
  k += sign(f32(n)) + fract(p.uv.x * 9) - trunc(-2.5) + -7.5 % 2 + (p.position.y % 3.5) + atan2(t.x, t.y) + tanh(t.x) + sinh(t.y);
  let u = mix(vec3f(t, k), clamp(q, vec3f(0), vec3f(3)), 0.3) + smoothstep(vec3f(0), vec3f(2), c) + step(vec3f(0.5), c);
  return vec4f(u * dot(q.zyx, vec3f(0.1)) + reflect(u, normalize(vec3f(1, 2, 3))) + cross(u, c), f32(whole.x)) + vec4f(vec2f(whole), pow(p.uv.x, 2.5), 0);
}`,
  'everything that can be looked at': `
fn effect(p: Pixel) -> vec4f {
  let o = vec2i(i32(arg1), -1);
  let a = normal(o) + event(o) * 0.1 + velocity(o) + p.direction * p.size.y * 0.01;
  return vec4f(a + vec3f(depth(o) * 0.1 + doppler(o), emissionTime(o) * 0.1 + time, object(o)), 1);
}`,
};

/** Texts in GLSL, written as for OpenGL. */
const GLSL_TEXTS: Readonly<Record<string, string>> = {
  'a denoiser in GLSL, guided by colours': `
#version 430 core
uniform vec2 iResolution;
uniform sampler2D baseColorSampler;
uniform float arg1;
layout(location = 0) out vec4 Color;
const int K = 2;
float likeness(float d, vec3 a, vec3 b) { return exp(-arg1 * d - dot(a - b, a - b)); }
void main()
{
  vec2 uv = gl_FragCoord.xy / iResolution;
  vec3 here = texture(baseColorSampler, uv).rgb, col = vec3(0.0);
  float sum = 0.0;
  for (int i = -K; i <= K; i++)
    for (int j = -K; j <= K; j++)
    {
      vec3 there = texture(baseColorSampler, uv + vec2(i, j) / iResolution).rgb;
      float w = likeness(i * i + j * j, here, there);
      sum += w;
      col += there * w;
    }
  Color = vec4(col / sum, 1.0);
}`,
  'matrices in GLSL: every surface again where it is': `
uniform vec2 iResolution;
uniform sampler2D baseColorSampler, baseColorSampler2, positionSampler, depthSampler;
uniform mat4 view, projection;
out vec4 Color;
void main() {
  vec2 uv = gl_FragCoord.xy / iResolution;
  vec3 at = texture(positionSampler, uv).xyz;
  vec4 clip = projection * view * vec4(at, 1);
  float depth = texture(depthSampler, uv).r;
  vec4 far = inverse(projection * mat4(mat3(view))) * vec4(uv * 2 - 1, 1, 1);
  Color = vec4(normalize(far.xyz), 1);
  if (depth == 0) return;
  Color.rg = clip.xy / clip.w * 0.5 + 0.5 - uv;
  Color.b = clip.z / clip.w - depth;
  Color.rgb += mod(at, 2).zxy * mix(texture(baseColorSampler, uv), texture(baseColorSampler2, uv), 0.5).rgb;
}`,
  'materials in GLSL': `
uniform vec2 iResolution;
uniform sampler2D diffuseColorSampler, metallicRoughnessSampler, roughnessSampler;
out vec4 Color;
void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  vec4 m = texelFetch(metallicRoughnessSampler, here, 0);
  Color = vec4(m.xy, texelFetch(roughnessSampler, here + ivec2(1, 0), 0).x, 1);
  Color.rgb += 10 * texelFetch(diffuseColorSampler, here - ivec2(0, 1), 0).rgb * (m.x > 0.5 ? 1 : 2.5);
}`,
};

export const EFFECT_CASES: readonly EffectCase[] = [
  ...Object.entries({ ...TEXTS, ...GLSL_TEXTS }).flatMap(([name, text]) =>
    (['noise', 'scene'] as const).map((picture) => ({
      name: `${name}, ${picture}`,
      of: { text },
      args: [1.7],
      picture,
    })),
  ),
  ...both('gaussian-blur', [4, 0]),
  ...both('gaussian-blur', [2.3, 90]),
  ...both('gaussian-blur', [3.1, 30]),
  ...both('gaussian-blur', [0, 45]),
  ...both('bilateral-filter', [2, 0, 0]),
  ...both('bilateral-filter', [2.5, 0.05, 20]),
  ...both('bilateral-filter', [2.5, 0.3, 0]),
  ...both('sky-background', [2, 0.45, 0, 1]),
  ...both('sky-background', [1, 0.8, 12, 0.7]),
  ...both('sharpen', [1.5, 0]),
  ...both('sharpen', [3, 0.5]),
  ...both('bloom', [0.3, 0.7]),
  ...both('bloom', [1, 1]),
  ...both('edge', [0.5, 2, 1, 0.8]),
  ...both('edge', [0, 5, 0, 0]),
  ...both('vignette', [1, 4, 0]),
  ...both('vignette', [0.7, 2, 50]),
  ...both('fog', [8, 0.6, 0.5, 1]),
  ...both('fog', [20, 2, 0, 0.3]),
  ...(['sky', [0.2, 0.9, 0.4]] as const).flatMap((fogColor) =>
    [...both('fog', [8, 0.6, 0.5, 0.7]), ...both('sky-background', [0.8, 0.45, 12, 1])].map((of) => ({
      ...of,
      name: `${of.name}, into ${fogColor}`,
      fogColor,
    })),
  ),
  ...both('hue-shift', [70, 1]),
  ...both('hue-shift', [-160, 2.5]),
  ...['noise', 'scene'].flatMap((picture) =>
    [
      [2, 0.8, 5],
      [0.7, 1, 0],
    ].map((args) => ({
      name: `observer-marks ${args}, ${picture}, from outside`,
      of: 'observer-marks' as const,
      args,
      picture: picture as keyof typeof PICTURES,
      observer: [-1.5, -2, -5] as const,
    })),
  ),
  ...both('observer-marks', [2, 0.8, 5]),
  ...(['scene', 'dome', 'around', 'cube'] as const).map((picture) => ({
    name: `lens-grid, ${picture}`,
    of: 'lens-grid' as const,
    args: [20, 0.85, 1, 1],
    picture,
  })),
  ...both('depth-of-field', [4, 300, 12]),
  ...both('depth-of-field', [6, 2000, 24]),
  ...both('antialiasing', [0.1, 16, 0.5]),
  ...both('antialiasing', [0.02, 5, 1]),
  { name: 'antialiasing of hard edges', of: 'antialiasing', args: [0.1, 16, 0.5], picture: 'shapes' },
  { name: 'antialiasing under a mask', of: 'antialiasing', args: [0.1, 64, 0], picture: 'shapes', masked: true },
  ...both({ mode: 'normal' }, [0.4]),
  ...both({ mode: 'multiply' }, [1]),
  ...both({ mode: 'add' }, [0.8]),
  ...both({ mode: 'screen' }, [1]),
  ...both({ mode: 'overlay' }, [1]),
  ...both({ mode: 'difference' }, [1]),
  ...both({ mode: 'split' }, [0.35]),
  ...both({ mode: 'wipe' }, [0.5]),
  ...both({ mode: 'inset' }, [0.37]),
  { name: 'blur under a mask', of: 'gaussian-blur', args: [3, 0], picture: 'scene', masked: true },
  { name: 'bloom under a mask', of: 'bloom', args: [1, 0.5], picture: 'noise', masked: true },
  { name: 'add under a mask', of: { mode: 'add' }, args: [1], picture: 'noise', masked: true },
];
