import { type Message, msg } from '../../../../messages/message.ts';
import { depthOf, hasPrefix, isPrimPath, parentOf, someAncestor } from '../../layer/primPaths.ts';
import type { NamespaceMap } from '../primIndex/namespaceMap.ts';
import type { Relocates, ReportPrimIssue, StackLayer } from './layerStack.ts';

/** The relocates of a layer stack, the strongest layer's first; undefined where there are none. */
export function relocatesOf(layers: readonly StackLayer[], note: ReportPrimIssue): Relocates | undefined {
  const written = new Map<string, string>();
  for (const { source: layer } of layers) {
    const relocates = layer.layer.metadata.get('relocates');
    if (relocates?.type !== 'relocates') continue;
    for (const [source, target] of relocates.data) if (!written.has(source)) written.set(source, target);
  }
  const bySource = new Map(written);
  const comings = sourcesByTarget(written);
  for (const [source, target] of written) {
    const fault = relocateError(source, target) ?? relocateConflict(source, target, written, comings);
    if (!fault) continue;
    note('usd.relocates', '', msg`the relocate of ${source} to ${target}: ${fault}; it is left out`);
    bySource.delete(source);
  }
  const byTarget = new Map([...bySource].flatMap(([from, to]) => (to === '' ? [] : [[to, from] as const])));
  if (bySource.size === 0) return undefined;
  const mapsOfArcs = new Map<string, NamespaceMap>();
  return {
    bySource,
    byTarget,
    mapsOfArcs,
    byParent: movesByParent(bySource),
    resolved: resolvedMoves(bySource, byTarget),
  };
}

function movesByParent(bySource: ReadonlyMap<string, string>): Relocates['byParent'] {
  const out = new Map<string, (readonly [string, string])[]>();
  for (const move of bySource) {
    const [source, target] = move;
    for (const parent of new Set([parentOf(source), ...(target === '' ? [] : [parentOf(target)])])) {
      const moves = out.get(parent);
      if (moves) moves.push(move);
      else out.set(parent, [move]);
    }
  }
  return out;
}

/** The sources of each target. */
function sourcesByTarget(written: ReadonlyMap<string, string>): ReadonlyMap<string, readonly string[]> {
  const out = new Map<string, string[]>();
  for (const [source, target] of written) {
    const sources = out.get(target);
    if (sources) sources.push(source);
    else out.set(target, [source]);
  }
  return out;
}

function relocateError(source: string, target: string): Message | undefined {
  if (!isPrimPath(source) || (target !== '' && !isPrimPath(target))) return msg`it is not from prim to prim`;
  if (depthOf(source) < 2 || depthOf(target) === 1) return msg`root prims cannot be moved`;
  if (target !== '' && (hasPrefix(target, source) || hasPrefix(source, target)))
    return msg`one of them is in the other`;
  return undefined;
}

/** Conflicts between relocates: none may start or end at another's source. */
function relocateConflict(
  source: string,
  target: string,
  all: ReadonlyMap<string, string>,
  comings: ReadonlyMap<string, readonly string[]>,
): Message | undefined {
  const other = target !== '' && comings.get(target)?.find((from) => from !== source);
  if (other) return msg`${other} goes there as well`;
  const [before] = comings.get(source) ?? [];
  if (before !== undefined) return msg`${before} goes to ${source}`;
  const isMoved = (path: string): boolean => path !== source && all.has(path);
  if (someAncestor(target, isMoved)) return msg`what is around it is moved away`;
  return someAncestor(source, isMoved) ? msg`what is around the source is moved away` : undefined;
}

/** /A/B → /A/C and /A/C/D → /A/E: what is at /A/E was at /A/B/D. */
function resolvedMoves(
  bySource: ReadonlyMap<string, string>,
  byTarget: ReadonlyMap<string, string>,
): ReadonlyMap<string, string> {
  const whole = new Map<string, string>();
  for (const [source, target] of bySource) {
    let origin = source;
    const moveOnce = (around: string): boolean => {
      const before = byTarget.get(around);
      if (before !== undefined) origin = before + origin.slice(around.length);
      return before !== undefined;
    };
    for (let hop = 0; hop <= bySource.size && someAncestor(origin, moveOnce); hop++);
    whole.set(origin, target);
  }
  return whole;
}
