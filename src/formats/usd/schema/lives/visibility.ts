import { FOREVER } from '../../../../scene/defaults.ts';
import { commonLifetimes } from '../../../../scene/motion/lifetimes.ts';
import type { Lifetime } from '../../../../scene/types.ts';
import { attributeOf, sampleTimes, textAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';

/** Of what is always visible. */
export const ALWAYS: readonly Lifetime[] = [FOREVER];

/**
 * When a prim is visible [s]: it and those above it, which are visible in the times `around`, are not `invisible`. As UsdGeomImageable::ComputeVisibility: samples
 * are held, the first one also before it and the last one after it.
 */
export function visibleTimes(
  { startCode, codesPerSecond }: Pick<StageContext, 'startCode' | 'codesPerSecond'>,
  prim: PrimSpec,
  around: readonly Lifetime[],
): readonly Lifetime[] {
  const codes = sampleTimes(attributeOf(prim, 'visibility'));
  const isVisible = (code: number): boolean => textAt(prim, 'visibility', code) !== 'invisible';
  if (codes.length === 0) return isVisible(startCode) ? around : [];
  const own: Lifetime[] = [];
  let birth: number | undefined;
  codes.forEach((code, i) => {
    const seconds = i === 0 ? -Infinity : code / codesPerSecond;
    if (isVisible(code)) birth ??= seconds;
    else if (birth !== undefined) {
      own.push({ birth, death: seconds });
      birth = undefined;
    }
  });
  if (birth !== undefined) own.push({ birth, death: Infinity });
  return commonLifetimes(around, own);
}
