import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { anyOf, inEnglish, inLines, type LocalizedText, listed, type Message, msg, translate } from './message.ts';
import { MessageError, messageOf } from './messageError.ts';

describe('a message', () => {
  it('is its template and its values, as plain data', () => {
    const message = msg`vertex ${3} of ${'/Sheet'} is not finite`;
    expect(message).toEqual({ template: 'vertex {} of {} is not finite', values: [3, '/Sheet'] });
    expect(structuredClone(message)).toEqual(message);
    expect(JSON.parse(JSON.stringify(message))).toEqual(message);
  });

  it('is English without a translation; a string is the same in every language', () => {
    expect(inEnglish(msg`vertex ${3} of ${'/Sheet'} is not finite`)).toBe('vertex 3 of /Sheet is not finite');
    expect(inEnglish('/Sheet')).toBe('/Sheet');
    expect(translate('/Sheet', { '/Sheet': 'no' })).toBe('/Sheet');
    expect(translate(msg`nothing`, { something: '某物' })).toBe('nothing');
    // No key of the catalogue, though a property of the object.
    expect(translate(msg`constructor`, {})).toBe('constructor');
  });

  it('is translated with its values in the order of the other language', () => {
    const catalogue = { 'vertex {} of {}': '{2} 的顶点 {1}', 'a brick': '砖块' };
    expect(translate(msg`vertex ${3} of ${'/Sheet'}`, catalogue)).toBe('/Sheet 的顶点 3');
    expect(translate(msg`vertex ${3} of ${msg`a brick`}`, catalogue)).toBe('砖块 的顶点 3');
    // A part without translation stays English.
    expect(translate(msg`vertex ${3} of ${msg`a tile`}`, catalogue)).toBe('a tile 的顶点 3');
    expect(translate(msg`wrong: ${msg`vertex ${3} of ${msg`a brick`}`}`, catalogue)).toBe('wrong: 砖块 的顶点 3');
  });

  it('takes values for values, whatever they contain', () => {
    const odd = msg`${'{}'} and ${'{1}$&'}`;
    expect(inEnglish(odd)).toBe('{} and {1}$&');
    expect(translate(odd, { '{} and {}': '{2} 与 {1}' })).toBe('{1}$& 与 {}');
  });

  it('has numbers as JavaScript writes them', () => {
    expect(inEnglish(msg`${0.1 + 0.2}, ${-0}, ${Number.NaN}, ${1e21}`)).toBe('0.30000000000000004, 0, NaN, 1e+21');
  });

  it('shows a value that is missing, which types forbid', () => {
    expect(inEnglish(msg`is ${undefined as unknown as string}`)).toBe('is undefined');
  });

  it('lists texts', () => {
    const words = [msg`a cube`, 'b', msg`a ball`];
    expect(inEnglish(listed(words))).toBe('a cube, b, a ball');
    expect(inEnglish(anyOf(words))).toBe('a cube, b or a ball');
    expect([anyOf(['a']), listed(['a']), listed([])]).toEqual(['a', 'a', '']);
    const catalogue = { '{}, {}': '{1}、{2}', '{} or {}': '{1}或{2}', 'a cube': '方块', 'a ball': '球' };
    expect(translate(anyOf(words), catalogue)).toBe('方块、b或球');
    expect(words).toHaveLength(3);
  });
});

describe('any message', () => {
  const words = fc.string({ unit: fc.constantFrom(...'ab $&\\.,:{1}'), maxLength: 8 }).map(
    // Braces are only those of values.
    (text) => text.replaceAll('{', '').replaceAll('}', ''),
  );
  const { text } = fc.letrec<{ text: LocalizedText; message: Message }>((tie) => ({
    text: fc.oneof({ maxDepth: 4 }, fc.string({ maxLength: 6 }), tie('message')),
    message: fc
      .array(fc.tuple(fc.oneof(tie('text'), fc.integer(), fc.double()), words), { maxLength: 4 })
      .chain((parts) =>
        words.map((first): Message => {
          const quasis = [first, ...parts.map(([, after]) => after)];
          return msg(Object.assign(quasis, { raw: quasis }), ...parts.map(([value]) => value));
        }),
      ),
  }));
  const templatesOf = (of: LocalizedText | number): string[] =>
    typeof of === 'object' ? [of.template, ...of.values.flatMap(templatesOf)] : [];

  it('is English by a catalogue of English, also after a copy between threads', () => {
    fc.assert(
      fc.property(text, (some) => {
        const identity = Object.fromEntries(
          templatesOf(some).map((template) => {
            let nth = 0;
            return [template, template.replaceAll('{}', () => `{${++nth}}`)];
          }),
        );
        expect(translate(some, identity)).toBe(inEnglish(some));
        expect(inEnglish(structuredClone(some))).toBe(inEnglish(some));
      }),
    );
  });
});

describe('an error', () => {
  it('for users has a message, and is English for programs', () => {
    const cause = new Error('cause');
    const error = new MessageError(msg`no ${msg`light`}`, { cause });
    expect(error).toBeInstanceOf(Error);
    expect(error).toMatchObject({ message: 'no light', text: msg`no ${msg`light`}`, cause });
    expect(messageOf(error)).toBe(error.text);
  });

  it('of others keeps its words', () => {
    expect(inEnglish(messageOf(new TypeError('x is not iterable')))).toBe('x is not iterable');
    expect(inEnglish(messageOf('{} out of order'))).toBe('{} out of order');
    expect(inEnglish(messageOf(undefined))).toBe('undefined');
  });

  it('has as many lines or items as there are, however many', () => {
    const names = Array.from({ length: 30_000 }, (_, k) => `/Part${k}`);
    expect(inEnglish(inLines(names))).toBe(names.join('\n'));
    expect(inEnglish(listed(names))).toBe(names.join(', '));
  });
});
