import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type PixelContext, runShaderProgram } from './run.ts';
import { readShaderText } from './shaderText.ts';
import { SHADER_TEXT_LIMITS, ShaderTextError } from './sourceLocation.ts';

const ABOUT: PixelContext = {
  look: (channel, dx, dy) =>
    channel === 'image' ? [dx, dy, 10 * dx + dy, 1] : channel === 'normal' ? [0, 0, 1] : [dx + dy],
  input: (name) => (name === 'p.uv' ? [0.25, 0.75] : name === 'arg1' ? [3] : name.startsWith('p.') ? [5, 7] : [0]),
};
const effect = (body: string, before = ''): string => `${before}\nfn effect(p: Pixel) -> vec4f {\n${body}\n}`;
const result = (body: string, before?: string): readonly number[] =>
  runShaderProgram(readShaderText(effect(body, before)), ABOUT);
/** Evaluates a scalar expression. */
const number = (expression: string, before?: string): number =>
  result(`return vec4f(${expression}, 0, 0, 1);`, before)[0]!;

/** The error of a text, with its location. */
function refusal(text: string): { line: number; column: number; message: string } {
  try {
    readShaderText(text);
  } catch (thrown) {
    if (thrown instanceof ShaderTextError) return thrown;
    throw thrown;
  }
  throw new Error(`accepted: ${text}`);
}

describe('a shader text', () => {
  it('computes a colour per pixel', () => {
    expect(result('return vec4f(1, 0.5, 0, 1);')).toEqual([1, 0.5, 0, 1]);
    expect(result('return image(vec2i(2, -1)) * arg1;')).toEqual([6, -3, 57, 3]);
    expect(result('return vec4f(p.uv, p.position);')).toEqual([0.25, 0.75, 5, 7]);
  });

  it('has the arithmetic of WGSL', () => {
    expect(number('1.5 + 2 * 3')).toBe(7.5);
    expect(number('f32(7 / 2)')).toBe(3);
    expect(number('f32(-7 % 3)')).toBe(-1);
    expect(number('-7.5 % 2.0')).toBe(-1.5);
    expect(number('f32(i32(-2.7))')).toBe(-2);
    expect(number('round(2.5) + round(3.5)')).toBe(6);
    expect(number('f32(2147483647 + i32(arg1))')).toBe(-2147483646);
    expect(number('0x10 + 1e1 + .5 + 1.f')).toBe(27.5);
    expect(number('select(1.0, 2.0, arg1 > 2 && !(arg1 > 4))')).toBe(2);
    expect(number('f32(true)')).toBe(1);
    expect(number('min(arg1, 5) + 10 * max(-arg1, -5) + 100 * abs(-arg1)')).toBe(273);
  });

  it('has vectors, swizzles and matrices', () => {
    expect(result('let v = vec4f(vec2f(1, 2), 3, 4); return v.wzyx;')).toEqual([4, 3, 2, 1]);
    expect(
      result(
        'let v = vec3(1, 2, 3); return vec4f(vec3f(v) * 2, v[1] == 2 && v.z > v.r || false ? 1 : 0);'.replace(
          'v[1] == 2 && v.z > v.r || false ? 1 : 0',
          'select(0.0, 1.0, v[1] == 2)',
        ),
      ),
    ).toEqual([2, 4, 6, 1]);
    expect(number('dot(vec3f(1, 2, 3), vec3f(4, 5, 6)) + length(vec2f(3, 4))')).toBe(37);
    expect(result('return vec4f(cross(vec3f(1, 0, 0), vec3f(0, 1, 0)), 0);')).toEqual([0, 0, 1, 0]);
    expect(result('let m = mat2x2f(1, 2, 3, 4); return vec4f(m * vec2f(1, 1), vec2f(1, 1) * m);')).toEqual([
      4, 6, 3, 7,
    ]);
    expect(result('let m = mat2x2f(1, 2, 3, 4) * mat2x2f(1, 0, 0, arg1); return vec4f(m[0], m[1]);')).toEqual([
      1, 2, 9, 12,
    ]);
    expect(result('var v = vec4f(0); v.y = 5; v[2] += 2.5; v *= 2; return v;')).toEqual([0, 10, 5, 0]);
    expect(result('return mix(vec4f(0), vec4f(4), 0.25) + clamp(vec4f(9), vec4f(0), vec4f(1));')).toEqual([2, 2, 2, 2]);
  });

  it('has branches, loops, break, continue and early return', () => {
    expect(
      number(
        'sumTo(10)',
        'fn sumTo(n: i32) -> f32 { var s = 0; for (var i = 0; i <= 100; i++) { if (i > n) { break; } s += i; } return f32(s); }',
      ),
    ).toBe(55);
    expect(
      number(
        'odd()',
        'fn odd() -> f32 { var s = 0.0; for (var i = 9; i >= 0; i -= 1) { if (i % 2 == 0) { continue; } s += f32(i); } return s; }',
      ),
    ).toBe(25);
    expect(
      number(
        'first(3) * 100 + first(30)',
        'fn first(n: i32) -> f32 { for (var i = 0; i < 9; i += 2) { for (var j = 0; j < 3; j++) { if (i * j > n) { return f32(i * 10 + j); } } } return -1.0; }',
      ),
    ).toBe(2199);
    expect(
      result('if (arg1 > 5) { return vec4f(1); } else if (arg1 > 2) { return vec4f(2); } else { return vec4f(3); }'),
    ).toEqual([2, 2, 2, 2]);
    expect(result('var a = 1.0; { let a = 5.0; } return vec4f(a);')).toEqual([1, 1, 1, 1]);
  });

  it('has constants, and functions in any order', () => {
    expect(
      number(
        'twice(K)',
        'const K: f32 = 2 * N; const M = 3; fn twice(x: f32) -> f32 { return 2 * x; }'.replace('2 * N', '6'),
      ),
    ).toBe(12);
    expect(
      number('outer(1)', 'fn outer(x: f32) -> f32 { return inner(x) + 1; } fn inner(x: f32) -> f32 { return x * 10; }'),
    ).toBe(11);
    expect(number('all(p)', 'fn all(q: Pixel) -> f32 { return q.uv.x + q.color.a; }')).toBe(1.25);
    const { reads } = readShaderText(effect('return vec4f(depth(vec2i(1)) + normal(vec2i(0, 1)).x) + p.color;'));
    expect(new Set(reads)).toEqual(new Set(['depth', 'normal', 'image']));
    expect(reads.length).toBe(3);
  });

  it('ignores formatting', () => {
    const text = '/* a /* nested */ comment */ fn effect ( p : Pixel , )->vec4 < f32 >{// end\nreturn(vec4<f32>(1));;}';
    expect(runShaderProgram(readShaderText(text), ABOUT)).toEqual([1, 1, 1, 1]);
  });
});

describe('a text is rejected, with location and remedy:', () => {
  const body = (text: string): string => `fn effect(p: Pixel) -> vec4f {\n  ${text}\n  return vec4f(1);\n}`;
  it.each([
    ['fn main() -> f32 { return 1.0; }', 1, 1, /there is no function effect: write `fn effect\(p: Pixel\) -> vec4f/],
    ['fn effect(p: Pixel) -> vec3f { return vec3f(1); }', 1, 4, /effect should be/],
    [body('while (true) { }'), 2, 3, /`while` is not taken: write a `for`/],
    [body('loop { }'), 2, 3, /`loop` is not taken/],
    [body('discard;'), 2, 3, /`discard` is not taken: return the colour/],
    [body('for (var i = 0; i < 10; i *= 2) { }'), 2, 27, /write i\+\+/],
    [body('for (var i = 0; i < i32(arg1); i++) { }'), 2, 23, /known beforehand.*leave the loop by `break`/],
    [body('for (var i = 0; i < 10; i--) { }'), 2, 21, /never end/],
    [body('for (var i = 0; i > -1; i++) { }'), 2, 21, /never end/],
    [body('for (var i = 0; i < 100000; i++) { }'), 2, 21, /goes round 100000 times; more than 512/],
    [body('for (var i = 0.0; i < 1; i += 0.1) { }'), 2, 16, /whole number/],
    [body('for (var i = 0; i < 4; i++) { i = 0; }'), 2, 33, /counts this loop/],
    [body('for (;;) { }'), 2, 3, /no counter/],
    [body('var x: array<f32, 4>;'), 2, 10, /array is not taken: pass and return values/],
    [body('var<private> x: f32;'), 2, 6, /address spaces/],
    [body('let x = &p;'), 2, 11, /pointers/],
    [body('let x: ptr<function, f32> = 1;'), 2, 10, /ptr is not taken/],
    [body('let x = textureLoad(t, vec2i(0), 0);'), 2, 23, /t is not declared/],
    [body('let x = dpdx(1.0);'), 2, 11, /no function dpdx/],
    [body('let x = 1u;'), 2, 11, /leave the u out/],
    [body('let x: u32 = 1;'), 2, 10, /u32 is not taken: use i32/],
    [body('let x = 1 & 2;'), 2, 13, /works on bits/],
    [body('let x = 1.0; x = 2.0;'), 2, 16, /cannot be changed: copy it into a variable/],
    [body('let x = 1; let x = 2;'), 2, 14, /x already/],
    [body('let x = vec3f(1) + vec2f(1);'), 2, 20, /vec3f and vec2f/],
    [body('let x = 1 + arg1 + i32(2);'), 2, 20, /f32 and i32/],
    [body('let x: vec3f = vec3f(1, 2);'), 2, 18, /3 components, and is given 2/],
    [body('let x: f32 = true;'), 2, 16, /bool, and should be f32: convert it by f32/],
    [body('if (1) { }'), 2, 7, /should be bool/],
    [body('let x = image(p.uv);'), 2, 18, /offset of image.*vec2f.*vec2i/],
    [body('let x = vec2f(1).z;'), 2, 19, /vec2f has no .z/],
    [body('let x = vec2f(1)[2];'), 2, 19, /no \[2\]/],
    [body('let x = p.colour;'), 2, 12, /has position, uv, size, direction, view, projection and color/],
    [body('var v = vec3f(1); v.xy = vec2f(1);'), 2, 22, /one component at a time/],
    [body('let x: mat2x3f = 1;'), 2, 10, /mat2x3f is not known/],
    [body('let x = 1 / 0.0;'), 2, 13, /no number that f32 holds/],
    [body('let x = i32(arg1) % 0;'), 2, 21, /whole number by 0/],
    [body('let x = sqrt(-1);'), 2, 11, /no number/],
    [body('let x = sin(1, 2);'), 2, 11, /takes 1 value, and has 2/],
    [body('let x = y;'), 2, 11, /y is not declared/],
    [body('let x = 3'), 3, 3, /expected `;` here, found `return`/],
    [body('let x = (1;'), 2, 13, /expected `\)`/],
    [body('let $ = 1;'), 2, 7, /no meaning/],
    [body('break;'), 2, 3, /in no loop/],
    ['fn effect(p: Pixel) -> vec4f { if (arg1 > 0) { return vec4f(1); } }', 1, 4, /not every way/],
    ['struct A { x: f32 }', 1, 1, /`struct` is not taken: use vectors/],
    ['@fragment fn effect(p: Pixel) -> vec4f { return vec4f(1); }', 1, 1, /attributes/],
    ['@group(0) @binding(0) var<storage> x: array<f32>;', 1, 1, /attributes/],
    ['var<private> x: f32;', 1, 1, /outside of a function/],
    [
      'fn sin(x: f32) -> f32 { return x; } fn effect(p: Pixel) -> vec4f { return vec4f(1); }',
      1,
      4,
      /call yours otherwise/,
    ],
    [
      'fn a(x: f32) -> f32 { return b(x); }\nfn b(x: f32) -> f32 { return a(x); }\nfn effect(p: Pixel) -> vec4f { return vec4f(a(1)); }',
      1,
      4,
      /calls itself/,
    ],
    ['/* never closed', 1, 1, /no end/],
    ['', 1, 1, /no function effect/],
  ] as const)('%s', (text, line, column, message) => {
    const found = refusal(text);
    expect(found.message).toMatch(message);
    expect([found.line, found.column]).toEqual([line, column]);
  });

  it('if it is too long, too deeply nested or too slow', () => {
    expect(refusal(' '.repeat(SHADER_TEXT_LIMITS.length + 1)).message).toMatch(/shorten it/);
    expect(refusal(body(`let x = ${'('.repeat(5000)}1${')'.repeat(5000)};`)).message).toMatch(/brackets deep/);
    expect(refusal(body(`let x = ${'-'.repeat(5000)}1;`)).message).toMatch(/expected|brackets deep/);
    expect(refusal(body(`let x = 1${' + 1'.repeat(3000)};`)).message).toMatch(/longer than 128 operators/);
    expect(refusal(body(`${'{'.repeat(3000)}`)).message).toMatch(/brackets deep/);
    expect(refusal(body(`${'if (true) { } else '.repeat(500)} { }`)).message).toMatch(/brackets deep/);
    const loop = (inner: string, n: number, name: string) =>
      `for (var ${name} = 0; ${name} < ${n}; ${name}++) { ${inner} }`;
    expect(refusal(body(loop(loop('', 100, 'i'), 100, 'j'))).message).toMatch(/go round 10000 times/);
    expect(
      refusal(
        body(
          `var s = vec4f(0); ${loop(loop('s += image(vec2i(i, j)) * exp(f32(i * j)) / exp2(f32(i + j)) * sin(f32(i));', 60, 'i'), 60, 'j')}`,
        ),
      ).message,
    ).toMatch(/steps for each pixel/);
    const doubling = Array.from(
      { length: 14 },
      (_, k) => `fn f${k + 1}(x: f32) -> f32 { return f${k}(x) + f${k}(x + 1); }`,
    ).join('\n');
    expect(
      refusal(`fn f0(x: f32) -> f32 { return x; }\n${doubling}\nfn effect(p: Pixel) -> vec4f { return vec4f(f14(1)); }`)
        .message,
    ).toMatch(/operations/);
    expect(
      refusal(
        `fn round1(x: f32) -> f32 { var s = x; ${loop('s += 1;', 100, 'i')} return s; }\n${body(`var s = 0.0; ${loop('s += round1(s);', 100, 'i')}`)}`,
      ).message,
    ).toMatch(/go round 10000 times/);
  });

  it('and any text either runs or is rejected with a location', () => {
    const words = [
      'fn',
      'effect',
      '(',
      ')',
      'p',
      ':',
      'Pixel',
      '->',
      'vec4f',
      '{',
      '}',
      'return',
      ';',
      'let',
      'var',
      'x',
      '=',
      '1',
      '.5',
      '+',
      '*',
      '<',
      '>',
      'for',
      'if',
      'else',
      'i',
      '++',
      ',',
      '.',
      'xy',
      '[',
      ']',
      'image',
      'vec2i',
      'const',
      '-',
      '!',
      '&&',
      'true',
      'mat2x2f',
      'select',
      'break',
    ];
    const text = fc.oneof(
      fc.string(),
      fc.array(fc.constantFrom(...words), { maxLength: 60 }).map((list) => list.join(' ')),
      fc.array(fc.constantFrom(...words), { maxLength: 30 }).map((list) => effect(list.join(' '))),
      fc
        .array(fc.constantFrom(...words), { maxLength: 8 })
        .map((list) => effect(`var x = vec4f(1); x = ${list.join(' ')}; return x;`)),
    );
    fc.assert(
      fc.property(text, (written) => {
        try {
          expect(runShaderProgram(readShaderText(written), ABOUT).length).toBe(4);
        } catch (thrown) {
          expect(thrown).toBeInstanceOf(ShaderTextError);
        }
      }),
      { numRuns: 2000 },
    );
  });
});
