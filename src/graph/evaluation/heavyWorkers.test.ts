import { MessageChannel } from 'node:worker_threads';
import { afterEach, describe, expect, it } from 'vitest';
import { add, build, connect, set, toys } from '../../../tests/support/graphKit.ts';
import { saying } from '../../../tests/support/inWords.ts';
import { msg } from '../../messages/message.ts';
import { NodeRefusal, type NodeType } from '../nodeType.ts';
import { CancelledError, Evaluator } from './evaluator.ts';
import { heavyWorkerPool, serveHeavy } from './heavyWorkers.ts';

const series: NodeType = {
  ...toys.sum,
  id: 'series',
  heavy: true,
  params: { count: { kind: 'number', title: 'count', default: 3, min: 0, max: 1e6, step: 1 } },
  inputs: { a: { type: 'number' } },
  outputs: { numbers: { type: 'numbers' } },
  async evaluate({ a }, { count }, { node, progress, services }) {
    progress(0.5, 'counting');
    if (count === 13)
      throw new NodeRefusal({ severity: 'error', code: 'test.unlucky', place: node, message: msg`no 13` });
    if (count === 14) throw new TypeError('unforeseen');
    if (count === 15) await new Promise(() => {});
    return { numbers: Float32Array.from({ length: Number(count) }, (_, i) => Number(a) * i), services };
  },
};
const library = { ...toys, series };

/** Both ends of a thread are in this process; messages are structured-cloned as between real threads. */
const open: MessageChannel[] = [];
let started = 0;
let ended = 0;
const threads = () =>
  heavyWorkerPool(() => {
    started++;
    const channel = new MessageChannel();
    open.push(channel);
    serveHeavy<unknown>(library, 'of the thread', {
      listen: (onReply) => void channel.port2.on('message', onReply),
      reply: (reply, transfer) => channel.port2.postMessage(reply, transfer),
    });
    return {
      send: (order) => channel.port1.postMessage(order),
      listen: (onReply) => void channel.port1.on('message', onReply),
      end: () => {
        ended++;
        channel.port1.close();
      },
    };
  });
afterEach(() => {
  for (const { port1 } of open.splice(0)) port1.close();
  started = 0;
  ended = 0;
});

const document = (count: number) =>
  build(
    add('x', 'value'),
    add('s', 'series'),
    connect('x.number', 's.a'),
    set('x', 'value', 2),
    set('s', 'count', count),
  );

describe('a heavy node', () => {
  it('gives the same result and progress in a thread as here', async () => {
    const reports: unknown[] = [];
    const evaluator = new Evaluator<unknown>(library, { heavy: threads() });
    const there = await evaluator.evaluate(document(4), 's', 'from outside', {
      progress: (...report) => reports.push(report),
    });
    expect(there.target).toEqual({
      status: 'done',
      outputs: { numbers: Float32Array.of(0, 2, 4, 6), services: 'of the thread' },
    });
    expect(reports).toEqual([['s', 0.5, 'counting']]);
    const here = await new Evaluator<unknown>(library).evaluate(document(4), 's', 'of the thread');
    expect(here.target).toEqual(there.target);
  });

  it('returns its refusal unchanged, and the thread continues with the next node', async () => {
    const evaluator = new Evaluator<unknown>(library, { heavy: threads() });
    const problem = async (count: number) => (await evaluator.evaluate(document(count), 's', undefined)).target;
    expect(await problem(13)).toMatchObject({ problem: { code: 'test.unlucky', place: 's', message: msg`no 13` } });
    expect(await problem(14)).toMatchObject({
      problem: { code: 'graph.evaluation', place: 's', message: saying(/^unforeseen$/) },
    });
    expect(await problem(2)).toMatchObject({ status: 'done' });
    expect([started, ended]).toEqual([1, 0]);
  });

  it('is cancelled by terminating its thread; the next request gets a new one', async () => {
    const evaluator = new Evaluator<unknown>(library, { heavy: threads() });
    const abort = new AbortController();
    const never = evaluator.evaluate(document(15), 's', undefined, {
      signal: abort.signal,
      progress: () => abort.abort(),
    });
    await expect(never).rejects.toThrow(CancelledError);
    expect((await evaluator.evaluate(document(1), 's', undefined)).target.status).toBe('done');
    expect([started, ended]).toEqual([2, 1]);
  });

  it('whose inputs cannot be sent fails at its node', async () => {
    const odd = { ...library, value: { ...toys.value, evaluate: () => ({ number: () => 1 }) } };
    const evaluator = new Evaluator<unknown>(odd, { heavy: threads() });
    const { target } = await evaluator.evaluate(document(1), 's', undefined);
    expect(target).toMatchObject({ problem: { place: 's', message: saying(/clone/) } });
  });
});
