import { msg } from '../../../../messages/message.ts';
import { messageOf } from '../../../../messages/messageError.ts';
import { expandExpression, isExpression, NO_VARIABLES, variablesUnder } from './expressions.ts';
import type { LayerStack, ReportPrimIssue, StackLayer } from './layerStack.ts';
import { isLayerError, type LayerStore, type LoadedLayer } from './layerStore.ts';
import { relocatesOf } from './relocates.ts';
import { composeOffsets, isInvertible, NO_OFFSET, type TimeOffset } from './timeOffset.ts';

/** Maximum depth of sublayers in sublayers. */
const MAX_DEPTH = 64;

/** Builds and caches layer stacks; incomplete ones are rebuilt once their layers are loaded. */
export class LayerStackCache {
  private readonly store: LayerStore;
  private readonly note: ReportPrimIssue;
  private readonly byRoot = new Map<string, LayerStack>();

  constructor(store: LayerStore, note: ReportPrimIssue) {
    this.store = store;
    this.note = note;
  }

  /** `above`: expression variables of the referencing stack. */
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

  /** Adds a layer and its sublayers; false if one is not loaded yet. */
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
      else if (isLayerError(found)) this.note(found.code, '', msg`the sublayer ${found.message}`, found.missing);
      else {
        const chain = [...above, source];
        if (chain.includes(found) || chain.length > MAX_DEPTH) {
          const message = chain.includes(found)
            ? msg`the sublayer @${asset}@ of ${source.id} is one of its own sublayers; it is left out there`
            : msg`the sublayer @${asset}@ of ${source.id} is nested deeper than ${MAX_DEPTH}; it is left out there`;
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

  /** Undefined if the expression fails. */
  private expanded(asset: string, { source, variables }: StackLayer): string | undefined {
    if (!isExpression(asset)) return asset;
    try {
      return expandExpression(asset, variables) || undefined;
    } catch (thrown) {
      this.note('usd.expression', '', msg`the sublayer ${asset} of ${source.id} is left out: ${messageOf(thrown)}`);
      return undefined;
    }
  }

  private usable(time: TimeOffset, asset: string, source: LoadedLayer): TimeOffset {
    if (isInvertible(time)) return time;
    const message = msg`the sublayer @${asset}@ of ${source.id} has the offset ${time.offset} and the scale ${time.scale}, which are no times; they are left out`;
    this.note('usd.layer-offset', '', message);
    return NO_OFFSET;
  }
}
