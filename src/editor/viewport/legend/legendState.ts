import { createStore } from 'zustand/vanilla';
import type { FalseColorScale } from '../../../spectrum/falseColor/falseColor.ts';
import { loadPreferences, savePreferences } from '../../state/preferences.ts';

/** A position in the picture, 0 … 1 from its left and top. */
export type PicturePosition = readonly [x: number, y: number];

/** The value behind a false colour at a position, and the prim it is of. */
export interface PickedValue {
  /** NaN where the quantity is undefined. */
  readonly value: number;
  /** Prim path; undefined for the sky. */
  readonly path: string | undefined;
}

/** The legend of false colours with the picked value, which changes with the picture. */
export interface LegendState {
  /** Colour scale of the displayed picture. */
  readonly colors?: FalseColorScale;
  readonly pointer?: PicturePosition;
  /**
   * Whether the value at the center is shown instead of that at the pointer: without a pointing device, or while
   * flying.
   */
  readonly crosshair: boolean;
  readonly picked?: PickedValue;
  /** Whether it is shown, and so drawn into saved pictures. */
  readonly visible: boolean;
}

export const legendStore = createStore<LegendState>(() => ({ crosshair: false, visible: true }));

/** Sets the colour scale of the displayed picture. */
export function setLegendColors(colors: FalseColorScale | undefined): void {
  const { colors: before, picked } = legendStore.getState();
  if (before?.kind === colors?.kind && before?.from === colors?.from && before?.to === colors?.to) return;
  legendStore.setState({ colors, picked: before?.kind === colors?.kind ? picked : undefined });
}

export const setPointer = (pointer: PicturePosition | undefined): void => legendStore.setState({ pointer });
/** Turning the crosshair on also shows the legend, which displays its value. */
export const toggleCrosshair = (): void =>
  legendStore.setState(({ crosshair, visible: shown }) => ({ crosshair: !crosshair || !shown, visible: true }));

/** Saved as a preference. */
export function setLegendVisible(shown: boolean): void {
  legendStore.setState({ visible: shown, ...(!shown && { crosshair: false }) });
  savePreferences({ ...loadPreferences(), legend: shown });
}

/** Position at which to pick; undefined: none. */
export const pickPosition = ({
  colors,
  pointer,
  crosshair,
  visible: shown,
}: LegendState): PicturePosition | undefined => (colors && shown ? (crosshair ? [0.5, 0.5] : pointer) : undefined);
