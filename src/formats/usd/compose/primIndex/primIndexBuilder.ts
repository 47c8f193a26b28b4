import type { Message } from '../../../../messages/message.ts';
import type { MissingFile } from '../../../../scene/types.ts';
import type { DiagnosticCode } from '../../../diagnostics/diagnosticCodes.ts';
import type { LayerStack, ReportPrimIssue } from '../layers/layerStack.ts';
import type { LayerStackCache } from '../layers/layerStackCache.ts';
import type { LayerStore } from '../layers/layerStore.ts';
import type { CompositionBudget } from './compositionBudget.ts';
import type { CompositionArc, PrimIndexNode, TargetArc } from './primIndexNode.ts';
import type { TaskList } from './tasks.ts';

/** Shared by the prim indexes of one stage. */
export interface CompositionContext {
  readonly store: LayerStore;
  readonly stacks: LayerStackCache;
  /** By variant set: the variants to try, in this order, where nothing is selected. */
  readonly fallbacks: ReadonlyMap<string, readonly string[]>;
  readonly work: CompositionBudget;
  readonly note: ReportPrimIssue;
}

/** An index that is built inside another: that of an arc's target below a root prim, with the arcs of the target's ancestors. */
export interface IndexStackFrame {
  /** The target's path. */
  readonly path: string;
  /** The node that has the arc, in the outer index. */
  readonly parent: PrimIndexNode;
  readonly arc: Pick<CompositionArc, 'kind' | 'map'>;
  readonly skipsDuplicates: boolean;
  readonly outer: PrimIndexBuilder;
}

export interface ArcOptions {
  /** Default: true; false adds an inert node. */
  readonly contributes?: boolean;
  /** The arcs of the target's ancestors are followed as well. */
  readonly ancestral?: boolean;
  /** No node is added where the index has the site already. */
  readonly skipsDuplicates?: boolean;
}

/** A prim index under construction, as the arcs use it. */
export interface PrimIndexBuilder {
  readonly context: CompositionContext;
  /** Absent in the outermost index. */
  readonly frame: IndexStackFrame | undefined;
  /** Levels of namespace between the prim whose index this is and the descendant that it is built for. */
  readonly ancestorDepth: number;
  readonly tasks: TaskList;
  readonly work: CompositionBudget;
  /** Adds a diagnostic about the composed prim; `missing`: the missing layer, if it is about one. */
  report(code: DiagnosticCode, message: Message, missing?: MissingFile): void;
  /** Reports `message` where no site of `target` has opinions once all arcs are followed. */
  expectOpinions(target: PrimIndexNode, message: Message): void;
  /** Adds a site below a node and queues its tasks. Undefined where it would make a cycle, or is there already. */
  addArc(
    parent: PrimIndexNode,
    stack: LayerStack,
    path: string,
    arc: TargetArc,
    options?: ArcOptions,
  ): PrimIndexNode | undefined;
}
