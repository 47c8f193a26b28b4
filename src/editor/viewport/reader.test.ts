import { beforeEach, describe, expect, it } from 'vitest';
import { IDENTITY } from '../../math/quat.ts';
import { ZERO } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/boost.ts';
import type { PickResult } from '../../render/settings.ts';
import { DEFAULT_SETTINGS } from '../../scene/view.ts';
import type { FalseColor } from '../../spectrum/falseColor.ts';
import { legend, pointAt, showColors, toggleCrosshair } from '../state/legend.ts';
import { type Readable, Reader } from './reader.ts';

const surface = { objectId: 1, path: '/a', emissionTime: 3, position: ZERO, velocity: ZERO, doppler: 2, depth: 1 };
const asked: (readonly [number, number])[] = [];
const shown = (kind: FalseColor, found: PickResult = { light: [1, 1, 1], surface }): Readable => ({
  viewPoint: { t: 5, position: ZERO, u: properVelocity([0, 0, -0.6]), orientation: IDENTITY, fovY: 1e-6 },
  settings: { ...DEFAULT_SETTINGS, falseColors: { kind, from: 0.5, to: 2 } },
  width: 100,
  height: 50,
  pick: async (x, y) => {
    asked.push([x, y]);
    return found;
  },
});
const reading = () => legend.getState().reading;

beforeEach(() => {
  asked.length = 0;
  legend.setState({ pointer: undefined, crosshair: false, reading: undefined });
  showColors(undefined);
});

describe('the reader', () => {
  it.each([
    ['doppler', 2],
    ['emission-time', -2],
    ['radiance', 1],
    ['band', 1.1e-6],
  ] as const)('tells the number behind the colour: %s', async (kind, value) => {
    showColors({ kind, from: 0.5, to: 2 });
    pointAt([0.25, 0.99999]);
    await new Reader().follow(shown(kind), 0);
    expect(asked).toEqual([[25, 49]]);
    expect(reading()).toEqual({ value: expect.closeTo(value, 9), path: '/a' });
  });

  it('the sky has a shift of its own, and no time', async () => {
    pointAt([0.5, 0.5]);
    for (const [kind, value] of [
      ['doppler', expect.closeTo(2, 6)],
      ['emission-time', Number.NaN],
    ] as const) {
      showColors({ kind, from: 0.5, to: 2 });
      await new Reader().follow(shown(kind, { light: [0, 0, 0] }), 0);
      expect(reading()).toEqual({ value, path: undefined });
    }
  });

  it('asks once for one place of one picture, at the crosshair where there is one, and for nothing where nobody points', async () => {
    showColors({ kind: 'doppler', from: 0.5, to: 2 });
    const reader = new Reader();
    const picture = shown('doppler');
    expect(reader.follow(picture, 0)).toBeUndefined();
    pointAt([0.1, 0.1]);
    await reader.follow(picture, 100);
    expect(reader.follow(picture, 200)).toBeUndefined();
    toggleCrosshair();
    await reader.follow(picture, 300);
    expect(asked).toEqual([
      [10, 5],
      [50, 25],
    ]);
    toggleCrosshair();
    pointAt(undefined);
    expect(reader.follow(picture, 400)).toBeUndefined();
    expect(reading()).toBeUndefined();
  });

  it('what was read of other colours is forgotten', async () => {
    showColors({ kind: 'doppler', from: 0.5, to: 2 });
    pointAt([0.5, 0.5]);
    const late = new Reader().follow(shown('doppler'), 0);
    showColors({ kind: 'radiance', from: 0.1, to: 10 });
    await late;
    expect(reading()).toBeUndefined();
  });
});
