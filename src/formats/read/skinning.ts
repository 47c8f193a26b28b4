/** Skin weights: `perPoint` joints per point, weights not normalized. */
export interface SkinInfluences {
  readonly perPoint: number;
  readonly joints: ArrayLike<number>;
  readonly weights: ArrayLike<number>;
}

/**
 * Linear blend skinning: out = Σ w M over the joints of one point.
 *
 * @param matrices `size` numbers for each joint
 */
export function blendMatrices(
  out: Float64Array | number[],
  matrices: Float64Array,
  size: number,
  { perPoint, joints, weights }: SkinInfluences,
  point: number,
): void {
  for (let k = 0; k < size; k++) out[k] = 0;
  for (let i = point * perPoint; i < (point + 1) * perPoint; i++) {
    const w = weights[i];
    if (w === 0) continue;
    const from = joints[i] * size;
    for (let k = 0; k < size; k++) out[k] += w * matrices[from + k];
  }
}
