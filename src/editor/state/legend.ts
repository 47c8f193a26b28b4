import { createStore } from 'zustand/vanilla';
import type { FalseColors } from '../../spectrum/falseColor.ts';
import { loadPreferences, savePreferences } from './preferences.ts';

/** A place of the picture, 0 … 1 from its left and from its top. */
export type Place = readonly [x: number, y: number];

/** What is read at a place: the number that the colours stand for, and of what. */
export interface Reading {
  /** Not a number: there is nothing of the kind. */
  readonly value: number;
  /** Prim path; undefined: the sky. */
  readonly path: string | undefined;
}

/** The legend of false colours, and the value that is pointed at; it changes by itself, as the picture does. */
export interface LegendState {
  /** Of the picture that is shown. */
  readonly colors?: FalseColors;
  readonly pointer?: Place;
  /** The value in the middle is told, whatever is pointed at: for those without a pointer, and to read while flying. */
  readonly crosshair: boolean;
  readonly reading?: Reading;
  /** Whether it lies over the picture, and so is in saved ones. */
  readonly shown: boolean;
}

export const legend = createStore<LegendState>(() => ({ crosshair: false, shown: true }));

/** Says what the colours of the picture mean now. */
export function showColors(colors: FalseColors | undefined): void {
  const { colors: before, reading } = legend.getState();
  if (before?.kind === colors?.kind && before?.from === colors?.from && before?.to === colors?.to) return;
  legend.setState({ colors, reading: before?.kind === colors?.kind ? reading : undefined });
}

export const pointAt = (pointer: Place | undefined): void => legend.setState({ pointer });
/** Where the legend is hidden it comes with the crosshair, whose value it tells. */
export const toggleCrosshair = (): void =>
  legend.setState(({ crosshair, shown }) => ({ crosshair: !crosshair || !shown, shown: true }));

/** Kept for the next visit. */
export function showLegend(shown: boolean): void {
  legend.setState({ shown, ...(!shown && { crosshair: false }) });
  savePreferences({ ...loadPreferences(), legend: shown });
}

/** Where a value is to be read; undefined: nowhere. */
export const placeToRead = ({ colors, pointer, crosshair, shown }: LegendState): Place | undefined =>
  colors && shown ? (crosshair ? [0.5, 0.5] : pointer) : undefined;
