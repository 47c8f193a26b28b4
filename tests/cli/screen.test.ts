import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { decode } from 'fast-png';
import { describe, expect, test } from 'vitest';
import { OVERLAY_COLORS } from '../../src/spectrum/display/overlayColors.ts';
import { encodeSrgb } from '../../src/spectrum/display/srgb.ts';
import { outputFolder, scene, slowlight, slowlightJson } from './program.ts';

const folder = outputFolder();
const out = (name: string): string => join(folder, name);
const movers = scene('movers.usda');
const still = ['--size', '160x90', '--time', '1'];
/** What is the same in both pipelines is asked of this one, which starts in a third of the other's time where there is no GPU. */
const rays = ['--pipeline', 'reference', '--samples', '1'];

interface Rendered {
  readonly width: number;
  readonly exposure: readonly [number, number];
  readonly falseColours?: { readonly kind: string; readonly from: number; readonly to: number };
}
const render = (name: string, ...flags: string[]): Promise<Rendered> =>
  slowlightJson<Rendered>('render', movers, '-o', out(name), ...flags);
const pictureOf = (name: string) => decode(readFileSync(out(name)));

/** Mean of red, green and blue, 0 … 255. */
function brightness(name: string): number {
  const { data, channels } = pictureOf(name);
  let sum = 0;
  for (let i = 0; i < data.length; i += channels) sum += data[i]! + data[i + 1]! + data[i + 2]!;
  return sum / ((3 * data.length) / channels);
}

describe('exposure and tone', () => {
  test('manual exposure is not metered; metering gives a fast observer a picture of medium brightness', async () => {
    const fast = [...still, '--beta', '0,0,-0.9'];
    const manual = await render('manual.png', ...fast, '--metering', 'manual', '--exposure', '-1');
    const automatic = await render('automatic.png', ...fast);
    const eye = await render('eye.png', ...fast, ...rays, '--metering', 'resting-eye');
    expect(manual.exposure).toEqual([-1, -1]);
    expect(automatic.exposure[0]).toBeLessThan(-2);
    expect(eye.exposure[0]).toBeGreaterThan(automatic.exposure[0] + 1);
    expect(brightness('automatic.png')).toBeLessThan(brightness('manual.png'));
    expect(brightness('automatic.png')).toBeGreaterThan(60);
    expect(brightness('automatic.png')).toBeLessThan(200);
    // The reported exposure, set manually, gives the same picture.
    await render('again.png', ...fast, '--metering', 'manual', '--exposure', String(automatic.exposure[0]));
    expect(readFileSync(out('again.png'))).toEqual(readFileSync(out('automatic.png')));
  });

  test('both pipelines have the same exposure, to a twentieth of a stop; the tone curve changes only the picture', async () => {
    const raster = await render('raster.png', ...still);
    const reference = await render('reference.png', ...still, ...rays);
    expect(Math.abs(raster.exposure[0] - reference.exposure[0])).toBeLessThan(0.05);
    const agx = await render('agx.png', ...still, '--tone', 'agx');
    expect(agx.exposure).toEqual(raster.exposure);
    expect(readFileSync(out('agx.png'))).not.toEqual(readFileSync(out('raster.png')));
  });

  test('in a film the exposure adapts smoothly, like an eye', async () => {
    const film = ['--size', '64x36', '--frames', '0:1', '--fps', '100', '--beta', '0,0,-0.9', '--stay-in-place'];
    const { exposure } = await render('film.##.png', ...film);
    const alone = await render('alone.png', '--size', '64x36', '--time', '0.01', '--beta', '0,0,-0.9');
    expect(Math.abs(exposure[1] - exposure[0])).toBeLessThanOrEqual(
      0.1 * Math.abs(alone.exposure[0] - exposure[0]) + 1e-3,
    );
  });
});

describe('false colours', () => {
  test('are the same in both pipelines, with a legend of their scale', async () => {
    const flags = [...still, '--beta', '0,0,-0.5', '--false-colour', 'doppler', '--legend'];
    const fast = await render('shift.png', ...flags);
    const exact = await render('truth.png', ...flags, '--pipeline', 'reference');
    expect(fast.falseColours).toEqual({
      kind: 'doppler',
      from: 1 / exact.falseColours!.to,
      to: exact.falseColours!.to,
    });
    const [a, b] = [pictureOf('shift.png'), pictureOf('truth.png')];
    expect(a.width).toBe(160);
    expect(a.height).toBeGreaterThan(110);
    let differing = 0;
    for (let i = 0; i < a.data.length; i++) if (Math.abs(a.data[i]! - b.data[i]!) > 2) differing++;
    expect(differing / a.data.length).toBeLessThan(0.01);
  });

  test('a ghost, past and future have a legend too, below the picture', async () => {
    const flags = [...still, '--ghost', 'simultaneity', '--past-future', '--beta', '0,0,-0.5'];
    await render('ghost.png', ...flags);
    await render('ghost-legend.png', ...flags, '--legend');
    const [plain, told] = [pictureOf('ghost.png'), pictureOf('ghost-legend.png')];
    expect(told.height).toBeGreaterThan(plain.height + 30);
    const { length } = plain.data;
    expect(told.data.slice(0, length)).toEqual(plain.data);
    const below = new Set<string>();
    for (let i = length; i < told.data.length; i += told.channels) below.add(String([...told.data.slice(i, i + 3)]));
    const colors = Object.values(OVERLAY_COLORS).map((linear) => linear.map((x) => Math.round(255 * encodeSrgb(x))));
    expect(colors.filter((color) => !below.has(String(color)))).toEqual([]);
  });

  test('are recorded in the file with the observer', async () => {
    const flags = [...still, '--beta', '0,0,-0.5', '--false-colour', 'doppler', '--false-range', '0.5:2'];
    await render('told.png', ...flags, '--pipeline', 'reference');
    const { text } = pictureOf('told.png');
    expect(text).toMatchObject({ falseColors: 'doppler from 0.5 to 2', worldTime: '1 s', view: 'light-cone' });
    expect(Number.parseFloat(text!.observerSpeed!)).toBeCloseTo(0.5, 12);
    const { speedOfLight, ...rest } = text!;
    expect(speedOfLight).toMatch(/^[\d.]+ m\/s$/);
    expect(Object.values(rest).join(' '), 'no paths').not.toContain('/');
  });

  test('have any given range', async () => {
    const flags = [...still, '--false-colour', 'emission-time', '--false-range', '-0.5:0', '--pipeline', 'reference'];
    expect((await render('time.png', ...flags)).falseColours).toEqual({ kind: 'emission-time', from: -0.5, to: 0 });
    expect(pictureOf('time.png').height).toBe(90);
  });

  test.each([
    [['--legend'], /--legend is for false colours, a ghost, and past and future/],
    [['--false-colour', 'radiance', '--false-range', '0:1'], /logarithmic/],
    [['--false-colour', 'doppler', '--false-range', '2:1'], /the smaller one first/],
    [['--false-colour', 'taste'], /doppler, emission-time, radiance, band/],
    [['--tone', 'sepia'], /neutral, agx, linear/],
    [['--metering', 'spot'], /automatic, resting-eye, manual/],
  ])('%j is rejected, with valid alternatives', async (flags, message) => {
    const { code, err } = await slowlight('render', movers, '-o', out('no.png'), ...flags);
    expect(code).toBe(2);
    expect(err).toMatch(message);
  });

  test('an .exr file holds the values themselves', async () => {
    const { code, err } = await slowlight('render', movers, '-o', out('no.exr'), '--false-colour', 'doppler');
    expect(code).toBe(2);
    expect(err).toMatch(/--aov/);
  });
});
