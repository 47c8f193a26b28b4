import type { Random } from '../../math/random.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { rgbSensor } from './rgbSensor.ts';
import type { Sensor } from './spectralContext.ts';
import { spectralSensor } from './spectralSensor.ts';

/** Wavelengths per pixel, divided among its samples, and the minimum per path. */
const [WAVELENGTHS_PER_PIXEL, MIN_WAVELENGTHS_PER_PATH] = [64, 16];

/** Returns the factory of the sensor for each sample of a pixel, given the sample's random numbers. */
export function sensorsOf(settings: RenderSettings, samples = WAVELENGTHS_PER_PIXEL): (random: Random) => Sensor {
  if (settings.colors !== 'spectral') {
    const sensor = rgbSensor(settings.colors, settings);
    return () => sensor;
  }
  const count = 2 ** Math.ceil(Math.log2(Math.max(WAVELENGTHS_PER_PIXEL / samples, MIN_WAVELENGTHS_PER_PATH)));
  return (random) => {
    const shift = random();
    // Random numbers are stratified in pairs: skip one, so that the pairs used for directions stay aligned.
    random();
    return spectralSensor(settings, count, shift);
  };
}
