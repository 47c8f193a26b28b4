import { isCoarse } from '../../flight/inputDevice.ts';

/** Width of the panels beside the picture, at first [px]. */
export const SIDE_WIDTH = 308;
/** Under the picture the panels are closed to their tabs at first: they are so high [px]. */
export const SHEET_HEIGHT = isCoarse ? 48 : 32;
