import type { Code } from '../../codes.ts';
import { addClasses, implyClasses, startOfClasses } from './classes.ts';
import { isInstance } from './instances.ts';
import type { LayerStack, LayerStacks, Note } from './layerStack.ts';
import type { LayerStore } from './layerStore.ts';
import { type Arc, areRelated, everyNode, hasClasses, Node, silence, speaksAnywhere } from './node.ts';
import { anyAround, nameOf, parentOf } from './paths.ts';
import { addReferences } from './references.ts';
import { addRelocate, implyRelocate } from './relocations.ts';
import { type Task, type TaskKind, TaskList } from './tasks.ts';
import { addVariant, addVariantSets } from './variants.ts';
import { STEPS, type Work } from './work.ts';

/** What all prims of a stage are composed with. */
export interface Composer {
  readonly store: LayerStore;
  readonly stacks: LayerStacks;
  /** Variants by set, the best first, where nothing is selected. */
  readonly fallbacks: ReadonlyMap<string, readonly string[]>;
  readonly work: Work;
  readonly note: Note;
}

/** An arc to a prim that is not at the root: the prim's own index is built first, with the opinions on what is around it. */
export interface Frame {
  /** The site whose index is wanted. */
  readonly path: string;
  /** The node that has the arc, in the index that is built around this one. */
  readonly parent: Node;
  readonly arc: Pick<Arc, 'kind' | 'map'>;
  readonly skipsDuplicates: boolean;
  readonly outer: IndexBuilder;
}

/** What a builder is started by: an arc, or the builder of a prim that is in the one to build. */
interface Around {
  readonly frame?: Frame;
  readonly inner?: IndexBuilder;
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
const MAX_LEVEL = 100;
/** Sites that one prim can have. */
export const MAX_NODES = 4000;

/**
 * Finds all sites that have opinions on one prim and orders them by strength: local, inherits, variants, relocates,
 * references, payloads, specializes (LIVERPS; OpenUSD glossary, "LIVERPS Strength Ordering"). It starts from the index
 * of the prim around it, since arcs there bring namespace with them, and follows the arcs of every site that it finds.
 */
export class IndexBuilder {
  readonly composer: Composer;
  readonly frame: Frame | undefined;
  /** Of the prims that are asked for here, this one is so many levels around the last. */
  readonly ancestorDepth: number;
  readonly tasks: TaskList;
  root!: Node;
  private readonly evaluatesVariants: boolean;
  private readonly level: number;
  private readonly count: { nodes: number };
  /** The prim of the stage that all this is for. */
  private readonly path: string;
  private readonly expected: { target: Node; message: string }[];

  private constructor(composer: Composer, path: string, around: Around = {}, evaluatesVariants = true) {
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
  static stagePrim(composer: Composer, stack: LayerStack, path: string, around: Node | undefined): Node {
    const builder = new IndexBuilder(composer, path);
    builder.root = around ? builder.childOf(around, path) : new Node(stack, path);
    const index = builder.run();
    for (const { target, message } of builder.expected)
      if (!speaksAnywhere(target)) builder.note('usd.unresolved-prim', message);
    return index;
  }

  /** Everything that a site has, its ancestors' arcs among them, as it is needed where an arc leads to the site. */
  private static target(stack: LayerStack, path: string, frame: Frame, contributes: boolean): Node {
    const builder = new IndexBuilder(frame.outer.composer, path, { frame }, false);
    return builder.buildAt(stack, path, contributes);
  }

  private buildAt(stack: LayerStack, path: string, contributes: boolean): Node {
    if (path === '' || path.endsWith('}') || this.isTooDeep(path)) this.root = new Node(stack, path);
    else {
      const around = new IndexBuilder(this.composer, path, { inner: this }).buildAt(stack, parentOf(path), true);
      this.root = this.childOf(around, path);
    }
    if (!contributes) this.root.isInert = true;
    return path === '' ? this.root : this.run();
  }

  private childOf(around: Node, path: string): Node {
    return around.toChild(nameOf(path), isInstance(around));
  }

  private isTooDeep(path: string): boolean {
    if (this.level <= MAX_LEVEL) return false;
    this.note('usd.too-deep', `arcs to ${path} are nested more than ${MAX_LEVEL} deep; they are left out there`);
    return true;
  }

  private run(): Node {
    const nodes = everyNode(this.root);
    for (const node of nodes) node.serial = this.count.nodes++;
    this.work.spend(STEPS.site * nodes.length);
    this.addArcTasks(this.root, true);
    for (let task = this.tasks.take(); task && !this.isFull(); task = this.tasks.take()) this.perform(task);
    // Each base is compared with all others.
    this.work.spend(everyNode(this.root).filter(({ arc }) => arc.kind === 'specialize').length ** 2 * 2);
    return this.root;
  }

  get work(): Work {
    return this.composer.work;
  }

  private isFull(): boolean {
    if (this.count.nodes > MAX_NODES)
      this.note('usd.too-many-arcs', `more than ${MAX_NODES} sites have opinions on it; the rest is left out`);
    return this.count.nodes > MAX_NODES || this.work.isTooMuch;
  }

  private perform(task: Task): void {
    const { node } = task;
    if (PERFORM_INERT.has(task.kind) || !node.isInert) PERFORM[task.kind](this, task);
  }

  /** Says something about the prim that is composed. */
  note(code: Code, message: string): void {
    this.composer.note(code, this.path, message);
  }

  /** A reference or payload has to lead to something; whether it does is known when all arcs are followed. */
  expect(target: Node, message: string): void {
    this.expected.push({ target, message });
  }

  /** Adds a site under a node, and what is to be done there. Undefined where it cannot be, or is there already. */
  addArc(parent: Node, stack: LayerStack, path: string, arc: Arc, options: ArcOptions = {}): Node | undefined {
    if (arc.kind !== 'variant' && this.makesCycle(parent, stack, path)) {
      const message = `the ${arc.kind} of ${parent.path} in ${parent.stack.root.id} to ${path} leads back to where it comes from; it is left out`;
      this.note('usd.cycle', message);
      return undefined;
    }
    const skipsDuplicates = options.skipsDuplicates || (this.frame?.skipsDuplicates ?? false);
    if ((skipsDuplicates && this.hasSite(parent, stack, path)) || this.isFull()) return undefined;
    this.work.spend(STEPS.site + STEPS.pair * arc.map.pairs.length);
    const ancestral = options.ancestral ?? false;
    const contributes = options.contributes ?? true;
    let node: Node;
    if (ancestral) {
      node = IndexBuilder.target(stack, path, { path, parent, arc, skipsDuplicates, outer: this }, contributes);
    } else {
      node = new Node(stack, path);
      node.isInert = !contributes;
      node.serial = this.count.nodes++;
    }
    if (arc.kind !== 'relocate' && isMovedAway(stack, path)) silence(node);
    node.isAncestral = false;
    parent.adopt(node, arc);
    this.addTasks(node, !ancestral);
    return node;
  }

  /** What is to be done for a new node: its own arcs, unless its index has followed them, and what they imply above. */
  private addTasks(node: Node, ownArcs: boolean): void {
    if (node.isClass) this.tasks.add({ kind: 'impliedClasses', node: startOfClasses(node) });
    else if (hasClasses(node)) this.tasks.add({ kind: 'impliedClasses', node });
    this.addArcTasks(node, ownArcs);
  }

  private addArcTasks(tree: Node, ownArcs: boolean): void {
    for (const node of everyNode(tree)) {
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
  private makesCycle(parent: Node, stack: LayerStack, path: string): boolean {
    return this.someFrame(parent, path, (node, site) => {
      this.work.spend(1);
      for (let at: Node | undefined = node; at; at = at.parent)
        if (at.stack === stack && areRelated(at.path, site)) return true;
      return false;
    });
  }

  private hasSite(parent: Node, stack: LayerStack, path: string): boolean {
    return this.someFrame(parent, path, (node, site) => {
      const others = everyNode(node.root);
      this.work.spend(others.length);
      return others.some((other) => other.isSite(stack, site));
    });
  }

  /**
   * Asks this index and those around it. An index may be that of a prim around the one which is wanted: `site` is what
   * the path becomes there once the wanted one is reached.
   */
  private someFrame(parent: Node, path: string, ask: (node: Node, site: string) => boolean): boolean {
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

const PERFORM: Readonly<Record<TaskKind, (builder: IndexBuilder, task: Task) => void>> = {
  relocate: (builder, { node }) => addRelocate(builder, node),
  impliedRelocate: (builder, { node }) => implyRelocate(builder, node),
  references: (builder, { node }) => addReferences(builder, node, 'reference'),
  payloads: (builder, { node }) => addReferences(builder, node, 'payload'),
  inherits: (builder, { node }) => addClasses(builder, node, 'inherit'),
  impliedClasses: (builder, { node }) => implyClasses(builder, node),
  specializes: (builder, { node }) => addClasses(builder, node, 'specialize'),
  variantSets: (builder, { node }) => addVariantSets(builder, node),
  variant: (builder, task) => addVariant(builder, task),
  fallbackVariant: (builder, task) => addVariant(builder, task),
};

/** Sites without opinions of their own still imply classes, and are moved. */
const PERFORM_INERT: ReadonlySet<TaskKind> = new Set(['impliedClasses', 'relocate', 'impliedRelocate']);

/** Where a relocate of the same layers takes the prim away from, nothing is left that an arc could lead to. */
function isMovedAway({ relocates }: LayerStack, path: string): boolean {
  return relocates !== undefined && anyAround(path, (around) => relocates.whole.has(around));
}
