import { depthOf, hasPrefix, isPrimPath, parentOf, stripVariants } from '../../layer/primPaths.ts';
import { classesAt } from '../layers/siteOpinions.ts';
import { STEP_COSTS } from './compositionBudget.ts';
import {
  composeMaps,
  inverseMap,
  isIdentity,
  mapToSource,
  type NamespaceMap,
  sameMaps,
  withRoot,
} from './namespaceMap.ts';
import type { PrimIndexBuilder } from './primIndexBuilder.ts';
import { hasClasses, type PrimIndexNode } from './primIndexNode.ts';
import { mapForArc } from './referenceArcs.ts';

type ClassKind = 'inherit' | 'specialize';

/** Follows the inherits or the specializes that a site has. */
export function addClassArcs(builder: PrimIndexBuilder, node: PrimIndexNode, kind: ClassKind): void {
  const paths = classesAt(node.opinions, kind === 'inherit' ? 'inherits' : 'specializes');
  paths.forEach((path, number) => {
    if (isPrimPath(path)) addClassArc(builder, kind, node, undefined, withRoot(mapForArc(node, path)), number);
    else builder.report('usd.class-path', `it ${kind}s ${path}, which is not the path of a prim; that is left out`);
  });
}

/** Adds a class below a node, or finds it there. Undefined where the arc has no meaning in the node's namespace. */
function addClassArc(
  builder: PrimIndexBuilder,
  kind: ClassKind,
  parent: PrimIndexNode,
  origin: PrimIndexNode | undefined,
  map: NamespaceMap,
  number: number,
): PrimIndexNode | undefined {
  const path = classPath(parent.path, map);
  if (path === undefined) return undefined;
  builder.work.spend(parent.children.length);
  const known = parent.children.find((child) => child.isSite(parent.stack, path));
  if (known) return known;
  // Implied from one node of a layer stack to another it can be the very same site: kept only to be implied further.
  const contributes = path !== parent.path && !origin?.isSite(parent.stack, path);
  const arc = { kind, origin, map, number, depth: parent.depth };
  const ancestral = contributes && depthOf(path) > 1;
  return builder.addArc(parent, parent.stack, path, arc, { contributes, ancestral, skipsDuplicates: contributes });
}

/** Where the class is, as seen from a site; the site's variants are kept. */
function classPath(site: string, map: NamespaceMap): string | undefined {
  const path = mapToSource(map, stripVariants(site));
  if (path === undefined || !site.includes('{')) return path;
  let inVariant = site;
  while (!inVariant.endsWith('}')) inVariant = parentOf(inVariant);
  const plain = stripVariants(inVariant);
  return hasPrefix(path, plain) ? inVariant + path.slice(plain.length) : path;
}

/**
 * A class that what is referred to has can be overridden where it is referred from: the classes under a node are
 * implied under its parent, in the parent's namespace.
 */
export function implyClassArcs(builder: PrimIndexBuilder, node: PrimIndexNode): void {
  if (!node.parent || !hasClasses(node)) return;
  // Classes can be outside of what the arc maps: they are in the same place on both sides.
  implyClassTree(builder, node.parent, node, withRoot(node.arc.map), true);
}

function implyClassTree(
  builder: PrimIndexBuilder,
  to: PrimIndexNode,
  from: PrimIndexNode,
  transfer: NamespaceMap,
  isStart: boolean,
): void {
  if (to.arc.kind === 'relocate' && to.parent) {
    implyClassTree(builder, to.parent, from, composeMaps(withRoot(to.arc.map), transfer), isStart);
    builder.tasks.add({ kind: 'impliedClasses', node: to });
    return;
  }
  for (const child of [...from.children]) {
    if (!child.isClass) continue;
    // The next class in one chain of classes: it belongs under `from`, not beside it.
    if (isStart && from.isClass && from.depthBelowArc === child.depthBelowArc) continue;
    // Relocates can make maps of any length, and two are composed with this one.
    builder.work.spend(2 * STEP_COSTS.item * transfer.pairs.length);
    const map = impliedMap(transfer, child.arc.map);
    const known = to.children.find((c) => c.arc.origin === child && sameMaps(c.arc.map, map));
    const implied = known ?? addClassArc(builder, child.arc.kind as ClassKind, to, child, map, child.arc.number);
    if (!implied || !hasClasses(child)) continue;
    const deeper = composeMaps(inverseMap(map), composeMaps(transfer, child.arc.map));
    implyClassTree(builder, implied, child, deeper, false);
  }
}

const impliedMap = (transfer: NamespaceMap, classMap: NamespaceMap): NamespaceMap =>
  isIdentity(transfer) ? classMap : withRoot(composeMaps(transfer, composeMaps(classMap, inverseMap(transfer))));

/** The node that a chain of classes starts from, with the chains that what is around it is in: they are implied as one. */
export function classHierarchyStart(node: PrimIndexNode): PrimIndexNode {
  let start = node;
  while (start.isClass) {
    const depth = start.depthBelowArc;
    let instance = start;
    let top = start;
    while (instance.isClass && instance.parent && instance.depthBelowArc === depth) {
      top = instance;
      instance = instance.parent;
    }
    start = instance;
    if (instance.isClass && hasPrefix(top.path, instance.pathAtArc)) break;
  }
  return start;
}
