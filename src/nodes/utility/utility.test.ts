import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { utilityProject } from '../../../tests/support/exampleGraphs.ts';
import { add, build, edited, set } from '../../../tests/support/graphKit.ts';
import { validateDocument } from '../../graph/analysis/validate.ts';
import type { ParamValue } from '../../graph/document/document.ts';
import { Evaluator } from '../../graph/evaluation/evaluator.ts';
import { gamma as gammaOf, velocity } from '../../physics/lorentz/boost.ts';
import { makeObject, makeScene } from '../../scene/defaults.ts';
import { box } from '../../scene/mesh/primitives.ts';
import { nodeLibrary } from '../library.ts';
import { evaluatedPicture } from '../pictures/renderSettings.ts';
import { type Services, workerServices } from '../services.ts';
import { arity, OPERATIONS, type Operation } from './operations.ts';

async function outputs(type: string, params: Record<string, ParamValue>) {
  const document = edited(
    build(add('it', type)),
    ...Object.entries(params).map(([param, value]) => ({ kind: 'set-param', node: 'it', param, value }) as const),
  );
  const { target } = await new Evaluator(nodeLibrary).evaluate(document, 'it', workerServices);
  return target.status === 'done' ? target.outputs : target;
}
const math = async (operation: Operation, a: number, b = 0, c = 0) => {
  const found = await outputs('math', { operation, a, b, c });
  return 'number' in found ? found.number : found;
};

describe('math', () => {
  it.each<[Operation, number, number, number, number]>([
    ['add', 2, 3, 0, 5],
    ['subtract', 2, 3, 0, -1],
    ['multiply', 2, 3, 0, 6],
    ['divide', 3, 2, 0, 1.5],
    ['power', 2, 10, 0, 1024],
    ['minimum', 2, 3, 0, 2],
    ['maximum', 2, 3, 0, 3],
    ['modulo', -1, 3, 0, 2],
    ['mix', 10, 20, 0.25, 12.5],
    ['clamp', 5, 0, 3, 3],
    ['square-root', 9, 0, 0, 3],
    ['exponential', 0, 0, 0, 1],
    ['logarithm', Math.E, 0, 0, 1],
    ['absolute', -2, 0, 0, 2],
    ['round', 2.5, 0, 0, 3],
    ['floor', -0.5, 0, 0, -1],
    ['sine', Math.PI / 6, 0, 0, 0.5],
    ['cosine', Math.PI / 3, 0, 0, 0.5],
    ['tangent', Math.PI / 4, 0, 0, 1],
    ['arcsine', 1, 0, 0, Math.PI / 2],
    ['arccosine', 1, 0, 0, 0],
    ['arctangent', 1, -1, 0, (3 * Math.PI) / 4],
    ['gamma-of-beta', 0.8, 0, 0, 5 / 3],
    ['beta-of-gamma', 5 / 3, 0, 0, 0.8],
  ])('%s of %d, %d, %d is %d', async (operation, a, b, c, wanted) => {
    expect(await math(operation, a, b, c)).toBeCloseTo(wanted, 12);
  });

  it('converts β to γ accurately near c', () => {
    fc.assert(
      fc.property(fc.double({ min: 1e-6, max: 1e3, noNaN: true }), (u) => {
        const [gamma, [beta]] = [gammaOf([u, 0, 0]), velocity([u, 0, 0])];
        expect(OPERATIONS['beta-of-gamma'](gamma)).toBeCloseTo(beta, 9);
        // Digits of β are lost near 1: relative error γ²·ε.
        expect(OPERATIONS['gamma-of-beta'](beta) / gamma - 1).toBeLessThan(4e-16 * gamma * gamma + 1e-15);
      }),
    );
  });

  it.each<[Operation, number, number]>([
    ['divide', 1, 0],
    ['square-root', -1, 0],
    ['gamma-of-beta', 1, 0],
    ['beta-of-gamma', 0.5, 0],
  ])('%s of %d is rejected where it is undefined', async (operation, a, b) => {
    expect(await math(operation, a, b)).toMatchObject({ problem: { code: 'math.undefined', place: 'it' } });
  });

  it('shows as many inputs as an operation has', () => {
    expect((['sine', 'add', 'mix'] as const).map(arity)).toEqual([1, 2, 3]);
  });
});

describe('vector math', () => {
  it.each([
    ['add', [5, 7, 9], Math.sqrt(155)],
    ['subtract', [-3, -3, -3], Math.sqrt(27)],
    ['scale', [2, 4, 6], Math.sqrt(56)],
    ['cross', [-3, 6, -3], Math.sqrt(54)],
    ['normalize', [1, 2, 3].map((x) => x / Math.sqrt(14)), 1],
    ['dot', [32, 32, 32], 32],
    ['length', [Math.sqrt(14), Math.sqrt(14), Math.sqrt(14)], Math.sqrt(14)],
  ])('%s of (1, 2, 3), (4, 5, 6) and 2', async (operation, vector, number) => {
    const found = await outputs('vector-math', { operation, a: [1, 2, 3], b: [4, 5, 6], factor: 2 });
    expect(found).toEqual({ vector: vector.map((x) => expect.closeTo(x, 12)), number: expect.closeTo(number, 12) });
  });

  it('rejects overflow', async () => {
    const found = await outputs('vector-math', { operation: 'scale', a: [1e308, 0, 0], factor: 10 });
    expect(found).toMatchObject({ problem: { code: 'math.undefined', place: 'it' } });
  });
});

describe('compare', () => {
  it.each([
    ['less', [1, 0, 0]],
    ['less-or-equal', [1, 1, 0]],
    ['greater', [0, 0, 1]],
    ['greater-or-equal', [0, 1, 1]],
    ['equal', [0, 1, 0]],
    ['unequal', [1, 0, 1]],
  ])('%s', async (relation, wanted) => {
    const found = await Promise.all([1, 2, 3].map((a) => outputs('compare', { relation, a, b: 2 })));
    expect(found).toEqual(wanted.map((number) => ({ number })));
  });
});

describe('utility nodes', () => {
  const house = makeObject({ path: '/House', mesh: box([1, 1, 1]) });
  const services: Services = {
    ...workerServices,
    readScene: async () => ({ scene: { ...makeScene({ name: 'a' }), objects: [house] } }),
  };
  const pictured = async (gamma: number) => {
    const document = edited(utilityProject(), set('number', 'number', gamma), set('text', 'text', ''));
    return evaluatedPicture(await new Evaluator(nodeLibrary).evaluate(document, 'output', services));
  };

  it('drive a picture', async () => {
    expect(validateDocument(utilityProject(), nodeLibrary)).toEqual([]);
    const fast = await pictured(1.25);
    expect(fast?.exposure).toBe(2);
    expect(fast?.fastest?.speed).toBeCloseTo(0.6 * 30, 9);
    const slow = await pictured(1.1);
    expect(slow?.exposure).toBe(0.25);
  });
});
