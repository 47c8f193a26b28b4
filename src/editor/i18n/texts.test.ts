import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { settingTexts } from '../../nodes/common/settingTexts.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { EFFECTS } from '../../scene/frameGraph/effects.ts';
import { exampleTexts } from './exampleTexts.ts';
import { preferredLanguage } from './i18n.ts';
import { uiTexts } from './texts.ts';

const examples = new URL('../../../examples/', import.meta.url);
const placeholders = (text: string) => [...text.matchAll(/\{\{(\w+)\}\}/g)].map(([, name]) => name).sort();

describe('the UI texts', () => {
  it('are complete in both languages, with the same placeholders', () => {
    const odd = Object.entries(uiTexts).filter(
      ([, [en, zh]]) => !en.trim() || !zh.trim() || placeholders(en).join() !== placeholders(zh).join(),
    );
    expect(odd).toEqual([]);
  });

  it('are all used', () => {
    const sources = Object.values(
      import.meta.glob<string>(
        ['../../**/*.{ts,tsx}', '!**/{texts,graphTexts,projectTexts,nodeTexts,effectTexts}.ts'],
        {
          query: '?raw',
          import: 'default',
          eager: true,
        },
      ),
    ).join('\n');
    // Matches keys composed from templates: `lock.${lock}.help`.
    const composed =
      /^(lock|loading|header)\.(free|look|fly|fetch|parse|trace|simulate|dark|light)|^legend\.(doppler|emission-time|radiance|band)$|^(band|preset|light|math|vectorMath|relation|category|type|graph\.course)\.|^energy\.(change|total|kinetic|potential|fastest|momentum|angularMomentum)$/;
    // Texts of settings come from the list of settings.
    const unused = Object.keys(uiTexts).filter(
      (key) => !sources.includes(`'${key}'`) && !composed.test(key) && !Object.hasOwn(settingTexts, key),
    );
    expect(unused).toEqual([]);
  });

  it('include all texts of effects', () => {
    const keys = Object.values(EFFECTS).flatMap(({ title, help, args }) => [
      title,
      help,
      ...args.map((arg) => arg.title),
    ]);
    expect(keys.filter((key) => !Object.hasOwn(uiTexts, key))).toEqual([]);
  });

  it('include all texts of the node library', () => {
    const keys = Object.values(nodeLibrary).flatMap((type) => [
      type.title,
      type.help,
      ...Object.values(type.params).flatMap((spec) => [
        spec.title,
        ...(spec.help ? [spec.help] : []),
        ...(spec.kind === 'choice' ? spec.options.map((option) => option.title) : []),
        ...(spec.kind === 'number' ? Object.values(spec.as?.cases ?? {}).map(({ title }) => title) : []),
      ]),
      ...[...Object.values(type.inputs), ...Object.values(type.outputs)].flatMap(({ title }) => title ?? []),
    ]);
    // Single letters are the same in every language.
    expect(keys.filter((key) => !Object.hasOwn(uiTexts, key) && !/^[A-Z]$/.test(key))).toEqual([]);
  });
});

describe('the examples in Chinese', () => {
  const numbers = (text: string) => (text.match(/\d+(\.\d+)?/g) ?? []).sort();
  const lookFor = (layer: string) => /string lookFor = "((?:[^"\\]|\\.)*)"/.exec(layer)?.[1] ?? '';

  it.each(readdirSync(examples).filter((file) => file.endsWith('.slowlight.json')))(
    'the translation of %s has the same numbers as its file',
    (file) => {
      const { lookFor: own = '' } = JSON.parse(readFileSync(new URL(file, examples), 'utf8'));
      expect(numbers(exampleTexts[file.replace('.slowlight.json', '')]?.lookFor ?? '')).toEqual(numbers(own));
    },
  );

  it.each(readdirSync(examples).filter((file) => file.endsWith('.usda')))(
    'the translation of %s has the same numbers as its file',
    (file) => {
      const words = exampleTexts[file.replace('.usda', '')];
      const head = readFileSync(new URL(file, examples)).subarray(0, 4096).toString('utf8');
      expect(numbers(words?.lookFor ?? '')).toEqual(numbers(lookFor(head)));
    },
  );
});

describe('the page’s language', () => {
  it('is the first requested by the browser that is available', () => {
    expect(preferredLanguage(['fr-FR', 'zh-CN', 'en'])).toBe('zh');
    expect(preferredLanguage(['fr'])).toBe('en');
    expect(preferredLanguage([])).toBe('en');
  });
});
