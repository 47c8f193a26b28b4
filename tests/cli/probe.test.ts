import { expect, test } from 'vitest';
import { scene, slowlight, slowlightJson } from './program.ts';

interface Vertex {
  readonly time: number;
  readonly position: number[];
  readonly apparent: number[];
  readonly distance: number;
  readonly doppler: number;
  readonly visible: boolean;
}
interface Probe {
  readonly speedOfLight: number;
  readonly observer: { readonly beta: number[]; readonly gamma: number };
  readonly vertices: Vertex[];
}
interface PixelProbe {
  readonly seen: (Vertex & { readonly prim: string; readonly object: number }) | null;
}
const movers = scene('movers.usda');

test('light of a receding cube was emitted where distance = c · age, and is redshifted', async () => {
  const { vertices, speedOfLight } = await slowlightJson<Probe>(
    'probe',
    movers,
    '--prim',
    '/World/Leaving',
    '--time',
    '2',
  );
  expect(speedOfLight).toBe(10);
  expect(vertices).toHaveLength(24);
  for (const { time, position, apparent, doppler } of vertices) {
    const distance = Math.hypot(...position);
    // On the observer's past light cone, and on the vertex's world line: z(t) + 6 t has one of its two initial values.
    expect(distance).toBeCloseTo(10 * (2 - time), 10);
    expect(Math.abs(position[2] + 6 * time + 20)).toBeCloseTo(1, 10);
    // An observer at rest sees it where it was at emission, D = 1/[γ(1 + β·n)] with β along −z.
    position.forEach((x, k) => void expect(apparent[k]).toBeCloseTo(x, 10));
    expect(doppler).toBeCloseTo(0.8 / (1 - (0.6 * position[2]) / distance), 10);
  }
});

test('a moving observer sees a cube at rest aberrated, as the boosted light cone has it', async () => {
  const flags = ['--position', '0,0,0', '--beta', '0,0,-0.8', '--time', '1'];
  const { vertices, observer } = await slowlightJson<Probe>('probe', movers, '--prim', '/World/Still', ...flags);
  expect(observer.gamma).toBeCloseTo(1 / 0.6, 12);
  for (const { position, apparent, doppler, distance } of vertices) {
    const r = Math.hypot(...position);
    // (ct, x) = (−r, x) boosted by β along −z.
    expect(apparent[2]).toBeCloseTo((position[2] - 0.8 * r) / 0.6, 10);
    expect(apparent[0]).toBeCloseTo(position[0], 12);
    expect(distance).toBeCloseTo(Math.hypot(...apparent), 10);
    expect(doppler).toBeCloseTo(distance / r, 10);
  }
});

test('a moving camera is the observer', async () => {
  const { observer } = await slowlightJson<Probe>(
    'probe',
    movers,
    '--prim',
    '/World/Still',
    '--camera',
    '/World/Flyer',
    '--time',
    '1',
  );
  expect(observer.beta[0]).toBeCloseTo(0.5, 12);
});

test('the middle pixel sees the near side of the cube ahead', async () => {
  const size = ['--size', '101x101', '--pixel', '50,50', '--time', '1'];
  const { seen } = await slowlightJson<PixelProbe>('probe', movers, ...size);
  expect(seen).toMatchObject({ prim: '/World/Still', object: 1 });
  expect(seen?.distance).toBeCloseTo(9, 6);
  expect(seen?.time).toBeCloseTo(1 - 0.9, 6);
  const nothing = await slowlightJson<PixelProbe>(
    'probe',
    movers,
    '--size',
    '101x101',
    '--pixel',
    '0,0',
    '--time',
    '1',
  );
  expect(nothing.seen).toBeNull();
});

test('without --json the output is a table, one line per vertex', async () => {
  const { code, out } = await slowlight('probe', movers, '--prim', '/World/Still', '--view', 'simultaneity');
  expect(code).toBe(0);
  expect(out.trim().split('\n')).toHaveLength(25);
});

test('for a missing object the existing ones are listed', async () => {
  const { code, err } = await slowlight('probe', movers, '--prim', '/World/Cube');
  expect(code).toBe(2);
  expect(err).toContain('/World/Leaving');
});

test('--solver newton gives where its steps end, and is refused for a pixel, which a ray probes', async () => {
  const newton = ['--solver', 'newton', '--iterations', '1', '--damping', '0.3', '--time', '2'];
  const { vertices } = await slowlightJson<Probe>('probe', movers, '--prim', '/World/Leaving', ...newton);
  for (const { time, position } of vertices) {
    // One step from t = 2 s: f = |x|, f′ = c + v·x/|x|, v = −6 m/s along z.
    const [x, y, z] = [position[0], position[1], position[2] - 6 * (2 - time)];
    const r = Math.hypot(x, y, z);
    expect(time).toBeCloseTo(2 - (0.3 * r) / (10 - (6 * z) / r), 10);
  }
  const refused = await slowlight('probe', movers, '--pixel', '3,3', ...newton);
  expect(refused.code).toBe(2);
  expect(refused.err).toContain('--solver newton is for --prim');
});
