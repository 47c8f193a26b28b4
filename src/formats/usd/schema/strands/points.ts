import { msg } from '../../../../messages/message.ts';
import { MAX_SPHERES, sphereFor } from '../../../read/strands/pointSpheres.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numbersAt, type TimeCode } from '../../layer/attributes.ts';
import type { NumberArray, PrimSpec } from '../../layer/layer.ts';
import { stageTimeCode } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import { elementValues } from './elementValues.ts';
import { DEFAULT_WIDTH, type Strand } from './strand.ts';

/** The Points of a prim as spheres, `widths` across. */
export function pointStrand(context: StageContext, prim: PrimSpec): Strand | undefined {
  const start = numbersAt(prim, 'points', context.startCode)!;
  const total = Math.floor(start.length / 3);
  if (total === 0) return undefined;
  // Evenly, where there are too many.
  const step = Math.ceil(total / MAX_SPHERES);
  const count = Math.ceil(total / step);
  if (step > 1)
    report(
      context,
      'warning',
      'usd.strands',
      prim.path,
      msg`it has ${total} points; one in ${step} is drawn, since at most ${MAX_SPHERES} are`,
    );
  const { points: round, triangles } = sphereFor(count);
  const corners = round.length / 3;
  const counts = { constant: 1, uniform: total, varying: total, vertex: total };
  const pointOf = Uint32Array.from({ length: count * corners }, (_, i) => step * Math.floor(i / corners));
  const flight = flightOf(context, prim);
  const widthsAt = (time: TimeCode) =>
    elementValues(context, prim, { names: ['primvars:widths', 'widths'], size: 1, counts, fallback: 'vertex', time });
  return {
    faceCounts: new Uint32Array((count * triangles.length) / 3).fill(3),
    faceIndices: Uint32Array.from(
      { length: count * triangles.length },
      (_, i) => triangles[i % triangles.length] + corners * Math.floor(i / triangles.length),
    ),
    at: (time) => {
      const centres = flight?.at(time) ?? numbersAt(prim, 'points', time) ?? start;
      const widths = widthsAt(time);
      const points = new Float32Array(3 * pointOf.length);
      const normals = new Float32Array(3 * pointOf.length);
      for (let i = 0; i < pointOf.length; i++) {
        const point = pointOf[i];
        const width = widths ? widths.values[widths.interpolation === 'constant' ? 0 : point] : DEFAULT_WIDTH;
        for (let k = 0; k < 3; k++) {
          const direction = round[3 * (i % corners) + k];
          normals[3 * i + k] = direction;
          points[3 * i + k] = (centres[3 * point + k] ?? 0) + (Math.abs(width) / 2) * direction;
        }
      }
      return { points, normals };
    },
    valuesOf: (name, size) => {
      const found = elementValues(context, prim, {
        names: [name],
        size,
        counts,
        fallback: 'constant',
        time: context.startCode,
      });
      if (!found) return undefined;
      const place = (i: number): number => (found.interpolation === 'constant' ? 0 : pointOf[i]);
      return Float32Array.from(
        { length: size * pointOf.length },
        (_, i) => found.values[size * place(Math.floor(i / size)) + (i % size)],
      );
    },
    pointOf,
    doubleSided: false,
    times: flight?.times,
  };
}

/**
 * The flight of points with one sample and velocities, as UsdGeomPointBased computes it: p + v (t − t₀), over the times of
 * the stage; undefined for others.
 */
function flightOf(
  context: StageContext,
  prim: PrimSpec,
): { readonly times: readonly number[]; at(time: TimeCode): Float64Array } | undefined {
  const samples = attributeOf(prim, 'points')?.timeSamples;
  if (samples?.times.length !== 1) return undefined;
  const [from] = samples.times;
  const [points, velocities] = ['points', 'velocities'].map((name): NumberArray => numbersAt(prim, name, from) ?? NONE);
  if (velocities.length === 0) return undefined;
  const { metadata } = context.layer;
  const [start, end] = [stageTimeCode(metadata, 'start'), stageTimeCode(metadata, 'end')];
  if (velocities.length !== points.length || start === undefined || end === undefined || !(end > start)) {
    const message = msg`its velocities are not used: they need one for each point, and a stage with startTimeCode and endTimeCode`;
    report(context, 'warning', 'usd.velocities', prim.path, message);
    return undefined;
  }
  return {
    times: [start, end],
    at: (time = from) =>
      Float64Array.from(points, (x, i) => x + (velocities[i] * (time - from)) / context.codesPerSecond),
  };
}

const NONE = new Float32Array(0);
