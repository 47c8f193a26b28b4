import { addScaled, scale, type Vec3, ZERO } from '../math/vec3.ts';
import { observerDoppler } from '../physics/optics/doppler.ts';
import { sceneNightSky } from '../scene/lights/sceneLights.ts';
import { cosmicBackground } from '../scene/stars/cosmicBackground.ts';
import { pointSpread } from '../scene/stars/pointSpread.ts';
import { projectStars } from '../scene/stars/projectStars.ts';
import type { NightSky } from '../scene/types.ts';
import { isLuminous } from '../scene/views/views.ts';
import type { SpacetimeRay } from './acceleration/ray.ts';
import { nearestHit, type TracedScene } from './intersection/tracedScene.ts';
import type { ImageTile, TileRequest } from './tileRequest.ts';
import { coverage } from './transport/transmittance.ts';

interface StarSprite {
  readonly x: number;
  readonly y: number;
  readonly half: number;
  readonly light: Vec3;
}

/** Linear sRGB radiance of the stars and the cosmic background at a point of the picture [px from its top left], attenuated along its ray. */
export type StarField = (ray: SpacetimeRay, x: number, y: number) => Vec3;

/** The stars of a tile; undefined if the scene has no night sky. Stars are points, spread over a few pixels as in the rasterizer. */
export function starField(scene: TracedScene, request: TileRequest, tile: ImageTile): StarField | undefined {
  const sky = sceneNightSky(scene.scene);
  if (!sky) return undefined;
  const stars = starsNear(sky, request, tile);
  const { view, settings } = request;
  const background = (ray: SpacetimeRay): Vec3 => {
    // Modes without spectra have no light that is invisible at rest.
    if (settings.colors !== 'spectral') return ZERO;
    const D = isLuminous(settings) ? observerDoppler(ray.dx, view.u) : 1;
    return scale(cosmicBackground(D, settings), sky.gain);
  };
  return (ray, x, y) => {
    let sum = background(ray);
    for (const star of stars) {
      const [dx, dy] = [x - star.x, y - star.y];
      if (Math.abs(dx) < star.half && Math.abs(dy) < star.half)
        sum = addScaled(sum, star.light, pointSpread(Math.hypot(dx, dy)));
    }
    return sum[0] + sum[1] + sum[2] > MIN_RADIANCE ? scale(sum, transmittanceToCamera(scene, ray)) : ZERO;
  };
}

/** No picture shows less radiance than this. */
const MIN_RADIANCE = 1e-12;

function starsNear(
  sky: NightSky,
  { view, settings, width, height }: TileRequest,
  tile: ImageTile,
): readonly StarSprite[] {
  const capacity = 3 * sky.stars.temperatures.length;
  const [positions, radiances] = [new Float32Array(capacity), new Float32Array(capacity)];
  const count = projectStars(sky, view, settings, width, height, { positions, radiances });
  const near: StarSprite[] = [];
  for (let k = 0; k < 3 * count; k += 3) {
    const [x, y, half] = [((positions[k] + 1) / 2) * width, ((1 - positions[k + 1]) / 2) * height, positions[k + 2]];
    if (x + half > tile.x0 && x - half < tile.x1 && y + half > tile.y0 && y - half < tile.y1)
      near.push({ x, y, half, light: [radiances[k], radiances[k + 1], radiances[k + 2]] });
  }
  return near;
}

/** The fraction of background light that passes all visible sides. */
function transmittanceToCamera(scene: TracedScene, ray: SpacetimeRay): number {
  let transmitted = 1;
  const hidden = nearestHit(scene, ray, {
    any: true,
    visibleSides: true,
    accepts: (hit) => {
      const opacity = coverage(scene, hit);
      transmitted *= 1 - opacity;
      return opacity >= 1;
    },
  });
  return hidden ? 0 : transmitted;
}
