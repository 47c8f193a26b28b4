import { describe, expect, it } from 'vitest';
import { emptyDocument, MAX_NODES } from './document.ts';
import { parseDocument } from './parse.ts';

const whole = emptyDocument();
const withNode = (parts: object) => ({ ...whole, nodes: { n: { type: 'merge', params: {}, ...parts } } });
const withNote = (parts: object) => ({ ...whole, notes: { a: { text: '', at: [0, 0], size: [9, 9], ...parts } } });
const withEdge = (input: string) => ({
  ...whole,
  edges: { e: { from: { node: 'n', output: 'geometry' }, to: { node: 'n', input } } },
});
const withFile = (name: string, parts: object) => ({ ...whole, files: { [name]: parts } });
const mark = { name: '1', time: 0, position: [0, 0, 0], properTime: 0, ownTime: 0, u: [0, 0, 0] };
const NAME = 'a name is a letter and at most 63 more letters, digits, - or _';
const VALUE = 'a value is a number, true or false, a text, or a list of numbers or of texts';

describe('a project that breaks the schema is refused with place, rule and value:', () => {
  it.each<[why: string, data: unknown, message: string]>([
    ['no project', [1], 'the file: expected an object, received a list'],
    ['a number', 5, 'the file: expected an object, received a number; it is 5'],
    ['another format', { ...whole, format: 'other' }, 'format: expected "slowlight"; it is "other"'],
    ['a later version', { ...whole, version: 99 }, 'version: expected 6; it is 99'],
    ['a missing part', { ...whole, nodes: undefined }, 'nodes: expected an object, received nothing'],
    ['an unknown key', withNode({ colour: 'red' }), 'nodes.n: unknown: "colour"; leave it out'],
    ['unknown keys', { ...whole, a: 1, b: 2 }, 'the file: unknown: "a", "b"; leave it out'],
    ['a wrong type', withNode({ params: 4 }), 'nodes.n.params: expected an object, received a number; it is 4'],
    ['null', withNode({ type: null }), 'nodes.n.type: expected a text, received null'],
    ['a switch', withNode({ muted: false }), 'nodes.n.muted: expected true; it is false'],
    ['an empty text', withNode({ type: '' }), 'nodes.n.type: an empty text; it is ""'],
    [
      'a long text',
      { ...whole, title: 'x'.repeat(201) },
      `title: longer than 200 characters; it is "${'x'.repeat(79)}`,
    ],
    ['a value', withNode({ params: { a: { no: 'value' } } }), `nodes.n.params.a: ${VALUE}`],
    ['a mixed list', withNode({ params: { a: [1, 'b'] } }), `nodes.n.params.a: ${VALUE}`],
    ['a colour', withNote({ color: 'red' }), 'notes.a.color: a colour is # and six digits of 0…9, a…f; it is "red"'],
    ['two marks of one name', { ...whole, marks: [mark, mark] }, 'marks: there are two of the name "1"'],
    ['a mark without name', { ...whole, marks: [{ ...mark, name: '' }] }, 'marks.0.name: an empty text; it is ""'],
    ['a mark in a plane', { ...whole, marks: [{ ...mark, u: [0, 0] }] }, 'marks.0.u: fewer than 3 entries'],
    ['a point', withNote({ at: ['1', 2] }), 'notes.a.at.0: expected a number, received a text; it is "1"'],
    ['a long point', withNote({ at: [1, 2, 3] }), 'notes.a.at: more than 2 entries'],
    ['a short point', withNote({ at: [1] }), 'notes.a.at: fewer than 2 entries'],
    [
      'a long list',
      { ...whole, frames: { f: { title: '', nodes: Array(MAX_NODES + 1).fill('n') } } },
      `frames.f.nodes: more than ${MAX_NODES} entries`,
    ],
    [
      'a bad key',
      { ...whole, nodes: { 'a b': { type: 'merge', params: {} } } },
      `nodes.a b: a name that is not allowed: ${NAME}`,
    ],
    [
      'a bad key of a short value',
      withNode({ params: { 'a b': 1 } }),
      `nodes.n.params.a b: a name that is not allowed: ${NAME}`,
    ],
    ['an empty key', withFile('', {}), 'files.: a name that is not allowed: an empty text'],
    [
      'a bad name',
      withEdge('1x'),
      `edges.e.to.input: ${NAME}, here with a number after a dot where it takes many; it is "1x"`,
    ],
    ['a hash', withFile('a', { hash: '12' }), 'files.a.hash: a hash is 64 digits of 0…9, a…f; it is "12"'],
    ['a negative size', withFile('a', { size: -1 }), 'files.a.size: less than 0; it is -1'],
    [
      'half a byte',
      withFile('a', { size: 0.5 }),
      'files.a.size: expected a whole number, received a number; it is 0.5',
    ],
  ])('%s', (_, data, message) => {
    expect(() => parseDocument(JSON.stringify(data))).toThrow(expect.objectContaining({ message }));
  });
});
