import type { Random } from '../../math/random.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { rgbSensor } from './rgbSensor.ts';
import type { Sensor } from './spectralContext.ts';
import { spectralSensor } from './spectralSensor.ts';

/** Wavelengths of a pixel, shared out among its samples; and the fewest that go along one path. */
const [OF_PIXEL, OF_PATH] = [64, 16];

/** The observer's eye for each of the samples of a pixel, by the sample's numbers. */
export function sensorsOf(settings: RenderSettings, samples = OF_PIXEL): (random: Random) => Sensor {
  if (settings.colors === 'approximate') {
    const eye = rgbSensor(settings);
    return () => eye;
  }
  const count = 2 ** Math.ceil(Math.log2(Math.max(OF_PIXEL / samples, OF_PATH)));
  return (random) => {
    const shift = random();
    // Numbers come in pairs that know of each other: the pairs of directions stay together.
    random();
    return spectralSensor(settings, count, shift);
  };
}
