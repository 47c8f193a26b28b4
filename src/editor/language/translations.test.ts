import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { makeSystem } from '../../dynamics/system.ts';
import { readLayer } from '../../formats/usd/readLayer.ts';
import { hintsOf } from '../../formats/usd/schema/slowlightAttributes.ts';
import { emptyDocument } from '../../graph/document/document.ts';
import { parseDocument } from '../../graph/document/parse.ts';
import { decodeShareLink } from '../../graph/document/shareLink.ts';
import { applyCommand } from '../../graph/edits/commands.ts';
import { evaluateExpression } from '../../graph/expression.ts';
import { chinese } from '../../messages/languages/chinese.ts';
import { LANGUAGE_TAGS, LANGUAGES } from '../../messages/languages.ts';
import { type LocalizedText, translate } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';

/** In Chinese, as it arrives from another thread. */
const inChinese = (text: LocalizedText): string => translate(structuredClone(text), chinese.messages);

it('the Chinese is Chinese, but for names and keys', () => {
  const names = /^(?:null|prim|AgX|Esc|Yoshida \d|slowlight: \{\}|--set \{\}.*)$/;
  const odd = Object.entries(chinese.messages).filter(
    ([template, words]) => /\p{L}{3}/u.test(template) && !/\p{Script=Han}/u.test(words) && !names.test(template),
  );
  expect(odd).toEqual([]);
});

describe('actual messages are in Chinese:', () => {
  const said = (work: () => unknown): string => {
    try {
      work();
    } catch (error) {
      return inChinese(messageOf(error));
    }
    throw new Error('nothing was refused');
  };
  const withNode = (node: object) => JSON.stringify({ ...emptyDocument(), nodes: { node } });

  it.each([
    ['of a project', () => parseDocument('{"format": 3'), /^不是 JSON：/],
    [
      'of its parts',
      () => parseDocument(withNode({ type: 'merge', params: 4 })),
      /^nodes\.node\.params：应为对象，而不是数；现为 4$/,
    ],
    [
      'of a name',
      () => applyCommand(emptyDocument(), { kind: 'add-node', node: 'a b', type: 'merge', at: [0, 0] }),
      /^“a b”不能作为节点的名称/,
    ],
    ['of a system', () => makeSystem({ masses: Float64Array.of(1, 0) }), /^点 1 的质量为 0 kg；请设为大于 0$/],
    ['of a link', () => decodeShareLink('project=!'), /^链接：.*；它在传送中被截断或更改/],
  ])('%s', (_, work, words) => {
    expect(said(work)).toMatch(words);
  });

  it('of an expression', () => {
    const problem = (text: string) => {
      const result = evaluateExpression(text, { unit: 'm' });
      return 'problem' in result && inChinese(result.problem);
    };
    expect(problem('3 m + 2 s')).toBe('m 与 s 不能相加');
    expect(problem('sin(')).toBe('末尾缺少内容');
    expect(problem('2 s')).toBe('值的单位是 s，而需要的是 m');
  });
});

describe.each(LANGUAGE_TAGS.filter((tag) => tag !== 'en'))('the examples in %s', (tag) => {
  const folder = new URL('../../../examples/', import.meta.url);
  const numbers = (text: string): string[] => (text.match(/\d+(\.\d+)?/g) ?? []).sort();
  /** By name; what the file itself says to look for. */
  const examples = readdirSync(folder).flatMap((file) => {
    const [, name = '', kind] = /^(.*?)\.(slowlight\.json|usdc)$/.exec(file) ?? [];
    if (!kind) return [];
    const bytes = readFileSync(new URL(file, folder));
    const { lookFor } = kind === 'usdc' ? hintsOf(readLayer(bytes, file)) : JSON.parse(bytes.toString('utf8'));
    return [{ name, said: String(lookFor ?? '') }];
  });

  it('are all translated, and no others', async () => {
    const { examples: translated } = await LANGUAGES[tag].load();
    expect(examples.length).toBeGreaterThan(20);
    expect(Object.keys(translated).sort()).toEqual([...new Set(examples.map(({ name }) => name))].sort());
    for (const { title, lookFor } of Object.values(translated)) expect([title, lookFor]).not.toContain('');
  });

  it.each(examples)('have the numbers of the file: $name', async ({ name, said }) => {
    const { examples: translated } = await LANGUAGES[tag].load();
    expect(numbers(translated[name]?.lookFor ?? '')).toEqual(numbers(said));
  });
});
