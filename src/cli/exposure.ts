import { eased, exposureFor, type Metering } from '../nodes/metering.ts';
import { GAUGE, gaugePixel, luminanceOf } from '../scene/gauge.ts';
import { isFinished } from '../scene/plan.ts';
import type { Painter, PictureRequest } from './painter.ts';
import type { Size } from './parse.ts';

/** Sets the exposure of one picture after another, as an eye would that follows them: each by its own light, eased over the scene's time. */
export class ExposureMeter {
  private readonly painter: Painter;
  private readonly metering: Metering;
  private readonly size: Size;
  private last: { readonly t: number; readonly exposure: number } | undefined;

  constructor(painter: Painter, metering: Metering, size: Size) {
    this.painter = painter;
    this.metering = metering;
    this.size = size;
  }

  /** The exposure that the metering sets for a picture [EV]. */
  async read(request: PictureRequest): Promise<number> {
    const { metering, size, last } = this;
    if (metering === 'manual') return 0;
    const { view } = request;
    const { plan, ...plain } = request.settings;
    const settings = isFinished(plan) ? plain : request.settings;
    const { aovs } = await this.painter.paint({ ...request, settings, samples: 1, pixels: false, aovs: ['beauty'] });
    const luminance = atPlaces(aovs.get('beauty')!, size);
    const target = exposureFor(metering, { luminance }, view, settings, size.width / size.height);
    const exposure = last ? eased(last.exposure, target, Math.abs(view.t - last.t)) : target;
    this.last = { t: view.t, exposure };
    return exposure;
  }
}

/** Of linear light, three values per pixel. */
function atPlaces(beauty: Float32Array, { width, height }: Size): Float32Array {
  return Float32Array.from({ length: GAUGE * GAUGE }, (_, i) => {
    const pixel = 3 * (gaugePixel(Math.floor(i / GAUGE), height) * width + gaugePixel(i % GAUGE, width));
    return luminanceOf(beauty[pixel]!, beauty[pixel + 1]!, beauty[pixel + 2]!);
  });
}
