import { msg } from '../../../../messages/message.ts';
import { MAX_SURFACE_POINTS, ribbonFaces, ribbonPoints, tubeFaces, tubePoints } from '../../../read/strands/sweep.ts';
import { report } from '../../diagnostics.ts';
import { numbersAt, type TimeCode, textAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import { type ElementCounts, type ElementInterpolation, type ElementValues, elementValues } from './elementValues.ts';
import {
  type CurveArrays,
  type CurveKind,
  type SampledCurve,
  sampleCurves,
  segmentCount,
  varyingCount,
} from './stencils.ts';
import { DEFAULT_WIDTH, type Strand } from './strand.ts';

/** How finely curves are divided: steps per segment and sides of a tube, finest first. */
const DIVISIONS = [
  [8, 10],
  [6, 8],
  [4, 6],
  [2, 4],
  [1, 3],
] as const;

/** The curves of a prim as tubes, or as ribbons where they have normals; `widths` across. */
export function curveStrand(context: StageContext, prim: PrimSpec): Strand | undefined {
  const written = curvesOf(context, prim);
  if (!written) return undefined;
  const { start, curves: all } = written;
  const isRibbon = ['primvars:normals', 'normals'].some((name) => numbersAt(prim, name, context.startCode));
  const { curves, steps, sides } = bounded(context, prim, all, isRibbon);
  const sampled = sampleCurves(curves, curves.kind.basis === 'linear' ? 1 : steps);
  const samples = sampled.flatMap((curve) => curve.samples.map((sample) => ({ ...sample, curve: curve.index })));
  let first = 0;
  const runs = sampled.map(({ samples: { length: count }, closed }) => {
    first += count;
    return { first: first - count, count, closed };
  });
  const counts = elementCounts(all, start.length / 3);
  const { counts: faceCounts, indices, sampleOfPoint } = isRibbon ? ribbonFaces(runs) : tubeFaces(runs, sides);
  const read = (names: readonly string[], size: number, fallback: ElementInterpolation, time: TimeCode) => {
    const found = elementValues(context, prim, { names, size, counts, fallback, time });
    return found && onSamples(found, size, samples);
  };
  return {
    faceCounts,
    faceIndices: indices,
    at: (time) => {
      const vertices = { interpolation: 'vertex', values: numbersAt(prim, 'points', time) ?? start } as const;
      const centres = onSamples(vertices, 3, samples);
      const widths = read(['primvars:widths', 'widths'], 1, 'vertex', time);
      const radii = Float64Array.from(samples, (_, s) => Math.abs(widths ? widths[s] : DEFAULT_WIDTH) / 2);
      const facing = isRibbon && read(['primvars:normals', 'normals'], 3, 'vertex', time);
      if (!isRibbon) return tubePoints(runs, centres, radii, sides, curves.kind.basis === 'linear');
      return ribbonPoints(runs, centres, radii, facing || new Float32Array(centres.length));
    },
    valuesOf: (name, size) => {
      const values = read([name], size, 'constant', context.startCode);
      return (
        values &&
        Float32Array.from(
          { length: size * sampleOfPoint.length },
          (_, i) => values[size * sampleOfPoint[Math.floor(i / size)] + (i % size)],
        )
      );
    },
    doubleSided: isRibbon,
  };
}

/** The curves that fit, and how finely. */
function bounded(context: StageContext, prim: PrimSpec, curves: CurveArrays, isRibbon: boolean) {
  const isLinear = curves.kind.basis === 'linear';
  let [segments, kept] = [0, 0];
  const coarsest = isRibbon ? 2 : 3;
  for (; kept < curves.counts.length; kept++) {
    const more = segmentCount(curves, curves.counts[kept], kept);
    if ((segments + more + 3 * (kept + 1)) * coarsest > MAX_SURFACE_POINTS) break;
    segments += more;
  }
  if (kept < curves.counts.length)
    report(
      context,
      'warning',
      'usd.strands',
      prim.path,
      msg`it has ${curves.counts.length} curves; the first ${kept} are drawn, since their surface has at most ${MAX_SURFACE_POINTS} points`,
    );
  const pointsOf = ([steps, sides]: readonly [number, number]): number =>
    (segments * (isLinear ? 1 : steps) + 3 * kept) * (isRibbon ? 2 : sides);
  const [steps, sides] =
    DIVISIONS.find((one) => pointsOf(one) <= MAX_SURFACE_POINTS) ?? DIVISIONS[DIVISIONS.length - 1];
  return { curves: { ...curves, counts: Array.from(curves.counts).slice(0, kept) }, steps, sides };
}

/** The arrays of a prim; undefined, with a diagnostic, if they do not fit each other. */
function curvesOf(
  context: StageContext,
  prim: PrimSpec,
): { start: ArrayLike<number>; curves: CurveArrays } | undefined {
  const start = numbersAt(prim, 'points', context.startCode)!;
  const counts = numbersAt(prim, 'curveVertexCounts', context.startCode) ?? [];
  let needed = 0;
  for (let i = 0; i < counts.length; i++) needed += Math.max(0, counts[i]);
  if (needed > start.length / 3) {
    const message = msg`its curveVertexCounts need ${needed} points, and it has ${start.length / 3}`;
    report(context, 'warning', 'usd.strands', prim.path, message);
    return undefined;
  }
  return {
    start,
    curves: { counts, kind: prim.typeName === 'NurbsCurves' ? nurbsKind(context, prim) : basisKind(prim) },
  };
}

function basisKind(prim: PrimSpec): CurveKind {
  const text = (name: string): string | undefined => textAt(prim, name, undefined);
  const [type, basis, wrap] = [text('type'), text('basis'), text('wrap')];
  return {
    basis: type === 'linear' ? 'linear' : basis === 'bspline' || basis === 'catmullRom' ? basis : 'bezier',
    wrap: wrap === 'periodic' || wrap === 'pinned' ? wrap : 'nonperiodic',
  };
}

function nurbsKind(context: StageContext, prim: PrimSpec): CurveKind {
  const at = (name: string): ArrayLike<number> => numbersAt(prim, name, context.startCode) ?? [];
  const weights = numbersAt(prim, 'pointWeights', context.startCode);
  return { basis: 'nurbs', knots: at('knots'), orders: at('order'), ranges: at('ranges'), weights };
}

function elementCounts(curves: CurveArrays, vertices: number): ElementCounts {
  let varying = 0;
  for (let i = 0; i < curves.counts.length; i++) {
    const count = Math.max(0, curves.counts[i]);
    varying += varyingCount(curves, count, segmentCount(curves, count, i));
  }
  return { constant: 1, uniform: curves.counts.length, varying, vertex: vertices };
}

/** Values at samples: by the basis for vertex values, straight between those of the ends of a segment for varying ones. */
function onSamples(
  { interpolation, values }: ElementValues,
  size: number,
  samples: readonly (SampledCurve['samples'][number] & { readonly curve: number })[],
): Float64Array {
  const out = new Float64Array(size * samples.length);
  samples.forEach(({ vertices, weights, varying: [a, b, t], curve }, s) => {
    for (let k = 0; k < size; k++) {
      const at = (i: number): number => values[size * i + k] ?? 0;
      out[size * s + k] =
        interpolation === 'vertex'
          ? vertices.reduce((sum, v, j) => sum + weights[j] * at(v), 0)
          : interpolation === 'varying'
            ? at(a) * (1 - t) + at(b) * t
            : at(interpolation === 'uniform' ? curve : 0);
    }
  });
  return out;
}
