import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { decodeImage } from '../../src/formats/image/decodeImage.ts';
import { encodePng } from '../../src/formats/image/encodePng.ts';
import { type ExrChannel, writeExr } from '../../src/formats/image/exr.ts';
import { outputFolder, slowlight, slowlightJson } from './program.ts';

const folder = outputFolder();
const [width, height] = [40, 30];
const place = (name: string): string => join(folder, name);

function save(name: string, bytes: Uint8Array | string): string {
  writeFileSync(place(name), bytes);
  return place(name);
}

/** Grey, with a white square whose left edge is at `left`. */
function png(name: string, left: number, size = [width, height]): string {
  const rgba = new Uint8Array(4 * size[0] * size[1]).fill(255);
  for (let i = 0; i < size[0] * size[1]; i++) {
    const inside = i % size[0] >= left && i % size[0] < left + 10;
    if (!inside) rgba.fill(128, 4 * i, 4 * i + 3);
  }
  return save(name, encodePng(size[0], size[1], rgba));
}

type Value = (x: number, y: number) => number;
const channel = (name: string, value: Value, type: ExrChannel['type'] = 'float'): ExrChannel => {
  const values = Array.from({ length: width * height }, (_, i) => value(i % width, Math.floor(i / width)));
  return { name, type, data: type === 'uint' ? Uint32Array.from(values) : Float32Array.from(values) };
};
const exr = (name: string, channels: readonly ExrChannel[]): string =>
  save(name, writeExr({ width, height, channels }));

/** A wall that fills the picture, shifted by `shift` pixels to the right. */
const wall = (shift: number): ExrChannel[] => [
  channel('object', () => 1, 'uint'),
  channel('position.x', (x) => 0.1 * (x - shift)),
  channel('position.y', (_, y) => -0.1 * y),
  channel('position.z', () => -5),
];
const light = (gain: number): ExrChannel[] =>
  ['R', 'G', 'B'].map((name, k) => channel(name, (x, y) => gain * (1 + k + x + 2 * y)));
const aovTo = (map: string): string[] => ['--metric', 'aov', '-o', map];

const a = png('a.png', 10);
const b = png('b.png', 12);
const near = exr('near.exr', [...light(1), ...wall(2), channel('doppler', () => 1)]);
const far = exr('far.exr', [...light(1.1), ...wall(0), channel('depth', () => 5)]);

test('a picture does not differ from itself by any metric', async () => {
  for (const metric of ['flip', 'pixels']) {
    const found = await slowlightJson('compare', a, a, '--metric', metric);
    expect(found).toMatchObject({ metric, width, height, mean: 0, max: 0, share: 0 });
  }
  const found = await slowlightJson<{ displacement: object }>('compare', near, near, '--metric', 'aov');
  expect(found).toMatchObject({ otherObject: 0, displacement: { max: 0, share: 0, lost: 0 } });
});

test('prints how two pictures differ, and draws an error map', async () => {
  const map = place('error.png');
  const { code, out } = await slowlight('compare', a, b, '-o', map);
  expect(code).toBe(0);
  expect(out).toContain(`${a} against ${b}, 40 × 30 pixels`);
  expect(out).toMatch(/mean +0\.\d+\n/);
  expect(out).toMatch(/above 0\.1 +\d/);
  const drawn = decodeImage(readFileSync(map), map);
  expect(drawn.height).toBeGreaterThan(height);
  const brightness = (x: number) => drawn.data[4 * (15 * drawn.width + x)];
  // The changed columns, and columns far from them.
  expect(brightness(10)).toBeGreaterThan(brightness(30) + 50);
});

test('draws both pictures beside the error map', async () => {
  for (const [first, second] of [
    [a, b],
    [near, far],
  ]) {
    const map = place('three.png');
    const { code, err } = await slowlight('compare', first, second, '-o', map, '--triptych');
    expect(code, err).toBe(0);
    expect(decodeImage(readFileSync(map), map).width).toBeGreaterThanOrEqual(3 * width);
  }
});

test('counts the pixels that differ', async () => {
  const found = await slowlightJson('compare', a, b, '--metric', 'pixels');
  // Four columns of forty, by 127 of 255.
  expect(found).toMatchObject({ share: 0.1, threshold: 0.02, max: expect.closeTo(127 / 255, 5) });
});

test('exits with 5 if more pixels differ than allowed', async () => {
  const allowing = (share: string) => slowlight('compare', a, b, '--metric', 'pixels', '--fail-above', share);
  expect((await allowing('0.1')).code).toBe(0);
  const { code, out, err } = await allowing('0.05');
  expect(code).toBe(5);
  expect(out).toContain('10 % of the pixels');
  expect(err).toContain('10 % of the pixels are different, and --fail-above allows 5 %');
});

test('compares channels, and reports displacements', async () => {
  const found = await slowlightJson<{ channels: { name: string; absolute: { max: number } }[] }>(
    ...['compare', near, far, '--metric', 'aov', '-o', place('moved.png')],
  );
  expect(found).toMatchObject({
    onlyA: ['doppler'],
    onlyB: ['depth'],
    otherObject: 0,
    displacement: { mean: expect.closeTo(2, 4), share: 1, threshold: 0.5, measured: width * height },
  });
  const x = found.channels.find(({ name }) => name === 'position.x');
  expect(x?.absolute.max).toBeCloseTo(0.2, 5);
  const { out } = await slowlight('compare', near, far, '--metric', 'aov', '--channel', 'R');
  expect(out).toMatch(/displacement +mean 2 px/);
  expect(out).toMatch(/R above 0 +100 % of the pixels/);
  expect(out).toMatch(/only in A +doppler/);
});

test('data without light are compared and drawn', async () => {
  const map = place('data.png');
  const { code, err } = await slowlight('compare', ...[exr('p.exr', wall(1)), exr('q.exr', wall(0))], ...aovTo(map));
  expect(code, err).toBe(0);
  expect(decodeImage(readFileSync(map), map).height).toBeGreaterThan(height);
  const { code: refused, err: why } = await slowlight(
    'compare',
    place('p.exr'),
    place('q.exr'),
    ...aovTo(map),
    '--triptych',
  );
  expect(refused).toBe(3);
  expect(why).toContain('has no channel R');
});

test('high dynamic range pictures are compared at suitable exposures', async () => {
  const found = await slowlightJson<{ mean: number }>('compare', near, far);
  expect(found).toMatchObject({ metric: 'flip', exposures: { count: 2 } });
  expect(found.mean).toBeGreaterThan(0.01);
});

test.each([
  ['sizes that differ', () => [a, png('small.png', 3, [20, 10])], 3, ['a.png has 40 × 30', 'small.png has 20 × 10']],
  ['a file that is not there', () => [a, place('none.png')], 3, ['none.png: there is no such file']],
  ['a folder', () => [a, folder], 3, ['is a folder']],
  ['a damaged picture', () => [a, save('cut.png', readFileSync(a).subarray(0, 60))], 3, ['cut.png', 'damaged']],
  ['a damaged EXR', () => [far, save('cut.exr', readFileSync(far).subarray(0, 400))], 3, ['cut.exr', 'damaged']],
  ['what is no picture', () => [save('a.txt', 'words'), a], 3, ['a.txt', 'PNG']],
  ['light against a screen', () => [far, a], 3, ['far.exr', 'a.png', 'two .exr']],
  ['channels of a PNG', () => [a, b, '--metric', 'aov'], 3, ['a.png', '.exr']],
  ['an EXR without light', () => [exr('dark.exr', wall(0)), far], 3, ['dark.exr has no channel R', '--aov beauty']],
  [
    'light that is no number',
    () => [far, exr('nan.exr', [...light(1).slice(1), channel('R', (x, y) => (x === 3 && y === 7 ? NaN : 1))])],
    3,
    ['nan.exr: R of pixel 3,7 is NaN'],
  ],
  ['a channel that is not there', () => [near, far, '--metric', 'aov', '--channel', 'depth'], 3, ['near.exr', 'depth']],
  [
    'displacement without positions',
    () => [exr('plain.exr', light(1)), far, '--metric', 'aov', '-o', place('no.png')],
    3,
    ['position.x', '--aov position,object'],
  ],
  ['nothing in common', () => [exr('one.exr', wall(0)), exr('two.exr', light(1)), '--metric', 'aov'], 3, ['common']],
  ['a map that is no PNG', () => [a, b, '-o', place('map.jpg')], 2, ['.png']],
  ['a triptych without a file', () => [a, b, '--triptych'], 2, ['-o']],
  ['a channel of no metric', () => [near, far, '--channel', 'R'], 2, ['--metric aov']],
  ['an unknown metric', () => [a, b, '--metric', 'ssim'], 2, ['flip']],
])('%s is rejected with a remedy', async (_, args, code, words) => {
  const result = await slowlight('compare', ...args());
  expect(result.code, result.err).toBe(code);
  for (const word of words) expect(result.err).toContain(word);
  expect(result.err).not.toContain('    at ');
});
