import { msg } from '../../../../messages/message.ts';
import { commonLifetimes } from '../../../../scene/motion/lifetimes.ts';
import type { Lifetime } from '../../../../scene/types.ts';
import { report } from '../../diagnostics.ts';
import { numbersAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';
import { type MeshPiece, meshPieces, reportPieces } from './meshPieces.ts';

export interface NumberedPiece extends MeshPiece {
  /** From 1; undefined if there are no others. */
  readonly number: number | undefined;
}

/** Where and when a mesh, or a piece of it, is. */
interface Life {
  readonly transform: StageTransform;
  /** When it is visible [s]. */
  readonly lives: readonly Lifetime[];
}

/**
 * The pieces of a mesh whose topology changes, each with its own part of the mesh's life, without empty ones, with which simulations often begin; undefined if
 * its topology does not change, or if it may be skinned.
 */
export function livingPieces(
  context: StageContext,
  prim: PrimSpec,
  { transform, lives, maybeSkinned }: Life & { readonly maybeSkinned: boolean },
): readonly { readonly piece: NumberedPiece; readonly life: Life }[] | undefined {
  const all = meshPieces(context, prim);
  if (!all) return undefined;
  if (maybeSkinned) {
    const message = msg`its topology changes with time, and it may be skinned: it is held at the start`;
    report(context, 'warning', 'usd.topology', prim.path, message);
    return undefined;
  }
  const drawn = all.filter(({ at }) => (numbersAt(prim, 'faceVertexCounts', at)?.length ?? 0) > 0);
  reportPieces(context, prim, drawn);
  const { codesPerSecond } = context;
  return drawn.flatMap((piece, i) => {
    const own = commonLifetimes(lives, [{ birth: piece.from / codesPerSecond, death: piece.until / codesPerSecond }]);
    if (own.length === 0) return [];
    const number = drawn.length === 1 ? undefined : i + 1;
    return [{ piece: { ...piece, number }, life: { transform: transformInLife(transform, piece), lives: own } }];
  });
}

/** Samples of a transform that are kept before the birth and after the death of a piece. */
const MARGIN_SAMPLES = 3;

/** A transform as far as a piece needs it: around its life. */
function transformInLife(frame: StageTransform, { from, until }: MeshPiece): StageTransform {
  if (frame.times.length === 0) return frame;
  const first = frame.times.findIndex((time) => time > from);
  const begin = first < 0 ? frame.times.length : first;
  const after = frame.times.findIndex((time) => time >= until);
  const end = after < 0 ? frame.times.length : after;
  const within = frame.times.slice(Math.max(0, begin - MARGIN_SAMPLES), end + MARGIN_SAMPLES);
  const ends = Float64Array.from([from, until].filter(Number.isFinite));
  return { ...frame, times: unionOfTimes([within, ends]) };
}
