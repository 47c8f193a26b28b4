import { describe, expect, it } from 'vitest';
import { InputError } from '../../../scene/types.ts';
import type { AttributeSpec, Layer } from '../layer/layer.ts';
import { outcome, refusal } from './fixtures/outcome.ts';
import {
  bytes,
  type CrateParts,
  DATA_START,
  evenIntegers,
  integers,
  rep,
  repeated,
  sized,
  stored,
  u32,
  u64,
  writeCrate,
} from './fixtures/writeCrate.ts';

const TOKENS = [
  '',
  'primChildren',
  'A',
  'specifier',
  'properties',
  'x',
  'typeName',
  'int[]',
  'default',
  'timeSamples',
  'customData',
];
const token = (name: string): number => TOKENS.indexOf(name);

/** A layer with one prim `A` that has one attribute `x`, whose fields are given; `/A`'s own may have more. */
function crate(
  data: Uint8Array,
  own: readonly (readonly [string, bigint])[],
  ofPrim: readonly (readonly [string, bigint])[] = [],
  rest: Partial<CrateParts> = {},
): Uint8Array {
  const typeName = own.find(([name]) => name === 'typeName')?.[1] ?? rep(11, token('int[]'), 'i');
  const others = own.filter(([name]) => name !== 'typeName');
  const lists = bytes(u64(1), u32(token('A')), u64(1), u32(token('x')));
  const at = DATA_START + data.length;
  const fields = [
    ['primChildren', rep(41, at)],
    ['properties', rep(41, at + 12)],
    ['typeName', typeName],
    ...others,
    ...ofPrim,
  ] as const;
  const indices = (from: number, count: number): number[] => Array.from({ length: count }, (_, i) => from + i);
  const ownSet = [2, ...indices(3, others.length), -1];
  return writeCrate({
    tokens: TOKENS,
    strings: [token('x')],
    data: bytes(data, lists),
    fields: fields.map(([name, value]) => [token(name), value]),
    fieldSets: [0, -1, ...ownSet, 1, ...indices(3 + others.length, ofPrim.length), -1],
    paths: [
      [0, 0, -1],
      [1, token('A'), -1],
      [2, -token('x'), -2],
    ],
    specs: [
      [0, 0, 7],
      [1, 2 + ownSet.length, 6],
      [2, 2, 1],
    ],
    ...rest,
  });
}

const attribute = (data: Uint8Array): AttributeSpec => {
  const layer = outcome(data);
  if (layer instanceof InputError) throw layer;
  return layer.rootPrims.get('A')!.properties.get('x') as AttributeSpec;
};

const INTS = rep(3, DATA_START, 'ac');
const even = (count: number): Uint8Array => bytes(u64(count), evenIntegers(count, 3));

describe('a crate written here', () => {
  it('is read', () => {
    const { value, typeName } = attribute(crate(even(1000), [['default', INTS]]));
    expect(typeName).toBe('int[]');
    expect(value).toEqual({ type: 'int[]', data: Int32Array.from({ length: 1000 }, (_, i) => 3 * (i + 1)) });
  });

  it('may expand a thousandfold, but not indefinitely', () => {
    const data = crate(even(4e6), [['default', INTS]]);
    expect(data.length).toBeLessThan(16_000);
    expect((attribute(data).value as { data: Int32Array }).data.at(-1)).toBe(12e6);
    expect(refusal(crate(even(1e8), [['default', INTS]]))).toMatch(
      /^a\.usdc<\/A\.x> default \(byte 96\): an array of 100000000 numbers would take 381 MiB where \S+ MiB are left: .*split it/,
    );
  });

  it('may refer to one array from all its samples', () => {
    const [count, ints] = [20_000, even(1000)];
    const at = DATA_START + ints.length;
    const times = bytes(u64(count), new Uint8Array(Float64Array.from({ length: count }, (_, i) => i).buffer));
    const samples = bytes(times, u64(8, rep(48, at), 8, count), ...Array.from({ length: count }, () => u64(INTS)));
    const { timeSamples } = attribute(crate(bytes(ints, samples), [['timeSamples', rep(46, at + times.length)]]));
    expect(timeSamples!.values.length).toBe(count);
    expect(new Set(timeSamples!.values).size).toBe(1);
  });

  it('must not overlap arrays beyond the size of the file', () => {
    const [count, length] = [2000, 2 ** 18];
    // A length at every eighth byte, at which an array of that many bytes begins.
    const lengths = bytes(...Array.from({ length: count }, () => u64(length)));
    const zeros = new Uint8Array(length);
    const times = bytes(u64(count), new Uint8Array(Float64Array.from({ length: count }, (_, i) => i).buffer));
    const at = DATA_START + lengths.length + length;
    const arrays = Array.from({ length: count }, (_, i) => rep(2, DATA_START + 8 * i, 'a'));
    const samples = bytes(times, u64(8, rep(48, at), 8, count, ...arrays));
    const data = crate(bytes(lengths, zeros, samples), [['timeSamples', rep(46, at + times.length)]]);
    expect(data.length).toBeLessThan(2 ** 19);
    expect(refusal(data)).toContain('an array of 262144 numbers would take 256 KiB where');
  });

  it('must not have dictionaries that contain themselves', () => {
    const self = bytes(u64(1), u32(0), u64(8), u64(rep(31, DATA_START)));
    expect(refusal(crate(self, [], [['customData', rep(31, DATA_START)]]))).toBe(
      'a.usdc</A> customData (byte 108): values are nested more than 64 deep',
    );
  });

  it.each([31, 52, 53])('must not have dictionaries that double at every level, by type %i', (type) => {
    // 64 bytes each: two entries that refer to the next dictionary, then a value that is this one.
    const start = (i: number): number => DATA_START + 64 * i;
    const level = (i: number): Uint8Array => {
      const following = rep(31, start(i + 1));
      const entry = bytes(u32(0), u64(8, type === 31 ? following : rep(type, start(i) + 48)));
      return bytes(u64(2), entry, entry, u64(8, following));
    };
    const levels = Array.from({ length: 30 }, (_, i) => level(i));
    expect(refusal(crate(bytes(...levels, u64(0)), [], [['customData', rep(31, DATA_START)]]))).toContain(
      'a dictionary would take 128 bytes where',
    );
  });

  it('with a duplicate field is rejected', () => {
    const field = ['default', rep(3, 1, 'i')] as const;
    expect(refusal(crate(u64(0), [field, field]))).toBe('a.usdc</A.x> default: it has this field twice');
  });

  it('with an index past the end of a table is rejected', () => {
    const places = Array.from({ length: 20 }, (_, i) => (i === 7 ? 2 : 1));
    const data = bytes(u64(20), ['t'.charCodeAt(0)], u32(2, 0, 0x3f800000), integers(places));
    expect(refusal(crate(data, [['default', rep(8, DATA_START, 'ac')]]))).toContain(
      'default (byte 96): number 7 of an array is at place 2 of a table of 2',
    );
  });

  it('with more samples than times is rejected', () => {
    const times = bytes(u64(1), new Uint8Array(8));
    const samples = bytes(times, u64(8, rep(48, DATA_START), 8, 2, rep(3, 0, 'i'), rep(3, 0, 'i')));
    expect(refusal(crate(samples, [['timeSamples', rep(46, DATA_START + times.length)]]))).toContain(
      'there are 2 samples at 1 times',
    );
  });

  it('with unsorted samples is rejected', () => {
    const times = bytes(u64(2), new Uint8Array(Float64Array.of(2, 1).buffer));
    const samples = bytes(times, u64(8, rep(48, DATA_START), 8, 2, rep(3, 0, 'i'), rep(3, 0, 'i')));
    expect(refusal(crate(samples, [['timeSamples', rep(46, DATA_START + times.length)]]))).toContain(
      'a.usdc</A.x> timeSamples (byte 112): sample 1 is at the time 1, not after 2',
    );
  });

  it.each<[string, Partial<CrateParts>, string]>([
    [
      '0.3',
      { version: 3 },
      'is a crate file of version 0.3.0; 0.4 to 0.15 are read; write it anew with a present OpenUSD',
    ],
    ['0.16', { version: 16 }, 'is a crate file of version 0.16.0; 0.4 to 0.15 are read; write it as text: usdcat'],
  ])('of version %s is refused', (_, rest, message) => {
    expect(refusal(crate(u64(0), [], [], rest))).toContain(message);
  });

  it('with an array edit is rejected', () => {
    expect(refusal(crate(u64(0), [['default', rep(3, DATA_START, 'e')]], [], { version: 14 }))).toContain(
      'a.usdc</A.x> default: an array edit (crate 0.14) is not read; flatten it',
    );
  });

  it.each<[string, readonly [string, bigint], string]>([
    ['a number for a type', ['typeName', rep(3, 1, 'i')], '</A.x>: its typeName is of kind int, not token'],
    ['no such type', ['default', rep(99, DATA_START)], 'default: there is no type 99'],
    ['an array of what has none', ['default', rep(31, DATA_START, 'a')], 'there are no arrays of type 31'],
    ['a list op for a value', ['default', rep(32, 0, 'i')], 'a value of kind texts stands where none can'],
    ['a token that is not', ['default', rep(11, 999, 'i')], 'there is no token 999; there are 11'],
    ['a string that is not', ['default', rep(10, 7, 'i')], 'there is no string 7; there are 1'],
    ['a place past the end', ['default', rep(9, 2 ** 40)], 'a number takes 8 bytes from byte 1099511627776'],
    ['numbers compressed in no known way', ['default', rep(8, DATA_START, 'ac')], 'in an unknown way (255)'],
  ])('with %s is refused', (_, field, message) => {
    const data = bytes(u64(20), [255]);
    expect(refusal(crate(data, [field]))).toContain(message.replace('\\', ''));
  });
});

describe('invalid paths', () => {
  const paths = (...rows: CrateParts['paths']): string => refusal(crate(u64(0), [], [], { paths: rows }));
  const A = token('A');

  it.each<[string, CrateParts['paths'], string]>([
    [
      'lead round in a circle',
      [
        [0, 0, -1],
        [1, A, 1],
        [2, A, 0],
      ],
      'round in a circle',
    ],
    [
      'share an index',
      [
        [0, 0, -1],
        [0, A, -2],
      ],
      'two paths have index 0',
    ],
    [
      'have an index too large',
      [
        [0, 0, -1],
        [7, A, -2],
      ],
      'a path has index 7 of 2',
    ],
    [
      'have no token',
      [
        [0, 0, -1],
        [1, 77, -2],
      ],
      'an element of a path is token 77 of 11',
    ],
    ['jump nowhere', [[0, 0, -9]], 'the jump after path 0 is -9'],
    [
      'jump past the end',
      [
        [0, 0, -1],
        [1, A, 50],
        [2, A, -2],
      ],
      'leads to path 51 of 3',
    ],
  ])('%s', (_, rows, message) => {
    expect(paths(...rows)).toContain(message);
  });

  it('are too deep', () => {
    const rows = Array.from({ length: 400 }, (_, i): [number, number, number] => [i, i && A, i < 399 ? -1 : -2]);
    expect(paths(...rows)).toMatch(/^a\.usdc \(PATHS, byte \d+\): paths are nested more than 256 deep$/);
  });

  it('declare more than they have', () => {
    const section = bytes(u64(2 ** 40, 1), integers([0]), integers([0]), integers([-2]));
    expect(refusal(crate(u64(0), [], [], { sections: { PATHS: section } }))).toContain(
      '1099511627776 paths would take 8.00 TiB',
    );
  });
});

describe('invalid specs', () => {
  const specs = (...rows: CrateParts['specs']): string => refusal(crate(u64(0), [], [], { specs: rows }));

  it.each<[string, CrateParts['specs'], string]>([
    ['are of no layer', [[1, 0, 6]], 'there is no spec of the layer itself'],
    ['are of no path', [[9, 0, 6]], 'spec 0 is of path 9, which is none'],
    [
      'are two of one path',
      [
        [0, 0, 7],
        [0, 0, 7],
      ],
      'there are two specs of /',
    ],
    ['are listed and not there', [[0, 0, 7]], "it lists 'A', of which there is no spec"],
    [
      'are there and not listed',
      [
        [0, 1, 7],
        [1, 1, 6],
      ],
      'a.usdc</A>: there is a spec of this path, which is in no list',
    ],
    ['have fields past the end', [[0, 5000, 7]], 'its list of fields begins at 5000 of 6 and has no end'],
  ])('%s', (_, rows, message) => {
    expect(specs(...rows)).toContain(message);
  });

  it.each(['../A', 'A/B', 'a.b', '', ' ', '1', '{v=x}'])("are of a prim '%s'", (name) => {
    const tokens = TOKENS.map((known) => (known === 'A' ? name : known));
    expect(refusal(crate(u64(0), [], [], { tokens }))).toContain(`'${name}' is not a prim name`);
  });

  it('may belong to a prim with the name of an inherited property', () => {
    const tokens = TOKENS.map((known) => (known === 'A' ? '__proto__' : known));
    const layer = outcome(crate(u64(0), [], [], { tokens })) as Layer;
    expect([...layer.rootPrims.keys()]).toEqual(['__proto__']);
  });
});

describe('invalid tokens', () => {
  const tokens = (section: Uint8Array): string => refusal(crate(u64(0), [], [], { sections: { TOKENS: section } }));

  it('are not UTF-8, too few, too many or too long', () => {
    expect(refusal(crate(u64(0), [], [], { tokens: [Uint8Array.of(0xff)] }))).toContain('token 0 is not UTF-8');
    expect(tokens(bytes(u64(3, 4), sized(stored(u32(0x41004100)))))).toContain('of 3 tokens there are 2');
    expect(tokens(bytes(u64(5, 4), sized(stored(u32(0)))))).toContain('it says 5 tokens in 4 bytes');
    expect(tokens(bytes(u64(1, 2 ** 50), sized(stored(u32(0)))))).toContain('it says 1125899906842624 bytes of tokens');
    expect(tokens(bytes(u64(1e8, 1e8), sized(repeated(0, 1e8))))).toContain('100000000 tokens would take');
  });

  it('are referenced but missing', () => {
    expect(refusal(crate(u64(0), [], [], { strings: [99] }))).toMatch(
      /STRINGS, byte \d+\): string 0 is token 99 of 11/,
    );
    const fields = bytes(u64(1), integers([99]), sized(stored(u64(0))));
    expect(refusal(crate(u64(0), [], [], { sections: { FIELDS: fields } }))).toContain(
      'the name of field 0 is token 99 of 11',
    );
  });

  it('are of fields that have fewer values', () => {
    const fields = bytes(u64(2), integers([1, 2]), sized(stored(u64(0))));
    expect(refusal(crate(u64(0), [], [], { sections: { FIELDS: fields } }))).toContain(
      'the values of 2 fields take 8 bytes, not 16',
    );
  });

  it('have invalid compression', () => {
    const lz4 = (...data: number[]): string => tokens(bytes(u64(1, 100), sized(Uint8Array.from(data))));
    expect(lz4()).toContain('it says 100 bytes of tokens, which 0 compressed bytes cannot hold');
    expect(lz4(0, 0xf0, 255)).toContain('compressed data ends in the middle of a length');
    expect(lz4(0, 0x50, 1)).toContain('compressed data has 5 bytes that do not fit');
    expect(lz4(0, 0x10, 1, 5)).toContain('compressed data ends in the middle of a match');
    expect(lz4(0, 0x10, 1, 5, 0)).toContain('compressed data repeats 4 bytes from 5 before, which it has not');
    expect(lz4(0, 0x10, 1, 0, 0)).toContain('from 0 before, which it has not');
    expect(lz4(0, 0x1f, 1, 1, 0, 255, 0)).toContain('compressed data repeats 274 bytes');
    expect(lz4(2, 200, 0, 0, 0, 0)).toContain('a compressed chunk says 200 bytes, past its end');
  });
});
