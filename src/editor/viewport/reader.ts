import { skyDoppler } from '../../reference/falseColor.ts';
import type { PickResult } from '../../render/settings.ts';
import { luminanceOf } from '../../scene/gauge.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view.ts';
import type { FalseColor } from '../../spectrum/falseColor.ts';
import { emittedWavelength } from '../../spectrum/spectralBands.ts';
import { legend, type Place, placeToRead, type Reading } from '../state/legend.ts';

/** Between two readings [ms]. */
const INTERVAL = 80;

/** What can be asked of a picture that is shown. */
export interface Readable {
  readonly viewPoint: ViewPoint;
  readonly settings: RenderSettings;
  readonly width: number;
  readonly height: number;
  readonly pick: (x: number, y: number) => Promise<PickResult | undefined>;
}

/** Reads, for the legend, the number behind the colour at the place that is pointed at: when that or the picture changes, and without anybody waiting. */
export class Reader {
  #known = '';
  #busy = false;
  #since = Number.NEGATIVE_INFINITY;

  /** `now` [ms]. Gives what is being read, for those who would wait for it. */
  follow(shown: Readable, now: number): Promise<void> | undefined {
    const place = placeToRead(legend.getState());
    const what = JSON.stringify([place, shown]);
    if (what === this.#known || this.#busy || now - this.#since < INTERVAL) return undefined;
    this.#known = what;
    this.#since = now;
    if (place) return this.#read(shown, place);
    legend.setState({ reading: undefined });
    return undefined;
  }

  async #read(shown: Readable, [x, y]: Place): Promise<void> {
    const { width, height, settings } = shown;
    const [column, row] = [pixelAt(x, width), pixelAt(y, height)];
    this.#busy = true;
    try {
      const found = await shown.pick(column, row);
      const kind = settings.falseColors?.kind;
      const still = legend.getState().colors?.kind === kind;
      legend.setState({ reading: found && kind && still ? readingOf(kind, found, shown, column, row) : undefined });
    } finally {
      this.#busy = false;
    }
  }
}

const pixelAt = (share: number, size: number): number => Math.min(size - 1, Math.max(0, Math.floor(share * size)));

function readingOf(kind: FalseColor, found: PickResult, shown: Readable, column: number, row: number): Reading {
  const { viewPoint, settings, width, height } = shown;
  const { surface, light } = found;
  const path = surface?.path;
  const D = surface?.doppler ?? skyDoppler(viewPoint, settings, column + 0.5, row + 0.5, width, height);
  switch (kind) {
    case 'doppler':
      return { value: D, path };
    case 'band':
      return { value: emittedWavelength(D), path };
    case 'emission-time':
      return { value: surface ? surface.emissionTime - viewPoint.t : Number.NaN, path };
    case 'radiance':
      return { value: luminanceOf(...light), path };
  }
}
