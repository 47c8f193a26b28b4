import { msg } from '../../../../messages/message.ts';
import { report } from '../../diagnostics.ts';
import { boolAt, numbersAt, textAt } from '../../layer/attributes.ts';
import type { Layer, PrimSpec } from '../../layer/layer.ts';
import { isActive, metadataText } from '../../layer/query.ts';
import { primSpec } from '../../layer/specs.ts';
import type { StageContext } from '../context.ts';
import { cards } from './cards.ts';
import { modelBox } from './modelBox.ts';
import { boxEdges, originAxes } from './wires.ts';

/** What a model is drawn as instead. */
const MODES = ['origin', 'bounds', 'cards'] as const;
type DrawMode = (typeof MODES)[number] | 'default';

/** Linear; the fallback of `model:drawModeColor`. */
const COLOR: readonly number[] = [0.18, 0.18, 0.18];

/**
 * The stage with its models that have a `model:drawMode` replaced by what stands for them, as OpenUSD's imaging does: the mode is inherited, and applies to components,
 * and where `model:applyDrawMode` says so. Not where only something inside is asked for. Source: UsdGeomModelAPI (OpenUSD), "Draw Modes".
 */
export function withDrawModes(context: StageContext): Layer {
  const rootPrims = replaced(context, context.layer.rootPrims, { mode: 'default', isInModels: true });
  return rootPrims === context.layer.rootPrims ? context.layer : { ...context.layer, rootPrims };
}

type Prims = ReadonlyMap<string, PrimSpec>;

interface ModelContext {
  readonly mode: DrawMode;
  /** Whether all prims above are groups, so that models are there. */
  readonly isInModels: boolean;
}

/** The same map if nothing in it is replaced. */
function replaced(context: StageContext, prims: Prims, above: ModelContext): Prims {
  let changed: Map<string, PrimSpec> | undefined;
  for (const [name, prim] of prims) {
    const kind = kindOf(prim);
    const isGroup = above.isInModels && GROUPS.has(kind);
    const isModel = isGroup || (above.isInModels && MODELS.has(kind));
    const mode = isModel ? drawModeOf(prim, above.mode) : above.mode;
    const isInside = context.prim?.startsWith(`${prim.path}/`);
    const standIn = !isInside && isApplied(prim, mode) ? standInOf(context, prim, mode) : undefined;
    if (standIn) {
      changed ??= new Map(prims);
      changed.set(name, standIn);
    } else prim.children = replaced(context, prim.children, { mode, isInModels: isGroup });
  }
  return changed ?? prims;
}

const GROUPS = new Set(['group', 'assembly']);
const MODELS = new Set(['component', 'model']);
const kindOf = (prim: PrimSpec): string => metadataText(prim.metadata, 'kind') ?? '';

/** Of a model, as UsdGeomModelAPI::ComputeModelDrawMode, which reads it of nothing else. */
function drawModeOf(prim: PrimSpec, inherited: DrawMode): DrawMode {
  const written = textAt(prim, 'model:drawMode', undefined);
  return written === 'default' ? written : (MODES.find((mode) => mode === written) ?? inherited);
}

function isApplied(prim: PrimSpec, mode: DrawMode): mode is Exclude<DrawMode, 'default'> {
  if (mode === 'default' || prim.specifier !== 'def' || !isActive(prim)) return false;
  return boolAt(prim, 'model:applyDrawMode', undefined) ?? kindOf(prim) === 'component';
}

/** A prim in its place with the stand-in below it; undefined, with a diagnostic, if its size is not known. */
function standInOf(context: StageContext, prim: PrimSpec, mode: Exclude<DrawMode, 'default'>): PrimSpec | undefined {
  const color = Array.from(numbersAt(prim, 'model:drawModeColor', context.startCode) ?? COLOR);
  const box = mode === 'origin' ? undefined : modelBox(context, prim);
  if (mode !== 'origin' && !box) {
    const message = msg`model:drawMode is ${mode}, and nothing tells its size (extentsHint, or points below it); the model itself is drawn`;
    report(context, 'warning', 'usd.draw-mode', prim.path, message);
    return undefined;
  }
  const path = (name: string): string => `${prim.path}/${name}`;
  const shapes =
    mode === 'origin'
      ? [originAxes(path('origin'), color)]
      : mode === 'bounds'
        ? [boxEdges(path('bounds'), box!, color)]
        : cards(context, prim, box!, color);
  const children = new Map(shapes.map((shape) => [shape.name, shape]));
  return { ...primSpec(prim.path, { type: 'Xform', properties: placing(prim) }, children), metadata: prim.metadata };
}

/** What its place, its times and its purpose are made of. */
const placing = (prim: PrimSpec) =>
  [...prim.properties.values()].filter(({ name }) => /^(xformOp|visibility$|purpose$|slowlight:)/.test(name));
