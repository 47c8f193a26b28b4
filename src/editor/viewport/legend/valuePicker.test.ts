import { beforeEach, describe, expect, it } from 'vitest';
import { IDENTITY } from '../../../math/quat.ts';
import { ZERO } from '../../../math/vec3.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import type { PickResult } from '../../../render/settings.ts';
import { perspective } from '../../../scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS } from '../../../scene/view/view.ts';
import type { FalseColorQuantity } from '../../../spectrum/falseColor/falseColor.ts';
import { legendStore, setLegendColors, setPointer, toggleCrosshair } from './legendState.ts';
import { type PickablePicture, ValuePicker } from './valuePicker.ts';

const surface = { objectId: 1, path: '/a', emissionTime: 3, position: ZERO, velocity: ZERO, doppler: 2, depth: 1 };
const asked: (readonly [number, number])[] = [];
const shown = (kind: FalseColorQuantity, found: PickResult = { light: [1, 1, 1], surface }): PickablePicture => ({
  viewPoint: { t: 5, position: ZERO, u: properVelocity([0, 0, -0.6]), orientation: IDENTITY, lens: perspective(1e-6) },
  settings: { ...DEFAULT_SETTINGS, falseColors: { kind, from: 0.5, to: 2 } },
  width: 100,
  height: 50,
  pick: async (x, y) => {
    asked.push([x, y]);
    return found;
  },
});
const reading = () => legendStore.getState().picked;

beforeEach(() => {
  asked.length = 0;
  legendStore.setState({ pointer: undefined, crosshair: false, picked: undefined });
  setLegendColors(undefined);
});

describe('the value picker', () => {
  it.each([
    ['doppler', 2],
    ['emission-time', -2],
    ['radiance', 1],
    ['band', 1.1e-6],
  ] as const)('reads the value behind the colour: %s', async (kind, value) => {
    setLegendColors({ kind, from: 0.5, to: 2 });
    setPointer([0.25, 0.99999]);
    await new ValuePicker().update(shown(kind), 0);
    expect(asked).toEqual([[25, 49]]);
    expect(reading()).toEqual({ value: expect.closeTo(value, 9), path: '/a' });
  });

  it('reads a shift for the sky, but no time', async () => {
    setPointer([0.5, 0.5]);
    for (const [kind, value] of [
      ['doppler', expect.closeTo(2, 6)],
      ['emission-time', Number.NaN],
    ] as const) {
      setLegendColors({ kind, from: 0.5, to: 2 });
      await new ValuePicker().update(shown(kind, { light: [0, 0, 0] }), 0);
      expect(reading()).toEqual({ value, path: undefined });
    }
  });

  it('requests a value once per position and picture, at the crosshair if there is one, and none without a pointer', async () => {
    setLegendColors({ kind: 'doppler', from: 0.5, to: 2 });
    const reader = new ValuePicker();
    const picture = shown('doppler');
    expect(reader.update(picture, 0)).toBeUndefined();
    setPointer([0.1, 0.1]);
    await reader.update(picture, 100);
    expect(reader.update(picture, 200)).toBeUndefined();
    toggleCrosshair();
    await reader.update(picture, 300);
    expect(asked).toEqual([
      [10, 5],
      [50, 25],
    ]);
    toggleCrosshair();
    setPointer(undefined);
    expect(reader.update(picture, 400)).toBeUndefined();
    expect(reading()).toBeUndefined();
  });

  it('discards values of another quantity', async () => {
    setLegendColors({ kind: 'doppler', from: 0.5, to: 2 });
    setPointer([0.5, 0.5]);
    const late = new ValuePicker().update(shown('doppler'), 0);
    setLegendColors({ kind: 'radiance', from: 0.1, to: 10 });
    await late;
    expect(reading()).toBeUndefined();
  });
});
