import type { PolylineLine } from '../../src/physics/worldLines/kinds/polylineLine.ts';
import { emissionTime, newtonEmissionTime } from '../../src/physics/worldLines/lightCone.ts';
import type { Bench, Table } from '../support/bench.ts';
import { interleaved } from '../support/bench.ts';
import { openRenderer } from '../support/gpu.ts';
import { C, sphereScene } from '../support/scenes.ts';

const COUNTS = [16, 64, 256, 1024, 4096];
/** Accuracy for "equal error": error of the emission time over the light's travel time. */
const TOLERANCE = 1e-9;
const LINES = 200;
const ITERATIONS = [1, 2, 4, 8, 16, 32, 64];
/** Duration of the sampled motion [s]. */
const SPAN = 10;
/** Differences below this fraction of the frame time are noise. */
const NOISE = 0.1;
const OBSERVER = { t: 6, position: [0, 0, 0] as const };

export const emission: Bench = {
  name: 'emission',
  title: 'Emission events per second: exact against Newton, and growth with samples',
  about:
    'CPU: the f64 library on polylines that circle at 0.8 c, one event per call. Newton gets the fewest iterations of 1, 2, 4 … 64 with which every event is known to 1e-9 of its ' +
    'travel time; where 64 do not suffice the share that fails is told. GPU: rigid spheres with 100,000 vertices in a picture of 64 × 36, so that the vertices are what costs; ' +
    'the time of the same frame with c = ∞ is taken off. Newton there has the 4 iterations that the CPU needs.',
  async run() {
    return [await onCpu(), await onGpu()];
  },
};

function circlingLine(samples: number, index: number): PolylineLine {
  const times = Float64Array.from({ length: samples }, (_, k) => (SPAN * k) / (samples - 1));
  const positions = new Float64Array(3 * samples);
  const radius = 1 + (index % 17) / 4;
  times.forEach((t, k) => {
    const a = (0.8 * C * t) / radius + index;
    positions.set([radius * Math.cos(a), radius * Math.sin(a), -6 - (index % 5)], 3 * k);
  });
  return { kind: 'polyline', times, positions };
}

async function onCpu(): Promise<Table> {
  const rows: (string | number)[][] = [];
  for (const samples of COUNTS) {
    const lines = Array.from({ length: LINES }, (_, i) => circlingLine(samples, i));
    const { iterations, failing } = newtonNeeds(lines);
    const options = { iterations, damping: 1 };
    const repeat = (solve: (line: PolylineLine) => number | undefined) => () => {
      for (let n = 0; n < 20; n++) for (const line of lines) solve(line);
    };
    const [exact, newton] = await interleaved(
      [
        repeat((line) => emissionTime(line, OBSERVER, C)),
        repeat((line) => newtonEmissionTime(line, OBSERVER, C, options)),
      ],
      5,
    );
    const perSecond = (ms: number): number => (20 * LINES * 1000) / ms;
    rows.push([
      String(samples),
      perSecond(exact),
      perSecond(newton),
      String(iterations),
      `${(100 * failing).toFixed(0)} %`,
      newton / exact,
    ]);
  }
  return {
    columns: ['samples', 'CPU exact [1/s]', 'CPU Newton [1/s]', 'iterations', 'still wrong', 'exact is × faster'],
    rows,
  };
}

/** On a polyline the iteration can oscillate between two segments; more steps do not help then. */
function newtonNeeds(lines: readonly PolylineLine[]): { iterations: number; failing: number } {
  let failing = 1;
  for (const iterations of ITERATIONS) {
    const wrong = lines.filter((line) => {
      const truth = emissionTime(line, OBSERVER, C) ?? Number.NaN;
      const t = newtonEmissionTime(line, OBSERVER, C, { iterations, damping: 1 });
      return !(Math.abs(t - truth) <= TOLERANCE * (OBSERVER.t - truth));
    });
    failing = wrong.length / lines.length;
    if (failing === 0) return { iterations, failing };
  }
  return { iterations: ITERATIONS[ITERATIONS.length - 1], failing };
}

async function onGpu(): Promise<Table> {
  const rows: (string | number)[][] = [];
  for (const samples of COUNTS) {
    const scene = sphereScene(200_000, 'rigid', samples);
    const vertices = scene.objects.reduce((sum, { mesh }) => sum + mesh.positions.length / 3, 0);
    const { renderer, frame } = await openRenderer(64, 36);
    await renderer.setScene(scene);
    const works = [() => frame({ view: 'galilean' }), () => frame(), () => frame({ solver: 'newton', iterations: 4 })];
    const [plain, exact, newton] = await interleaved(works, 5);
    renderer.dispose();
    const perSecond = (ms: number): number | string =>
      ms - plain < NOISE * plain ? 'too fast to tell' : (vertices * 1000) / (ms - plain);
    rows.push([String(samples), plain, exact, newton, perSecond(exact), perSecond(newton)]);
  }
  const columns = ['samples', 'c = ∞ [ms]', 'exact [ms]', 'Newton [ms]', 'GPU exact [1/s]', 'GPU Newton [1/s]'];
  return { columns, rows };
}
