import type { Note, StackLayer } from './layerStack.ts';
import { depthOf, hasPrefix, isPrimPath } from './paths.ts';

/** How a layer stack moves the prims that its arcs bring, to other names or places. */
export interface Relocates {
  /** As written: where a prim is, and where it goes; '' where it is removed. */
  readonly bySource: ReadonlyMap<string, string>;
  readonly byTarget: ReadonlyMap<string, string>;
  /** With the moves of what is around a prim taken into account: where its specs are in the arcs' own namespace. */
  readonly whole: ReadonlyMap<string, string>;
}

/** The relocates of a layer stack, the strongest layer's first; undefined where there are none. */
export function relocatesOf(layers: readonly StackLayer[], note: Note): Relocates | undefined {
  const bySource = new Map<string, string>();
  const byTarget = new Map<string, string>();
  for (const { source: layer } of layers) {
    const written = layer.layer.metadata.get('relocates');
    if (written?.type !== 'relocates') continue;
    for (const [source, target] of written.data) {
      if (bySource.has(source)) continue;
      const fault = faultOf(source, target) ?? (byTarget.has(target) ? `${target} is taken by another` : undefined);
      if (fault) note('usd.relocates', '', `the relocate of ${source} to ${target}: ${fault}; it is left out`);
      else {
        bySource.set(source, target);
        if (target !== '') byTarget.set(target, source);
      }
    }
  }
  return bySource.size === 0 ? undefined : { bySource, byTarget, whole: wholeMoves(bySource) };
}

function faultOf(source: string, target: string): string | undefined {
  if (!isPrimPath(source) || (target !== '' && !isPrimPath(target))) return 'it is not from prim to prim';
  if (depthOf(source) < 2 || depthOf(target) === 1) return 'root prims cannot be moved';
  if (target !== '' && (hasPrefix(target, source) || hasPrefix(source, target))) return 'one of them is in the other';
  return undefined;
}

/** /A/B → /A/C and /A/C/D → /A/E: what is at /A/E was at /A/B/D. */
function wholeMoves(bySource: ReadonlyMap<string, string>): ReadonlyMap<string, string> {
  const whole = new Map<string, string>();
  for (const [source, target] of bySource) {
    let origin = source;
    for (let hop = 0; hop <= bySource.size; hop++) {
      const around = [...bySource].find(([, to]) => to !== '' && hasPrefix(origin, to));
      if (!around) break;
      origin = around[0] + origin.slice(around[1].length);
    }
    whole.set(origin, target);
  }
  return whole;
}
