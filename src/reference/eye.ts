import type { RenderSettings } from '../scene/view.ts';
import type { Random } from './directions.ts';
import type { Eye } from './sight.ts';
import { spectralEye } from './spectral.ts';
import { tintedEye } from './tinted.ts';

/** Wavelengths of a pixel, shared out among its samples; and the fewest that go along one path. */
const [OF_PIXEL, OF_PATH] = [64, 16];

/** The observer's eye for each of the samples of a pixel, by the sample's numbers. */
export function eyesOf(settings: RenderSettings, samples = OF_PIXEL): (random: Random) => Eye {
  if (settings.colors === 'approximate') {
    const eye = tintedEye(settings);
    return () => eye;
  }
  const count = 2 ** Math.ceil(Math.log2(Math.max(OF_PIXEL / samples, OF_PATH)));
  return (random) => {
    const shift = random();
    // Numbers come in pairs that know of each other: the pairs of directions stay together.
    random();
    return spectralEye(settings, count, shift);
  };
}
