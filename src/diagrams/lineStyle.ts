export type ColorScheme = 'light' | 'dark';

/**
 * Colours that stay distinct with all types of colour blindness (Okabe and Ito 2008), in brightnesses for a light and a
 * dark background; dashes distinguish them without colour.
 */
const COLORS = {
  light: ['#0072b2', '#d55e00', '#00805e', '#b0538b', '#8a6100', '#3a3f47'],
  dark: ['#56b4e9', '#e69f00', '#2fc79b', '#e08bb9', '#f0e442', '#c9cfd8'],
} as const;
const DASHES: readonly (readonly number[])[] = [[], [7, 3], [2, 3], [10, 3, 2, 3], [4, 4], [12, 4]];

/** Colour and dash pattern of the n-th line. */
export const lineStyle = (
  n: number,
  scheme: ColorScheme,
): { readonly color: string; readonly dash: readonly number[] } => ({
  color: COLORS[scheme][n % COLORS.light.length]!,
  dash: DASHES[n % DASHES.length]!,
});
