import { MessageChannel } from 'node:worker_threads';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { add, build, connect, edited, set, toys } from '../../../tests/support/graphKit.ts';
import type { GraphDocument } from '../document/document.ts';
import type { NodeType, Outputs } from '../nodeType.ts';
import { CancelledError, Evaluator } from './evaluator.ts';
import { heavyWorkerPool, serveHeavy } from './heavyWorkers.ts';
import { throttleInterims } from './interim.ts';

/** A run of `tally`, controlled by the test. */
interface Led {
  readonly resume: Outputs | undefined;
  readonly interim: ((number: number) => void) | undefined;
  readonly end: (number: number) => void;
}
const led: Led[] = [];
const tally: NodeType = {
  ...toys.sum,
  id: 'tally',
  evaluate: (_inputs, _params, { interim, resume, signal }) =>
    new Promise((done, fail) => {
      led.push({
        resume,
        interim: interim && ((number) => interim(() => ({ number, own: `state of ${number}` }))),
        end: (number) => done({ number }),
      });
      signal?.addEventListener('abort', () => fail(new Error('ended')));
    }),
};
let twices = 0;
const twice: NodeType = {
  ...toys.length,
  id: 'twice',
  inputs: { a: { type: 'number' } },
  evaluate: ({ a }) => ({ number: 2 * Number(a), run: ++twices }),
};
const library = { ...toys, tally, twice };
const document = build(add('x', 'value'), add('t', 'tally'), add('d', 'twice'), connect('x.number', 't.a'));
const doubled = edited(document, connect('t.number', 'd.a'));

/** Starts an evaluation that reports interim results. */
function begin(evaluator: Evaluator<unknown>, of: GraphDocument, target: string, interims?: 'stopped') {
  const abort = new AbortController();
  const told: string[] = [];
  const onInterim = (node: string) => void told.push(node);
  const ended = evaluator.evaluate(of, target, 0, { signal: abort.signal, onInterim, interims });
  ended.catch(() => {});
  return { abort, told, ended };
}
const soFar = async (evaluator: Evaluator<unknown>, of: GraphDocument, target: string) =>
  (await evaluator.evaluate(of, target, 0, { interims: 'all' })).target;
const settled = () => new Promise((done) => setTimeout(done));

beforeEach(() => {
  led.length = 0;
  twices = 0;
});

describe('long-running work', () => {
  it('has interim results with everything downstream, and those are not cached', async () => {
    const evaluator = new Evaluator<unknown>(library);
    const main = begin(evaluator, doubled, 'd');
    const early = soFar(evaluator, doubled, 'd');
    led[0]!.interim!(3);
    await settled();
    expect(main.told).toEqual(['t']);
    expect(await early).toEqual({ status: 'done', outputs: { number: 6, run: 1 }, interim: true });
    expect(await soFar(evaluator, doubled, 't')).toEqual({
      status: 'done',
      outputs: { number: 3, own: 'state of 3' },
      interim: true,
    });
    led[0]!.end(5);
    expect((await main.ended).target).toEqual({ status: 'done', outputs: { number: 10, run: 2 } });
    expect(await soFar(evaluator, doubled, 'd')).toEqual({ status: 'done', outputs: { number: 10, run: 2 } });
    expect(led).toHaveLength(1);
    // Its content equals that of the interim result; a result that depends on an interim must not be cached for it.
    const three = edited(doubled, add('y', 'value'), set('y', 'value', 3), connect('y.number', 'd.a'));
    expect(await soFar(evaluator, three, 'd')).toEqual({ status: 'done', outputs: { number: 6, run: 3 } });
  });

  it('without observers is not asked for interim results', () => {
    const evaluator = new Evaluator<unknown>(library);
    evaluator.evaluate(document, 't', 0);
    expect(led[0]!.interim).toBeUndefined();
  });

  it('does not continue for observers only', async () => {
    const evaluator = new Evaluator<unknown>(library);
    const main = begin(evaluator, document, 't');
    const looking = soFar(evaluator, document, 't');
    main.abort.abort();
    await expect(looking).rejects.toThrow(CancelledError);
    expect(led).toHaveLength(1);
  });

  it('without interim results is awaited by observers', async () => {
    const evaluator = new Evaluator<unknown>(library);
    begin(evaluator, doubled, 'd');
    const looking = soFar(evaluator, doubled, 'd');
    led[0]!.end(4);
    expect(await looking).toMatchObject({ outputs: { number: 8 } });
    expect((await looking).status === 'done' && 'interim' in (await looking)).toBe(false);
  });

  it('when cancelled keeps its interim result, and later resumes from there', async () => {
    const evaluator = new Evaluator<unknown>(library);
    const first = begin(evaluator, doubled, 'd');
    led[0]!.interim!(3);
    first.abort.abort();
    await expect(first.ended).rejects.toThrow(CancelledError);
    // Twice: downstream results are cached.
    for (const _ of [1, 2])
      expect((await begin(evaluator, doubled, 'd', 'stopped').ended).target).toEqual({
        status: 'done',
        outputs: { number: 6, run: 1 },
        interim: true,
      });
    expect(led).toHaveLength(1);

    const second = begin(evaluator, doubled, 'd');
    expect(led[1]!.resume).toEqual({ number: 3, own: 'state of 3' });
    await settled();
    expect(second.told).toEqual(['t']);
    expect(await soFar(evaluator, doubled, 'd')).toMatchObject({ outputs: { number: 6 }, interim: true });
    second.abort.abort();
    await expect(second.ended).rejects.toThrow(CancelledError);

    const third = begin(evaluator, doubled, 'd');
    expect(led[2]!.resume).toEqual({ number: 3, own: 'state of 3' });
    led[2]!.end(9);
    expect((await third.ended).target).toMatchObject({ outputs: { number: 18 } });
    // With other parameters the work starts anew.
    begin(evaluator, edited(doubled, set('t', 'bias', 1)), 'd');
    expect(led[3]!.resume).toBeUndefined();
  });

  it('keeps the interim results of the last four cancelled runs', async () => {
    const evaluator = new Evaluator<unknown>(library);
    const at = (bias: number) => begin(evaluator, edited(document, set('t', 'bias', bias)), 't');
    for (const bias of [1, 2, 3, 4, 5]) {
      const run = at(bias);
      led.at(-1)!.interim!(bias);
      run.abort.abort();
      await expect(run.ended).rejects.toThrow(CancelledError);
    }
    for (const bias of [1, 2, 3, 4, 5]) at(bias);
    expect(led.slice(5).map(({ resume }) => resume?.number)).toEqual([undefined, 2, 3, 4, 5]);
  });
});

describe('in a thread', () => {
  const open: MessageChannel[] = [];
  afterEach(() => {
    for (const { port1 } of open.splice(0)) port1.close();
  });
  const threads = () =>
    heavyWorkerPool(() => {
      const channel = new MessageChannel();
      open.push(channel);
      serveHeavy<unknown>({ ...library, tally: { ...tally, heavy: true } }, 0, {
        listen: (hear) => void channel.port2.on('message', hear),
        reply: (reply, transfer) => channel.port2.postMessage(reply, transfer),
      });
      return {
        send: (order) => channel.port1.postMessage(order),
        listen: (hear) => void channel.port1.on('message', hear),
        end: () => channel.port1.close(),
      };
    });

  it('it yields interim results, and resumes from the last one', async () => {
    const evaluator = new Evaluator<unknown>({ ...library, tally: { ...tally, heavy: true } }, { heavy: threads() });
    const first = begin(evaluator, doubled, 'd');
    await expect.poll(() => led).toHaveLength(1);
    led[0]!.interim!(3);
    await expect.poll(() => first.told).toEqual(['t']);
    expect(await soFar(evaluator, doubled, 'd')).toMatchObject({ outputs: { number: 6 }, interim: true });
    first.abort.abort();
    await expect(first.ended).rejects.toThrow(CancelledError);
    const second = begin(evaluator, doubled, 'd');
    await expect.poll(() => led).toHaveLength(2);
    expect(led[1]!.resume).toEqual({ number: 3, own: 'state of 3' });
    led[1]!.end(7);
    expect((await second.ended).target).toMatchObject({ outputs: { number: 14 } });
  });
});

it('the first interim result is made at once, later ones at intervals that grow with their cost', () => {
  let now = 1000;
  const clock = vi.spyOn(performance, 'now').mockImplementation(() => now);
  const times: number[] = [];
  let spent = 0;
  const interim = throttleInterims(() => {});
  // The longer the work runs, the more there is to copy.
  const make = (): Outputs => {
    times.push(now);
    const cost = now / 500;
    spent += cost;
    now += cost;
    return {};
  };
  for (; now < 61_000; now += 10) interim(make);
  clock.mockRestore();
  expect(times[0]).toBe(1000);
  expect(times[1]! - times[0]!).toBeLessThan(300);
  expect(times.length).toBeGreaterThan(20);
  expect(spent / 60_000).toBeLessThan(0.05);
  const gaps = times.slice(1).map((time, i) => time - times[i]!);
  expect(gaps.at(-1)).toBeGreaterThan(4 * gaps[0]!);
});
