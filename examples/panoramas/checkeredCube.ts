import type { Texture } from '../../src/scene/types.ts';
import { Canvas } from '../kit/paint.ts';

/** Side of a face, its squares in a row [px]. */
const [FACE, FIELDS] = [512, 8];
const LIGHT = '#efe9dc';
/** Colours of the faces, as the picture has them: right, left and up, above down, ahead and behind. Both sides are alike, so that halves can be compared. */
const COLORS = ['#a8443a', '#a8443a', '#3d62a8', '#4a4f57', '#b98a2e', '#2f7a55'];

/** The inside of a cube with checkered faces: test scene of Mantiuk et al. 2004 (docs/physics.md §14). */
export function checkeredCube(): Texture {
  const canvas = new Canvas(3 * FACE, 2 * FACE, LIGHT);
  for (const [face, color] of COLORS.entries())
    canvas.squares(FACE * (face % 3), FACE * Math.floor(face / 3), FIELDS, FACE / FIELDS, color);
  return canvas.texture('checkered-cube');
}
