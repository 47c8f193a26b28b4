import { CUBE_FACES, type CubeFace, nearestCosine } from './cubeFaces.ts';
import type { PanoramicLens } from './lenses.ts';

/** The faces of the cube that a lens sees any part of. */
export function coveredFaces(lens: PanoramicLens): readonly CubeFace[] {
  if (lens.kind !== 'fisheye') return CUBE_FACES;
  const { aperture, elevation } = lens;
  const least = Math.cos(aperture / 2) + 1e-9;
  return CUBE_FACES.filter((face) => nearestCosine(face, [0, Math.sin(elevation), -Math.cos(elevation)]) > least);
}
