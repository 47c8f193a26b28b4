import type { PictureRequest } from '../../pipelines/pictureRenderer.ts';
import type { MeteringMode } from '../../scene/settings/settings.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { adaptExposure, exposureForMetering } from './metering.ts';
import type { PictureMeter } from './pictureMeter.ts';

/** Sets the exposure of consecutive pictures like an adapting eye: metered per picture, eased over scene time. */
export class ExposureMeter {
  private readonly meter: PictureMeter;
  private readonly metering: MeteringMode;
  private readonly size: PictureSize;
  private last: { readonly t: number; readonly exposure: number } | undefined;

  constructor(meter: PictureMeter, metering: MeteringMode, size: PictureSize) {
    this.meter = meter;
    this.metering = metering;
    this.size = size;
  }

  /** Metered exposure of a picture [EV]. */
  async read({ views, settings }: PictureRequest): Promise<number> {
    const { metering, size, last } = this;
    if (metering === 'manual') return 0;
    const readings = await this.meter.read(views, settings, 'radiance');
    const target = exposureForMetering(metering, readings, views, settings, size);
    const [{ t }] = views;
    const exposure = last ? adaptExposure(last.exposure, target, Math.abs(t - last.t)) : target;
    this.last = { t, exposure };
    return exposure;
  }
}
