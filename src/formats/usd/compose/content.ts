import type { PrimSpec } from '../layer.ts';
import { type Place, timeOf } from './localValues.ts';

const NUMBERS = new WeakMap<object, number>();
let last = 0;

/** Tells objects apart. */
function numberOf(thing: object): number {
  const known = NUMBERS.get(thing) ?? ++last;
  NUMBERS.set(thing, known);
  return known;
}

/** What says where a prim is and what it wears, not what it is. */
const PLACING = /^(xformOp|visibility$|purpose$|material:binding|slowlight:)/;

/** They hold others, and are nothing themselves that could be shared. */
const HOLDERS = new Set(['Xform', 'Scope']);

/**
 * Names what a prim is made of: two prims with one name hold the same values, wherever they are. Opinions that only
 * place a prim do not count, so that instances of a mesh have one name. Undefined for what has no name to be asked for.
 */
export function contentOf(typeName: string, opinions: readonly (Place & { spec: PrimSpec })[]): string | undefined {
  if (HOLDERS.has(typeName)) return undefined;
  const parts = opinions.flatMap((opinion) => {
    const { spec, node } = opinion;
    if ([...spec.properties.keys()].every((name) => PLACING.test(name))) return [];
    const { offset, scale } = timeOf(opinion);
    return [`${numberOf(spec)}/${numberOf(node.stack)}@${offset}*${scale}`];
  });
  return [typeName, ...parts].join(' ');
}
