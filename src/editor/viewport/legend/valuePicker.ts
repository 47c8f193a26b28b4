import { skyDoppler } from '../../../reference/post/falseColor.ts';
import type { PickResult } from '../../../render/settings.ts';
import { relativeLuminance } from '../../../scene/view/metering.ts';
import type { RenderSettings, ViewPoint } from '../../../scene/view/view.ts';
import type { FalseColorQuantity } from '../../../spectrum/falseColor/falseColor.ts';
import { emittedWavelength } from '../../../spectrum/falseColor/spectralBands.ts';
import { legendStore, type PickedValue, type PicturePosition, pickPosition } from './legendState.ts';

/** Minimum interval of readings [ms]. */
const MIN_PICK_INTERVAL = 80;

/** Picking interface of a displayed picture. */
export interface PickablePicture {
  readonly viewPoint: ViewPoint;
  readonly settings: RenderSettings;
  readonly width: number;
  readonly height: number;
  readonly pick: (x: number, y: number) => Promise<PickResult | undefined>;
}

/** Reads the value at the picked position for the legend when position or picture change; asynchronous. */
export class ValuePicker {
  private known = '';
  private busy = false;
  private since = Number.NEGATIVE_INFINITY;

  /** `now` [ms]. Returns the running read, if any. */
  update(shown: PickablePicture, now: number): Promise<void> | undefined {
    const place = pickPosition(legendStore.getState());
    const what = JSON.stringify([place, shown]);
    if (what === this.known || this.busy || now - this.since < MIN_PICK_INTERVAL) return undefined;
    this.known = what;
    this.since = now;
    if (place) return this.read(shown, place);
    legendStore.setState({ picked: undefined });
    return undefined;
  }

  private async read(shown: PickablePicture, [x, y]: PicturePosition): Promise<void> {
    const { width, height, settings } = shown;
    const [column, row] = [pixelAt(x, width), pixelAt(y, height)];
    this.busy = true;
    try {
      const found = await shown.pick(column, row);
      const kind = settings.falseColors?.kind;
      const still = legendStore.getState().colors?.kind === kind;
      legendStore.setState({
        picked: found && kind && still ? pickedValueOf(kind, found, shown, column, row) : undefined,
      });
    } finally {
      this.busy = false;
    }
  }
}

const pixelAt = (share: number, size: number): number => Math.min(size - 1, Math.max(0, Math.floor(share * size)));

function pickedValueOf(
  kind: FalseColorQuantity,
  found: PickResult,
  shown: PickablePicture,
  column: number,
  row: number,
): PickedValue {
  const { viewPoint, settings, width, height } = shown;
  const { surface, light } = found;
  const path = surface?.path;
  const D = surface?.doppler ?? skyDoppler([viewPoint], { width, height }, settings, column + 0.5, row + 0.5);
  switch (kind) {
    case 'doppler':
      return { value: D, path };
    case 'band':
      return { value: emittedWavelength(D), path };
    case 'emission-time':
      return { value: surface ? surface.emissionTime - viewPoint.t : Number.NaN, path };
    case 'radiance':
      return { value: relativeLuminance(...light), path };
  }
}
