import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { random } from '../../../math/random.ts';
import { SHADER_CHANNELS } from '../program.ts';
import { type PixelContext, runShaderProgram } from '../run.ts';
import { readShaderText } from '../shaderText.ts';
import { ShaderTextError } from '../sourceLocation.ts';
import { isGlsl } from './isGlsl.ts';

const SIZE = [13, 9] as const;

/** A picture of unrelated numbers, seen at a pixel. */
function pixel(x: number, y: number): PixelContext {
  const value = (channel: string, px: number, py: number, k: number): number => {
    const next = random(1 + px + 100 * py + 10_000 * k + 100_000 * Object.keys(SHADER_CHANNELS).indexOf(channel));
    next();
    return next();
  };
  return {
    look: (channel, dx, dy) =>
      Array.from({ length: SHADER_CHANNELS[channel] }, (_, k) => value(channel, x + dx, y + dy, k)),
    input: (name) => {
      if (name === 'p.position') return [x + 0.5, y + 0.5];
      if (name === 'p.uv') return [(x + 0.5) / SIZE[0], (y + 0.5) / SIZE[1]];
      if (name === 'p.size') return SIZE;
      if (name === 'p.direction') return [0.6, 0, -0.8];
      if (name === 'p.view') return [0.6, 0, 0.8, 0, 0, 1, 0, 0, -0.8, 0, 0.6, 0, 0, 0, 0, 1];
      if (name === 'p.projection') return [0.5, 0, 0, 0, 0, 0.7, 0, 0, 0.1, 0, -1, -1, 0, 0, -0.2, 0];
      return [{ arg1: 0.7, arg2: 0.3, arg3: -1.5, arg4: 2, time: 4 }[name] ?? 0];
    },
  };
}

const HEAD = `#version 430 core
uniform vec2 iResolution;
uniform sampler2D baseColorSampler;
uniform float arg1;
layout(location = 0) out vec4 Color;
`;
const run = (text: string, x = 5, y = 3): readonly number[] => runShaderProgram(readShaderText(text), pixel(x, y));
/** A number that `main` computes. */
const number = (expression: string, before = ''): number =>
  run(`${HEAD}${before}\nvoid main() { Color = vec4(${expression}, 0, 0, 1); }`)[0]!;

function refusal(text: string): { line: number; column: number; message: string } {
  try {
    readShaderText(text);
  } catch (thrown) {
    if (thrown instanceof ShaderTextError) return thrown;
    throw thrown;
  }
  throw new Error(`accepted: ${text}`);
}

describe('a text in GLSL', () => {
  it('is known by its main or its version', () => {
    expect(isGlsl('// a blur\n#version 430\n')).toBe(true);
    expect(isGlsl('void main ( ) {}')).toBe(true);
    expect(isGlsl('// void main()\nfn effect(p: Pixel) -> vec4f { return vec4f(1); }')).toBe(false);
  });

  it('has the arithmetic of GLSL', () => {
    expect(number('1.5 + 2 * 3')).toBe(7.5);
    expect(number('7 / 2')).toBe(3);
    expect(number('7 / 2.')).toBe(3.5);
    expect(number('float(-7 % 3)')).toBe(-1);
    expect(number('mod(-7.5, 2.0)')).toBeCloseTo(0.5, 14);
    expect(number('mod(vec2(5, -1), 3).y')).toBe(2);
    expect(number('arg1 > 0.5 ? arg1 < 0.6 ? 1 : 2.5 : 3')).toBe(2.5);
    expect(number('max(vec3(1, 5, 2), 3).x + clamp(vec2(-1, 9), 0, 1).y + step(0.5, vec2(0.6)).x')).toBe(5);
    expect(number('atan(1.0, 1.0) + atan(1.0)')).toBeCloseTo(Math.PI / 2, 14);
    expect(number('inversesqrt(4) + length(vec2(3, 4))')).toBe(5.5);
    expect(number('1e1 + 2.5f + 0x10')).toBe(28.5);
    expect(number('vec4(1, 2, 3, 4).tp.y + vec3(vec4(5)).x')).toBe(8);
  });

  it('converts ints where a float is expected, as desktop GLSL does', () => {
    expect(number('half(3) + N', 'const int N = 2;\nfloat half(float x) { return x / 2; }')).toBe(3.5);
    expect(number('f(4)', 'float f(int n) { float x = n; x += n; return x * n; }')).toBe(32);
  });

  it('has matrices, their inverses and the corners of others', () => {
    const matrix = 'const mat2 M = mat2(2, 1, 7, 4);\n';
    expect(number('(inverse(M) * vec2(1, 0)).x', matrix)).toBe(4);
    expect(number('(arg1 * inverse(M) * M / 1 * vec2(1, 0)).x'.replace(' / 1', ''), matrix)).toBeCloseTo(0.7, 14);
    expect(number('transpose(M)[0].y', matrix)).toBe(7);
    expect(number('mat3(2)[1].y + mat4(M)[1].x + mat4(M)[3].w + mat2(mat4(M))[0].y', matrix)).toBe(11);
    // A matrix that is not known beforehand.
    const text = `${HEAD}uniform mat4 view; uniform mat4 projection;
void main() { mat4 m = projection * mat4(mat3(view)); Color = inverse(m) * m * vec4(1, 2, 3, 4); }`;
    for (const [i, x] of run(text).entries()) expect(x).toBeCloseTo(i + 1, 10);
  });

  it('assigns several components, which the new value may read', () => {
    const text = `${HEAD}void main() { vec4 v = vec4(1, 2, 3, 4); v.xy = v.yx; v.wz *= 10; v.rgb += vec3(0.5); Color = v; Color.a = 9.0; }`;
    expect(run(text)).toEqual([2.5, 1.5, 30.5, 9]);
  });

  it('has macros, prototypes, lists of declarations, bodies without brackets, and an early return of main', () => {
    const text = `${HEAD}
#define TWO 2.0
#define FOUR (TWO * TWO)
precision highp float;
float later(float x, in float);
void main(void) {
  const float scale = arg1 * 10;
  float a = FOUR, b, c = a;
  for (int i = 0; i < 8; ++i)
    if (i % 2 == 0) continue;
    else if (i > 5) break;
    else b += i;
  Color = vec4(later(a, 1.), b, scale, 1);
  if (b > 8) return;
  Color = vec4(0);
}
float later(float x, float y) { x *= 3; return x + y; }`;
    const [a, b, c] = run(text) as [number, number, number];
    expect([a, b]).toEqual([13, 9]);
    expect(c).toBeCloseTo(7, 14);
  });

  it('reads pixels from the bottom left, as its textures do', () => {
    const at = (expression: string, x: number, y: number) =>
      run(`${HEAD}void main() { vec2 uv = gl_FragCoord.xy / iResolution; Color = ${expression}; }`, x, y);
    const texel = (x: number, y: number) => [0, 1, 2, 3].map((_, k) => pixel(x, y).look('image', 0, 0)[k]);
    expect(at('texture(baseColorSampler, uv)', 5, 3)).toEqual(texel(5, 3));
    expect(at('texture2D(baseColorSampler, uv + vec2(2, 1) / iResolution)', 5, 3)).toEqual(texel(7, 2));
    expect(at('texelFetch(baseColorSampler, ivec2(0, 0), 0)', 5, 3)).toEqual(texel(0, 8));
    expect(at('textureLod(baseColorSampler, vec2(0.999), 0.)', 5, 3)).toEqual(texel(12, 0));
    expect(at('vec4(gl_FragCoord.xy, textureSize(baseColorSampler, 0))', 5, 3)).toEqual([5.5, 5.5, 13, 9]);
  });

  it('has the channels of the G-buffer as samplers', () => {
    const text = `${HEAD}uniform sampler2D metallicRoughnessSampler, diffuseColorSampler, baseColorSampler2;
void main() { Color = texelFetch(metallicRoughnessSampler, ivec2(gl_FragCoord), 0); }`;
    const { look } = pixel(5, 3);
    expect(run(text)).toEqual([...look('metallicRoughness', 0, 0), 0, 1]);
    const other = text.replace(
      'texelFetch(metallic',
      'texelFetch(diffuseColorSampler, ivec2(gl_FragCoord), 0) + 0.0 * texelFetch(metallic',
    );
    expect(run(other).slice(0, 3)).toEqual([...look('albedo', 0, 0)]);
  });
});

/** The same effects in both languages. */
const PAIRS: Readonly<Record<string, readonly [glsl: string, wgsl: string]>> = {
  'a blur along a line': [
    `${HEAD}uniform float arg2;
const int N = 3;
float weight(float d) { return exp(-2.0 * d); }
void main() {
  vec2 uv = gl_FragCoord.xy / iResolution;
  vec2 by = vec2(arg2, sqrt(1 - arg2 * arg2)) * 2 / iResolution;
  vec3 col = vec3(0.0, 0.0, 0.0);
  float sum = 0.0, cur;
  for (int i = -N; i <= N; i++) {
    cur = weight(float(i * i) / float(N * N));
    sum += cur;
    col += texture(baseColorSampler, uv + float(i) * by).rgb * cur;
  }
  col /= sum;
  Color = vec4(col, 1.0);
}`,
    `const N = 3;
fn effect(p: Pixel) -> vec4f {
  let by = vec2f(arg2, sqrt(1 - arg2 * arg2)) * 2;
  var col = vec3f(0);
  var sum = 0.0;
  for (var i = -N; i <= N; i++) {
    let w = exp(-2.0 * f32(i * i) / 9.0);
    sum += w;
    let step = floor(f32(i) * by + 0.5);
    col += image(vec2i(i32(step.x), -i32(step.y))).rgb * w;
  }
  return vec4f(col / sum, 1);
}`,
  ],
  'a denoiser guided by colours': [
    `${HEAD}uniform float arg3;
const int K = 2;
float likeness(float d, vec3 a, vec3 b) { return exp(-arg1 * d - arg3 * arg3 * dot(a - b, a - b)); }
void main() {
  vec2 uv = gl_FragCoord.xy / iResolution;
  vec3 here = texture(baseColorSampler, uv).rgb, col = vec3(0);
  float sum = 0;
  for (int i = -K; i <= K; i++)
    for (int j = -K; j <= K; j++) {
      vec3 there = texture(baseColorSampler, uv + vec2(i, j) / iResolution).rgb;
      float w = likeness(i * i + j * j, here, there);
      sum += w; col += there * w;
    }
  Color = vec4(col / sum, 1.0);
}`,
    `fn effect(p: Pixel) -> vec4f {
  let here = p.color.rgb;
  var col = vec3f(0);
  var sum = 0.0;
  for (var i = -2; i <= 2; i++) { for (var j = -2; j <= 2; j++) {
    let there = image(vec2i(i, -j)).rgb;
    let d = here - there;
    let w = exp(-arg1 * f32(i * i + j * j) - arg3 * arg3 * dot(d, d));
    sum += w;
    col += there * w;
  } }
  return vec4f(col / sum, 1);
}`,
  ],
  'a blend of two pictures': [
    `#version 430 core
uniform vec2 iResolution;
uniform sampler2D baseColorSampler1;
uniform sampler2D baseColorSampler2;
uniform float alpha;
layout(location = 0) out vec4 Color;
void main() {
  vec2 uv = gl_FragCoord.xy / iResolution;
  Color = mix(texture(baseColorSampler1, uv), texture(baseColorSampler2, uv), alpha);
}`,
    'fn effect(p: Pixel) -> vec4f { return mix(p.color, image2(vec2i(0)), arg1); }',
  ],
  'occlusion in screen space': [
    `${HEAD}uniform sampler2D positionSampler, normalSampler, depthSampler;
uniform mat4 view, projection;
vec3 hash(vec3 p) { p = fract(p * vec3(70.1, 105.3, 104.8)); p += dot(p, p.yxz + 36.3); return fract((p.xxy + p.yxx) * p.zyx); }
vec3 onSphere(vec3 p) {
  vec3 h = hash(p);
  h.xy *= 2 * 3.14159265;
  return vec3(vec2(cos(h.x), sin(h.x)) * sin(h.y), cos(h.y)) * pow(h.z, 0.333);
}
void main() {
  vec2 uv = gl_FragCoord.xy / iResolution;
  vec3 at = texture(positionSampler, uv).xyz, normal = texture(normalSampler, uv).xyz;
  if (length(normal) < 0.1) { Color = vec4(1.0); return; }
  float hidden = 0.0;
  for (int i = 0; i < 8; i++) {
    vec3 dir = onSphere(vec3(uv, i));
    if (dot(dir, normal) < 0.0) dir = -dir;
    vec4 clip = projection * view * vec4(at + dir * arg1, 1.0);
    vec3 ndc = clip.xyz / clip.w;
    hidden += ndc.z > texture(depthSampler, ndc.xy * 0.5 + 0.5).r ? 1.0 : 0.0;
  }
  Color.rgb = vec3(1.0 - hidden / 8);
  Color.a = 1.0;
}`,
    `fn hash(a: vec3f) -> vec3f {
  var p = fract(a * vec3f(70.1, 105.3, 104.8));
  p += dot(p, p.yxz + 36.3);
  return fract((p.xxy + p.yxx) * p.zyx);
}
fn effect(p: Pixel) -> vec4f {
  let o = vec2i(0);
  let n = normal(o);
  let uv = vec2f(p.uv.x, (p.size.y - p.position.y) / p.size.y);
  if (length(n) < 0.1) { return vec4f(1); }
  var hidden = 0.0;
  for (var i = 0; i < 8; i++) {
    let h = hash(vec3f(uv, f32(i)));
    let a = h.x * 2 * 3.14159265;
    let b = h.y * 2 * 3.14159265;
    var dir = vec3f(cos(a) * sin(b), sin(a) * sin(b), cos(b)) * pow(h.z, 0.333);
    if (dot(dir, n) < 0) { dir = -dir; }
    let clip = p.projection * p.view * vec4f(apparent(o) + dir * arg1, 1);
    let to = (clip.xy / clip.w * 0.5 + 0.5) * p.size;
    let seen = clipDepth(vec2i(i32(floor(to.x) - floor(p.position.x)), i32(floor(p.size.y - p.position.y) - floor(to.y))));
    if (clip.z / clip.w > seen) { hidden += 1; }
  }
  return vec4f(vec3f(1 - hidden / 8), 1);
}`,
  ],
};

describe('the same effect in both languages', () => {
  it.each(Object.entries(PAIRS))('%s', (_, [glsl, wgsl]) => {
    const [a, b] = [readShaderText(glsl), readShaderText(wgsl)];
    expect(new Set(a.reads)).toEqual(new Set(b.reads));
    for (const [x, y] of [
      [5, 3],
      [0, 0],
      [12, 8],
      [2, 7],
    ] as const) {
      const [p, q] = [runShaderProgram(a, pixel(x, y)), runShaderProgram(b, pixel(x, y))];
      for (const [k, value] of p.entries()) expect(value).toBeCloseTo(q[k]!, 12);
    }
  });

  it('a Gaussian blur is the sum of its weights', () => {
    const offsets = [-3, -2, -1, 0, 1, 2, 3];
    const weights = offsets.map((i) => Math.exp((-2 * i * i) / 9));
    const total = weights.reduce((sum, w) => sum + w);
    // cos = 0.3, sin = 0.954: steps of two pixels, to the nearest one.
    const red = offsets.map(
      (i) => pixel(5, 3).look('image', Math.round(0.6 * i), -Math.round(2 * Math.sqrt(0.91) * i))[0]!,
    );
    const expected = red.reduce((sum, x, k) => sum + x * weights[k]!, 0) / total;
    expect(run(PAIRS['a blur along a line']![0])[0]).toBeCloseTo(expected, 12);
  });
});

describe('a text in GLSL is rejected, with location and remedy:', () => {
  const main = (body: string, before = '') => `${HEAD}${before}void main() {\n${body}\n}`;
  it.each([
    [main('float x = 1.0;\nwhile (x > 0.0) x -= 1.0;'), 8, 1, /`while` is not taken: write a `for`/],
    [main('for (int i = 0; i < int(arg1); i++) Color.r += 1.;'), 7, 21, /known beforehand/],
    [main('for (float x = 0.0; x < 1.0; x += 0.1) Color.r += x;'), 7, 16, /must be a whole number/],
    [main('discard;'), 7, 1, /return the colour/],
    [main('float a[3];'), 7, 8, /arrays are not taken/],
    [main('vec3 c = texture(baseColorSampler, vec2(0));'), 7, 10, /is vec4, and should be vec3/],
    [main('Color = sum(1.0);'), 7, 9, /there is no function sum/],
    [main('Color = vec4(arg2);'), 7, 14, /arg2 is not declared/],
    [main('Color = vec4(dFdx(arg1));'), 7, 14, /no function dFdx/],
    [main('vec4 v; v.xx = vec2(1);'), 7, 10, /one component twice/],
    [main('vec2 v = vec3(1) + vec2(1);'), 7, 18, /between vec3 and vec2/],
    [main('Color = texture(other, vec2(0));'), 7, 17, /other is no sampler/],
    [main('', 'uniform sampler2D lightMap;\n'), 6, 19, /nothing is known by the name of the sampler lightMap/],
    [main('', 'uniform mat4 modelMatrix;\n'), 6, 14, /nothing is known by the name of `uniform mat4 modelMatrix`/],
    [main('', 'uniform int arg2;\n'), 6, 9, /arg2 is of type float/],
    [main('', 'struct Light { vec3 color; };\n'), 6, 1, /`struct` is not taken/],
    [main('', 'float global = 1.0;\n'), 6, 1, /outside of functions/],
    [main('', 'void set(out float x) {}\n'), 6, 10, /`out` is not taken: return the value/],
    [main('', 'void nothing() {}\n'), 6, 6, /nothing returns nothing/],
    [main('', '#ifdef FAST\n'), 6, 1, /`#ifdef` is not taken/],
    [main('', '#define SQUARE(x) x * x\n'), 6, 9, /has arguments/],
    [main('', 'float f(float x) { return f(x); }\n'), 6, 7, /calls itself/],
    [`${HEAD}float f() { return 1.0; }`, 6, 26, /no function main/],
    ['#version 430\nout vec4 Color;\nvoid main() { Color = vec4(1) }', 3, 31, /expected `;` here, found `}`/],
  ] as const)('%s', (text, line, column, message) => {
    const found = refusal(text);
    expect(found.message).toMatch(message);
    expect([found.line, found.column]).toEqual([line, column]);
  });

  it('whatever is written, an answer comes soon', () => {
    const doubling = Array.from({ length: 60 }, (_, i) => `#define A${i + 1} A${i} A${i}`).join('\n');
    expect(refusal(`#version 430\n#define A0 +1.0\n${doubling}\nvoid main() {}`).message).toMatch(/longer than/);
    const nested = `${'texture(baseColorSampler, '.repeat(14)}vec2(0)${').xy'.repeat(14)}`;
    const deep = `${'mat4(mat3('.repeat(18)}1.0${'))'.repeat(18)}`;
    for (const body of [`vec2 v = ${nested};`, `float x = arg1; mat4 m = ${deep.replace('1.0', 'x')};`])
      try {
        readShaderText(main(body));
      } catch (error) {
        expect(error).toBeInstanceOf(ShaderTextError);
      }
    const words = [
      'void',
      'main',
      '()',
      '{',
      '}',
      'vec2',
      'float',
      'x',
      '=',
      '1.0',
      ';',
      'for',
      '(',
      ')',
      'int',
      '#',
      ',',
      '?',
      ':',
      '.',
      '\n',
    ];
    fc.assert(
      fc.property(fc.array(fc.constantFrom(...words), { maxLength: 40 }), (parts) => {
        try {
          readShaderText(`${HEAD}${parts.join(' ')} void main() {}`);
        } catch (error) {
          if (!(error instanceof ShaderTextError)) throw error;
        }
      }),
      { numRuns: 500 },
    );
  });
});
