import { msg } from '../../../../messages/message.ts';
import { messageOf } from '../../../../messages/messageError.ts';
import { depthOf, isPrimPath, stripVariants } from '../../layer/primPaths.ts';
import { metadataText } from '../../layer/query.ts';
import { expandExpression } from '../layers/expressions.ts';
import type { LayerStack } from '../layers/layerStack.ts';
import { isLayerError, type LoadedLayer } from '../layers/layerStore.ts';
import { referencesAt, type SourcedReference } from '../layers/siteOpinions.ts';
import { composeOffsets, isInvertible, NO_OFFSET, type TimeOffset } from '../layers/timeOffset.ts';
import { arcMap, composeMaps, type NamespaceMap, withPairs, withRoot } from './namespaceMap.ts';
import type { PrimIndexBuilder } from './primIndexBuilder.ts';
import { ARC_NAMES, type PrimIndexNode } from './primIndexNode.ts';

type ReferenceType = 'reference' | 'payload';

/** Follows the references or the payloads that a site has. */
export function addReferenceArcs(builder: PrimIndexBuilder, node: PrimIndexNode, kind: ReferenceType): void {
  const arcs = referencesAt(node.opinions, kind === 'reference' ? 'references' : 'payload');
  arcs.forEach((arc, number) => {
    const target = targetOf(builder, node, kind, arc);
    if (!target) return;
    const { stack, path, time } = target;
    const map = mapForArc(node, path, time);
    // Internal references map the whole namespace.
    const whole = arc.asset === '' ? withRoot(map) : map;
    const written = { kind, map: whole, number, depth: node.depth };
    const added = builder.addArc(node, stack, path, written, { ancestral: depthOf(path) > 1 });
    if (added)
      builder.expectOpinions(
        added,
        msg`its ${ARC_NAMES[kind]} ${describe(arc)} leads to ${path}, which ${stack.root.id} does not have`,
      );
  });
}

interface ReferenceTarget {
  readonly stack: LayerStack;
  readonly path: string;
  readonly time: TimeOffset;
}

function targetOf(
  builder: PrimIndexBuilder,
  node: PrimIndexNode,
  kind: ReferenceType,
  arc: SourcedReference,
): ReferenceTarget | undefined {
  const root = arc.asset === '' ? node.stack.root : layerOf(builder, kind, arc);
  if (!root) return undefined;
  const path = arc.path === '' ? defaultPrim(root) : arc.path;
  if (path === undefined || !isPrimPath(path)) {
    const why = path === undefined ? msg`${root.id} has no defaultPrim` : msg`${path} is not the path of a prim`;
    builder.report('usd.default-prim', msg`its ${ARC_NAMES[kind]} ${describe(arc)} is left out: ${why}`);
    return undefined;
  }
  const stack =
    arc.asset === '' ? node.stack : builder.context.stacks.getOrBuild(root, undefined, node.stack.variables);
  return { stack, path, time: referenceTimeOffset(builder, kind, arc, arc.asset === '' ? undefined : root) };
}

function layerOf(builder: PrimIndexBuilder, kind: ReferenceType, arc: SourcedReference): LoadedLayer | undefined {
  const asset = assetOf(builder, kind, arc);
  if (asset === '') return undefined;
  const found = builder.context.store.find(arc.from.source.id, asset);
  if (!found || !isLayerError(found)) return found;
  builder.report(
    found.code,
    kind === 'reference' ? msg`its reference ${found.message}` : msg`its payload ${found.message}`,
    found.missing,
  );
  return undefined;
}

/** The asset path, with expressions evaluated; empty on error. */
function assetOf(builder: PrimIndexBuilder, kind: ReferenceType, { asset, from }: SourcedReference): string {
  try {
    return expandExpression(asset, from.variables);
  } catch (thrown) {
    builder.report('usd.expression', msg`its ${ARC_NAMES[kind]} @${asset}@ is left out: ${messageOf(thrown)}`);
    return '';
  }
}

/**
 * Time offset from the target to the referencing stack, scaled by their time codes per second. For internal
 * references the offset of the authoring layer does not count: the target's layers have it.
 */
function referenceTimeOffset(
  builder: PrimIndexBuilder,
  kind: ReferenceType,
  arc: SourcedReference,
  target: LoadedLayer | undefined,
): TimeOffset {
  const { from } = arc;
  const usable = isInvertible(arc);
  if (!usable)
    builder.report(
      'usd.layer-offset',
      msg`its ${ARC_NAMES[kind]} ${describe(arc)} has the offset ${arc.offset} and the scale ${arc.scale}, which are no times; they are left out`,
    );
  const written = usable ? { offset: arc.offset, scale: arc.scale } : NO_OFFSET;
  if (!target) return written;
  const own = composeOffsets(from.time, written);
  return { offset: own.offset, scale: (own.scale * from.source.codesPerSecond) / target.codesPerSecond };
}

/** The default prim's name, or since OpenUSD 25 its path. */
function defaultPrim({ layer }: LoadedLayer): string | undefined {
  const name = metadataText(layer.metadata, 'defaultPrim');
  if (!name) return undefined;
  return name.startsWith('/') ? name : `/${name}`;
}

const describe = ({ asset, path }: SourcedReference): string =>
  `${asset ? `@${asset}@` : ''}${path ? `<${path}>` : ''}`;

/** Namespace map of an arc from its target to its node, with the node's relocates. */
export function mapForArc(node: PrimIndexNode, source: string, time: TimeOffset = NO_OFFSET): NamespaceMap {
  const target = stripVariants(node.path);
  const map = arcMap(source, target, time);
  const { relocates } = node.stack;
  if (!relocates) return map;
  const key = [source, target, time.offset, time.scale].join('\n');
  const known = relocates.mapsOfArcs.get(key);
  if (known) return known;
  const moves = [...relocates.resolved].filter(([from, to]) => to !== '' && from.startsWith(`${target}/`));
  const moved = composeMaps(withPairs(withRoot(arcMap('', '', NO_OFFSET)), moves), map);
  relocates.mapsOfArcs.set(key, moved);
  return moved;
}
