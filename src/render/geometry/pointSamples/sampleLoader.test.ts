import { describe, expect, it } from 'vitest';
import { leftInFile } from '../../../../tests/support/streamed.ts';
import { plane } from '../../../scene/mesh/primitives.ts';
import { isStreamed } from '../../../scene/streaming/samplePoints.ts';
import type { SampledPointsMotion } from '../../../scene/types.ts';
import { LocalSamples } from './packedSamples.ts';
import { SampleLoader } from './sampleLoader.ts';
import { type SampleReply, type SampleRequest, serveSamples } from './sampleServer.ts';

const mesh = plane(1, 1, 'Y');
const memory: SampledPointsMotion = {
  kind: 'sampled-points',
  times: Float64Array.from({ length: 50 }, (_, k) => k),
  origin: [0, 0, 0],
  points: Array.from({ length: 50 }, (_, k) => mesh.positions.map((x) => x + k / 8)),
  normals: Array.from({ length: 50 }, () => mesh.normals),
};
const file = leftInFile(memory);

/** A worker that works when `work` is called; messages are copied, as to a real one. */
function lazyWorker() {
  const requests: SampleRequest[] = [];
  let serve: ((event: MessageEvent<SampleRequest>) => void) | undefined;
  const worker = {
    onmessage: undefined as ((event: MessageEvent<SampleReply>) => void) | undefined,
    postMessage: (request: SampleRequest) => requests.push(structuredClone(request)),
    terminate() {},
  };
  serveSamples({
    addEventListener: (_, listener) => {
      serve = listener;
    },
    postMessage: (reply, { transfer }) =>
      worker.onmessage?.({ data: structuredClone(reply, { transfer }) } as MessageEvent<SampleReply>),
  });
  const work = (): number => {
    const waiting = requests.splice(0);
    for (const data of waiting) serve?.({ data } as MessageEvent<SampleRequest>);
    return waiting.length;
  };
  return { worker: worker as unknown as Worker, work };
}

function startLoader(motion = file) {
  const { worker, work } = lazyWorker();
  const notifications: (Error | 'samples')[] = [];
  const loader = new SampleLoader(worker, {
    onSamples: () => notifications.push('samples'),
    onError: (error) => notifications.push(error),
  });
  if (!isStreamed(motion.points)) throw new Error('in memory');
  const samples = loader.samplesOf(motion.points);
  work();
  samples.setWindow(0, 50);
  return { samples, work, told: notifications };
}

describe('samples from a worker', () => {
  it('equal those packed on this thread, and are delivered once', () => {
    const { samples, work, told: notifications } = startLoader();
    expect(samples.take(7)).toBeUndefined();
    expect([work(), notifications]).toEqual([1, ['samples']]);
    expect(samples.take(7)).toEqual(new LocalSamples(memory, mesh.normals).take(7));
    expect(samples.take(7)).toBeUndefined();
  });

  it('are requested once, and a few at a time', () => {
    const { samples, work } = startLoader();
    for (let i = 0; i < 3; i++) for (let k = 0; k < 10; k++) samples.take(k);
    expect(work()).toBe(4);
    for (let k = 4; k < 10; k++) samples.take(k);
    expect(work()).toBe(4);
  });

  it('are dropped if they are outside the window', () => {
    const { samples, work } = startLoader();
    samples.take(3);
    samples.setWindow(30, 40);
    work();
    samples.setWindow(0, 10);
    expect(samples.take(3)).toBeUndefined();
  });

  it('that cannot be read are reported once, with file and place', () => {
    if (!isStreamed(file.points)) throw new Error('in memory');
    const gone = { name: 'cache.usdc', handle: { path: '/gone' } };
    const lost = file.points.samples.map(({ points, ...rest }) => ({
      ...rest,
      points: { ...points, before: { ...points.before, file: gone } },
    }));
    const { samples, work, told: notifications } = startLoader({ ...file, points: { ...file.points, samples: lost } });
    for (const k of [1, 2, 3]) samples.take(k);
    work();
    const errors = notifications.filter((notification) => notification !== 'samples');
    expect(errors).toHaveLength(1);
    expect(errors[0].message).toContain('cache.usdc');
    samples.take(9);
    expect(work()).toBe(0);
  });
});
