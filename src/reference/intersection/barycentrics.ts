/** Upper bound of the rounding tolerance, as a fraction of the longest edge. */
const MAX_SLACK = 1e-6;
/** A triangle is degenerate where sin² of the angle between two edges is not above this. */
const MIN_SIN_SQUARED = 1e-28;

/** Tests whether a point in the plane of a triangle is inside it, and computes its barycentric weights. */
export class BarycentricTest {
  /** The three corners, relative to the point [m]. */
  readonly q = new Float64Array(9);
  /** Weights of the second and third corners; 0 … 1. */
  v = 0;
  w = 0;

  /**
   * Whether the point is inside. Points outside by no more than the rounding error count as inside, so that no ray slips between two triangles
   * that share an edge. The error is `noise`, that of positions [m], and more at grazing incidence: `speed` is that of the ray relative to the
   * triangle, `across` its component across the plane.
   */
  contains(noise: number, speed: number, across: number): boolean {
    const q = this.q;
    const ex = q[3] - q[0];
    const ey = q[4] - q[1];
    const ez = q[5] - q[2];
    const fx = q[6] - q[0];
    const fy = q[7] - q[1];
    const fz = q[8] - q[2];
    const nx = ey * fz - ez * fy;
    const ny = ez * fx - ex * fz;
    const nz = ex * fy - ey * fx;
    const n2 = nx * nx + ny * ny + nz * nz;
    const e2 = ex * ex + ey * ey + ez * ez;
    const f2 = fx * fx + fy * fy + fz * fz;
    if (!(n2 > MIN_SIN_SQUARED * e2 * f2)) return false;
    const g2 = (fx - ex) ** 2 + (fy - ey) ** 2 + (fz - ez) ** 2;
    const slack = Math.min(noise * (1 + speed / across), MAX_SLACK * Math.sqrt(Math.max(e2, f2, g2)));
    const h0 = this.edgeFunction(3, 6, nx, ny, nz);
    const h1 = this.edgeFunction(6, 0, nx, ny, nz);
    const h2 = this.edgeFunction(0, 3, nx, ny, nz);
    const least = -slack * Math.sqrt(n2);
    if (h0 < least * Math.sqrt(g2) || h1 < least * Math.sqrt(f2) || h2 < least * Math.sqrt(e2)) return false;
    const sum = Math.max(0, h0) + Math.max(0, h1) + Math.max(0, h2);
    this.v = Math.max(0, h1) / sum;
    this.w = Math.max(0, h2) / sum;
    return true;
  }

  /** N·(q_i × q_j): twice the signed area of the triangle of the point and an edge, times |N|. */
  private edgeFunction(i: number, j: number, nx: number, ny: number, nz: number): number {
    const q = this.q;
    return (
      nx * (q[i + 1] * q[j + 2] - q[i + 2] * q[j + 1]) +
      ny * (q[i + 2] * q[j] - q[i] * q[j + 2]) +
      nz * (q[i] * q[j + 1] - q[i + 1] * q[j])
    );
  }
}
