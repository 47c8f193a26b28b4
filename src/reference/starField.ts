import { addScaled, scale, type Vec3, ZERO } from '../math/vec3.ts';
import { observerDoppler } from '../physics/optics/doppler.ts';
import { sceneNightSky } from '../scene/lights/sceneLights.ts';
import { cosmicBackground } from '../scene/stars/cosmicBackground.ts';
import { pointSpread } from '../scene/stars/pointSpread.ts';
import { projectStars } from '../scene/stars/projectStars.ts';
import type { NightSky } from '../scene/types.ts';
import { VIEWS } from '../scene/views/views.ts';
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

/** Linear sRGB radiance of the stars and what is behind them at a point of the picture [px from its top left], as much as gets there along its ray. */
export type StarField = (ray: SpacetimeRay, x: number, y: number) => Vec3;

/** The stars of a tile; undefined where a scene has none. A star is a point: it is spread over a few pixels as the rasterizer spreads it. */
export function starField(scene: TracedScene, request: TileRequest, tile: ImageTile): StarField | undefined {
  const sky = sceneNightSky(scene.scene);
  if (!sky) return undefined;
  const stars = starsNear(sky, request, tile);
  const { view, settings } = request;
  const behind = (ray: SpacetimeRay): Vec3 => {
    // Of what is invisible at rest approximate colours know nothing.
    if (settings.colors === 'approximate') return ZERO;
    const D = VIEWS[settings.view].luminous ? observerDoppler(ray.dx, view.u) : 1;
    return scale(cosmicBackground(D, settings), sky.gain);
  };
  return (ray, x, y) => {
    let sum = behind(ray);
    for (const star of stars) {
      const [dx, dy] = [x - star.x, y - star.y];
      if (Math.abs(dx) < star.half && Math.abs(dy) < star.half)
        sum = addScaled(sum, star.light, pointSpread(Math.hypot(dx, dy)));
    }
    return sum[0] + sum[1] + sum[2] > MIN_RADIANCE ? scale(sum, transmittanceToCamera(scene, ray)) : ZERO;
  };
}

/** Less than this no picture shows. */
const MIN_RADIANCE = 1e-12;

function starsNear(
  sky: NightSky,
  { view, settings, width, height }: TileRequest,
  tile: ImageTile,
): readonly StarSprite[] {
  const room = 3 * sky.stars.temperatures.length;
  const [places, lights] = [new Float32Array(room), new Float32Array(room)];
  const count = projectStars(sky, view, settings, width, height, { positions: places, radiances: lights });
  const near: StarSprite[] = [];
  for (let k = 0; k < 3 * count; k += 3) {
    const [x, y, half] = [((places[k] + 1) / 2) * width, ((1 - places[k + 1]) / 2) * height, places[k + 2]];
    if (x + half > tile.x0 && x - half < tile.x1 && y + half > tile.y0 && y - half < tile.y1)
      near.push({ x, y, half, light: [lights[k], lights[k + 1], lights[k + 2]] });
  }
  return near;
}

/** What of the light from behind everything gets past the sides that are shown. */
function transmittanceToCamera(scene: TracedScene, ray: SpacetimeRay): number {
  let share = 1;
  const hidden = nearestHit(scene, ray, {
    visibleSides: true,
    accepts: (hit) => {
      const held = coverage(scene, hit);
      share *= 1 - held;
      return held >= 1;
    },
  });
  return hidden ? 0 : share;
}
