import type { Message } from '../../../../messages/message.ts';
import type { MissingFile } from '../../../../scene/types.ts';
import type { DiagnosticCode } from '../../../diagnostics/diagnosticCodes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { specAt } from '../../layer/primPaths.ts';
import type { NamespaceMap } from '../primIndex/namespaceMap.ts';
import type { Variables } from './expressions.ts';
import type { LoadedLayer } from './layerStore.ts';
import type { TimeOffset } from './timeOffset.ts';

/** A layer and its sublayers, strongest first. */
export interface LayerStack {
  readonly root: LoadedLayer;
  readonly layers: readonly StackLayer[];
  readonly relocates: Relocates | undefined;
  /** Expression variables: those of its root, overridden by the referencing stacks. */
  readonly variables: Variables;
  /** Opinions cached by path: many arcs can target one prim. */
  readonly opinions: Map<string, readonly Opinion[]>;
}

export interface StackLayer {
  readonly source: LoadedLayer;
  /** From the layer's own times to those of the stack's root. */
  readonly time: TimeOffset;
  /** Those of its stack. */
  readonly variables: Variables;
}

/** Relocates of a layer stack: renames and moves of prims that its arcs bring. */
export interface Relocates {
  /** As authored: source path → target path; '' where removed. */
  readonly bySource: ReadonlyMap<string, string>;
  readonly byTarget: ReadonlyMap<string, string>;
  /** Those from or to a prim's children, by the prim's path. */
  readonly byParent: ReadonlyMap<string, readonly (readonly [source: string, target: string])[]>;
  /** Namespace maps of arcs with relocates, cached by arc. */
  readonly mapsOfArcs: Map<string, NamespaceMap>;
  /** Sources resolved through ancestors' relocates to the arcs' own namespace. */
  readonly resolved: ReadonlyMap<string, string>;
}

/** One layer's spec of a prim. */
export interface Opinion {
  readonly spec: PrimSpec;
  readonly from: StackLayer;
}

export type ReportPrimIssue = (code: DiagnosticCode, path: string, message: Message, missing?: MissingFile) => void;

/** All opinions of a stack on the prim at a path, strongest first. */
export function opinionsAt({ layers, opinions }: LayerStack, path: string): readonly Opinion[] {
  const known = opinions.get(path);
  if (known) return known;
  const found = layers.flatMap((from) => {
    const spec = specAt(from.source.root, path);
    return spec ? [{ spec, from }] : [];
  });
  opinions.set(path, found);
  return found;
}
