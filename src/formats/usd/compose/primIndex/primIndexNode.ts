import { type Message, msg } from '../../../../messages/message.ts';
import { ancestorPath, depthOf, hasPrefix } from '../../layer/primPaths.ts';
import { type LayerStack, type Opinion, opinionsAt } from '../layers/layerStack.ts';
import { composeOffsets, NO_OFFSET, type TimeOffset } from '../layers/timeOffset.ts';
import { composeMaps, IDENTITY, type NamespaceMap } from './namespaceMap.ts';

/** Composition arcs, strongest first. */
export const ARCS = ['root', 'inherit', 'variant', 'relocate', 'reference', 'payload', 'specialize'] as const;
export type ArcType = (typeof ARCS)[number];

/** Arcs in messages. */
export const ARC_NAMES: Readonly<Record<Exclude<ArcType, 'root' | 'variant'>, Message>> = {
  inherit: msg`inherit`,
  relocate: msg`relocate`,
  reference: msg`reference`,
  payload: msg`payload`,
  specialize: msg`specialize`,
};

/** The arc from a node's parent to it. */
export interface CompositionArc {
  readonly kind: ArcType;
  /** Of an implied class or relocate: the node that implies it. Absent for authored arcs. */
  readonly origin?: PrimIndexNode | undefined;
  /** From the node's namespace to its parent's. */
  readonly map: NamespaceMap;
  /** Index among the arcs of its kind on one site. */
  readonly number: number;
  /** Namespace depth of the prim with the arc. */
  readonly depth: number;
}

/** An arc that adds a node. */
export type TargetArc = CompositionArc & { readonly kind: Exclude<ArcType, 'root'> };

const ROOT_ARC: CompositionArc = { kind: 'root', map: IDENTITY, number: 0, depth: 0 };

/**
 * A node of a prim index: a site (path in a layer stack) that may have opinions on the prim. The root is the prim's
 * own site, children are the targets of a site's arcs, strongest first.
 */
export class PrimIndexNode {
  readonly stack: LayerStack;
  readonly path: string;
  arc: CompositionArc = ROOT_ARC;
  parent: PrimIndexNode | undefined;
  readonly children: PrimIndexNode[] = [];
  /** Opinions of the stack's layers at the path, strongest first. */
  readonly opinions: readonly Opinion[];
  /** Kept only for its position in the tree: its opinions do not count. */
  isInert = false;
  /** The arc is on an ancestor prim. */
  isAncestral = false;
  /** Creation order; a node is younger than its parent. */
  serial = 0;
  /** Cached by `isInstance`, on the root of a complete index. */
  isInstanceCached: boolean | undefined;
  private cachedMapToRoot: NamespaceMap | undefined;
  private cachedTimeToRoot: TimeOffset | undefined;
  private cachedStrengthOrder: readonly PrimIndexNode[] | undefined;
  private cachedDepth: number | undefined;
  private cachedPathAtArc: string | undefined;

  constructor(stack: LayerStack, path: string, opinions: readonly Opinion[] = opinionsAt(stack, path)) {
    this.stack = stack;
    this.path = path;
    this.opinions = opinions;
  }

  get contributes(): boolean {
    return !this.isInert && this.opinions.length > 0;
  }

  /** Number of path elements. */
  get depth(): number {
    this.cachedDepth ??= depthOf(this.path);
    return this.cachedDepth;
  }

  get root(): PrimIndexNode {
    let node: PrimIndexNode = this;
    while (node.parent) node = node.parent;
    return node;
  }

  /** Levels of namespace between the prim that has the arc and this one. */
  get depthBelowArc(): number {
    return this.parent ? this.parent.depth - this.arc.depth : 0;
  }

  /** The arc's target path. */
  get pathAtArc(): string {
    this.cachedPathAtArc ??= ancestorPath(this.path, this.depthBelowArc);
    return this.cachedPathAtArc;
  }

  /** The arc is on this prim itself. */
  get isDirect(): boolean {
    return this.parent !== undefined && !this.isAncestral;
  }

  get isClass(): boolean {
    return this.arc.kind === 'inherit' || this.arc.kind === 'specialize';
  }

  get isImplied(): boolean {
    return this.isClass && this.arc.origin !== undefined;
  }

  /** From this node's namespace to that of the tree's root. */
  get mapToRoot(): NamespaceMap {
    this.cachedMapToRoot ??= this.parent ? composeMaps(this.parent.mapToRoot, this.arc.map) : IDENTITY;
    return this.cachedMapToRoot;
  }

  /** The time offset of `mapToRoot`, computed without paths: most opinions hold none. */
  get timeToRoot(): TimeOffset {
    this.cachedTimeToRoot ??= this.parent ? composeOffsets(this.parent.timeToRoot, this.arc.map.time) : NO_OFFSET;
    return this.cachedTimeToRoot;
  }

  isSite(stack: LayerStack, path: string): boolean {
    return this.stack === stack && this.path === path;
  }

  /** Inserts a subtree by strength. */
  insertChild(child: PrimIndexNode, arc: CompositionArc): void {
    child.arc = arc;
    child.parent = this;
    clearTreeCaches(child);
    const { children } = this;
    let [from, to] = [0, children.length];
    while (from < to) {
      const middle = (from + to) >> 1;
      if (compareSiblings(child, children[middle]) < 0) to = middle;
      else from = middle + 1;
    }
    children.splice(from, 0, child);
  }

  /**
   * The index of a child prim before its own arcs. Sites without opinions on the parent and without arcs are dropped.
   * In an instance only its own arcs count.
   */
  childIndex(name: string, isInInstance: boolean): PrimIndexNode {
    const origins = originsIn(this);
    const copy = (node: PrimIndexNode, isLocal: boolean): PrimIndexNode | undefined => {
      const child = node.childNode(name);
      const local = isLocal && !node.isDirect;
      if (local) child.isInert = true;
      for (const old of node.children) {
        const below = copy(old, local);
        if (!below) continue;
        below.parent = child;
        child.children.push(below);
      }
      // Decided by the parent's opinions: where a variant ends here, selections made in it still count.
      const needed =
        node.opinions.length > 0 ||
        child.children.length > 0 ||
        origins?.has(node) ||
        node.stack.relocates ||
        !node.isAncestral;
      if (!needed) return undefined;
      if (origins?.has(node)) origins.set(node, child);
      // Relocated away by the site's own layers.
      if (node.parent && child.stack.relocates?.bySource.has(child.path)) makeInert(child);
      return child;
    };
    const root = copy(this, isInInstance)!;
    if (!origins) return root;
    for (const node of allNodes(root)) {
      const { origin } = node.arc;
      if (origin) node.arc = { ...node.arc, origin: origins.get(origin) };
    }
    return root;
  }

  private childNode(name: string): PrimIndexNode {
    const opinions: Opinion[] = [];
    for (const { spec, from } of this.opinions) {
      const child = spec.children.get(name);
      if (child) opinions.push({ spec: child, from });
    }
    const child = new PrimIndexNode(this.stack, `${this.path}/${name}`, opinions);
    child.arc = this.arc;
    child.isInert = this.isInert;
    child.isAncestral = this.parent !== undefined;
    child.serial = this.serial;
    child.cachedMapToRoot = this.cachedMapToRoot;
    child.cachedTimeToRoot = this.cachedTimeToRoot;
    child.cachedDepth = this.depth + 1;
    child.cachedPathAtArc = this.cachedPathAtArc;
    return child;
  }

  static clearCaches(node: PrimIndexNode): void {
    node.cachedMapToRoot = undefined;
    node.cachedTimeToRoot = undefined;
    node.cachedPathAtArc = undefined;
  }

  /** `strengthOrder` of a complete index. */
  static strongestFirst(index: PrimIndexNode): readonly PrimIndexNode[] {
    index.cachedStrengthOrder ??= strengthOrder(index);
    return index.cachedStrengthOrder;
  }
}

/** Nodes that are the origin of implied arcs in the tree, to be mapped to their copies. */
function originsIn(
  tree: PrimIndexNode,
  found?: Map<PrimIndexNode, PrimIndexNode | undefined>,
): Map<PrimIndexNode, PrimIndexNode | undefined> | undefined {
  const { origin } = tree.arc;
  let origins = found;
  if (origin) origins = (origins ?? new Map<PrimIndexNode, PrimIndexNode | undefined>()).set(origin, undefined);
  for (const child of tree.children) origins = originsIn(child, origins);
  return origins;
}

/** Invalidates cached maps to the root. */
function clearTreeCaches(tree: PrimIndexNode): void {
  for (const node of allNodes(tree)) PrimIndexNode.clearCaches(node);
}

/** Whether any contributing opinion has a metadata key. */
export const hasMetadata = (index: PrimIndexNode, key: string): boolean =>
  strongestFirst(index).some((node) => !node.isInert && node.opinions.some(({ spec }) => spec.metadata.has(key)));

export const hasOpinions = (node: PrimIndexNode): boolean =>
  node.opinions.length > 0 || node.children.some(hasOpinions);

/** Makes a subtree inert. */
export function makeInert(tree: PrimIndexNode): void {
  for (const node of allNodes(tree)) node.isInert = true;
}

export const hasClasses = (node: PrimIndexNode): boolean => node.children.some((child) => child.isClass);

/** All nodes of a tree in pre-order. */
export function allNodes(node: PrimIndexNode, into: PrimIndexNode[] = []): PrimIndexNode[] {
  into.push(node);
  for (const child of node.children) allNodes(child, into);
  return into;
}

/** Negative if `a` is stronger: by arc kind, namespace depth, origin, and index among arcs of one site. */
function compareSiblings(a: PrimIndexNode, b: PrimIndexNode): number {
  if (a.arc.kind !== b.arc.kind) return ARCS.indexOf(a.arc.kind) - ARCS.indexOf(b.arc.kind);
  if (a.arc.depth !== b.arc.depth) return b.arc.depth - a.arc.depth;
  const [from, other] = [a.arc.origin ?? a.parent!, b.arc.origin ?? b.parent!];
  if (from !== other) return compareInTree(a, from, other);
  return a.arc.number - b.arc.number;
}

/** Negative if `a` comes first in the tree of `within`; nodes of other trees come last. */
function compareInTree(within: PrimIndexNode, a: PrimIndexNode, b: PrimIndexNode): number {
  const [wayToA, wayToB] = [pathFromRoot(a), pathFromRoot(b)];
  const { root } = within;
  if (wayToA[0] !== root || wayToB[0] !== root) return Number(wayToA[0] !== root) - Number(wayToB[0] !== root);
  let fork = 1;
  while (wayToA[fork] && wayToA[fork] === wayToB[fork]) fork++;
  const { children } = wayToA[fork - 1];
  return (wayToA[fork] ? children.indexOf(wayToA[fork]) : -1) - (wayToB[fork] ? children.indexOf(wayToB[fork]) : -1);
}

/** The path of nodes from the root. */
function pathFromRoot(node: PrimIndexNode): PrimIndexNode[] {
  const way: PrimIndexNode[] = [];
  for (let at: PrimIndexNode | undefined = node; at; at = at.parent) way.push(at);
  return way.reverse();
}

/** The nodes in strength order: pre-order, but specializes after everything else (a base is weaker than any opinion on what specializes it). */
export function strengthOrder(root: PrimIndexNode): PrimIndexNode[] {
  const out: PrimIndexNode[] = [];
  const bases: PrimIndexNode[] = [];
  const visit = (node: PrimIndexNode): void => {
    out.push(node);
    for (const child of node.children) {
      if (child.arc.kind === 'specialize') bases.push(child);
      else visit(child);
    }
  };
  visit(root);
  if (bases.length === 0) return out;
  const places = new Map(allNodes(root.root).map((node, place) => [node, place]));
  while (bases.length > 0) {
    // Bases below a base join the queue, so that the strongest comes next.
    let first = 0;
    for (let i = 1; i < bases.length; i++) if (compareBases(bases[i], bases[first], places) < 0) first = i;
    visit(bases.splice(first, 1)[0]);
  }
  return out;
}

export const strongestFirst = PrimIndexNode.strongestFirst;

/** Negative if base `a` is stronger than base `b`; they may be anywhere in one tree. */
function compareBases(a: PrimIndexNode, b: PrimIndexNode, places: ReadonlyMap<PrimIndexNode, number>): number {
  const [originOfA, stepsOfA] = authoredArc(a);
  const [originOfB, stepsOfB] = authoredArc(b);
  if (originOfA === originOfB) return stepsOfB - stepsOfA;
  if (isDescendantOf(originOfA, originOfB)) return 1;
  if (isDescendantOf(originOfB, originOfA)) return -1;
  const depths = depthInStage(b) - depthInStage(a);
  return depths !== 0 ? depths : (places.get(originOfA) ?? 0) - (places.get(originOfB) ?? 0);
}

/** The node of the authored arc, and how many times it was implied. */
function authoredArc(node: PrimIndexNode): readonly [PrimIndexNode, number] {
  let at = node;
  let steps = 0;
  while (at.isImplied && at.arc.origin) {
    at = at.arc.origin;
    steps++;
  }
  return [at, steps];
}

function isDescendantOf(node: PrimIndexNode, above: PrimIndexNode): boolean {
  for (let at = node.parent; at; at = at.parent) if (at === above) return true;
  return false;
}

/** Namespace depth of the stage prim at which the arc applies. */
const depthInStage = (node: PrimIndexNode): number => node.root.depth - node.depthBelowArc;

/** Whether one path is a prefix of the other. */
export const areNestedPaths = (a: string, b: string): boolean => hasPrefix(a, b) || hasPrefix(b, a);
