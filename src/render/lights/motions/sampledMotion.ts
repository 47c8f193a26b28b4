import { dot, int, mix, normalize, select, vec4 } from 'three/tsl';
import { sub } from '../../../math/vec3.ts';
import { samplesUntil } from '../../../physics/worldLines/samples.ts';
import { samplePose } from '../../../scene/motion/poses.ts';
import type { SampledMotion } from '../../../scene/types.ts';
import { polylineEmission } from '../../../shaders/emission/polylineEmission.ts';
import type { Int, Vec4 } from '../../../shaders/types.ts';
import { pieceAt } from '../../geometry/vertexSamples.ts';
import { type LightMotionKind, relativeAnchor } from './lightMotionKind.ts';

/** Longest table that a shader searches. */
const MAX_SAMPLES = 4096;
/** Texels per sample: (position, time) relative to the anchor, orientation. */
const SAMPLE_TEXELS = 2;

export const SAMPLED_MOTION: LightMotionKind<SampledMotion> = {
  sampleTexels: ({ times }) => SAMPLE_TEXELS * Math.min(times.length, MAX_SAMPLES),
  /** The samples up to the anchor and one more: no surface that is seen is lit by later ones. */
  write({ times, poses }, anchor, { t, position: observer, c }, samples, used) {
    const end = Math.max(2, Math.min(times.length, samplesUntil(times, t + anchor.ahead / c) + 1));
    const begin = Math.max(0, end - MAX_SAMPLES);
    for (let k = begin; k < end; k++) {
      const { position, orientation } = samplePose(poses, k);
      const time = c * (times[k] - t) - anchor.ahead;
      const offset = sub(sub(position, observer), anchor.offset);
      samples.set([...offset, time, ...orientation], used + SAMPLE_TEXELS * (k - begin));
    }
    return { motion: [used, end - begin, 0, 0], w: 1, used: SAMPLE_TEXELS * (end - begin) };
  },
  emission({ motion, samples }, d, lag) {
    const anchor = relativeAnchor(d);
    const [first, count] = [int(motion.x).toVar(), int(motion.y).toVar()];
    const texel = (index: Int, k: number): Vec4 =>
      samples.texel(first.add(index.mul(int(SAMPLE_TEXELS))).add(int(k))).toVar();
    const { dx, s, velocity } = polylineEmission(anchor, (i) => texel(i, 0).add(vec4(0, 0, 0, lag)), count);
    const elapsed = s.sub(lag).toVar();
    const { index, fraction } = pieceAt({ count, time: (i) => texel(i, 0).w }, elapsed);
    const [a, b] = [texel(index, 1), texel(index.add(int(1)), 1)];
    const orientation = normalize(mix(a, select(dot(a, b).lessThan(0), b.negate(), b), fraction)).toVar();
    return { offset: dx.toVar(), elapsed, velocity: velocity.toVar(), orientation };
  },
};
