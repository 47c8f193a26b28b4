import { describe, expect, it } from 'vitest';
import { inEnglish } from '../../../messages/message.ts';
import { memorySource } from '../../files/fileSource.ts';
import { readUsd } from '../read.ts';
import { parseLayer } from '../text/parser.ts';
import { SampleBudget } from './sampleBudget.ts';

const layerOf = (samples: number, things: number): Uint8Array =>
  new TextEncoder().encode(`#usda 1.0
def Xform "W" {
double3 xformOp:translate.timeSamples = { ${Array.from({ length: samples }, (_, i) => `${i}: (${i % 7}, 0, 0)`).join(', ')} }
uniform token[] xformOpOrder = ["xformOp:translate"]
${Array.from({ length: things }, (_, i) => `def Cube "C${i}" {}`).join('\n')}
}`);

describe('the sample times of transforms', () => {
  const given = (samples: number, things: number, written = samples): number[] => {
    const budget = new SampleBudget(parseLayer(layerOf(written, things), 'a.usda'));
    return Array.from({ length: things }, () => budget.take(samples));
  };

  it('are complete in ordinary scenes', () => {
    expect(given(250, 1000)).toEqual(new Array(1000).fill(250));
  });

  it('are complete if every object has its own', () => {
    const layer = parseLayer(layerOf(2, 1), 'a.usda');
    const op = layer.rootPrims.get('W')?.properties.get('xformOp:translate');
    if (op?.kind === 'attribute') op.timeSamples = { times: new Float64Array(900_000), values: [] };
    expect(new SampleBudget(layer).take(900_000)).toBe(900_000);
  });

  it('are limited where a few samples move very many objects', () => {
    const all = given(50_000, 1000);
    expect(all.reduce((sum, n) => sum + n, 0)).toBeLessThanOrEqual(2 ** 18 + 4 * 50_000);
    expect(Math.min(...all)).toBeGreaterThanOrEqual(128);
    expect(new Set(all).size).toBeLessThan(5);
  });

  it('that are omitted are reported', async () => {
    const scene = await readUsd(memorySource({ 'a.usda': layerOf(9000, 40) }), 'a.usda');
    const used = scene.objects.map(({ motion }) => ('times' in motion ? motion.times.length : 0));
    const [first] = scene.diagnostics.filter((d) => d.code === 'usd.sample-budget');
    expect(used[0]).toBe(9000);
    expect(used[39]).toBeLessThan(9000);
    expect(inEnglish(first.message)).toContain('it is moved by 9000 samples');
  });
});
