import { add, addScaled, dot, scale, type Vec3, ZERO } from '../math/vec3.ts';
import type { RenderSettings } from '../scene/view/view.ts';
import { LUMINANCE_WEIGHTS } from '../spectrum/color/observerColor.ts';
import { toneMap } from '../spectrum/display/toneMap.ts';
import type { Overlay } from './camera/groundGrid.ts';

/** A sample that is brighter than this times white, and than this times the median of its object's samples, is dimmed to that: a firefly. */
const FIREFLY = 4;

/**
 * What a pixel displays. Samples of one object are averaged before the tone curve, because curves clip and compress noise, which would darken it; those of
 * different objects, and those of the sky, afterwards, which antialiases edges of very bright ones too.
 */
export class DisplayPixel {
  private readonly objects = new Map<number, { lights: Vec3[]; bare: number }>();
  private sum: Vec3 = ZERO;
  private count = 0;
  private readonly settings: RenderSettings;

  constructor(settings: RenderSettings) {
    this.settings = settings;
  }

  /** Adds a sample's light (linear sRGB radiance) under `overlays`, the last on top; `object`: what its ray meets, undefined for the sky. */
  add(light: Vec3, object: number | undefined, overlays: readonly Overlay[]): void {
    this.count++;
    let bare = 1;
    for (const { color, cover } of overlays.toReversed()) {
      this.sum = addScaled(this.sum, color, bare * cover);
      bare *= 1 - cover;
    }
    if (object === undefined) {
      this.sum = addScaled(this.sum, this.toneMapped(light), bare);
      return;
    }
    const own = this.objects.get(object) ?? { lights: [], bare: 0 };
    own.lights.push(light);
    own.bare += bare;
    this.objects.set(object, own);
  }

  /** Linear sRGB to display, 0 … 1. */
  mean(): Vec3 {
    let sum = this.sum;
    for (const { lights, bare } of this.objects.values())
      sum = addScaled(sum, this.toneMapped(meanWithoutFireflies(lights, this.settings)), bare);
    return scale(sum, 1 / this.count);
  }

  private toneMapped(light: Vec3): Vec3 {
    return toneMap(light, this.settings.exposure, this.settings.tone);
  }
}

/** The mean of samples of light, fireflies dimmed. */
export function meanWithoutFireflies(lights: readonly Vec3[], { exposure }: Pick<RenderSettings, 'exposure'>): Vec3 {
  const white = 2 ** -exposure;
  const luminances = lights.map((light) => dot(LUMINANCE_WEIGHTS, light));
  const median = [...luminances].sort((a, b) => a - b)[lights.length >> 1];
  const limit = FIREFLY * Math.max(white, median);
  const sum = lights.reduce(
    (all, light, i) => add(all, scale(light, luminances[i] > limit ? limit / luminances[i] : 1)),
    ZERO,
  );
  return scale(sum, 1 / lights.length);
}
