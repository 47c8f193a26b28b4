import type { ImageTile } from './tileRequest.ts';

/** A part of a picture divided into squares of a side [px], row by row; those at its end may be smaller. */
export function squaresOf({ x0: left, y0: top, x1, y1 }: ImageTile, side: number): ImageTile[] {
  const squares: ImageTile[] = [];
  for (let y0 = top; y0 < y1; y0 += side)
    for (let x0 = left; x0 < x1; x0 += side)
      squares.push({ x0, y0, x1: Math.min(x0 + side, x1), y1: Math.min(y0 + side, y1) });
  return squares;
}

/** A whole picture divided into such squares. */
export const squaresOfPicture = (
  { width, height }: { readonly width: number; readonly height: number },
  side: number,
): ImageTile[] => squaresOf({ x0: 0, y0: 0, x1: width, y1: height }, side);
