import fc from 'fast-check';
import { deflateSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { add, build, connect, documents, toys } from '../../../tests/support/graphKit.ts';
import { inEnglish } from '../../messages/message.ts';
import { validateDocument } from '../analysis/validate.ts';
import { copyFragment, parseFragment, pasteFragment, serializeFragment } from '../edits/fragment.ts';
import { Evaluator } from '../evaluation/evaluator.ts';
import { DocumentError, emptyDocument, type GraphDocument } from './document.ts';
import { parseDocument } from './parse.ts';
import { serializeDocument } from './serialize.ts';
import { isShareLink } from './shareFragment.ts';
import { decodeShareLink, encodeShareLink } from './shareLink.ts';

/** Every input gives a document or a DocumentError with a place. */
function readOrRefuse<T>(read: () => T): T | undefined {
  try {
    return read();
  } catch (error) {
    expect(error).toBeInstanceOf(DocumentError);
    expect((error as Error).message).toMatch(/^.+?: ./s);
    return undefined;
  }
}

/** A value in JSON that is replaced, duplicated or removed. */
interface Damage {
  readonly path: readonly number[];
  readonly by: unknown;
}
const odd = fc.oneof(
  fc.constantFrom<unknown>(
    null,
    0,
    -1,
    1e308,
    '',
    '__proto__',
    'constructor',
    'x.y',
    [],
    {},
    true,
    [[]],
    'a'.repeat(300),
  ),
  fc.string(),
  fc.constantFrom('n0', 'n1', 'group', 'group-input', 'group-output', 'reroute', 'any', 'value'),
);
const damage: fc.Arbitrary<Damage> = fc.record({ path: fc.array(fc.nat(30), { minLength: 1, maxLength: 6 }), by: odd });

function damaged(text: string, { path, by }: Damage): string {
  const data: unknown = JSON.parse(text);
  let at = data as Record<string, unknown>;
  for (const step of path.slice(0, -1)) {
    const keys = Object.keys(at);
    const next = keys.length === 0 ? undefined : at[keys[step % keys.length]!];
    if (typeof next !== 'object' || next === null) break;
    at = next as Record<string, unknown>;
  }
  const keys = Object.keys(at);
  const key = keys.length === 0 ? 'more' : keys[path.at(-1)! % keys.length]!;
  if (path.at(-1)! % 5 === 0) delete at[key];
  else if (path.at(-1)! % 7 === 0 && typeof by === 'string') at[by] = at[key];
  else at[key] = by;
  return JSON.stringify(data);
}

/** Exercises a document; one that could be read must not fail. */
async function use(document: GraphDocument): Promise<void> {
  expect(parseDocument(serializeDocument(document))).toEqual(document);
  const problems = validateDocument(document, toys);
  for (const { message, place } of problems) expect([message, place].map(inEnglish)).not.toContain('');
  const { results } = await new Evaluator(toys).evaluate(document, Object.keys(document.nodes), {});
  const odd = [...results.values()].filter(
    (result) => result.status === 'failed' && result.problem.code === 'graph.evaluation',
  );
  expect(odd).toEqual([]);
}

describe('a project', () => {
  it('that is damaged is rejected with a location, or can be used', () =>
    fc.assert(
      fc.asyncProperty(
        documents(25),
        fc.array(damage, { minLength: 1, maxLength: 3 }),
        fc.integer({ min: 1, max: 4 }),
        async (document, list, version) => {
          const { format, nodes, edges, layout } = document;
          // Of an earlier version, which is migrated first, or the current one.
          const old =
            version < 3 ? JSON.stringify({ format, version, nodes, edges, layout }) : serializeDocument(document);
          const text = list.reduce(damaged, old);
          const read = readOrRefuse(() => parseDocument(text));
          if (read) await use(read);
        },
      ),
      { numRuns: 300 },
    ));

  it('of random bytes is rejected', () => {
    fc.assert(
      fc.property(fc.oneof(fc.string(), fc.json()), (text) => readOrRefuse(() => parseDocument(text)) === undefined),
    );
  });

  it.each([
    ['too large', `"${' '.repeat(2 ** 24)}"`, /^the file: 16 MiB is more/],
    ['deeper than any', '['.repeat(1e6), /^not JSON|^the file/],
    ['an edge under another name', edgeNamed('x.b'), /^edges\.x\.b: it feeds s\.a/],
    ['an edge to nothing', edgeNamed('s.a', { nodes: {}, layout: {} }), /^edges\.s\.a\.from: there is no node "x"/],
    ['a place for nothing', edgeNamed('s.a', { layout: { toString: [0, 0] } }), /^layout\.toString: there is no node/],
    [
      'a socket that is there twice',
      edgeNamed('s.a', { groups: { g: doubled() } }),
      /^groups\.g\.inputs: there are two of the name "a"/,
    ],
    ['more nodes than may be', edgeNamed('s.a', { nodes: many() }), /^nodes: 10001 are more than the 10000/],
  ])('%s is rejected with its location', (_what, text, message) => {
    expect(() => parseDocument(text)).toThrow(message);
    expect(() => parseDocument(text)).toThrow(DocumentError);
  });

  it('may use names of inherited properties', async () => {
    const document = build(
      add('constructor', 'value'),
      add('toString', 'sum'),
      connect('constructor.number', 'toString.a'),
    );
    await use(document);
    await use(build(add('x', 'constructor'), add('s', 'sum'), connect('x.hasOwnProperty', 's.a')));
  });
});

function edgeNamed(key: string, more: object = {}): string {
  const document = build(add('x', 'value'), add('s', 'sum'), connect('x.number', 's.a'));
  return JSON.stringify({ ...document, edges: { [key]: Object.values(document.edges)[0] }, ...more });
}
function doubled() {
  const { format: _f, version: _v, groups: _g, files: _files, ...graph } = emptyDocument();
  const socket = { name: 'a', type: 'number' };
  return { title: '', ...graph, inputs: [socket, socket], outputs: [] };
}
function many() {
  return Object.fromEntries(Array.from({ length: 10_001 }, (_, i) => [`n${i}`, { type: 'value', params: {} }]));
}

describe('copied nodes', () => {
  it('that are damaged are rejected with a location, or can be pasted', () => {
    fc.assert(
      fc.property(documents(25), fc.array(damage, { minLength: 1, maxLength: 3 }), (document, list) => {
        const copied = serializeFragment(copyFragment(document, { nodes: Object.keys(document.nodes) }));
        const fragment = readOrRefuse(() => parseFragment(list.reduce(damaged, copied)));
        if (fragment) pasteFragment(document, fragment);
      }),
      { numRuns: 200 },
    );
  });
});

describe('a link', () => {
  it('round-trips any project', () => {
    fc.assert(
      fc.property(documents(40), (document) => {
        const fragment = encodeShareLink(document);
        expect(fragment).toMatch(/^project=[A-Za-z0-9_-]+$/);
        expect(isShareLink(`#${fragment}`)).toBe(true);
        expect(decodeShareLink(`#${fragment}`)).toEqual(document);
      }),
      { numRuns: 100 },
    );
  });

  it('that is damaged is rejected', () => {
    const letters = fc.constantFrom(...'AZaz09-_=+/ %');
    const change = fc.record({ at: fc.nat(2000), cut: fc.nat(40), put: fc.string({ unit: letters, maxLength: 6 }) });
    fc.assert(
      fc.property(documents(20), change, (document, { at, cut, put }) => {
        const whole = encodeShareLink(document);
        const from = 8 + (at % (whole.length - 8));
        const text = whole.slice(0, from) + put + whole.slice(from + cut);
        readOrRefuse(() => decodeShareLink(text));
      }),
      { numRuns: 300 },
    );
    for (const text of ['', '#', 'scene=a', 'project=', 'project=AAAA', 'project=#', `project=${'A'.repeat(40_000)}`])
      expect(readOrRefuse(() => decodeShareLink(text))).toBeUndefined();
  });

  it('that is a decompression bomb is not unpacked', () => {
    const bomb = deflateSync(new Uint8Array(2 ** 24), { level: 9 });
    expect(() => decodeShareLink(`project=${Buffer.from(bomb).toString('base64url')}`)).toThrow(/unpacks to more than/);
  });

  it('is not created for a project that is too large', () => {
    const document = build(
      ...Array.from({ length: 3000 }, (_, i) =>
        add(`n${i}x${(i * 7919) % 104729}`, 'value', [(i * 104729) % 9973, (i * 7919) % 9967]),
      ),
    );
    expect(() => encodeShareLink(document)).toThrow(/save it to a file/);
  });
});
