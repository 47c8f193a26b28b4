import { expect, it } from 'vitest';
import { type FlightSettings, keptSettings, settingsOf } from './flightSettings.ts';

const settings: FlightSettings = {
  mode: 'thrust',
  along: 1.5,
  across: 0.1,
  level: true,
  attitude: 'against',
  collision: 'slide',
  clearance: 0.7,
  ground: true,
  eyeHeight: 1.2,
};

it('what is kept comes back, and nothing else is kept', () => {
  const kept: unknown = JSON.parse(JSON.stringify(settingsOf({ ...settings, ...{ recording: true } })));
  expect(kept).toEqual(settings);
  expect(keptSettings(kept)).toEqual(settings);
});

it('what cannot be read is as at first, and the rest stays', () => {
  const first = keptSettings(undefined);
  expect(first.mode).toBe('velocity');
  for (const kept of [null, 7, 'drive', []]) expect(keptSettings(kept)).toEqual(first);
  const damaged = { ...settings, mode: 'swim', along: -1, clearance: 'far', collision: 'bounce', attitude: 3 };
  const { across, level, ground, eyeHeight } = settings;
  expect(keptSettings(damaged)).toEqual({ ...first, across, level, ground, eyeHeight });
});
