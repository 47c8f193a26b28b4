/** `bilinear` splits faces as Catmull–Clark, `linear` as Loop, both without smoothing. */
export type SubdivisionScheme = 'catmullClark' | 'loop' | 'bilinear' | 'linear';

export const splitsTriangles = (scheme: SubdivisionScheme): boolean => scheme === 'loop' || scheme === 'linear';
export const isLinear = (scheme: SubdivisionScheme): boolean => scheme === 'bilinear' || scheme === 'linear';

/** Number of faces after `levels` levels; `corners`: total number of face corners. */
export const facesAfter = (corners: number, scheme: SubdivisionScheme, levels: number): number =>
  splitsTriangles(scheme) ? (corners / 3) * 4 ** levels : corners * 4 ** (levels - 1);
