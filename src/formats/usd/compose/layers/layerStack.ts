import type { DiagnosticCode } from '../../../diagnostics/diagnosticCodes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { specAt } from '../../layer/primPaths.ts';
import type { NamespaceMap } from '../primIndex/namespaceMap.ts';
import type { Variables } from './expressions.ts';
import type { LoadedLayer } from './layerStore.ts';
import type { TimeOffset } from './timeOffset.ts';

/** A layer and the layers below it, strongest first: what is edited together and composed as one. */
export interface LayerStack {
  readonly root: LoadedLayer;
  readonly layers: readonly StackLayer[];
  readonly relocates: Relocates | undefined;
  /** What expressions in its layers are made with: those of its root, under those of the stacks that lead to it. */
  readonly variables: Variables;
  /** By path, what was asked for: one prim can be what many arcs lead to. */
  readonly opinions: Map<string, readonly Opinion[]>;
}

export interface StackLayer {
  readonly source: LoadedLayer;
  /** From the layer's own times to those of the stack's root. */
  readonly time: TimeOffset;
  /** Those of its stack. */
  readonly variables: Variables;
}

/** How a layer stack moves the prims that its arcs bring, to other names or places. */
export interface Relocates {
  /** As written: where a prim is, and where it goes; '' where it is removed. */
  readonly bySource: ReadonlyMap<string, string>;
  readonly byTarget: ReadonlyMap<string, string>;
  /** Those from or to a prim's children, by the prim's path. */
  readonly byParent: ReadonlyMap<string, readonly (readonly [source: string, target: string])[]>;
  /** Maps of arcs with the moves in them, by arc: one prim's arcs are followed again for each prim that is moved in it. */
  readonly mapsOfArcs: Map<string, NamespaceMap>;
  /** With the moves of what is around a prim taken into account: where its specs are in the arcs' own namespace. */
  readonly resolved: ReadonlyMap<string, string>;
}

/** What one layer of a stack says about a prim. */
export interface Opinion {
  readonly spec: PrimSpec;
  readonly from: StackLayer;
}

export type ReportPrimIssue = (code: DiagnosticCode, path: string, message: string) => void;

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
