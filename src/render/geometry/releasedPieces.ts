/** Number of pictures after which what they have not shown is released. */
const UNSEEN_PICTURES = 16;

/** Finds which of some things that take turns have not been in the picture for a while, so that their memory on the GPU can be freed. */
export class ReleasedPieces<T> {
  private readonly pieces: readonly T[];
  private readonly lastSeen = new Map<T, number>();
  private pictures = 0;

  constructor(pieces: readonly T[]) {
    this.pieces = pieces;
  }

  /** Those that have been in a picture and are not released. */
  get kept(): readonly T[] {
    return [...this.lastSeen.keys()];
  }

  /** Takes what the next picture shows; returns what is to be released. */
  next(isVisible: (piece: T) => boolean): readonly T[] {
    this.pictures++;
    for (const piece of this.pieces) if (isVisible(piece)) this.lastSeen.set(piece, this.pictures);
    const released: T[] = [];
    for (const [piece, seen] of this.lastSeen) if (this.pictures - seen >= UNSEEN_PICTURES) released.push(piece);
    for (const piece of released) this.lastSeen.delete(piece);
    return released;
  }
}
