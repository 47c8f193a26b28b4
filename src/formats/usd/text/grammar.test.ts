import { describe, expect, it } from 'vitest';
import { InputError } from '../../../scene/types.ts';
import type { AttributeSpec, Value } from '../layer/layer.ts';
import { parseLayer } from './parser.ts';

const parse = (body: string) => parseLayer(new TextEncoder().encode(`#usda 1.0\n${body}`), 'a.usda');

function attribute(declaration: string): AttributeSpec {
  const { properties } = parse(`def "A"\n{\n${declaration}\n}\n`).rootPrims.get('A')!;
  return [...properties.values()][0] as AttributeSpec;
}
const valueIn = (declaration: string): Value => attribute(declaration).value!;

function errorOf(text: string): string {
  try {
    parseLayer(new TextEncoder().encode(text), 'a.usda');
  } catch (thrown) {
    if (!(thrown instanceof InputError)) throw thrown;
    return thrown.message;
  }
  throw new Error('no error');
}
const errorIn = (body: string): string => errorOf(`#usda 1.0\n${body}`);

describe('numbers', () => {
  it('are stored in typed arrays of their type', () => {
    expect(valueIn('point3f[] p = [(1, 2, 3), (4, 5, 6)]')).toEqual({
      type: 'float3[]',
      data: Float32Array.of(1, 2, 3, 4, 5, 6),
    });
    expect(valueIn('uint[] p = [4294967295]')).toEqual({ type: 'uint[]', data: Uint32Array.of(4294967295) });
    expect(valueIn('int64 p = -9007199254740993')).toEqual({ type: 'int64', data: -9007199254740993n });
  });

  it('are rounded correctly, with few or many digits', () => {
    for (const text of [
      '0.1',
      '1e23',
      '8.41e21',
      '123456789012345680',
      '0.000001',
      '9007199254740993',
      '2.2250738585072011e-308',
      '5e-324',
      `0.${'3'.repeat(400)}`,
      `1${'0'.repeat(300)}`,
      '1e-22',
      '4.35',
      '0.3',
      '1e400',
    ])
      expect(valueIn(`double x = ${text}`)).toEqual({ type: 'double', data: Number(text) });
  });

  it('have the quaternion’s real part last', () => {
    expect(valueIn('quatf q = (1, 2, 3, 4)')).toEqual({ type: 'quatf', data: Float32Array.of(2, 3, 4, 1) });
  });

  it('are counted correctly with comments in between', () => {
    expect(valueIn('int[] x = [1, # ], 2\n 2, // ]\n 3 /* ],,,, */, 4]')).toEqual({
      type: 'int[]',
      data: Int32Array.of(1, 2, 3, 4),
    });
  });

  it.each([
    ['int x = 3000000000', '3000000000 is not a whole number from -2147483648 to 2147483647'],
    ['uint x = -1.5', '-1.5 is not a whole number'],
    ['float x:1 = 2', "expected a new line or ';'"],
    ['rel x = <A//B>', '<A//B> is not the path of a prim or a property'],
    ['rel x = [</A>, </A>]', 'an item of this list is there twice'],
    ['def def "A" {\n}', "'def' is a word of the language"],
    ['int x = 1;; int y', "found ';'"],
    ['uniform int x\nint x', "'x' is uniform in one statement and not in another"],
    ['uchar x = 256', 'from 0 to 255'],
    ['int64 x = 9223372036854775808', 'does not fit int64'],
    ['int64 x = 1.0', "expected a whole number, found '1.0'"],
    ['float x = +1', "expected a number, found '+'"],
    ['float x = 1e', 'the exponent of this number has no digits'],
    ['bool x = on', "'on' is not true, false, 0 or 1"],
    ['float3 x = (1, 2)', "expected ',' between the 3 parts"],
    ['float3 x = (1, 2, 3, 4)', "expected ')' after the 3 parts"],
    ['matrix2d x = (1, 2, 3, 4)', "expected '(' before a value with 2 numbers, found '1'"],
    ['float[] x = [1 2]', "expected ',' or ']' in a list, found '2'"],
    ['float[] x = [1, 2', 'in a list, found'],
  ])('%s is refused', (declaration, message) => {
    expect(errorIn(`def "A"\n{\n${declaration}\n}\n`)).toContain(message);
  });
});

describe('kinds of absence are distinguished', () => {
  it('no value, a blocked value, a blocked sample', () => {
    expect(attribute('float x').value).toBeUndefined();
    expect(valueIn('float x = None')).toEqual({ type: 'blocked' });
    expect(valueIn('double x = AnimationBlock')).toEqual({ type: 'animationBlock' });
    const { timeSamples } = attribute('float x.timeSamples = { 2: 5, 1: None }');
    expect(timeSamples!.times).toEqual(Float64Array.of(1, 2));
    expect(timeSamples!.values).toEqual([{ type: 'blocked' }, { type: 'float', data: 5 }]);
  });
});

describe('errors have file, line and column, what was found and what was expected', () => {
  it.each([
    ['', "a.usda:1:1: the file does not begin with '#usda 1.0', so it is not USD text"],
    ['#usda 2.0\n', 'a.usda: is USD text of version 2.0; only 1.x is read'],
    [
      '#usda 1.0\ndef "A"\n',
      "a.usda:3:1: expected '{' before the contents of /A, found the end of the file; it may be cut off",
    ],
    ['#usda 1.0\ndef "A"\n{\n  float x = \n}\n', "a.usda:5:1: expected a number, found '}'"],
    [
      '#usda 1.0\ndef "A"\n{\n  float x = 1 float y = 2\n}\n',
      "a.usda:4:15: expected a new line or ';' after the attribute 'x', found 'float'",
    ],
    ['#usda 1.0\ndef "A b"\n{\n}\n', "a.usda:2:5: 'A b' is not a prim name"],
    ['#usda 1.0\ndef "A"\n{\n}\ndef "A"\n{\n}\n', 'a.usda:5:5: there is already a prim /A'],
    ['#usda 1.0\ndef "A"\n{\nfloat x\nint x\n}\n', "'x' is already of type float, not int"],
    ['#usda 1.0\ndef "A"\n{\nrel x\nint x\n}\n', "'x' is already a relationship of /A"],
    [
      '#usda 1.0\ndef "A"\n{\nstring s = "abc\n}\n',
      'a.usda:4:12: the string that begins here is not closed on its line',
    ],
    ['#usda 1.0\ndef "A"\n{\nasset s = @abc\n}\n', 'the asset path that begins here is not closed with @ on its line'],
    ['#usda 1.0\n(\n  foo bar\n)\n', "a.usda:3:7: expected '=' after the metadata key 'foo', found 'bar'"],
    ['#usda 1.0\nxform "A"\n', "a.usda:2:1: expected 'def', 'over' or 'class', found 'xform'"],
    ['#usda 1.0\n/* open', 'the comment that begins here is not closed with */'],
    ['#usda 1.0\ndef "A"\n{\nprepend float x = 1\n}\n', "expected '.connect' after a list qualifier"],
    ['#usda 1.0\ndef "A"\n{\nfloat x.default = 1\n}\n', "'.default' is not .timeSamples, .connect or .spline"],
  ])('%j', (text, message) => {
    expect(errorOf(text)).toContain(message);
  });

  it('rejects invalid UTF-8', () => {
    const bytes = new TextEncoder().encode('#usda 1.0\ndef "A"\n{\n  string s = "é"\n}\n');
    bytes[bytes.indexOf(0xc3)] = 0xff;
    expect(() => parseLayer(bytes, 'a.usda')).toThrow('this text is not UTF-8');
  });
});

describe('nesting is bounded', () => {
  const deep = (open: string, close: string, n: number): string => open.repeat(n) + close.repeat(n);

  it('of prims', () => {
    const prims = (n: number) => `${'def "A" {\n'.repeat(n)}${'}\n'.repeat(n)}`;
    expect(parse(prims(200)).rootPrims.size).toBe(1);
    expect(errorIn(prims(100_000))).toContain('prims are nested more than 256 deep');
  });

  it('of dictionaries, variants and unknown values', () => {
    expect(errorIn(`(\ncustomLayerData = { ${deep('dictionary a = {', '}', 1e5)} }\n)`)).toContain('64 deep');
    expect(errorIn(`def "A" {\n ${'variantSet "v" = { "x" {\n'.repeat(1e5)}`)).toContain('256 deep');
    expect(errorIn(`def "A" {\n odd x = ${deep('[', ']', 1e5)}\n}`)).toContain('64 deep');
    const custom = `1: 2; { ${deep('dictionary a = {', '}', 1e5)} }`;
    expect(errorIn(`def "A" {\n float x.spline = { ${custom} }\n}`)).toContain('64 deep');
  });
});

describe('statements', () => {
  it('end at a newline, a semicolon or a bracket', () => {
    const { properties } = parse('def "A" { float x = 1; float y; rel z; int w = 2 }').rootPrims.get('A')!;
    expect([...properties.keys()]).toEqual(['x', 'y', 'z', 'w']);
  });

  it('that delete or prepend nothing have no effect, and an explicit empty list is empty', () => {
    const op = (statement: string) => {
      const entry = parse(`def "A" (\n${statement} = []\n)\n{\n}`).rootPrims.get('A')!.metadata.get('references');
      return entry?.type === 'arcs' ? entry.op : undefined;
    };
    expect(op('delete references')).toEqual({});
    expect(op('references')).toEqual({ explicit: [] });
  });

  it('keep a value of unknown type as text', () => {
    expect(valueIn('odd x = [("]", 2), @a@]')).toEqual({ type: 'unregistered', data: '[("]", 2), @a@]' });
  });

  it('may use names of inherited properties', () => {
    const { metadata } = parse('(\n customLayerData = {\n int __proto__ = 1\n int constructor = 2\n }\n)');
    const data = metadata.get('customLayerData') as Extract<Value, { type: 'dictionary' }>;
    expect([...data.data.keys()]).toEqual(['__proto__', 'constructor']);
    expect(({} as Record<string, unknown>).type).toBeUndefined();
  });
});
