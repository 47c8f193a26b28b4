import type { PrimSpec } from '../../layer/layer.ts';
import { layerToStageTime, type OpinionSource } from './stageValues.ts';

const OBJECT_IDS = new WeakMap<object, number>();
let lastId = 0;

/** A unique id per object. */
function objectId(thing: object): number {
  const known = OBJECT_IDS.get(thing) ?? ++lastId;
  OBJECT_IDS.set(thing, known);
  return known;
}

/** Properties of placement and binding, not of content. */
const PLACEMENT_PROPERTIES = /^(xformOp|visibility$|purpose$|material:binding|slowlight:)/;

/** Grouping types without shareable content. */
const GROUP_TYPES = new Set(['Xform', 'Scope']);

/**
 * Key of a prim's content: equal keys mean equal values, wherever the prims are. Opinions that only place a prim do
 * not count, so that instances of a mesh share a key. Undefined for prims without content.
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
