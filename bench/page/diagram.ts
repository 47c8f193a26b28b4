import { cpus } from 'node:os';
import type { DiagramLine } from '../../src/diagrams/diagramLines.ts';
import { spacetimeDiagram } from '../../src/diagrams/spacetimeDiagram.ts';
import { diagramSvg } from '../../src/diagrams/svg.ts';
import { random } from '../../src/math/random.ts';
import { inEnglish } from '../../src/messages/message.ts';
import { properVelocity } from '../../src/physics/lorentz/boost.ts';
import type { WorldLine } from '../../src/physics/worldLines/worldLine.ts';
import { type Bench, cpuTimed, interleaved } from '../support/bench.ts';

const LINES = 200;
/** Pictures of one measurement: each with another event, as while flying. */
const PICTURES = 60;
const C = 10;

/** A kind of world line for each of a number of objects, at random places within 40 m. */
const KINDS: Readonly<Record<string, (number: () => number) => WorldLine>> = {
  uniform: (number) => ({
    kind: 'uniform',
    position: [80 * number() - 40, number(), 0],
    velocity: [18 * number() - 9, 0, 0],
  }),
  hyperbolic: (number) => ({
    kind: 'hyperbolic',
    position: [80 * number() - 40, number(), 0],
    properAcceleration: [40 * number() - 20, 0, 0],
    t0: 8 * number() - 4,
  }),
  'of 240 samples': (number) => {
    const [x, size, rate] = [80 * number() - 40, 2 * number(), 4 * number()];
    const times = Float64Array.from({ length: 240 }, (_, i) => i / 24 - 5);
    const positions = Float64Array.from({ length: 720 }, (_, i) =>
      i % 3 === 0 ? x + size * Math.sin(rate * times[i / 3]!) : 0,
    );
    return { kind: 'polyline', times, positions };
  },
};

export const diagram: Bench = {
  name: 'diagram',
  title: 'Spacetime diagrams',
  about: `A spacetime diagram of ${LINES} world lines, 900 × 600, from the scene's world lines to SVG text, with ticks of proper time, emission events and slices; processor time per picture, of ${PICTURES} pictures in which the observer's event and velocity change, without the browser's drawing. ${cpus()[0]?.model ?? ''}.`,
  async run() {
    const works = Object.values(KINDS).flatMap((kind) => {
      const next = random(1);
      const lines = Array.from(
        { length: LINES },
        (_, i): DiagramLine => ({
          name: `/World/Line${i}`,
          line: kind(next),
          lifetime: { birth: Number.NEGATIVE_INFINITY, death: Number.POSITIVE_INFINITY },
        }),
      );
      return (['world', 'observer'] as const).map((frame) => () => {
        for (let k = 0; k < PICTURES; k++) {
          const observer = {
            t: k / 60,
            position: [k / 30, 0, 0] as const,
            u: properVelocity([0.9 * Math.sin(k / 10), 0, 0]),
          };
          const options = { observer, speedOfLight: C, lines, frame, axis: [1, 0, 0] as const, span: 50 };
          diagramSvg(spacetimeDiagram({ ...options, width: 900, height: 600 }), 'dark', inEnglish);
        }
      });
    });
    const times = await interleaved(works, 5, cpuTimed);
    const rows = Object.keys(KINDS).map((kind, i) => [kind, times[2 * i]! / PICTURES, times[2 * i + 1]! / PICTURES]);
    return [{ columns: ['world lines', 'world frame [ms]', "observer's frame [ms]"], rows }];
  },
};
