import { describe, expect, it } from 'vitest';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { domeLens } from './lenses/fisheyeLens.ts';
import { perspective } from './lenses/perspectiveLens.ts';
import { fisheyeOfMetadata, pictureMetadata } from './pictureMetadata.ts';
import { DEFAULT_SETTINGS, type ViewPoint } from './view.ts';

const view: ViewPoint = {
  t: 6.5,
  position: [1, 2, -3],
  u: properVelocity([0, 0, -0.6]),
  orientation: [0, 0, 0, 1],
  lens: perspective(Math.PI / 3),
};
const settings = { ...DEFAULT_SETTINGS, speedOfLight: 30, exposure: -1.25 };

describe('metadata of a picture', () => {
  it('are the observer and the display settings', () => {
    const { observerBeta, observerSpeed, fieldOfView, ...rest } = pictureMetadata(view, settings);
    expect(observerBeta!.split(' ').map(Number)[2]).toBeCloseTo(-0.6, 12);
    expect(Number.parseFloat(observerSpeed!)).toBeCloseTo(0.6, 12);
    expect(Number.parseFloat(fieldOfView!)).toBeCloseTo(60, 12);
    expect(rest).toEqual({
      Software: 'Slowlight',
      worldTime: '6.5 s',
      speedOfLight: '30 m/s',
      observerPosition: '1 2 -3 m',
      view: 'light-cone',
      colors: 'spectral',
      exposure: '-1.25 EV',
      tone: 'neutral',
    });
  });

  it('have the lens, of which that of a fisheye is found again', () => {
    for (const lens of [
      domeLens(Math.PI, 0.3),
      domeLens(4, -0.2),
      { kind: 'fisheye', aperture: 1, elevation: 0 },
    ] as const) {
      const found = fisheyeOfMetadata(pictureMetadata({ ...view, lens }, settings).lens!)!;
      expect(found.aperture).toBeCloseTo(lens.aperture, 12);
      expect(found.elevation).toBeCloseTo(lens.elevation, 12);
    }
    const others = [
      { kind: 'equirectangular' },
      { kind: 'cube', layout: '3x2' },
      { kind: 'stereo', separation: 1 },
    ] as const;
    for (const lens of others)
      expect(fisheyeOfMetadata(pictureMetadata({ ...view, lens }, settings).lens!)).toBeUndefined();
    expect(fisheyeOfMetadata('fisheye of 1e9 degrees, its axis 0 degrees up')).toBeUndefined();
  });

  it('list unphysical settings', () => {
    const about = pictureMetadata(view, {
      ...settings,
      lightDelay: false,
      aberration: false,
      dopplerMix: 0.5,
      beaming: 0,
    });
    expect(about).toMatchObject({ lightDelay: 'off', aberration: 'off', dopplerMix: '0.5', beaming: '0' });
  });

  it('have the scale of false colours, and no exposure where those do not depend on it', () => {
    const about = pictureMetadata(view, { ...settings, falseColors: { kind: 'emission-time', from: -5, to: 0 } });
    expect(about.falseColors).toBe('emission-time from -5 s to 0 s');
    expect(about.exposure).toBeUndefined();
    const band = pictureMetadata(view, { ...settings, falseColors: { kind: 'band', from: 3e-8, to: 1e-5 } });
    expect(band).toMatchObject({ falseColors: 'band from 3e-8 m to 0.00001 m', exposure: '-1.25 EV' });
  });
});
