export type Scheme = 'light' | 'dark';

/** Colours that are told apart with every kind of colour blindness (Okabe and Ito 2008), as bright as each ground needs; dashes tell them apart without. */
const COLORS = {
  light: ['#0072b2', '#d55e00', '#00805e', '#b0538b', '#8a6100', '#3a3f47'],
  dark: ['#56b4e9', '#e69f00', '#2fc79b', '#e08bb9', '#f0e442', '#c9cfd8'],
} as const;
const DASHES: readonly (readonly number[])[] = [[], [7, 3], [2, 3], [10, 3, 2, 3], [4, 4], [12, 4]];

/** How the n-th line is drawn. */
export const lineStyle = (n: number, scheme: Scheme): { readonly color: string; readonly dash: readonly number[] } => ({
  color: COLORS[scheme][n % COLORS.light.length]!,
  dash: DASHES[n % DASHES.length]!,
});
