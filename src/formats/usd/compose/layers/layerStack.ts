import type { DiagnosticCode } from '../../../diagnostics/diagnosticCodes.ts';
import { messageOf } from '../../../diagnostics/inputError.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { specAt } from '../../layer/primPaths.ts';
import { expandExpression, isExpression, NO_VARIABLES, type Variables, variablesUnder } from './expressions.ts';
import { isLayerError, type LayerStore, type LoadedLayer } from './layerStore.ts';
import { type Relocates, relocatesOf } from './relocates.ts';
import { composeOffsets, isInvertible, NO_OFFSET, type TimeOffset } from './timeOffset.ts';

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

/** Sublayers in sublayers, to this depth. */
const MAX_DEPTH = 64;

/** Builds layer stacks from a store; one that waits for layers is built again once they are there. */
export class LayerStackCache {
  private readonly store: LayerStore;
  private readonly note: ReportPrimIssue;
  private readonly byRoot = new Map<string, LayerStack>();

  constructor(store: LayerStore, note: ReportPrimIssue) {
    this.store = store;
    this.note = note;
  }

  /** `above`: the variables of the stack that leads here. */
  getOrBuild(root: LoadedLayer, session?: LoadedLayer, above = NO_VARIABLES): LayerStack {
    const variables = variablesUnder(above, root.layer.metadata.get('expressionVariables'));
    const values = variables.size > 0 ? JSON.stringify([...variables].sort()) : '';
    const key = `${root.id}\n${session ? 'session' : ''}\n${values}`;
    const known = this.byRoot.get(key);
    if (known) return known;
    const layers: StackLayer[] = session ? [{ source: session, time: NO_OFFSET, variables }] : [];
    const complete = this.collect({ source: root, time: NO_OFFSET, variables }, [], layers);
    const stack: LayerStack = {
      root,
      layers,
      variables,
      relocates: relocatesOf(layers, complete ? this.note : () => {}),
      opinions: new Map(),
    };
    if (complete) this.byRoot.set(key, stack);
    return stack;
  }

  /** Adds a layer and what is below it; false where one of them is still to come. */
  private collect(layer: StackLayer, above: readonly LoadedLayer[], into: StackLayer[]): boolean {
    const { source, time, variables } = layer;
    into.push(layer);
    const subLayers = source.layer.metadata.get('subLayers');
    if (subLayers?.type !== 'subLayers') return true;
    let complete = true;
    for (const { asset: written, offset, scale } of subLayers.data) {
      const asset = this.expanded(written, layer);
      if (asset === undefined) continue;
      const found = this.store.find(source.id, asset);
      if (!found) complete = false;
      else if (isLayerError(found)) this.note(found.code, '', `the sublayer ${found.message}`);
      else {
        const chain = [...above, source];
        if (chain.includes(found) || chain.length > MAX_DEPTH) {
          const message = chain.includes(found)
            ? `the sublayer @${asset}@ of ${source.id} is one of its own sublayers; it is left out there`
            : `the sublayer @${asset}@ of ${source.id} is nested deeper than ${MAX_DEPTH}; it is left out there`;
          this.note('usd.cycle', '', message);
          continue;
        }
        const own = this.usable({ offset, scale }, asset, source);
        const scaled = { offset: own.offset, scale: (own.scale * source.codesPerSecond) / found.codesPerSecond };
        complete =
          this.collect({ source: found, time: composeOffsets(time, scaled), variables }, chain, into) && complete;
      }
    }
    return complete;
  }

  /** Undefined where an expression makes no path. */
  private expanded(asset: string, { source, variables }: StackLayer): string | undefined {
    if (!isExpression(asset)) return asset;
    try {
      return expandExpression(asset, variables) || undefined;
    } catch (thrown) {
      this.note('usd.expression', '', `the sublayer ${asset} of ${source.id} is left out: ${messageOf(thrown)}`);
      return undefined;
    }
  }

  private usable(time: TimeOffset, asset: string, source: LoadedLayer): TimeOffset {
    if (isInvertible(time)) return time;
    const message = `the sublayer @${asset}@ of ${source.id} has the offset ${time.offset} and the scale ${time.scale}, which are no times; they are left out`;
    this.note('usd.layer-offset', '', message);
    return NO_OFFSET;
  }
}
