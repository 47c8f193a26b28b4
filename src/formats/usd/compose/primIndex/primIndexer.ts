import type { DiagnosticCode } from '../../../diagnostics/diagnosticCodes.ts';
import { nameOf, parentOf, someAncestor } from '../../layer/primPaths.ts';
import type { LayerStack, LayerStackCache, ReportPrimIssue } from '../layers/layerStack.ts';
import type { LayerStore } from '../layers/layerStore.ts';
import { addClassArcs, classHierarchyStart, implyClassArcs } from './classArcs.ts';
import { type CompositionBudget, STEP_COSTS } from './compositionBudget.ts';
import { isInstance } from './instances.ts';
import {
  allNodes,
  areNestedPaths,
  type CompositionArc,
  hasClasses,
  hasOpinions,
  makeInert,
  PrimIndexNode,
} from './primIndexNode.ts';
import { addReferenceArcs } from './referenceArcs.ts';
import { addRelocateArc, implyRelocateArc } from './relocateArcs.ts';
import { type IndexTask, type IndexTaskKind, TaskList } from './tasks.ts';
import { addVariantArc, addVariantSets } from './variantArcs.ts';

/** What all prims of a stage are composed with. */
export interface CompositionContext {
  readonly store: LayerStore;
  readonly stacks: LayerStackCache;
  /** Variants by set, the best first, where nothing is selected. */
  readonly fallbacks: ReadonlyMap<string, readonly string[]>;
  readonly work: CompositionBudget;
  readonly note: ReportPrimIssue;
}

/** An arc to a prim that is not at the root: the prim's own index is built first, with the opinions on what is around it. */
export interface IndexStackFrame {
  /** The site whose index is wanted. */
  readonly path: string;
  /** The node that has the arc, in the index that is built around this one. */
  readonly parent: PrimIndexNode;
  readonly arc: Pick<CompositionArc, 'kind' | 'map'>;
  readonly skipsDuplicates: boolean;
  readonly outer: PrimIndexBuilder;
}

/** What a builder is started by: an arc, or the builder of a prim that is in the one to build. */
interface BuilderOrigin {
  readonly frame?: IndexStackFrame;
  readonly inner?: PrimIndexBuilder;
}

export interface ArcOptions {
  /** Its opinions count. */
  readonly contributes?: boolean;
  /** What is around the target in namespace has opinions on it as well. */
  readonly ancestral?: boolean;
  /** Nothing is added where the index has the site already. */
  readonly skipsDuplicates?: boolean;
}

/** Indexes within indexes, to this depth. */
const MAX_NESTED_INDEXES = 100;
/** Sites that one prim can have. */
export const MAX_NODES = 4000;

/**
 * Finds all sites that have opinions on one prim and orders them by strength: local, inherits, variants, relocates,
 * references, payloads, specializes (LIVERPS; OpenUSD glossary, "LIVERPS Strength Ordering"). It starts from the index
 * of the prim around it, since arcs there bring namespace with them, and follows the arcs of every site that it finds.
 */
export class PrimIndexBuilder {
  readonly composer: CompositionContext;
  readonly frame: IndexStackFrame | undefined;
  /** Of the prims that are asked for here, this one is so many levels around the last. */
  readonly ancestorDepth: number;
  readonly tasks: TaskList;
  root!: PrimIndexNode;
  private readonly evaluatesVariants: boolean;
  private readonly level: number;
  private readonly count: { nodes: number };
  /** The prim of the stage that all this is for. */
  private readonly path: string;
  private readonly expected: { target: PrimIndexNode; message: string }[];

  private constructor(
    composer: CompositionContext,
    path: string,
    around: BuilderOrigin = {},
    evaluatesVariants = true,
  ) {
    this.composer = composer;
    this.tasks = new TaskList(composer.work);
    const from = around.inner ?? around.frame?.outer;
    this.path = from?.path ?? path;
    this.expected = from?.expected ?? [];
    this.frame = around.inner ? around.inner.frame : around.frame;
    this.ancestorDepth = (from?.ancestorDepth ?? 0) + (around.inner ? 1 : 0);
    this.level = (from?.level ?? 0) + 1;
    this.count = from?.count ?? { nodes: 0 };
    this.evaluatesVariants = evaluatesVariants;
  }

  /** The index of a prim of the stage. `around` is that of its parent, none for the pseudo-root. */
  static stagePrim(
    composer: CompositionContext,
    stack: LayerStack,
    path: string,
    around: PrimIndexNode | undefined,
  ): PrimIndexNode {
    const builder = new PrimIndexBuilder(composer, path);
    builder.root = around ? builder.childOf(around, path) : new PrimIndexNode(stack, path);
    const index = builder.run();
    for (const { target, message } of builder.expected)
      if (!hasOpinions(target)) builder.report('usd.unresolved-prim', message);
    return index;
  }

  /** Everything that a site has, its ancestors' arcs among them, as it is needed where an arc leads to the site. */
  private static target(stack: LayerStack, path: string, frame: IndexStackFrame, contributes: boolean): PrimIndexNode {
    const builder = new PrimIndexBuilder(frame.outer.composer, path, { frame }, false);
    return builder.buildAt(stack, path, contributes);
  }

  private buildAt(stack: LayerStack, path: string, contributes: boolean): PrimIndexNode {
    if (path === '' || path.endsWith('}') || this.isTooDeep(path)) this.root = new PrimIndexNode(stack, path);
    else {
      const around = new PrimIndexBuilder(this.composer, path, { inner: this }).buildAt(stack, parentOf(path), true);
      this.root = this.childOf(around, path);
    }
    if (!contributes) this.root.isInert = true;
    return path === '' ? this.root : this.run();
  }

  private childOf(around: PrimIndexNode, path: string): PrimIndexNode {
    return around.childIndex(nameOf(path), isInstance(around));
  }

  private isTooDeep(path: string): boolean {
    if (this.level <= MAX_NESTED_INDEXES) return false;
    this.report(
      'usd.too-deep',
      `arcs to ${path} are nested more than ${MAX_NESTED_INDEXES} deep; they are left out there`,
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
    return this.composer.work;
  }

  private isOverBudget(): boolean {
    if (this.count.nodes > MAX_NODES)
      this.report('usd.too-many-arcs', `more than ${MAX_NODES} sites have opinions on it; the rest is left out`);
    return this.count.nodes > MAX_NODES || this.work.isExhausted;
  }

  private perform(task: IndexTask): void {
    const { node } = task;
    if (TASKS_FOR_INERT.has(task.kind) || !node.isInert) TASK_HANDLERS[task.kind](this, task);
  }

  /** Says something about the prim that is composed. */
  report(code: DiagnosticCode, message: string): void {
    this.composer.note(code, this.path, message);
  }

  /** A reference or payload has to lead to something; whether it does is known when all arcs are followed. */
  expectOpinions(target: PrimIndexNode, message: string): void {
    this.expected.push({ target, message });
  }

  /** Adds a site under a node, and what is to be done there. Undefined where it cannot be, or is there already. */
  addArc(
    parent: PrimIndexNode,
    stack: LayerStack,
    path: string,
    arc: CompositionArc,
    options: ArcOptions = {},
  ): PrimIndexNode | undefined {
    if (arc.kind !== 'variant' && this.makesCycle(parent, stack, path)) {
      const message = `the ${arc.kind} of ${parent.path} in ${parent.stack.root.id} to ${path} leads back to where it comes from; it is left out`;
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
      node = PrimIndexBuilder.target(stack, path, { path, parent, arc, skipsDuplicates, outer: this }, contributes);
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

  /** What is to be done for a new node: its own arcs, unless its index has followed them, and what they imply above. */
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

  /** The prims that lead here, through all indexes that are being built: none of them may be in the target, or around it. */
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

  /**
   * Asks this index and those around it. An index may be that of a prim around the one which is wanted: `site` is what
   * the path becomes there once the wanted one is reached.
   */
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

/** Sites without opinions of their own still imply classes, and are moved. */
const TASKS_FOR_INERT: ReadonlySet<IndexTaskKind> = new Set(['impliedClasses', 'relocate', 'impliedRelocate']);

/** Where a relocate of the same layers takes the prim away from, nothing is left that an arc could lead to. */
function isRelocatedAway({ relocates }: LayerStack, path: string): boolean {
  return relocates !== undefined && someAncestor(path, (around) => relocates.resolved.has(around));
}
