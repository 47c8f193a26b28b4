import type { Lifetime } from '../../../scene/types.ts';
import { attribute, custom, type Properties } from '../layer/specs.ts';
import { double, token } from '../layer/values.ts';
import type { WriteContext } from './motions.ts';

/** When a prim exists: its visibility over time. That would hide prims below it too, so one that has any says it by our own attributes. */
export function lifeProperties({ lives, isParent, inheritsLife, ...placement }: WriteContext): Properties {
  const changes = visibilityChanges(lives);
  if (inheritsLife && lives.length === 1) return slowlightLife(lives[0], () => true);
  if (changes.length === 0) return [];
  if (isParent) return slowlightLife(lives[0], Number.isFinite);
  const { codesPerSecond, startTime } = placement;
  const [first] = changes;
  const before = Math.min(startTime * codesPerSecond, first.time * codesPerSecond - 1);
  const samples = [
    { code: before, visible: !first.visible },
    ...changes.map(({ time, visible }) => ({ code: time * codesPerSecond, visible })),
  ];
  return [
    attribute('token', 'visibility', undefined, {
      timeSamples: {
        times: Float64Array.from(samples, ({ code }) => code),
        values: samples.map(({ visible }) => token(visible ? 'inherited' : 'invisible')),
      },
    }),
  ];
}

/** The times [s] at which it appears and disappears; lives that follow each other are one. */
function visibilityChanges(
  lives: readonly Lifetime[],
): readonly { readonly time: number; readonly visible: boolean }[] {
  return lives.flatMap(({ birth, death }, i) => [
    ...(Number.isFinite(birth) && lives[i - 1]?.death !== birth ? [{ time: birth, visible: true }] : []),
    ...(Number.isFinite(death) && lives[i + 1]?.birth !== death ? [{ time: death, visible: false }] : []),
  ]);
}

const slowlightLife = ({ birth, death }: Lifetime, isSaid: (time: number) => boolean): Properties => [
  ...(isSaid(birth) ? [custom('double', 'slowlight:birth', double(birth))] : []),
  ...(isSaid(death) ? [custom('double', 'slowlight:death', double(death))] : []),
];
