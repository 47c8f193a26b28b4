import { fillsPicture } from '../../scene/view/lenses/lensChoice.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { PictureViews } from '../../scene/view/pictureViews.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';

/** What a file of a picture says about the sphere of directions, so that 360° players recognise it; undefined where there is no mark for its lens, or it has a legend beside it. */
export function sphericalFileOf(views: PictureViews, size: PictureSize): SphericalPicture | undefined {
  const [view, ...others] = views;
  if (others.length > 0 || view.viewport || !fillsPicture(view.lens, size)) return undefined;
  const { lens } = view;
  if (lens.kind === 'equirectangular') return { projection: 'equirectangular', stereo: 'none' };
  if (lens.kind === 'stereo') return { projection: 'equirectangular', stereo: 'top-bottom' };
  return lens.kind === 'cube' && lens.layout === '3x2' ? { projection: 'cubemap', stereo: 'none' } : undefined;
}
