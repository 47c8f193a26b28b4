import { describe, expect, it } from 'vitest';
import { valueAt } from '../../layer/attributes.ts';
import { composedFiles } from '../fixtures/composedFiles.ts';

const CLIP = '#usda 1.0\ndef "Clip" {\ndouble x.timeSamples = { 0: 0, 5: 50, 9: 90 }\n}';

async function composed(clips: string, files: Record<string, string> = {}) {
  const root = `#usda 1.0\ndef "P" (\nclips = {\ndictionary default = {\nstring primPath = "/Clip"\n${clips}\n}\n}\n) {\ndouble x\n}`;
  const all = new Map(Object.entries({ 'root.usda': root, 'a.usda': CLIP, ...files }));
  const { stage, said, missing } = await composedFiles(all, 'root.usda');
  const x = stage.layer.rootPrims.get('P')?.properties.get('x');
  const at = (time: number): number | undefined => {
    const value = x?.kind === 'attribute' ? valueAt(x, time) : undefined;
    return value?.type === 'double' ? value.data : undefined;
  };
  return { said, missing, at, times: x?.kind === 'attribute' ? (x.timeSamples?.times ?? []) : [] };
}

describe('value clips', () => {
  it('jump where two entries of `times` have the same time', async () => {
    const { at, times } = await composed(
      'asset[] assetPaths = [@a.usda@]\ndouble2[] active = [(0, 0)]\ndouble2[] times = [(0, 0), (9, 9), (9, 0), (18, 9)]',
    );
    expect([-1, 4, 8.9, 9, 13, 18, 30].map(at)).toEqual([0, 40, expect.closeTo(89, 6), 0, 40, 90, 90]);
    // Usd.Attribute.GetTimeSamples of usd-core 26.11.
    expect([...times]).toEqual([0, 5, 8.999999995559108, 9, 14, 18]);
  });

  it('that are missing are reported with the searched location, and have no values', async () => {
    const { at, said, missing } = await composed(
      'asset[] assetPaths = [@a.usda@, @b.usda@]\ndouble2[] active = [(0, 0), (6, 1)]',
    );
    expect(said).toEqual([
      'usd.missing-layer root.usda</P>: the clip @b.usda@ is not there (looked for b.usda); open the folder that holds it',
    ]);
    expect(missing).toEqual([{ name: 'b.usda', lookedFor: ['b.usda'] }]);
    expect([5, 6, 8].map(at)).toEqual([50, undefined, undefined]);
  });

  it.each([
    ['double2[] active = [(0, 3)]', 'its active names clip 3, and there are 1'],
    ['double2[] active = [(0, 0), (0, 0)]', 'two clips are active from 0 on'],
    ['', 'none of its clips is active'],
    [
      'double2[] active = [(0, 0)]\ndouble2[] times = [(1, 0), (1, 1), (1, 2)]',
      'its times have more than two entries for 1',
    ],
    ['double2[] active = [(0, 0)]\ndouble2[] times = [(1, inf)]', 'its times are not all finite'],
  ])('are rejected if invalid: %s', async (lines, why) => {
    const { said, times } = await composed(`asset[] assetPaths = [@a.usda@]\n${lines}`);
    expect(said).toEqual([`usd.clips root.usda</P>: its clip set 'default' is left out: ${why}`]);
    expect(times).toHaveLength(0);
  });

  const template = (path: string, start: number, end: number, stride: number, more = ''): string =>
    `string templateAssetPath = "${path}"\ndouble templateStartTime = ${start}\ndouble templateEndTime = ${end}\ndouble templateStride = ${stride}\n${more}`;

  it.each([
    [
      template('./a.usda', 1, 2, 1),
      "its templateAssetPath './a.usda' has no group of # between dots, or more than two",
    ],
    [template('./a.#.usda', 1, 1e9, 1), 'its template stands for more than 4096 clips'],
    [template('./a.#.usda', 1, 2, 0), 'its template goes from 1 to 2 in steps of 0, which does not end'],
    [
      template('./a.#.usda', 1, 2, 1, 'double templateActiveOffset = 2'),
      'its templateActiveOffset 2 is more than the stride 1',
    ],
  ])('are rejected if their template is invalid: %s', async (lines, why) => {
    expect((await composed(lines)).said).toEqual([
      `usd.clips root.usda</P>: its clip set 'default' is left out: ${why}`,
    ]);
  });

  it('have no more samples than a stage may have', async () => {
    const times = Array.from({ length: 5000 }, (_, i) => `(${i}, ${(i % 2) * 1000})`).join(', ');
    const samples = Array.from({ length: 1000 }, (_, i) => `${i}: ${i}`).join(', ');
    const { said } = await composed(
      `asset[] assetPaths = [@b.usda@]\ndouble2[] active = [(0, 0)]\ndouble2[] times = [${times}]`,
      { 'b.usda': `#usda 1.0\ndef "Clip" {\ndouble x.timeSamples = { ${samples} }\n}` },
    );
    expect(said).toEqual([expect.stringMatching(/^usd.clips root.usda<\/P>: the clips of the stage make more than/)]);
  });
});
