import { uniform } from 'three/tsl';
import { Vector2 } from 'three/webgpu';
import { CUBE_GRIDS } from '../../scene/view/lenses/cubeLens.ts';
import { filledSize, type Lens } from '../../scene/view/lenses/lenses.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';

/** The kinds of lenses, as shaders know them. */
export const LENS_NUMBERS: Readonly<Record<Lens['kind'], number>> = {
  perspective: 0,
  equirectangular: 1,
  fisheye: 2,
  cube: 3,
  stereo: 4,
};

/** The lens of the picture, but for a perspective one, of which the frustum has uniforms of its own. */
export function makeLensUniforms() {
  return {
    kind: uniform(0, 'int'),
    /** Width and height of the picture over those of the part that the lens fills. */
    scale: uniform(new Vector2(1, 1)),
    /** Of a fisheye: the angle across the circle, and that of its axis above the camera's [rad]. */
    aperture: uniform(Math.PI),
    elevation: uniform(0),
    /** Of a cube: columns and rows of faces. */
    grid: uniform(new Vector2(3, 2)),
  };
}

export type LensUniforms = ReturnType<typeof makeLensUniforms>;

export function setLensUniforms(uniforms: LensUniforms, lens: Lens, size: PictureSize): void {
  const filled = filledSize(lens, size);
  uniforms.kind.value = LENS_NUMBERS[lens.kind];
  uniforms.scale.value.set(size.width / filled.width, size.height / filled.height);
  if (lens.kind === 'fisheye') {
    uniforms.aperture.value = lens.aperture;
    uniforms.elevation.value = lens.elevation;
  } else if (lens.kind === 'cube') uniforms.grid.value.set(...CUBE_GRIDS[lens.layout]);
}
