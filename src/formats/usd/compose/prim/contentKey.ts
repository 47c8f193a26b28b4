import type { PrimSpec } from '../../layer/layer.ts';
import { layerToStageTime, type OpinionSource } from './stageValues.ts';

const OBJECT_IDS = new WeakMap<object, number>();
let lastId = 0;

/** Tells objects apart. */
function objectId(thing: object): number {
  const known = OBJECT_IDS.get(thing) ?? ++lastId;
  OBJECT_IDS.set(thing, known);
  return known;
}

/** What says where a prim is and what it wears, not what it is. */
const PLACEMENT_PROPERTIES = /^(xformOp|visibility$|purpose$|material:binding|slowlight:)/;

/** They hold others, and are nothing themselves that could be shared. */
const GROUP_TYPES = new Set(['Xform', 'Scope']);

/**
 * Names what a prim is made of: two prims with one name hold the same values, wherever they are. Opinions that only
 * place a prim do not count, so that instances of a mesh have one name. Undefined for what has no name to be asked for.
 */
export function contentKeyOf(
  typeName: string,
  opinions: readonly (OpinionSource & { spec: PrimSpec })[],
): string | undefined {
  if (GROUP_TYPES.has(typeName)) return undefined;
  const parts = opinions.flatMap((opinion) => {
    const { spec, node } = opinion;
    if ([...spec.properties.keys()].every((name) => PLACEMENT_PROPERTIES.test(name))) return [];
    const { offset, scale } = layerToStageTime(opinion);
    return [`${objectId(spec)}/${objectId(node.stack)}@${offset}*${scale}`];
  });
  return [typeName, ...parts].join(' ');
}
