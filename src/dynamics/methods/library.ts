import { discreteGradient, implicitMidpoint } from './implicit.ts';
import type { IntegrationMethod } from './method.ts';
import { leapfrog, yoshida4, yoshida6, yoshida8 } from './splitting.ts';
import { linearlyImplicit, localGlobal, semiImplicitEuler } from './velocityMethods.ts';

const CORRECTIONS = [0, 1, 2, 3] as const;

/**
 * All methods by id; those of the source documents with the number of their correction (`local-global-2`).
 * @example
 * METHODS.get('leapfrog')!.order; // 2
 */
export const METHODS: ReadonlyMap<string, IntegrationMethod> = new Map(
  [
    discreteGradient,
    implicitMidpoint,
    leapfrog,
    yoshida4,
    yoshida6,
    yoshida8,
    ...[semiImplicitEuler, linearlyImplicit, localGlobal].flatMap((family) => CORRECTIONS.map(family)),
  ].map((method) => [method.id, method]),
);
