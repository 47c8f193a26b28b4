import { describe, expect, it } from 'vitest';
import type { AttributeSpec } from '../layer/layer.ts';
import { composedFiles } from './fixtures/composedFiles.ts';

const usda = (text: string): string => `#usda 1.0\n${text}`;

describe('times across arcs', () => {
  it('are mapped by every arc, the innermost first', async () => {
    const files = new Map([
      [
        'root.usda',
        usda(`( timeCodesPerSecond = 24 )
def "A" ( references = @b.usda@</B> (offset = 10; scale = 2) ) {}
def "I" ( inherits = </A> ) { over "K" ( specializes = </A/K> ) {} }`),
      ],
      ['b.usda', usda('( timeCodesPerSecond = 24 )\ndef "B" ( payload = @c.usda@</C> (offset = 1; scale = -1) ) {}')],
      [
        'c.usda',
        usda(
          '( timeCodesPerSecond = 12 )\ndef "C" { def "K" { double x.timeSamples = { 0: 0, 3: 1 }\ntimecode t = 5\n} }',
        ),
      ],
    ]);
    const { stage } = await composedFiles(files, 'root.usda');
    // Two codes of the middle one are one of the innermost: t ↦ 2 (1 − 2 t) + 10.
    for (const path of ['A', 'I']) {
      const { properties } = stage.layer.rootPrims.get(path)!.children.get('K')!;
      const [x, t] = ['x', 't'].map((name) => properties.get(name) as AttributeSpec);
      expect([...x.timeSamples!.times], path).toEqual([0, 12]);
      expect(
        x.timeSamples!.values.map((v) => 'data' in v && v.data),
        path,
      ).toEqual([1, 0]);
      expect(t.value, path).toEqual({ type: 'timecode', data: -8 });
    }
  });
});
