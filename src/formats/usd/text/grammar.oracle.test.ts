import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { isDeepStrictEqual } from 'node:util';
import { afterAll, describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../tests/support/pythonOracles.ts';
import { InputError } from '../../../scene/types.ts';
import { brokenText, smallTexts } from '../fixtures/brokenTexts.ts';
import { type Json, layerJson } from '../fixtures/layerJson.ts';
import type { Layer } from '../layer/layer.ts';
import { parseLayer } from './parser.ts';

const fixture = (name: string): string => fileURLToPath(new URL(`../fixtures/${name}`, import.meta.url));

const folder = mkdtempSync(join(tmpdir(), 'slowlight-grammar-'));
afterAll(() => rmSync(folder, { recursive: true }));

/** Number of broken texts. */
const COUNT = 1500;

/** The layers that usd-core reads from texts; null if rejected. */
function judged(texts: readonly string[]): Json[] {
  const path = join(folder, 'texts.json');
  writeFileSync(path, JSON.stringify(texts));
  return JSON.parse(python(fixture('oracle.py'), '--texts', path));
}

function ours(text: string): Layer | undefined {
  try {
    return parseLayer(new TextEncoder().encode(text), 'a.usda');
  } catch (thrown) {
    if (!(thrown instanceof InputError)) throw thrown;
    return undefined;
  }
}

/** Whether it has values of unknown types or metadata of unknown keys, of which only the text is kept. */
const isUnknown = (layer: Layer): boolean =>
  /"unregistereds?"|"autoPlay"|"playbackMode"/.test(
    JSON.stringify(layer, (_, value) =>
      value instanceof Map ? [...value] : typeof value === 'bigint' ? String(value) : value,
    ),
  );

/** The difference from usd-core for a text; undefined if both agree. */
function difference(text: string, expected: Json): string | undefined {
  const layer = ours(text);
  if (layer && isUnknown(layer)) return undefined;
  if (!layer || !expected) return !layer === !expected ? undefined : `${layer ? 'read' : 'refused'}: ${text}`;
  return isDeepStrictEqual(layerJson(layer), expected) ? undefined : `otherwise: ${text}`;
}

describe.skipIf(!hasUsdCore())('broken texts', () => {
  const whole = smallTexts(readFileSync(fixture('grammar.usda'), 'utf8'));

  it('cover every statement of the grammar, and valid ones are read alike', () => {
    expect(whole.length).toBeGreaterThan(250);
    const expected = judged(whole);
    expect(expected.filter((layer) => layer === null)).toEqual([]);
    expect(whole.flatMap((text, i) => difference(text, expected[i]) ?? [])).toEqual([]);
  });

  it('are rejected if usd-core rejects them, and otherwise read alike', () => {
    const texts = Array.from({ length: COUNT }, (_, i) => brokenText(whole[i % whole.length], i));
    const expected = judged(texts);
    expect(expected.filter((layer) => layer !== null).length).toBeGreaterThan(COUNT / 100);
    expect(texts.flatMap((text, i) => difference(text, expected[i]) ?? [])).toEqual([]);
  });
});
