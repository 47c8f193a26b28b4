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
  const written = new Map<string, string>();
  for (const { source: layer } of layers) {
    const relocates = layer.layer.metadata.get('relocates');
    if (relocates?.type !== 'relocates') continue;
    for (const [source, target] of relocates.data) if (!written.has(source)) written.set(source, target);
  }
  const bySource = new Map(written);
  for (const [source, target] of written) {
    const fault = faultOf(source, target) ?? conflictOf(source, target, written);
    if (!fault) continue;
    note('usd.relocates', '', `the relocate of ${source} to ${target}: ${fault}; it is left out`);
    bySource.delete(source);
  }
  const byTarget = new Map([...bySource].flatMap(([from, to]) => (to === '' ? [] : [[to, from] as const])));
  return bySource.size === 0 ? undefined : { bySource, byTarget, whole: wholeMoves(bySource) };
}

function faultOf(source: string, target: string): string | undefined {
  if (!isPrimPath(source) || (target !== '' && !isPrimPath(target))) return 'it is not from prim to prim';
  if (depthOf(source) < 2 || depthOf(target) === 1) return 'root prims cannot be moved';
  if (target !== '' && (hasPrefix(target, source) || hasPrefix(source, target))) return 'one of them is in the other';
  return undefined;
}

/** Relocates are in the namespace that all of them make: none may lead to or from where another one starts. */
function conflictOf(source: string, target: string, all: ReadonlyMap<string, string>): string | undefined {
  for (const [from, to] of all) {
    if (from === source) continue;
    if (to !== '' && to === target) return `${from} goes there as well`;
    if (to === source) return `${from} goes to ${source}`;
    if (target !== '' && hasPrefix(target, from)) return `${from} is moved away`;
    if (hasPrefix(source, from)) return `${from}, around it, is moved away`;
  }
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
