// A worker thread of `npm run dynamics`: simulates the source documents' cloth and returns its energy over time.
import { parentPort, workerData } from 'node:worker_threads';

const { stiffness, gravity } = workerData;
const { integrate, makeSystem, meshSprings, METHODS, momenta, springForce, stateAtRest, uniformField } = await import(
  '../dist/lib/dynamics/index.js'
);
const { random } = await import('../dist/lib/math/index.js');

parentPort.on('message', (options) => parentPort.postMessage(simulated(options)));
parentPort.postMessage(undefined);

/** Energies [J] per sample, the largest kinetic energy [J], the reason for an early stop, and the time per step in each frame [ms]. */
function simulated({ id, c, h, every, duration, side, shaken, drag }) {
  const energies = [];
  const costs = [];
  const running = integrate({ ...cloth(side, c, shaken, drag), method: METHODS.get(id), duration, every, step: h });
  let [kinetic, steps, began] = [0, 0, performance.now()];
  for (;;) {
    const { done, value } = running.next();
    const now = performance.now();
    if (done) return { id, c, h, every, energies, kinetic, stop: value, steps, costs };
    if (value.steps > steps) costs.push((now - began) / (value.steps - steps));
    energies.push(value.quantities.total);
    kinetic = Math.max(kinetic, value.quantities.kinetic);
    [steps, began] = [value.steps, performance.now()];
  }
}

/** A level square cloth of 1 m and 1 kg, pinned at two corners; `shaken`: maximum initial velocity per axis [m/s]; `drag` [1/s]. */
function cloth(side, c, shaken = 0, drag = 0) {
  const points = side * side;
  const x = new Float64Array(3 * points);
  const corners = [];
  for (let i = 0; i < side; i++)
    for (let j = 0; j < side; j++) {
      const at = i * side + j;
      x.set([j / (side - 1), 0, i / (side - 1)], 3 * at);
      if (i + 1 < side && j + 1 < side) corners.push(at, at + 1, at + side + 1, at + side);
    }
  const masses = new Float64Array(points).fill(1 / points);
  const pinned = new Uint8Array(points);
  pinned[0] = pinned[side - 1] = 1;
  const faces = { counts: new Array((side - 1) ** 2).fill(4), corners };
  const net = springForce(meshSprings(x, faces, { structural: stiffness, shear: stiffness, bending: stiffness }));
  const system = makeSystem({ masses, pinned, c, drag, forces: [net, uniformField(masses, gravity)] });
  const next = random(1);
  const v = Array.from(x, () => shaken * (2 * next() - 1));
  return { system, start: { ...stateAtRest(x), p: momenta(system, v) } };
}
