import { createStore } from 'zustand/vanilla';
import type { FalseColorScale } from '../../../spectrum/falseColor/falseColor.ts';
import { loadPreferences, savePreferences } from '../../state/preferences.ts';

/** A place of the picture, 0 … 1 from its left and from its top. */
export type PicturePosition = readonly [x: number, y: number];

/** What is read at a place: the number that the colours stand for, and of what. */
export interface PickedValue {
  /** Not a number: there is nothing of the kind. */
  readonly value: number;
  /** Prim path; undefined: the sky. */
  readonly path: string | undefined;
}

/** The legend of false colours, and the value that is pointed at; it changes by itself, as the picture does. */
export interface LegendState {
  /** Of the picture that is shown. */
  readonly colors?: FalseColorScale;
  readonly pointer?: PicturePosition;
  /** The value in the middle is told, whatever is pointed at: for those without a pointer, and to read while flying. */
  readonly crosshair: boolean;
  readonly picked?: PickedValue;
  /** Whether it lies over the picture, and so is in saved ones. */
  readonly visible: boolean;
}

export const legendStore = createStore<LegendState>(() => ({ crosshair: false, visible: true }));

/** Says what the colours of the picture mean now. */
export function setLegendColors(colors: FalseColorScale | undefined): void {
  const { colors: before, picked } = legendStore.getState();
  if (before?.kind === colors?.kind && before?.from === colors?.from && before?.to === colors?.to) return;
  legendStore.setState({ colors, picked: before?.kind === colors?.kind ? picked : undefined });
}

export const setPointer = (pointer: PicturePosition | undefined): void => legendStore.setState({ pointer });
/** Where the legend is hidden it comes with the crosshair, whose value it tells. */
export const toggleCrosshair = (): void =>
  legendStore.setState(({ crosshair, visible: shown }) => ({ crosshair: !crosshair || !shown, visible: true }));

/** Kept for the next visit. */
export function setLegendVisible(shown: boolean): void {
  legendStore.setState({ visible: shown, ...(!shown && { crosshair: false }) });
  savePreferences({ ...loadPreferences(), legend: shown });
}

/** Where a value is to be read; undefined: nowhere. */
export const pickPosition = ({
  colors,
  pointer,
  crosshair,
  visible: shown,
}: LegendState): PicturePosition | undefined => (colors && shown ? (crosshair ? [0.5, 0.5] : pointer) : undefined);
