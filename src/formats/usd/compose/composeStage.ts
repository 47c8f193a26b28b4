import { listed, type Message, msg } from '../../../messages/message.ts';
import type { MissingFile } from '../../../scene/types.ts';
import type { DiagnosticCode } from '../../diagnostics/diagnosticCodes.ts';
import type { DiagnosticList } from '../../diagnostics/diagnosticLog.ts';
import { report } from '../diagnostics.ts';
import type { Layer, PrimSpec } from '../layer/layer.ts';
import { isActive } from '../layer/query.ts';
import { applyClips } from './clips/applyClips.ts';
import { type ClipSet, clipSetOf } from './clips/clipSet.ts';
import { type ClipSetDefinition, clipSetDefinitions } from './clips/definitions.ts';
import type { ReportPrimIssue } from './layers/layerStack.ts';
import { LayerStackCache } from './layers/layerStackCache.ts';
import { type LayerStore, type LoadedLayer, loadedLayer } from './layers/layerStore.ts';
import { childNames } from './prim/childNames.ts';
import { composedPrim } from './prim/composedPrim.ts';
import { type ComposedVariantSet, variantSetsOf } from './prim/variantSets.ts';
import { CompositionBudget, STEP_COSTS } from './primIndex/compositionBudget.ts';
import { isInstance } from './primIndex/instances.ts';
import type { CompositionContext } from './primIndex/primIndexBuilder.ts';
import { PrimIndexer } from './primIndex/primIndexer.ts';
import type { PrimIndexNode } from './primIndex/primIndexNode.ts';
import { sessionLayer, type VariantSelection } from './sessionLayer.ts';

/** Maximum number of prims: a small file can request any number. */
export const MAX_PRIMS = 250_000;
/** Maximum number of samples of all value clips. */
export const MAX_CLIP_SAMPLES = 2 ** 22;
/** Maximum depth of prims. */
export const MAX_DEPTH = 512;

export interface ComposeOptions {
  /** Stronger than what the file selects. */
  readonly variants?: readonly VariantSelection[] | undefined;
  /** By variant set: the variants to try, in this order, where nothing is selected. */
  readonly fallbacks?: ReadonlyMap<string, readonly string[]> | undefined;
}

export interface ComposedStage {
  /** The composed stage as one layer: prims without arcs, resolved values, stage paths. */
  readonly layer: Layer;
  readonly variantSets: readonly ComposedVariantSet[];
  /** Number of sublayers, references and payloads whose layers are missing. */
  readonly missingArcs: number;
}

/** Arcs to missing layers that are told one by one; all of them are counted in one line. */
const MAX_TOLD_MISSING = 3;
/** Maximum number of missing layers that this line names. */
const MAX_NAMED_LAYERS = 8;

/** A diagnostic deferred until the prim's index is final. */
interface PendingIssue {
  readonly code: DiagnosticCode;
  readonly path: string;
  readonly message: Message;
  readonly missing: MissingFile | undefined;
}

/** A prim whose children are composed, and their inherited state. */
interface ParentPrim {
  readonly index: PrimIndexNode;
  readonly path: string;
  readonly depth: number;
  /** It is inside an instance. */
  readonly isShared: boolean;
  /** Clip sets of the prim and its ancestors, strongest first. */
  readonly clips: readonly ClipSet[];
}

/** Composes the stage of a root layer. Layers are loaded on demand, so that unselected variants cost nothing. */
export async function composeStage(
  store: LayerStore,
  root: LoadedLayer,
  diagnostics: DiagnosticList,
  options: ComposeOptions = {},
): Promise<ComposedStage> {
  return new StageComposer(store, root, diagnostics, options).compose();
}

class StageComposer {
  private readonly store: LayerStore;
  private readonly root: LoadedLayer;
  /** Present even without selections: it tells the stage's stack from that of a reference to the root layer. */
  private readonly session: LoadedLayer;
  private readonly diagnostics: DiagnosticList;
  private readonly composer: CompositionContext;
  private readonly choices: readonly VariantSelection[];
  private readonly variantSets: ComposedVariantSet[] = [];
  private noted: PendingIssue[] = [];
  private prims = 0;
  private isFull = false;
  private missingArcs = 0;
  /** Names of missing layers, as written. */
  private readonly missingLayers = new Set<string>();
  private readonly clipBudget = { samples: MAX_CLIP_SAMPLES };

  constructor(store: LayerStore, root: LoadedLayer, diagnostics: DiagnosticList, options: ComposeOptions) {
    this.store = store;
    this.root = root;
    this.diagnostics = diagnostics;
    this.choices = options.variants ?? [];
    this.session = loadedLayer(sessionLayer(this.choices), '', true);
    const note: ReportPrimIssue = (code, path, message, missing) => {
      this.noted.push({ code, path, message, missing });
    };
    const stacks = new LayerStackCache(store, note);
    this.composer = {
      store,
      stacks,
      fallbacks: options.fallbacks ?? new Map(),
      work: new CompositionBudget(store),
      note,
    };
  }

  async compose(): Promise<ComposedStage> {
    const stack = await this.whenLayersLoaded(() => this.composer.stacks.getOrBuild(this.root, this.session));
    const index = await this.whenLayersLoaded(() => PrimIndexer.stagePrim(this.composer, stack, '', undefined));
    const { name, metadata } = this.root.layer;
    const root = { index, path: '', depth: 0, isShared: false, clips: [] };
    const rootPrims = await this.children(root, childNames(index));
    this.reportUnknownVariants();
    this.reportMissingLayers();
    const { missingArcs, variantSets } = this;
    return { layer: { name, metadata, rootPrims }, variantSets, missingArcs };
  }

  /** Repeats `build` until all layers are loaded; reports the diagnostics of the last run. */
  private async whenLayersLoaded<T>(build: () => T): Promise<T> {
    for (;;) {
      this.noted = [];
      const built = build();
      if (this.store.isComplete) {
        for (const { code, path, message, missing } of this.noted) this.report(code, path, message, missing);
        return built;
      }
      await this.store.load();
    }
  }

  private report(code: DiagnosticCode, path: string, message: Message, missing?: MissingFile): void {
    const context = { layer: this.root.layer, diagnostics: this.diagnostics };
    if (code === 'usd.missing-layer' && missing) {
      const isNew = !this.missingLayers.has(missing.name);
      this.missingLayers.add(missing.name);
      if (++this.missingArcs > MAX_TOLD_MISSING) {
        if (isNew) report(context, 'info', code, path, message, { missing });
        return;
      }
    }
    report(context, 'warning', code, path, message, missing && { missing });
  }

  private reportMissingLayers(): void {
    if (this.missingArcs <= MAX_TOLD_MISSING) return;
    const names = [...this.missingLayers];
    const named = listed([...names.slice(0, MAX_NAMED_LAYERS), ...(names.length > MAX_NAMED_LAYERS ? ['…'] : [])]);
    const message = msg`${this.missingArcs} references, payloads and sublayers lead to ${names.length} layers that are not there (${named}); open the folder that holds them`;
    this.report('usd.missing-layer', '', message);
  }

  private async children(parent: ParentPrim, names: readonly string[]): Promise<ReadonlyMap<string, PrimSpec>> {
    const { path, depth, isShared } = parent;
    const children = new Map<string, PrimSpec>();
    if (depth >= MAX_DEPTH) {
      this.report('usd.too-deep', path, msg`prims nested more than ${MAX_DEPTH} deep are left out`);
      return children;
    }
    for (const name of names) {
      if (!this.countPrim(path)) break;
      const childPath = `${path}/${name}`;
      const build = (): PrimIndexNode =>
        PrimIndexer.stagePrim(this.composer, parent.index.stack, childPath, parent.index);
      let index = build();
      if (!this.store.isComplete || this.noted.length > 0) index = await this.whenLayersLoaded(build);
      const prim = composedPrim(index, childPath, this.composer.work);
      if (this.isCutOff(prim)) break;
      children.set(name, prim);
      const definitions = clipSetDefinitions(index);
      const clips = definitions.length === 0 ? parent.clips : await this.clipSets(definitions, childPath, parent.clips);
      if (clips.length > 0) this.applyClips(prim, index, clips);
      if (!isShared) this.variantSets.push(...variantSetsOf(index, childPath));
      if (!isActive(prim)) continue;
      const below = childNames(index);
      if (below.length === 0) continue;
      const inside = isShared || isInstance(index);
      prim.children = await this.children({ index, path: childPath, depth: depth + 1, isShared: inside, clips }, below);
    }
    return children;
  }

  /** Counts a prim; false and reported above the limit. */
  private countPrim(path: string): boolean {
    const { work } = this.composer;
    work.spend(STEP_COSTS.prim);
    if (++this.prims <= MAX_PRIMS && !work.isExhausted) return true;
    this.reportFull(path);
    return false;
  }

  /** Reports an exhausted budget; true if the prim has no definition yet. */
  private isCutOff({ path, specifier }: PrimSpec): boolean {
    if (!this.composer.work.isExhausted) return false;
    this.reportFull(path);
    return specifier === 'over';
  }

  /** Clip sets of a prim and its ancestors, strongest first. */
  private async clipSets(
    definitions: readonly ClipSetDefinition[],
    path: string,
    around: readonly ClipSet[],
  ): Promise<readonly ClipSet[]> {
    const { note } = this.composer;
    const build = () => definitions.flatMap((d) => clipSetOf(d, this.store, path, note) ?? []);
    const own = await this.whenLayersLoaded(build);
    return [...own, ...around];
  }

  private applyClips(prim: PrimSpec, index: PrimIndexNode, clips: readonly ClipSet[]): void {
    if (this.clipBudget.samples < 0 || applyClips(prim, index, clips, this.clipBudget)) return;
    const message = msg`the clips of the stage make more than ${MAX_CLIP_SAMPLES} samples; from here on they are left out`;
    this.report('usd.clips', prim.path, message);
  }

  /** Reported once, at the first prim left out. */
  private reportFull(path: string): void {
    if (this.isFull) return;
    this.isFull = true;
    const why =
      this.prims > MAX_PRIMS
        ? msg`the stage has more than ${MAX_PRIMS} prims`
        : msg`its layers write ${this.store.specs} prims and properties, and their arcs make more of them than can be followed; ${this.prims - 1} prims are made`;
    this.report('usd.too-many-prims', path, msg`${why}; the rest is left out, from here on`);
  }

  private reportUnknownVariants(): void {
    for (const { path, set, variant } of this.choices) {
      const offered = this.variantSets.find((s) => s.path === path && s.set === set);
      if (offered?.variants.includes(variant) || (offered && variant === '')) continue;
      const message = offered
        ? msg`the variant '${variant}' of '${set}' is chosen, but ${set} has ${listed(offered.variants)}`
        : msg`the variant '${variant}' of '${set}' is chosen, but ${set} is not a variant set of this prim`;
      this.report('usd.variant', path, message);
    }
  }
}
