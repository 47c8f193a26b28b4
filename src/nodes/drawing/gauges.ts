import { AOVS_OF, falseValues } from '../../reference/falseColor.ts';
import { GAUGE, type Gauge, gaugePixel } from '../../scene/gauge.ts';
import { isFinished } from '../../scene/plan.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view.ts';
import type { FalseColor } from '../../spectrum/falseColor.ts';
import type { PicturePainter, Size } from './painter.ts';

/** Measures pictures where the page measures them, so that exposures and scales are the same. */
export class Gauges {
  private readonly painter: PicturePainter;
  private readonly size: Size;

  constructor(painter: PicturePainter, size: Size) {
    this.painter = painter;
    this.size = size;
  }

  /** What false colours of a kind stand for; `radiance`: the light that the metering works on. */
  async read(view: ViewPoint, settings: RenderSettings, kind: FalseColor): Promise<Gauge> {
    const { painter, size } = this;
    if (painter.measure) return painter.measure(view, settings);
    const { plan, ...plain } = settings;
    const lit = kind !== 'radiance' || isFinished(plan) ? plain : settings;
    const request = { view, settings: lit, samples: 1, pixels: false, aovs: AOVS_OF[kind] };
    const { aovs } = await painter.paint(request);
    const at = (of: FalseColor) =>
      AOVS_OF[of].every((name) => aovs.has(name))
        ? atPlaces(falseValues(of, { aovs, view, settings: lit, ...size }), size)
        : new Float32Array();
    return { luminance: at('radiance'), doppler: at('doppler'), time: at('emission-time') };
  }
}

/** Of values of all pixels. */
const atPlaces = (values: Float32Array, { width, height }: Size): Float32Array =>
  Float32Array.from(
    { length: GAUGE * GAUGE },
    (_, i) => values[gaugePixel(Math.floor(i / GAUGE), height) * width + gaugePixel(i % GAUGE, width)]!,
  );
