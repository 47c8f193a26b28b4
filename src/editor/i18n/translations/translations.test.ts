import { parseSync } from 'oxc-parser';
import { describe, expect, it } from 'vitest';
import { makeSystem } from '../../../dynamics/system.ts';
import { emptyDocument } from '../../../graph/document/document.ts';
import { parseDocument } from '../../../graph/document/parse.ts';
import { decodeShareLink } from '../../../graph/document/shareLink.ts';
import { applyCommand } from '../../../graph/edits/commands.ts';
import { evaluateExpression } from '../../../graph/expression.ts';
import { files } from './files.ts';
import { gltf } from './gltf.ts';
import { translations } from './index.ts';
import { program } from './program.ts';
import { shaderText } from './shaderText.ts';
import { messageTranslator } from './translateMessage.ts';
import { usd } from './usd.ts';

const sources = import.meta.glob<string>(
  [
    '../../../{compute,dynamics,graph,nodes,formats}/**/*.ts',
    '../../../scene/motion/kinds/*.ts',
    '../../../scene/validation/{validate,renderableScene,motionFindings}.ts',
    '../../../scene/shaderText/**/*.ts',
    '../../{loading,projects,saving,state}/**/*.{ts,tsx}',
    '../../shell/useSavePicture.ts',
    '!**/*.test.ts',
    '!**/fixtures/**',
    // UI texts, reference pages and GPU programs.
    '!../../../nodes/docs/{nodeTexts,effectTexts,nodeReference}.ts',
    '!../../../pipelines/maxSize.ts',
    '!../../../formats/diagnostics/diagnosticCodes.ts',
    '!../../../compute/shader.ts',
    // Lines of written files.
    '!../../../formats/usd/write/layerText.ts',
  ],
  { query: '?raw', import: 'default', eager: true },
);

type Syntax = { readonly type?: string } & Readonly<Record<string, unknown>>;

/** The text of a literal, template or concatenation with {} for each value; undefined for other expressions. */
function told(node: Syntax): string | undefined {
  if (node.type === 'Literal') return typeof node.value === 'string' ? node.value : undefined;
  if (node.type === 'TemplateLiteral')
    return (node.quasis as { value: { cooked: string } }[]).map(({ value }) => value.cooked).join('{}');
  if (node.type !== 'BinaryExpression' || node.operator !== '+') return undefined;
  const [left, right] = [told(node.left as Syntax), told(node.right as Syntax)];
  return left === undefined && right === undefined ? undefined : `${left ?? '{}'}${right ?? '{}'}`;
}

/** All texts in a source file. */
function textsIn(file: string, source: string): string[] {
  const texts: string[] = [];
  const walk = (node: unknown): void => {
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
/** Whether a text contains two English words, or a word beside a value. */
const reads = (text: string) => /\p{L}{2,},? (?:\p{L}|\{\}|["“(])|(?:\{\}|\}") \p{L}{2,}|\p{L}{2,} \{\}/u.test(text);
/** Texts that are not shown to users. */
const UNSAID = [
  // CSS classes, commands, paths, and errors for programmers.
  /^(?:sl-|slowlight |time \[s\],steps|no \w+Provider |passes of |\{\}\.(?:places|keys) |\{\} MiB$|\n|\/\/ |# )/,
  // Lines of OBJ and MTL, headings of tables, names of formats.
  /^(?:(?:vn|vt|usemtl|newmtl|mtllib|K[de]|P[rm]|Ni|map_K[de]|norm) \{\}|(?:relative radiance|Radiance HDR|Wavefront OBJ)$)/,
  // Of USD: name lists, prim lines, and lookup keys.
  /^(?:(?:active|add|assetInfo|bindMaterialAs|comment|elementSize|points|startTimeCode)(?: \w+){2,}|def \{\} "\{\}"|displayColor \{\} \{\}|\{\} clips of \{\})$/,
];

const holes = (text: string) => (text.match(/\{\}/g) ?? []).length;

const catalogues = { usd, gltf, files, shaderText, program };

/** The catalogue that messages of a file belong to. */
function catalogueOf(file: string): keyof typeof catalogues {
  const [, of] = /^(formats\/usd|formats\/gltf|formats|scene\/shaderText)\//.exec(file) ?? [];
  if (of === undefined) return 'program';
  return of === 'formats' ? 'files' : of === 'scene/shaderText' ? 'shaderText' : of === 'formats/usd' ? 'usd' : 'gltf';
}

describe('the Chinese message catalogues', () => {
  it.each(Object.keys(catalogues))('have every message of the sources: %s', (name) => {
    const missing = texts.filter(
      ([file, text]) =>
        catalogueOf(file) === name &&
        reads(text) &&
        !UNSAID.some((each) => each.test(text)) &&
        !Object.hasOwn(translations, text),
    );
    expect([...new Set(missing.map((each) => each.join(': ')))]).toEqual([]);
  });

  it.each(Object.entries(catalogues))('have no message that is not in the sources: %s', (_, catalogue) => {
    const known = new Set(texts.map(([, text]) => text));
    expect(Object.keys(catalogue).filter((key) => !known.has(key))).toEqual([]);
  });

  it('have no message twice', () => {
    const keys = Object.values(catalogues).flatMap((catalogue) => Object.keys(catalogue));
    expect(keys.filter((key, i) => keys.indexOf(key) !== i)).toEqual([]);
  });

  it('are Chinese, with each value once', () => {
    const odd = Object.entries(translations).filter(([key, other]) => {
      const values = [...other.matchAll(/\{(\d)\}/g)].map(([, nth]) => nth).sort();
      const all = Array.from({ length: holes(key) }, (_, i) => `${i + 1}`);
      return values.join() !== all.join() || (/\p{L}{3}/u.test(key) && !/\p{Script=Han}/u.test(other));
    });
    expect(odd).toEqual([]);
  });
});

describe('actual messages are translated', () => {
  const say = messageTranslator(translations);
  const said = (work: () => unknown): string => {
    try {
      work();
    } catch (error) {
      return say((error as Error).message);
    }
    throw new Error('nothing was refused');
  };
  const withNode = (node: object) => JSON.stringify({ ...emptyDocument(), nodes: { node } });

  it.each([
    ['a project', () => parseDocument('{"format": 3'), /^不是 JSON：/],
    [
      'its parts',
      () => parseDocument(withNode({ type: 'merge', params: 4 })),
      /^nodes\.node\.params：应为表，而不是数；现为 4$/,
    ],
    [
      'a name',
      () => applyCommand(emptyDocument(), { kind: 'add-node', node: 'a b', type: 'merge', at: [0, 0] }),
      /^“a b”不能作为节点的名称/,
    ],
    ['a system', () => makeSystem({ masses: Float64Array.of(1, 0) }), /^点 1 的质量为 0 kg；请设为大于 0$/],
    ['a link', () => decodeShareLink('project=!'), /^链接：.*；它在传送中被截断或更改/],
  ])('%s', (_, work, words) => {
    expect(said(work)).toMatch(words);
  });

  it('an expression', () => {
    const problem = (text: string) => say((evaluateExpression(text, { unit: 'm' }) as { problem: string }).problem);
    expect(problem('3 m + 2 s')).toBe('m 与 s 不能相加');
    expect(problem('sin(')).toBe('末尾缺少内容');
    expect(problem('2 s')).toBe('值的单位是 s，而需要的是 m');
  });

  it('why a run ended', () => {
    const stop =
      'vertex 3 of /Sheet went through what is solid, to (0, −0.1, 0) m; take a smaller step, a harder penalty, or let it go slower';
    expect(say(`it ended at t = 0.25 s: ${stop}`)).toBe(
      '于 t = 0.25 s 结束：/Sheet 的顶点 3 穿过了实体，到达（0, −0.1, 0）m；请减小步长、加大接触劲度，或让它慢一些',
    );
  });
});
