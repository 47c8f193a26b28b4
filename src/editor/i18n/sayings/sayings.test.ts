import { parseSync } from 'oxc-parser';
import { describe, expect, it } from 'vitest';
import { files } from './files.ts';
import { gltf } from './gltf.ts';
import { sayings } from './index.ts';
import { program } from './program.ts';
import { shaderText } from './shaderText.ts';
import { usd } from './usd.ts';

const sources = import.meta.glob<string>(
  [
    '../../../{compute,dynamics,graph,nodes,formats}/**/*.ts',
    '../../../scene/{validate,drawable}.ts',
    '../../../scene/shaderText/**/*.ts',
    '../../{loading,projects,saving,state}/**/*.{ts,tsx}',
    '../../shell/useSavePicture.ts',
    '!**/*.test.ts',
    '!**/fixtures/**',
    // Words of the catalogue, the pages about nodes and codes, and programs of the GPU.
    '!../../../nodes/{words,effectWords,reference}.ts',
    '!../../../nodes/drawing/largest.ts',
    '!../../../formats/codes.ts',
    '!../../../compute/shader.ts',
    // Lines of the files that are written.
    '!../../../formats/usd/write{Materials,Prims}.ts',
  ],
  { query: '?raw', import: 'default', eager: true },
);

type Syntax = { readonly type?: string } & Readonly<Record<string, unknown>>;

/** What a text, a template or a sum of them says, with {} for each value; undefined for anything else. */
function told(node: Syntax): string | undefined {
  if (node.type === 'Literal') return typeof node.value === 'string' ? node.value : undefined;
  if (node.type === 'TemplateLiteral')
    return (node.quasis as { value: { cooked: string } }[]).map(({ value }) => value.cooked).join('{}');
  if (node.type !== 'BinaryExpression' || node.operator !== '+') return undefined;
  const [left, right] = [told(node.left as Syntax), told(node.right as Syntax)];
  return left === undefined && right === undefined ? undefined : `${left ?? '{}'}${right ?? '{}'}`;
}

/** All that a source says anywhere. */
function textsIn(file: string, source: string): string[] {
  const texts: string[] = [];
  const walk = (node: unknown): void => {
    if (Array.isArray(node)) return node.forEach(walk);
    if (typeof node !== 'object' || node === null) return;
    const syntax = node as Syntax;
    if (syntax.type === 'ImportDeclaration' || syntax.type === 'TSLiteralType') return;
    const text = told(syntax);
    if (text !== undefined) texts.push(text);
    if (syntax.type === 'BinaryExpression' && text !== undefined) return;
    Object.values(syntax).forEach(walk);
  };
  walk(parseSync(file, source).program);
  return texts;
}

const texts = Object.entries(sources).flatMap(([file, source]) =>
  textsIn(file, source).map((text) => [file.replace(/^(\.\.\/)+/, ''), text] as const),
);
/** Two words of English, or a word beside a value. */
const reads = (text: string) => /\p{L}{2,},? (?:\p{L}|\{\}|["“(])|(?:\{\}|\}") \p{L}{2,}|\p{L}{2,} \{\}/u.test(text);
/** Texts that are no words to a person: of formats, styles, commands, and what programmers alone get to read. */
const OTHER =
  /^(?:sl-|slowlight |time \[s\],steps|no \w+Provider |passes of |\{\}\.(?:places|keys) |\{\} MiB$|\n|\/\/ )/;
/** Of USD: lists of names, a prim's line in a file, and keys of what is looked up. */
const OTHER_OF_USD =
  /^(?:(?:active|add|assetInfo|bindMaterialAs|comment|elementSize|points|startTimeCode)(?: \w+){2,}|def \{\} "\{\}"|displayColor \{\} \{\}|\{\} clips of \{\})$/;

const holes = (text: string) => (text.match(/\{\}/g) ?? []).length;

const catalogues = { usd, gltf, files, shaderText, program };

/** Whose sentences those of a file are. */
function catalogueOf(file: string): keyof typeof catalogues {
  const [, of] = /^(formats\/usd|formats\/gltf|formats|scene\/shaderText)\//.exec(file) ?? [];
  if (of === undefined) return 'program';
  return of === 'formats' ? 'files' : of === 'scene/shaderText' ? 'shaderText' : of === 'formats/usd' ? 'usd' : 'gltf';
}

describe('what the program says, in Chinese', () => {
  it.each(Object.keys(catalogues))('has every sentence of the source: %s', (name) => {
    const missing = texts.filter(
      ([file, text]) =>
        catalogueOf(file) === name &&
        reads(text) &&
        !OTHER.test(text) &&
        !OTHER_OF_USD.test(text) &&
        !Object.hasOwn(sayings, text),
    );
    expect([...new Set(missing.map((each) => each.join(': ')))]).toEqual([]);
  });

  it.each(Object.entries(catalogues))('has none that the source does not have: %s', (_, catalogue) => {
    const known = new Set(texts.map(([, text]) => text));
    expect(Object.keys(catalogue).filter((key) => !known.has(key))).toEqual([]);
  });

  it('is said in one place', () => {
    const keys = Object.values(catalogues).flatMap((catalogue) => Object.keys(catalogue));
    expect(keys.filter((key, i) => keys.indexOf(key) !== i)).toEqual([]);
  });

  it('is Chinese, and has each value once', () => {
    const odd = Object.entries(sayings).filter(([key, other]) => {
      const values = [...other.matchAll(/\{(\d)\}/g)].map(([, nth]) => nth).sort();
      const all = Array.from({ length: holes(key) }, (_, i) => `${i + 1}`);
      return values.join() !== all.join() || (/\p{L}{3}/u.test(key) && !/\p{Script=Han}/u.test(other));
    });
    expect(odd).toEqual([]);
  });
});
