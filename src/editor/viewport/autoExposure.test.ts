import { describe, expect, it } from 'vitest';
import { meteredExposure } from '../../nodes/pictures/metering.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import { type LightMeterReadings, METER_CELLS } from '../../scene/view/metering.ts';
import { DEFAULT_SETTINGS } from '../../scene/view/view.ts';
import { AutoExposure, type MeteredPicture } from './autoExposure.ts';

const picture = { metering: 'automatic', falseColor: 'none' } as PictureSpec;
const viewPoint = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: [0, 0, 0, 1], lens: perspective(1) } as const;
const light = (luminance: number): LightMeterReadings => ({
  luminance: new Float32Array(METER_CELLS * METER_CELLS).fill(luminance),
  doppler: new Float32Array(),
  time: new Float32Array(),
});
const drawn = (luminance: number, more: Partial<MeteredPicture> = {}): MeteredPicture => ({
  picture,
  views: [{ ...viewPoint, t: luminance }],
  settings: DEFAULT_SETTINGS,
  size: { width: 3, height: 2 },
  wanted: DEFAULT_SETTINGS,
  detail: 6,
  measureLight: async () => light(luminance),
  ...more,
});
const wanted = (luminance: number): number => meteredExposure([luminance]);

describe('auto exposure', () => {
  it('adopts the first reading at once, and adapts gradually to the next', async () => {
    const autoExposure = new AutoExposure(false);
    autoExposure.observe(drawn(1));
    await autoExposure.advance(0, 0);
    expect(autoExposure.exposure(picture)).toBeCloseTo(wanted(1), 12);
    autoExposure.observe(drawn(16));
    await autoExposure.advance(0.02, 100);
    const way: number[] = [];
    for (let i = 0; i < 200; i++) {
      void autoExposure.advance(0.02, 101);
      way.push(autoExposure.exposure(picture));
    }
    expect(way[0]).toBeLessThan(wanted(1));
    expect(way[5]).toBeGreaterThan(wanted(16));
    expect(way.every((value, i) => i === 0 || value <= way[i - 1]!)).toBe(true);
    expect(way.at(-1)).toBe(way.at(-2));
    expect(way.at(-1)).toBeCloseTo(wanted(16), 12);
  });

  it('changes at once with reduced motion, and after a reset', async () => {
    for (const autoExposure of [new AutoExposure(true), new AutoExposure(false)]) {
      autoExposure.observe(drawn(1));
      await autoExposure.advance(0, 0);
      autoExposure.reset();
      autoExposure.observe(drawn(4));
      await autoExposure.advance(0.01, 100);
      void autoExposure.advance(0.01, 101);
      expect(autoExposure.exposure(picture)).toBeCloseTo(wanted(4), 12);
    }
  });

  it('after a reset ignores readings of earlier pictures', async () => {
    const autoExposure = new AutoExposure(false);
    let measured = (_: LightMeterReadings): void => {};
    autoExposure.observe(drawn(1, { measureLight: () => new Promise((done) => (measured = done)) }));
    const late = autoExposure.advance(0, 0);
    autoExposure.observe(drawn(2));
    autoExposure.reset();
    measured(light(1));
    await late;
    expect(autoExposure.advance(0, 100)).toBeUndefined();
    expect(autoExposure.exposure(picture)).toBe(0);
    autoExposure.observe(drawn(4));
    await autoExposure.advance(0, 200);
    expect(autoExposure.exposure(picture)).toBeCloseTo(wanted(4), 12);
  });

  it('is settled when the last picture is measured and the exposure has reached its target', async () => {
    const autoExposure = new AutoExposure(false);
    expect(autoExposure.isSettled).toBe(true);
    autoExposure.observe(drawn(1));
    expect(autoExposure.isSettled).toBe(false);
    const first = autoExposure.advance(0, 0);
    expect(autoExposure.isSettled).toBe(false);
    await first;
    expect(autoExposure.isSettled).toBe(true);
    autoExposure.observe(drawn(16));
    await autoExposure.advance(0.02, 100);
    void autoExposure.advance(0.02, 101);
    expect(autoExposure.isSettled).toBe(false);
    for (let i = 0; i < 200; i++) void autoExposure.advance(0.02, 102);
    expect(autoExposure.isSettled).toBe(true);
    autoExposure.observe(drawn(2, { measureLight: () => Promise.reject(new Error('lost')) }));
    await autoExposure.advance(0, 200)?.catch(() => {});
    expect(autoExposure.isSettled).toBe(true);
  });

  it('measures one picture at a time and none twice; a change of exposure is no new picture', async () => {
    const autoExposure = new AutoExposure(true);
    let count = 0;
    const readings = async () => {
      count++;
      return light(1);
    };
    const still = drawn(1, { measureLight: readings });
    autoExposure.observe(still);
    const first = autoExposure.advance(0, 0);
    autoExposure.observe(drawn(2, { measureLight: readings }));
    expect(autoExposure.advance(0, 100)).toBeUndefined();
    await first;
    await autoExposure.advance(0, 200);
    expect(count).toBe(2);
    autoExposure.observe(
      drawn(2, { measureLight: readings, wanted: { ...DEFAULT_SETTINGS, exposure: 3, tone: 'agx' } }),
    );
    expect(autoExposure.advance(0, 300)).toBeUndefined();
  });

  it('measures a still picture again in more detail, and when more of the scene is drawn, but not in less detail', async () => {
    const autoExposure = new AutoExposure(true);
    const seen = async (picture: MeteredPicture, isBetter: boolean, now: number): Promise<number> => {
      autoExposure.observe(picture, isBetter);
      await autoExposure.advance(0, now);
      void autoExposure.advance(0, now + 1);
      return autoExposure.exposure(picture.picture);
    };
    const still = drawn(1);
    const hurried = { ...DEFAULT_SETTINGS, occlusionRadius: 0 };
    const coarse = { ...still, settings: hurried, detail: 2, measureLight: async () => light(2) };
    const better = { ...still, measureLight: async () => light(4) };
    expect(await seen(coarse, false, 0)).toBeCloseTo(wanted(2), 12);
    expect(await seen(still, false, 100)).toBeCloseTo(wanted(1), 12);
    expect(await seen(coarse, false, 200)).toBeCloseTo(wanted(1), 12);
    expect(await seen(better, false, 300)).toBeCloseTo(wanted(1), 12);
    expect(await seen(better, true, 400)).toBeCloseTo(wanted(4), 12);
  });

  it('reads luminance alone, which needs no G-buffer, unless numbers are shown as colours', async () => {
    const asked: string[] = [];
    for (const [falseColor, frameGraph] of [
      ['none', undefined],
      ['doppler', undefined],
      ['none', { passes: [] }],
    ] as const) {
      const autoExposure = new AutoExposure(true);
      const measureLight: MeteredPicture['measureLight'] = async (quantities) => {
        asked.push(quantities);
        return light(1);
      };
      const shown = { ...picture, falseColor, frameGraph } as unknown as PictureSpec;
      autoExposure.observe(drawn(1, { picture: shown, measureLight }));
      await autoExposure.advance(0, 0);
    }
    expect(asked).toEqual(['luminance', 'all', 'all']);
  });

  it('measures only what is still drawn: a fine picture that gave way to a coarse one is measured when it is back', async () => {
    const autoExposure = new AutoExposure(true);
    let read = 0;
    const still = drawn(1);
    const inDetail = (detail: number): MeteredPicture => ({
      ...still,
      detail,
      measureLight: async () => {
        read = detail;
        return light(detail);
      },
    });
    const [coarse, fine] = [inDetail(2), inDetail(6)];
    const draw = async (picture: MeteredPicture, now: number): Promise<void> => {
      autoExposure.observe(picture);
      await autoExposure.advance(0, now);
    };
    await draw(coarse, 0);
    autoExposure.observe(fine);
    await draw(coarse, 100);
    expect(read).toBe(2);
    expect(autoExposure.isSettled).toBe(true);
    await draw(fine, 200);
    expect(read).toBe(6);
  });

  it('finds the scale of false colours, also with manual exposure', async () => {
    const autoExposure = new AutoExposure(true);
    const shown = { metering: 'manual', falseColor: 'doppler' } as PictureSpec;
    const readings = async (): Promise<LightMeterReadings> => ({ ...light(1), doppler: Float32Array.of(0.6, 1.2) });
    expect(autoExposure.scale('doppler').to).toBeLessThan(1.1);
    autoExposure.observe(drawn(1, { picture: shown, measureLight: readings }));
    await autoExposure.advance(0, 0);
    expect(autoExposure.scale('doppler')).toEqual({ from: 0.5, to: 2 });
    expect(autoExposure.exposure(shown)).toBe(0);
  });

  it('does not change a manual exposure, and survives a lost device', async () => {
    const autoExposure = new AutoExposure(true);
    const manual = { ...picture, metering: 'manual' } as const;
    autoExposure.observe(drawn(8, { picture: manual }));
    expect(autoExposure.advance(0, 0)).toBeUndefined();
    expect(autoExposure.exposure(manual)).toBe(0);
    autoExposure.observe(drawn(8, { measureLight: () => Promise.reject(new Error('lost')) }));
    await expect(autoExposure.advance(0, 100)).rejects.toThrow('lost');
    autoExposure.observe(drawn(4));
    await autoExposure.advance(0, 200);
    expect(autoExposure.exposure(picture)).toBeCloseTo(wanted(4), 12);
  });
});
