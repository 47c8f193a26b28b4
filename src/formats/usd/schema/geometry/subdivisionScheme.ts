import type { Message } from '../../../../messages/message.ts';
import type { SubdivisionScheme } from '../../../../scene/subdivide/scheme.ts';
import { report } from '../../diagnostics.ts';
import { textAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';

/** Rows of a picture that a mesh may fill without being more than about a pixel from its limit surface, if no levels are requested. */
export const SMOOTH_ROWS = 1080;

export type UsdSubdivisionScheme = Exclude<SubdivisionScheme, 'linear'>;
const SCHEMES: readonly string[] = ['catmullClark', 'loop', 'bilinear'] satisfies UsdSubdivisionScheme[];

/** Undefined for polygonal meshes. Unknown schemes are Catmull–Clark, the default. */
export function schemeOf(prim: PrimSpec): UsdSubdivisionScheme | undefined {
  const written = textAt(prim, 'subdivisionScheme', undefined) ?? 'catmullClark';
  if (written === 'none') return undefined;
  return SCHEMES.includes(written) ? (written as UsdSubdivisionScheme) : 'catmullClark';
}

export const reportSubdivision = (
  context: StageContext,
  prim: PrimSpec,
  severity: 'info' | 'warning',
  message: Message,
): void => report(context, severity, 'usd.subdivision', prim.path, message);
