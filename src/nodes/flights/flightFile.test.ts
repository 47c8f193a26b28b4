import { describe, expect, it } from 'vitest';
import { flyArcs } from '../../flight/arc.ts';
import { flightOf } from '../../flight/flightState.ts';
import { FlightPlayback } from '../../flight/recording/playback.ts';
import type { FlightRecording } from '../../flight/recording/recording.ts';
import { planTrip } from '../../flight/trip.ts';
import { fromAxisAngle, IDENTITY } from '../../math/quat.ts';
import { parseFlight, serializeFlight } from './flightFile.ts';
import { flightPath, flightSpeedOfLight } from './flightPath.ts';

const conditions = { c: 1, lock: 'free', playing: true } as const;
const rest = flightOf({ t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: IDENTITY, properTime: 0 });
const fast = { c: 1, acceleration: 1, limit: 300 };

/** A trip to rapidity 33 and half the way back. */
function farFlight(): FlightRecording {
  const there = planTrip(rest, [0.6e15, 1e14, -0.8e15], fast);
  const turned = [{ ...there[0]!, orientation: fromAxisAngle([0, 1, 0], 1) }, ...there.slice(1)];
  const far = flyArcs(rest, turned, conditions);
  const back = planTrip(far, [0, 0, 0], fast).slice(0, 1);
  return {
    legs: [
      { conditions, start: rest, arcs: turned },
      { conditions, start: { ...far, t: { value: far.t.value, rest: 0.03125 } }, arcs: back },
    ],
  };
}

describe('a file of a flight', () => {
  it('keeps a flight to the last digit', () => {
    const flight = farFlight();
    const read = parseFlight(serializeFlight(flight));
    expect(read).toEqual(flight);
  });

  const text = serializeFlight(farFlight());
  it.each([
    ['not JSON', '{', /^not JSON: /],
    ['another file', '{"slowlight":"project"}', /^slowlight: /],
    ['of a later version', text.replace('"version":1', '"version":2'), /^version: .*it is 2/],
    ['without legs', '{"slowlight":"flight","version":1,"legs":[]}', /^legs: fewer than 1 entries/],
    ['backwards in time', text.replace(/"dTau":[\d.e+]+/, '"dTau":-1'), /^legs\.0\.arcs\.0\.dTau: .*it is -1/],
    [
      'that never ends',
      text.replace(/"dTau":[\d.e+]+/, '"dTau":1e300'),
      /^legs\.0\.arcs\.0: it pushes beyond rapidity 300/,
    ],
    [
      'with light as its ship',
      text.replace('"rapidity":0', '"rapidity":301'),
      /^legs\.0\.start\.rapidity: more than 300/,
    ],
    ['with a lock of its own', text.replace('"free"', '"loose"'), /^legs\.0\.lock: .*"free", "look" or "fly"/],
    [
      'with a bent direction',
      text.replace('"direction":[1,0,0]', '"direction":[1,1,0]'),
      /^legs\.0\.start\.direction: its length/,
    ],
    ['with something more', text.replace('"c":1', '"c":1,"warp":9'), /^legs\.0: unknown: "warp"/],
  ])('%s is refused, and says where', (_, bad, message) => {
    expect(() => parseFlight(bad)).toThrow(message);
  });
});

describe('the path of a flight', () => {
  it('has pictures up to γ = 10⁴, and clocks beyond', () => {
    const playback = new FlightPlayback(farFlight());
    const view = flightPath(playback, { kind: 'perspective', fovY: 1 })(33);
    expect(Math.hypot(1, ...view.u)).toBeCloseTo(1e4, 6);
    expect(view.t).toBeGreaterThan(1e13);
  });

  it('has one speed of light, or says where it changes', () => {
    const { legs } = farFlight();
    expect(flightSpeedOfLight({ legs })).toBe(1);
    const slower = { ...legs[1]!, conditions: { ...conditions, c: 0.5 } };
    expect(() => flightSpeedOfLight({ legs: [legs[0]!, slower] })).toThrow(/leg 2 flies at c = 0.5 m\/s/);
  });
});
