import { toHalf } from '../../../src/math/half.ts';
import { random } from '../../../src/math/random.ts';
import { addScaled, cross, scale, type Vec3 } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import type { SceneRenderer } from '../../../src/render/renderer.ts';
import { directionFromLatLong } from '../../../src/scene/lights/latLong.ts';
import type { DomeLight, RadianceTexture } from '../../../src/scene/types.ts';
import { lookAtOrientation } from '../../../src/scene/view/camera.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { GREY, lit } from '../../support/lightKit.ts';

// Panoramas and flights in them: for Dawn, and for WebGL2 in a page.

/** Of pictures [px]. */
export const [W, H] = [160, 90];
/** Of panoramas: at rest a pixel covers two of their texels. */
export const [COLUMNS, ROWS] = [1024, 512];

/** Rows, and columns, that shine, one texel wide. */
export const LINES = [64, 128, 192, 256, 320, 384];

/** Something at every place, without edges. */
export const ripples = ([x, y, z]: Vec3): number =>
  0.5 + 0.2 * Math.sin(9 * x + 4 * y) + 0.2 * Math.sin(13 * z - 7 * y);

/** By (row, column). */
const CONTENTS = {
  noise: noise(),
  parallels: (y: number) => (LINES.includes(y) ? 1 : 0),
  // The flight is along −Z, which is the panorama's edge.
  meridians: (_y: number, x: number) => (LINES.includes(x) ? 1 : 0),
  ripples: (y: number, x: number) => ripples(directionFromLatLong((x + 0.5) / COLUMNS, 1 - (y + 0.5) / ROWS)),
};

/** Noise of four octaves: cells of 1, 4, 16 and 64 texels. */
function noise(): (y: number, x: number) => number {
  const next = random(7);
  const octaves = [1, 4, 16, 64].map((cell) => {
    const values = Float64Array.from({ length: (COLUMNS / cell) * (ROWS / cell) }, next);
    return (y: number, x: number) => values[Math.floor(y / cell) * (COLUMNS / cell) + Math.floor(x / cell)];
  });
  return (y, x) => octaves.reduce((sum, octave) => sum + octave(y, x), 0) / 4;
}

export interface PanoramaFlight {
  readonly content: keyof typeof CONTENTS;
  /** [c] */
  readonly beta: number;
  /** Of the flight, of the world. */
  readonly along: Vec3;
  /** The middle of the picture, of the observer's frame. */
  readonly forward: Vec3;
  readonly up: Vec3;
  /** [rad] */
  readonly fovY?: number;
  /** n × n a pixel; absent: one. */
  readonly samples?: number;
}

export const panorama = (content: PanoramaFlight['content']): DomeLight & { readonly texture: RadianceTexture } => ({
  kind: 'dome',
  path: '/dome',
  color: [1, 1, 1],
  texture: {
    name: content,
    width: COLUMNS,
    height: ROWS,
    data: Uint16Array.from({ length: 4 * COLUMNS * ROWS }, (_, i) => {
      const pixel = i >> 2;
      return toHalf(i % 4 === 3 ? 1 : CONTENTS[content](Math.floor(pixel / COLUMNS), pixel % COLUMNS));
    }),
    colorSpace: 'linear',
    filter: 'linear',
    wrapS: 'repeat',
    wrapT: 'clamp',
  },
});

/** Places alone: without shift and beaming. */
export const SETTINGS: RenderSettings = { ...GREY, grid: false, beaming: 0 };

export const viewOf = ({ beta, along, forward, up, fovY = Math.PI / 3 }: PanoramaFlight): ViewPoint => ({
  t: 0,
  position: [0, 0, 0],
  u: properVelocity(scale(along, beta)),
  orientation: lookAtOrientation(forward, up),
  lens: perspective(fovY),
});

/** One channel of a picture. */
export async function drawnPanorama(renderer: SceneRenderer, flight: PanoramaFlight): Promise<number[]> {
  await renderer.setScene(lit([], [panorama(flight.content)]).scene);
  renderer.render([viewOf(flight)], SETTINGS, flight.samples ?? 1);
  return Array.from(await renderer.readAov('beauty')).filter((_, i) => i % 3 === 0);
}

/** The flight past lines that cross its plane: the middle row of the picture has directions of that plane, from 5° to 95° off the flight. */
export function pastLines(content: 'parallels' | 'meridians', beta: number): PanoramaFlight & { readonly side: Vec3 } {
  const along: Vec3 = content === 'parallels' ? [0, 1, 0] : [0, 0, -1];
  // The panorama begins at −Z and turns over −X (a quarter of its width to the left of +Z is +X).
  const side: Vec3 = content === 'parallels' ? [0.8, 0, 0.6] : [1, 0, 0];
  const middle = (50 * Math.PI) / 180;
  const forward = addScaled(scale(along, Math.cos(middle)), side, Math.sin(middle));
  return { content, beta, along, side, forward, up: cross(side, along), fovY: 1.05 };
}
