/** Size of a picture [px]. */
export interface PictureSize {
  /** [px] */
  readonly width: number;
  /** [px] */
  readonly height: number;
}
