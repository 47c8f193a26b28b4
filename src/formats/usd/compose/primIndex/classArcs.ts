import { msg } from '../../../../messages/message.ts';
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
import { ARC_NAMES, hasClasses, type PrimIndexNode } from './primIndexNode.ts';
import { mapForArc } from './referenceArcs.ts';

type ClassKind = 'inherit' | 'specialize';

/** Follows the inherits or the specializes that a site has. */
export function addClassArcs(builder: PrimIndexBuilder, node: PrimIndexNode, kind: ClassKind): void {
  const paths = classesAt(node.opinions, kind === 'inherit' ? 'inherits' : 'specializes');
  paths.forEach((path, number) => {
    if (isPrimPath(path)) addClassArc(builder, kind, node, undefined, withRoot(mapForArc(node, path)), number);
    else
      builder.report(
        'usd.class-path',
        msg`it ${ARC_NAMES[kind]}s ${path}, which is not the path of a prim; that is left out`,
      );
  });
}

/** Adds a class below a node, or returns the existing one. Undefined if the path does not map. */
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
  // An implied class can be the very same site: kept inert, to be implied further.
  const contributes = path !== parent.path && !origin?.isSite(parent.stack, path);
  const arc = { kind, origin, map, number, depth: parent.depth };
  const ancestral = contributes && depthOf(path) > 1;
  return builder.addArc(parent, parent.stack, path, arc, { contributes, ancestral, skipsDuplicates: contributes });
}

/** Path of the class in the site's namespace, with the site's variants. */
function classPath(site: string, map: NamespaceMap): string | undefined {
  const path = mapToSource(map, stripVariants(site));
  if (path === undefined || !site.includes('{')) return path;
  let inVariant = site;
  while (!inVariant.endsWith('}')) inVariant = parentOf(inVariant);
  const plain = stripVariants(inVariant);
  return hasPrefix(path, plain) ? inVariant + path.slice(plain.length) : path;
}

/**
 * Classes of a referenced prim can be overridden in the referencing layers: the classes below a node are implied
 * below its parent, in the parent's namespace.
 */
export function implyClassArcs(builder: PrimIndexBuilder, node: PrimIndexNode): void {
  if (!node.parent || !hasClasses(node)) return;
  // Classes may be outside the arc's namespace: they keep their path.
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
    // The next class of one hierarchy belongs below `from`, not beside it.
    if (isStart && from.isClass && from.depthBelowArc === child.depthBelowArc) continue;
    // Maps with relocates can be long, and two are composed here.
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

/** The node that a class hierarchy starts from, including the hierarchies of ancestors: they are implied as a unit. */
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
