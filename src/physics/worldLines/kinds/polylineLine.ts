import { lerp, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { polylineEmission } from '../emission.ts';
import { type SampledLine, samplePosition, samplesUntil } from '../samples.ts';
import { uniformSlice } from '../slice.ts';
import { relativePosition, relativeTime, sampledLine } from './sampledLine.ts';
import type { WorldLineKind } from './worldLineKind.ts';

/** Straight pieces between samples. */
export interface PolylineLine extends SampledLine {
  readonly kind: 'polyline';
}

/** The samples after `from` up to `to`. */
function corners(w: PolylineLine, from: number, to: number): readonly Vec3[] {
  const [first, end] = [samplesUntil(w.times, from), samplesUntil(w.times, to)];
  const found: Vec3[] = [];
  for (let k = first; k < end; k++) found.push(samplePosition(w, k));
  return found;
}

export const POLYLINE_LINE: WorldLineKind<PolylineLine> = {
  ...sampledLine<PolylineLine>({
    positionAt(w, i, t) {
      const [t0, t1] = [w.times[i], w.times[i + 1]];
      return lerp(samplePosition(w, i), samplePosition(w, i + 1), (t - t0) / (t1 - t0));
    },
    velocityAt: (w, i) => scale(sub(samplePosition(w, i + 1), samplePosition(w, i)), 1 / (w.times[i + 1] - w.times[i])),
    pastLightCone: (w, i, observer, c) =>
      polylineEmission(
        relativePosition(w, i, observer),
        relativeTime(w, i, observer, c),
        relativePosition(w, i + 1, observer),
        relativeTime(w, i + 1, observer, c),
      ),
    simultaneitySlice(w, i, observer, u, c) {
      const [a, b] = [relativePosition(w, i, observer), relativePosition(w, i + 1, observer)];
      const [tA, tB] = [relativeTime(w, i, observer, c), relativeTime(w, i + 1, observer, c)];
      return uniformSlice(a, tA, scale(sub(b, a), 1 / (tB - tA)), u);
    },
  }),
  asPolyline: (w) => w,
  hullPoints: corners,
};
