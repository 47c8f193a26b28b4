import { parseSync } from 'oxc-parser';
import { describe, expect, it } from 'vitest';
import { LANGUAGE_TAGS, LANGUAGES, preferredLanguage } from '../languages.ts';

const sources = import.meta.glob<string>(
  ['../../**/*.{ts,tsx}', '../../../{examples,scripts}/**/*.ts', '!**/*.test.ts', '!**/languages/*.ts'],
  { query: '?raw', import: 'default', eager: true },
);

const projects = import.meta.glob<{ readonly title: string }>('../../../examples/*.slowlight.json', {
  import: 'default',
  eager: true,
});

type Syntax = { readonly type?: string } & Readonly<Record<string, unknown>>;
interface Template {
  readonly quasis: readonly { readonly value: { readonly cooked: string } }[];
  readonly expressions: readonly Syntax[];
}

const isMessage = ({ type, tag }: Syntax): boolean =>
  type === 'TaggedTemplateExpression' && (tag as { readonly name?: string }).name === 'msg';

/** Visits all nodes of a source's syntax tree. */
function visit(file: string, source: string, take: (node: Syntax) => void): void {
  const walk = (node: unknown): void => {
    if (typeof node !== 'object' || node === null) return;
    take(node as Syntax);
    Object.values(node).forEach(walk);
  };
  walk(parseSync(file, source).program);
}

/** Templates by message, with the files where they arise. */
const templates = new Map<string, Set<string>>();
/** Messages with braces of their own, which would be taken for values. */
const braced: string[] = [];
/** Places where a message is put into a plain string, as `[object Object]`. */
const misused: string[] = [];
for (const [file, source] of Object.entries(sources)) {
  if (!source.includes('msg`')) continue;
  visit(file, source, (node) => {
    if (isMessage(node)) {
      const { quasis } = node.quasi as Template;
      if (quasis.some(({ value }) => /\{\d*\}/.test(value.cooked))) braced.push(`${file}: ${node.start}`);
      const template = quasis.map(({ value }) => value.cooked).join('{}');
      templates.set(template, (templates.get(template) ?? new Set()).add(file));
    }
    const plain = node.type === 'TemplateLiteral' ? (node as unknown as Template).expressions : [];
    const added = node.type === 'BinaryExpression' && node.operator === '+' ? [node.left, node.right] : [];
    for (const part of [...plain, ...added] as Syntax[]) if (isMessage(part)) misused.push(`${file}: ${part.start}`);
  });
}
// The template of a message is itself no part of a plain string.
const ofMessages = new Set<string>();
for (const [file, source] of Object.entries(sources)) {
  if (!source.includes('msg`')) continue;
  visit(file, source, (node) => {
    if (!isMessage(node)) return;
    for (const part of (node.quasi as Template).expressions) ofMessages.add(`${file}: ${part.start}`);
  });
}

const count = (template: string): number => template.split('{}').length - 1;
/** What is the same in every language: numbers, units, joins of values. */
const needsWords = (template: string): boolean => /\p{L}{2}/u.test(template);

describe('messages', () => {
  it('are not put into plain strings', () => {
    expect(misused.filter((place) => !ofMessages.has(place))).toEqual([]);
  });

  it('have no {} of their own', () => {
    expect(braced).toEqual([]);
  });

  describe.each(LANGUAGE_TAGS.filter((tag) => tag !== 'en'))('in %s', (tag) => {
    const catalogue = async () => (await LANGUAGES[tag].load()).messages;

    it('are all translated', async () => {
      const known = await catalogue();
      const missing = [...templates].filter(([template]) => needsWords(template) && !Object.hasOwn(known, template));
      expect(missing.map(([template, files]) => `${[...files][0]}: ${template}`)).toEqual([]);
    });

    it('are all in the source', async () => {
      expect(Object.keys(await catalogue()).filter((template) => !templates.has(template))).toEqual([]);
    });

    it('has the examples’ projects under their own titles', async () => {
      const { examples } = await LANGUAGES[tag].load();
      const titles = Object.entries(projects).map(([file, { title }]) => [
        /(\w[\w-]*)\.slowlight/.exec(file)?.[1],
        title,
      ]);
      expect(titles.length).toBeGreaterThan(20);
      expect(titles.map(([name]) => [name, examples[name!]?.of])).toEqual(titles);
    });

    it('have each value once', async () => {
      const odd = Object.entries(await catalogue()).filter(([template, translation]) => {
        const values = [...translation.matchAll(/\{(\d+)\}/g)].map(([, nth]) => Number(nth)).sort((a, b) => a - b);
        return values.join() !== Array.from({ length: count(template) }, (_, i) => i + 1).join();
      });
      expect(odd).toEqual([]);
    });
  });
});

describe('the language', () => {
  it('is the first wanted one that is here', () => {
    expect(preferredLanguage(['fr-FR', 'zh-CN', 'en'])).toBe('zh');
    expect(preferredLanguage(['zh_CN.UTF-8'])).toBe('zh');
    expect(preferredLanguage(['fr'])).toBe('en');
    expect(preferredLanguage(['C', 'POSIX', ''])).toBe('en');
    expect(preferredLanguage([])).toBe('en');
  });
});
