import { describe, expect, it } from 'vitest';
import { nodeLibrary } from '../../nodes/library.ts';
import { preferredLanguage } from './i18n.ts';
import { messages } from './messages.ts';

const placeholders = (text: string) => [...text.matchAll(/\{\{(\w+)\}\}/g)].map(([, name]) => name).sort();

describe('the catalogue of messages', () => {
  it('has every text in both languages, with the same values to fill in', () => {
    const odd = Object.entries(messages).filter(
      ([, [en, zh]]) => !en.trim() || !zh.trim() || placeholders(en).join() !== placeholders(zh).join(),
    );
    expect(odd).toEqual([]);
  });

  it('has every text that the node library names', () => {
    const keys = Object.values(nodeLibrary).flatMap((type) => [
      type.title,
      type.help,
      ...Object.values(type.params).flatMap((spec) => [
        spec.title,
        ...(spec.help ? [spec.help] : []),
        ...(spec.kind === 'choice' ? spec.options.map((option) => option.title) : []),
      ]),
    ]);
    expect(keys.filter((key) => !Object.hasOwn(messages, key))).toEqual([]);
  });
});

describe('the language of the page', () => {
  it('is the first that the browser asks for and the catalogue has', () => {
    expect(preferredLanguage(['fr-FR', 'zh-CN', 'en'])).toBe('zh');
    expect(preferredLanguage(['fr'])).toBe('en');
    expect(preferredLanguage([])).toBe('en');
  });
});
