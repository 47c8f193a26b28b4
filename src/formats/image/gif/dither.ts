import { CHANNEL_WEIGHTS, nearestColor, type Palette } from './palette.ts';

/** Side of the square of pixels by which a colour is mixed. */
const SIDE = 4;
const MIXED = SIDE * SIDE;
/** Ranks of the pixels of the square, 0 … 15 (Bayer 1973, "An optimum method for two-level rendition"). */
const RANKS = Uint8Array.of(0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);
/** Bits of each channel by which mixtures are remembered. */
const KEY_BITS = 7;

/**
 * Maps pixels to a palette. A colour that the palette lacks becomes a pattern of sixteen pixels whose mean is nearest to
 * it; which of them a pixel gets depends on its place alone, so that what does not change from frame to frame keeps its
 * pattern. Source: Knoll 1999, "Pattern dithering" (US patent 6,606,166, expired).
 */
export class Ditherer {
  private readonly palette: Palette;
  /** By colour: one more than the number of its mixture. */
  private readonly places = new Uint32Array(1 << (3 * KEY_BITS));
  /** Indices of each mixture, dark to bright. */
  private mixtures = new Uint8Array(MIXED * 4096);
  private known = 0;

  constructor(palette: Palette) {
    this.palette = palette;
  }

  /** Indices of the palette for RGBA8 pixels, rows from the top. */
  map(rgba: Uint8Array, width: number, out: Uint8Array): void {
    const { places } = this;
    const drop = 8 - KEY_BITS;
    for (let i = 0, j = 0, x = 0, y = 0; i < out.length; i++, j += 4) {
      const key = ((rgba[j] >> drop) << (2 * KEY_BITS)) | ((rgba[j + 1] >> drop) << KEY_BITS) | (rgba[j + 2] >> drop);
      if (places[key] === 0) {
        this.mix(rgba[j], rgba[j + 1], rgba[j + 2]);
        places[key] = this.known;
      }
      out[i] = this.mixtures[MIXED * (places[key] - 1) + RANKS[SIDE * (y % SIDE) + (x % SIDE)]];
      if (++x === width) {
        x = 0;
        y++;
      }
    }
  }

  /** Each colour is the nearest to the wanted one plus what the colours before it lack. */
  private mix(r: number, g: number, b: number): void {
    const { palette } = this;
    const chosen: number[] = [];
    let [er, eg, eb] = [0, 0, 0];
    for (let k = 0; k < MIXED; k++) {
      const nearest = nearestColor(palette, r + er, g + eg, b + eb);
      chosen.push(nearest);
      er += r - palette[3 * nearest];
      eg += g - palette[3 * nearest + 1];
      eb += b - palette[3 * nearest + 2];
    }
    chosen.sort((a, b) => brightness(palette, a) - brightness(palette, b));
    if (MIXED * (this.known + 1) > this.mixtures.length) {
      const larger = new Uint8Array(2 * this.mixtures.length);
      larger.set(this.mixtures);
      this.mixtures = larger;
    }
    this.mixtures.set(chosen, MIXED * this.known++);
  }
}

const brightness = (palette: Palette, i: number): number =>
  CHANNEL_WEIGHTS.reduce((sum, weight, k) => sum + weight * palette[3 * i + k], 0);
