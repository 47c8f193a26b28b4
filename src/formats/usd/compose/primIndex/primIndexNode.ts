import { ancestorPath, depthOf, hasPrefix } from '../../layer/primPaths.ts';
import { type LayerStack, type Opinion, opinionsAt } from '../layers/layerStack.ts';
import { composeOffsets, NO_OFFSET, type TimeOffset } from '../layers/timeOffset.ts';
import { composeMaps, IDENTITY, type NamespaceMap } from './namespaceMap.ts';

/** The arcs of composition, the strongest first. */
export const ARCS = ['root', 'inherit', 'variant', 'relocate', 'reference', 'payload', 'specialize'] as const;
export type ArcType = (typeof ARCS)[number];

/** How a node comes to be under another. */
export interface CompositionArc {
  readonly kind: ArcType;
  /** Of a class or relocate that is implied: the node that it is implied by. Absent where the parent has the arc itself. */
  readonly origin?: PrimIndexNode | undefined;
  /** From the node's namespace to its parent's. */
  readonly map: NamespaceMap;
  /** Place among the arcs of its kind that are written together. */
  readonly number: number;
  /** How deep in namespace the prim is that has the arc. */
  readonly depth: number;
}

const ROOT_ARC: CompositionArc = { kind: 'root', map: IDENTITY, number: 0, depth: 0 };

/**
 * A site that has, or may have, opinions on a prim: a path in a layer stack. The nodes of a prim are a tree: its own
 * site, and under each site those that its arcs lead to, the stronger first.
 */
export class PrimIndexNode {
  readonly stack: LayerStack;
  readonly path: string;
  arc: CompositionArc = ROOT_ARC;
  parent: PrimIndexNode | undefined;
  readonly children: PrimIndexNode[] = [];
  /** What the stack's layers say at the path, strongest first. */
  readonly opinions: readonly Opinion[];
  /** Kept for its place in the tree only: its opinions do not count. */
  isInert = false;
  /** The arc is not on this prim but on one above. */
  isAncestral = false;
  /** When it was made; of two nodes in one tree, what is under the other is younger. */
  serial = 0;
  /** Of a complete index's root, once it is asked: whether it is an instance. */
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

  /** The number of names in its path. */
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

  /** Where the arc led. */
  get pathAtArc(): string {
    this.cachedPathAtArc ??= ancestorPath(this.path, this.depthBelowArc);
    return this.cachedPathAtArc;
  }

  /** The arc is on this very prim. */
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

  /** The times of `mapToRoot`, made without its paths: values need no more, and most opinions hold no paths. */
  get timeToRoot(): TimeOffset {
    this.cachedTimeToRoot ??= this.parent ? composeOffsets(this.parent.timeToRoot, this.arc.map.time) : NO_OFFSET;
    return this.cachedTimeToRoot;
  }

  isSite(stack: LayerStack, path: string): boolean {
    return this.stack === stack && this.path === path;
  }

  /** Puts a tree under this node, in its place by strength. */
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
   * The same tree one level down in namespace. Sites that nobody spoke at above this, and no arc starts from, are left out. In an
   * instance nothing counts but what its own arcs lead to.
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
      // Judged by the level above: where a variant ends here, what was selected by it still counts here.
      const needed =
        node.opinions.length > 0 ||
        child.children.length > 0 ||
        origins?.has(node) ||
        node.stack.relocates ||
        !node.isAncestral;
      if (!needed) return undefined;
      if (origins?.has(node)) origins.set(node, child);
      // What the site's own layers move away is elsewhere.
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

/** The nodes of a tree that others in it are implied by; what stands for each is still to be said. */
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

/** What is known of the way to the tree's root is another one's now. */
function clearTreeCaches(tree: PrimIndexNode): void {
  for (const node of allNodes(tree)) PrimIndexNode.clearCaches(node);
}

/** Whether any opinion that counts has the metadata of a key. */
export const hasMetadata = (index: PrimIndexNode, key: string): boolean =>
  strongestFirst(index).some((node) => !node.isInert && node.opinions.some(({ spec }) => spec.metadata.has(key)));

export const hasOpinions = (node: PrimIndexNode): boolean =>
  node.opinions.length > 0 || node.children.some(hasOpinions);

/** Keeps a tree for its place only. */
export function makeInert(tree: PrimIndexNode): void {
  for (const node of allNodes(tree)) node.isInert = true;
}

export const hasClasses = (node: PrimIndexNode): boolean => node.children.some((child) => child.isClass);

/** All nodes of a tree, each before those under it. */
export function allNodes(node: PrimIndexNode, into: PrimIndexNode[] = []): PrimIndexNode[] {
  into.push(node);
  for (const child of node.children) allNodes(child, into);
  return into;
}

/** Below 0 where `a` is stronger: by kind of arc, depth of what has it, origin, and place among those written. */
function compareSiblings(a: PrimIndexNode, b: PrimIndexNode): number {
  if (a.arc.kind !== b.arc.kind) return ARCS.indexOf(a.arc.kind) - ARCS.indexOf(b.arc.kind);
  if (a.arc.depth !== b.arc.depth) return b.arc.depth - a.arc.depth;
  const [from, other] = [a.arc.origin ?? a.parent!, b.arc.origin ?? b.parent!];
  if (from !== other) return compareInTree(a, from, other);
  return a.arc.number - b.arc.number;
}

/** Below 0 where `a` comes first in the tree that `within` is in; what is not in it comes last. */
function compareInTree(within: PrimIndexNode, a: PrimIndexNode, b: PrimIndexNode): number {
  const [wayToA, wayToB] = [pathFromRoot(a), pathFromRoot(b)];
  const { root } = within;
  if (wayToA[0] !== root || wayToB[0] !== root) return Number(wayToA[0] !== root) - Number(wayToB[0] !== root);
  let fork = 1;
  while (wayToA[fork] && wayToA[fork] === wayToB[fork]) fork++;
  const { children } = wayToA[fork - 1];
  return (wayToA[fork] ? children.indexOf(wayToA[fork]) : -1) - (wayToB[fork] ? children.indexOf(wayToB[fork]) : -1);
}

/** The nodes from the root to one. */
function pathFromRoot(node: PrimIndexNode): PrimIndexNode[] {
  const way: PrimIndexNode[] = [];
  for (let at: PrimIndexNode | undefined = node; at; at = at.parent) way.push(at);
  return way.reverse();
}

/**
 * The nodes of a tree from the strongest to the weakest: each before those under it, but all that is specialized after
 * everything else (what a base says is weaker than what anybody says about what specializes it).
 */
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
    // Those under a base join the rest, so that each time the strongest of all goes first.
    let first = 0;
    for (let i = 1; i < bases.length; i++) if (compareBases(bases[i], bases[first], places) < 0) first = i;
    visit(bases.splice(first, 1)[0]);
  }
  return out;
}

export const strongestFirst = PrimIndexNode.strongestFirst;

/** Below 0 where the base `a` is stronger than the base `b`; they may be anywhere in one tree. */
function compareBases(a: PrimIndexNode, b: PrimIndexNode, places: ReadonlyMap<PrimIndexNode, number>): number {
  const [originOfA, stepsOfA] = authoredArc(a);
  const [originOfB, stepsOfB] = authoredArc(b);
  if (originOfA === originOfB) return stepsOfB - stepsOfA;
  if (isDescendantOf(originOfA, originOfB)) return 1;
  if (isDescendantOf(originOfB, originOfA)) return -1;
  const depths = depthInStage(b) - depthInStage(a);
  return depths !== 0 ? depths : (places.get(originOfA) ?? 0) - (places.get(originOfB) ?? 0);
}

/** The node of the arc as it is written, and how many times it was implied since. */
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

/** How deep the prim of the stage is where the arc counts first. */
const depthInStage = (node: PrimIndexNode): number => node.root.depth - node.depthBelowArc;

/** Whether two paths are one, or one of them is in the other. */
export const areNestedPaths = (a: string, b: string): boolean => hasPrefix(a, b) || hasPrefix(b, a);
