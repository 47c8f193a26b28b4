import { emissionTime } from '../../src/physics/worldLines/lightCone.ts';
import { vertexWorldLine } from '../../src/scene/motion/motion.ts';
import type { Bench, Table } from '../support/bench.ts';
import { interleaved } from '../support/bench.ts';
import { openRenderer } from '../support/gpu.ts';
import { C, sphereScene, VIEW } from '../support/scenes.ts';

const SIZE = { width: 640, height: 360 };
const SAMPLES = 60;
const ROUNDS = 7;

export const cubic: Bench = {
  name: 'cubic',
  title: 'Cubic motion ÷ straight motion between samples',
  about: `Eight rippling spheres with ${SAMPLES} samples, 640 × 360, observer at 0.5 c: the same points, straight between samples or along cubics whose velocities are kept beside them. Both take turns. CPU: emission events of the f64 library.`,
  async run() {
    return [await frames(), await events()];
  },
};

async function frames(): Promise<Table> {
  const rows: (string | number)[][] = [];
  for (const triangles of [200_000, 1_000_000]) {
    const scenes = (['deforming', 'cubic'] as const).map((kind) => sphereScene(triangles, kind, SAMPLES));
    const opened = [];
    for (const scene of scenes) {
      const { renderer, frame } = await openRenderer(SIZE.width, SIZE.height);
      await renderer.setScene(scene);
      opened.push({ renderer, frame });
    }
    const vertices = scenes[0].objects.reduce((sum, { mesh }) => sum + mesh.positions.length / 3, 0);
    const [straight, curved] = await interleaved(
      opened.map(
        ({ frame }) =>
          () =>
            frame(),
      ),
      ROUNDS,
    );
    for (const { renderer } of opened) renderer.dispose();
    rows.push([vertices.toLocaleString('en'), straight, curved, curved / straight]);
  }
  return { columns: ['vertices', 'straight [ms]', 'cubic [ms]', '÷'], rows };
}

async function events(): Promise<Table> {
  const lines = (['deforming', 'cubic'] as const).map((kind) =>
    sphereScene(2_000, kind, SAMPLES).objects.flatMap((object) =>
      [3, 70, 110].map((i) => vertexWorldLine(object, i, C)),
    ),
  );
  const [straight, curved] = await interleaved(
    lines.map((all) => () => {
      for (let n = 0; n < 500; n++) for (const line of all) emissionTime(line, VIEW, C);
    }),
    ROUNDS,
  );
  const perSecond = (ms: number): number => (500 * lines[0].length * 1000) / ms;
  return {
    columns: ['CPU straight [1/s]', 'CPU cubic [1/s]', 'time ÷'],
    rows: [[perSecond(straight), perSecond(curved), curved / straight]],
  };
}
