import { type Message, msg } from '../../../../messages/message.ts';
import type { MissingFile } from '../../../../scene/types.ts';
import type { DiagnosticCode } from '../../../diagnostics/diagnosticCodes.ts';
import { nameOf, parentOf, someAncestor } from '../../layer/primPaths.ts';
import type { LayerStack } from '../layers/layerStack.ts';
import { addClassArcs, classHierarchyStart, implyClassArcs } from './classArcs.ts';
import { type CompositionBudget, STEP_COSTS } from './compositionBudget.ts';
import { isInstance } from './instances.ts';
import type { ArcOptions, CompositionContext, IndexStackFrame, PrimIndexBuilder } from './primIndexBuilder.ts';
import {
  ARC_NAMES,
  allNodes,
  areNestedPaths,
  hasClasses,
  hasOpinions,
  makeInert,
  PrimIndexNode,
  type TargetArc,
} from './primIndexNode.ts';
import { addReferenceArcs } from './referenceArcs.ts';
import { addRelocateArc, implyRelocateArc } from './relocateArcs.ts';
import { type IndexTask, type IndexTaskKind, TaskList } from './tasks.ts';
import { addVariantArc, addVariantSets } from './variantArcs.ts';

/** What a nested index is built for. */
interface IndexerOrigin {
  readonly from: PrimIndexer;
  /** The index is that of the parent prim of the one that `from` builds; otherwise of an arc's target. */
  readonly isParent: boolean;
  readonly frame: IndexStackFrame | undefined;
}

/** Maximum depth of nested indexes. */
const MAX_NESTED_INDEXES = 100;
/** Maximum number of sites of one prim. */
export const MAX_NODES = 4000;

/**
 * Finds all sites that have opinions on one prim and orders them by strength: local, inherits, variants, relocates,
 * references, payloads, specializes (LIVERPS; OpenUSD glossary, "LIVERPS Strength Ordering"). It starts from the parent
 * prim's index, whose arcs bring child prims, and follows the arcs of every site that it finds.
 */
export class PrimIndexer implements PrimIndexBuilder {
  readonly context: CompositionContext;
  readonly frame: IndexStackFrame | undefined;
  readonly ancestorDepth: number;
  readonly tasks: TaskList;
  root!: PrimIndexNode;
  private readonly evaluatesVariants: boolean;
  private readonly level: number;
  private readonly count: { nodes: number };
  /** The prim of the stage that all this is for. */
  private readonly path: string;
  private readonly expected: { target: PrimIndexNode; message: Message }[];

  private constructor(context: CompositionContext, path: string, origin?: IndexerOrigin, evaluatesVariants = true) {
    this.context = context;
    this.tasks = new TaskList(context.work);
    this.path = origin?.from.path ?? path;
    this.expected = origin?.from.expected ?? [];
    this.frame = origin?.frame;
    this.ancestorDepth = (origin?.from.ancestorDepth ?? 0) + (origin?.isParent ? 1 : 0);
    this.level = (origin?.from.level ?? 0) + 1;
    this.count = origin?.from.count ?? { nodes: 0 };
    this.evaluatesVariants = evaluatesVariants;
  }

  /** The index of a prim of the stage. `parent`: its parent's index, none for the pseudo-root. */
  static stagePrim(
    context: CompositionContext,
    stack: LayerStack,
    path: string,
    parent: PrimIndexNode | undefined,
  ): PrimIndexNode {
    const indexer = new PrimIndexer(context, path);
    indexer.root = parent ? indexer.childOf(parent, path) : new PrimIndexNode(stack, path);
    const index = indexer.run();
    for (const { target, message } of indexer.expected)
      if (!hasOpinions(target)) indexer.report('usd.unresolved-prim', message);
    return index;
  }

  /** The index of an arc's target with the arcs of its ancestors, variants not yet selected. */
  private targetIndex(stack: LayerStack, frame: IndexStackFrame, contributes: boolean): PrimIndexNode {
    const indexer = new PrimIndexer(this.context, frame.path, { from: this, isParent: false, frame }, false);
    return indexer.buildAt(stack, frame.path, contributes);
  }

  private buildAt(stack: LayerStack, path: string, contributes: boolean): PrimIndexNode {
    if (path === '' || path.endsWith('}') || this.isTooDeep(path)) this.root = new PrimIndexNode(stack, path);
    else {
      const origin = { from: this, isParent: true, frame: this.frame };
      const parent = new PrimIndexer(this.context, path, origin).buildAt(stack, parentOf(path), true);
      this.root = this.childOf(parent, path);
    }
    if (!contributes) this.root.isInert = true;
    return path === '' ? this.root : this.run();
  }

  private childOf(parent: PrimIndexNode, path: string): PrimIndexNode {
    return parent.childIndex(nameOf(path), isInstance(parent));
  }

  private isTooDeep(path: string): boolean {
    if (this.level <= MAX_NESTED_INDEXES) return false;
    this.report(
      'usd.too-deep',
      msg`arcs to ${path} are nested more than ${MAX_NESTED_INDEXES} deep; they are left out there`,
    );
    return true;
  }

  private run(): PrimIndexNode {
    const nodes = allNodes(this.root);
    for (const node of nodes) node.serial = this.count.nodes++;
    this.work.spend(STEP_COSTS.site * nodes.length);
    this.addArcTasks(this.root, true);
    for (let task = this.tasks.take(); task && !this.isOverBudget(); task = this.tasks.take()) this.perform(task);
    // Each base is compared with all others.
    this.work.spend(allNodes(this.root).filter(({ arc }) => arc.kind === 'specialize').length ** 2 * 2);
    return this.root;
  }

  get work(): CompositionBudget {
    return this.context.work;
  }

  private isOverBudget(): boolean {
    if (this.count.nodes > MAX_NODES)
      this.report('usd.too-many-arcs', msg`more than ${MAX_NODES} sites have opinions on it; the rest is left out`);
    return this.count.nodes > MAX_NODES || this.work.isExhausted;
  }

  private perform(task: IndexTask): void {
    const { node } = task;
    if (TASKS_FOR_INERT.has(task.kind) || !node.isInert) TASK_HANDLERS[task.kind](this, task);
  }

  report(code: DiagnosticCode, message: Message, missing?: MissingFile): void {
    this.context.note(code, this.path, message, missing);
  }

  expectOpinions(target: PrimIndexNode, message: Message): void {
    this.expected.push({ target, message });
  }

  addArc(
    parent: PrimIndexNode,
    stack: LayerStack,
    path: string,
    arc: TargetArc,
    options: ArcOptions = {},
  ): PrimIndexNode | undefined {
    if (arc.kind !== 'variant' && this.makesCycle(parent, stack, path)) {
      const message = msg`the ${ARC_NAMES[arc.kind]} of ${parent.path} in ${parent.stack.root.id} to ${path} leads back to where it comes from; it is left out`;
      this.report('usd.cycle', message);
      return undefined;
    }
    const skipsDuplicates = options.skipsDuplicates || (this.frame?.skipsDuplicates ?? false);
    if ((skipsDuplicates && this.hasSite(parent, stack, path)) || this.isOverBudget()) return undefined;
    this.work.spend(STEP_COSTS.site + STEP_COSTS.pair * arc.map.pairs.length);
    const ancestral = options.ancestral ?? false;
    const contributes = options.contributes ?? true;
    let node: PrimIndexNode;
    if (ancestral) {
      node = this.targetIndex(stack, { path, parent, arc, skipsDuplicates, outer: this }, contributes);
    } else {
      node = new PrimIndexNode(stack, path);
      node.isInert = !contributes;
      node.serial = this.count.nodes++;
    }
    if (arc.kind !== 'relocate' && isRelocatedAway(stack, path)) makeInert(node);
    node.isAncestral = false;
    parent.insertChild(node, arc);
    this.addTasks(node, !ancestral);
    return node;
  }

  /** Queues the tasks of a new node: its own arcs, unless its index has followed them, and what they imply. */
  private addTasks(node: PrimIndexNode, ownArcs: boolean): void {
    if (node.isClass) this.tasks.add({ kind: 'impliedClasses', node: classHierarchyStart(node) });
    else if (hasClasses(node)) this.tasks.add({ kind: 'impliedClasses', node });
    this.addArcTasks(node, ownArcs);
  }

  private addArcTasks(tree: PrimIndexNode, ownArcs: boolean): void {
    for (const node of allNodes(tree)) {
      if (ownArcs && node.stack.relocates) this.tasks.add({ kind: 'relocate', node });
      if (node.arc.kind === 'relocate') this.tasks.add({ kind: 'impliedRelocate', node });
      if (!node.contributes || node.opinions.every(({ spec }) => spec.metadata.size === 0)) continue;
      const written = (key: string): boolean => node.opinions.some(({ spec }) => spec.metadata.has(key));
      if (this.evaluatesVariants && written('variantSets')) this.tasks.add({ kind: 'variantSets', node });
      if (!ownArcs) continue;
      if (written('references')) this.tasks.add({ kind: 'references', node });
      if (written('payload')) this.tasks.add({ kind: 'payloads', node });
      if (written('inherits')) this.tasks.add({ kind: 'inherits', node });
      if (written('specializes')) this.tasks.add({ kind: 'specializes', node });
    }
  }

  /** Whether the target is, contains or is below a site on the path of arcs to it, through all nested indexes. */
  private makesCycle(parent: PrimIndexNode, stack: LayerStack, path: string): boolean {
    return this.someStackFrame(parent, path, (node, site) => {
      this.work.spend(1);
      for (let at: PrimIndexNode | undefined = node; at; at = at.parent)
        if (at.stack === stack && areNestedPaths(at.path, site)) return true;
      return false;
    });
  }

  private hasSite(parent: PrimIndexNode, stack: LayerStack, path: string): boolean {
    return this.someStackFrame(parent, path, (node, site) => {
      const others = allNodes(node.root);
      this.work.spend(others.length);
      return others.some((other) => other.isSite(stack, site));
    });
  }

  /** Calls `ask` for this index and the outer ones. In an ancestor's index, `site` is the path that the final index will have. */
  private someStackFrame(
    parent: PrimIndexNode,
    path: string,
    ask: (node: PrimIndexNode, site: string) => boolean,
  ): boolean {
    let site = path;
    let node = parent;
    for (let frame = this.frame; ; frame = frame.outer.frame) {
      if (ask(node, site)) return true;
      if (!frame) return false;
      site += frame.path.slice(node.root.path.length);
      node = frame.parent;
    }
  }
}

const TASK_HANDLERS: Readonly<Record<IndexTaskKind, (builder: PrimIndexBuilder, task: IndexTask) => void>> = {
  relocate: (builder, { node }) => addRelocateArc(builder, node),
  impliedRelocate: (builder, { node }) => implyRelocateArc(builder, node),
  references: (builder, { node }) => addReferenceArcs(builder, node, 'reference'),
  payloads: (builder, { node }) => addReferenceArcs(builder, node, 'payload'),
  inherits: (builder, { node }) => addClassArcs(builder, node, 'inherit'),
  impliedClasses: (builder, { node }) => implyClassArcs(builder, node),
  specializes: (builder, { node }) => addClassArcs(builder, node, 'specialize'),
  variantSets: (builder, { node }) => addVariantSets(builder, node),
  variant: (builder, task) => addVariantArc(builder, task),
  fallbackVariant: (builder, task) => addVariantArc(builder, task),
};

/** Inert sites still imply classes, and are relocated. */
const TASKS_FOR_INERT: ReadonlySet<IndexTaskKind> = new Set(['impliedClasses', 'relocate', 'impliedRelocate']);

/** Whether the path is relocated away by the stack's own layers, so that arcs to it find nothing. */
function isRelocatedAway({ relocates }: LayerStack, path: string): boolean {
  return relocates !== undefined && someAncestor(path, (around) => relocates.resolved.has(around));
}
