import { msg } from '../../../../messages/message.ts';
import { gatherPoints, makeMesh } from '../../../../scene/mesh/makeMesh.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numbersAt, sampleTimes } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { countOf } from '../../layer/storedArray.ts';
import type { StageContext } from '../context.ts';
import type { Deformation, PrimGeometry } from '../geometry/primGeometry.ts';
import type { PrimMaterials } from '../materials/materialBinding.ts';
import { curveStrand } from './curves.ts';
import { pointStrand } from './points.ts';
import type { Strand } from './strand.ts';

/** Attributes that shape points and curves over time. */
const SHAPING = ['points', 'widths', 'primvars:widths', 'normals', 'primvars:normals'];

/** Points, BasisCurves or NurbsCurves as a mesh: spheres, tubes or ribbons; undefined, with a diagnostic, if there is nothing to draw. */
export function strandGeometry(
  context: StageContext,
  prim: PrimSpec,
  surface: PrimMaterials,
): PrimGeometry | undefined {
  const points = numbersAt(prim, 'points', context.startCode);
  const strand = points && (prim.typeName === 'Points' ? pointStrand(context, prim) : curveStrand(context, prim));
  if (!strand || strand.faceCounts.length === 0) {
    const message = msg`there is nothing to draw in these ${prim.typeName}; they are left out`;
    report(context, 'warning', 'usd.empty-mesh', prim.path, message);
    return undefined;
  }
  const { base } = surface;
  const start = strand.at(context.startCode);
  const colors = base.colors && strand.valuesOf(`primvars:${base.colors.name}`, 3);
  const uvs = strand.valuesOf(`primvars:${base.uv?.name ?? 'st'}`, 2);
  const { mesh, pointOfVertex } = makeMesh({
    points: start.points,
    faceCounts: strand.faceCounts,
    faceIndices: strand.faceIndices,
    normals: { per: 'point', values: start.normals },
    ...(colors
      ? { colors: { per: 'point', values: colors } }
      : base.colors && { colors: { per: 'constant', values: Float32Array.from(base.colors.fallback) } }),
    ...(uvs && { uvs: { per: 'point', values: uvs } }),
    faceMaterials: new Uint32Array(strand.faceCounts.length).fill(base.index),
    doubleSided: strand.doubleSided,
  });
  const deformation = deformationOf(context, prim, strand, pointOfVertex);
  return deformation ? { mesh, deformation } : { mesh };
}

const timesOf = (prim: PrimSpec): number[] =>
  [...new Set(SHAPING.flatMap((name) => [...sampleTimes(attributeOf(prim, name))]))].sort((a, b) => a - b);

function deformationOf(
  context: StageContext,
  prim: PrimSpec,
  strand: Strand,
  pointOfVertex: Uint32Array,
): Deformation | undefined {
  const at = (time: number) => {
    const { points, normals } = strand.at(time);
    return { positions: gatherPoints(points, pointOfVertex), normals: gatherPoints(normals, pointOfVertex) };
  };
  const times = strand.times ?? timesOf(prim);
  if (times.length === 0) return undefined;
  const count = numbersAt(prim, 'points', context.startCode)!.length;
  const samples = attributeOf(prim, 'points')?.timeSamples;
  if (samples && !samples.values.every((value) => countOf(value) === count)) {
    const message = msg`the number of its points changes with time; it is held at the start`;
    report(context, 'warning', 'usd.topology', prim.path, message);
    return undefined;
  }
  const moves = { times: Float64Array.from(times), at };
  const velocities = attributeOf(prim, 'velocities')?.timeSamples;
  const { pointOf } = strand;
  const fits =
    velocities?.times.length === times.length && velocities.values.every((value) => countOf(value) === count);
  if (!context.cubic || !pointOf || !fits) return moves;
  const mover = pointOfVertex.map((point) => pointOf[point]);
  return { ...moves, velocitiesAt: (time) => gatherPoints(numbersAt(prim, 'velocities', time)!, mover) };
}
