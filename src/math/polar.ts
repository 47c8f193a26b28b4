import { determinant, type Mat3 } from './mat3.ts';
import { fromMatrix, normalizeQuat, type Quat } from './quat.ts';

type Symmetric4 = number[][];

/**
 * The proper rotation R that maximises tr(RᵀM): the rotation of the polar decomposition M = R S. Defined for singular
 * matrices and mirrors too. Source: Horn 1987, "Closed-form solution of absolute orientation using unit quaternions", §4.
 */
export function closestRotation(m: Mat3): Quat {
  const scale = rotationScale(m);
  if (scale > 0) return withPositiveW(fromMatrix(scale === 1 ? m : m.map((x) => x / scale)));
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = m;
  // Rows and columns in the order w x y z, so that ties select the smallest rotation.
  const k: Symmetric4 = [
    [xx + yy + zz, zy - yz, xz - zx, yx - xy],
    [zy - yz, xx - yy - zz, xy + yx, zx + xz],
    [xz - zx, xy + yx, yy - xx - zz, yz + zy],
    [yx - xy, zx + xz, yz + zy, zz - xx - yy],
  ];
  const vectors = diagonalize(k);
  let best = 0;
  for (let i = 1; i < 4; i++) if (k[i][i] > k[best][best]) best = i;
  const [w, x, y, z] = vectors.map((row) => row[best]);
  return withPositiveW(normalizeQuat([x, y, z, w]));
}

/** The one of q and −q with w ≥ 0. */
const withPositiveW = ([x, y, z, w]: Quat): Quat => (w < 0 ? [-x, -y, -z, -w] : [x, y, z, w]);

/** Relative rounding error of products of f64 rotations. */
const ROUNDING = 1e-14;

/** s > 0 if M = s R up to rounding with a proper rotation R, else 0. Most transforms are of this kind and need no iteration. */
function rotationScale(m: Mat3): number {
  const [a, b, c, d, e, f, g, h, i] = m;
  const square = a * a + d * d + g * g;
  const most = ROUNDING * square;
  if (Math.abs(b * b + e * e + h * h - square) > most || Math.abs(c * c + f * f + i * i - square) > most) return 0;
  if (Math.abs(a * b + d * e + g * h) > most || Math.abs(a * c + d * f + g * i) > most) return 0;
  if (!(Math.abs(b * c + e * f + h * i) <= most) || !(determinant(m) > 0)) return 0;
  return Math.abs(square - 1) <= ROUNDING ? 1 : Math.sqrt(square);
}

/** Jacobi's method: diagonalizes `k` in place and returns its eigenvectors as columns. */
function diagonalize(k: Symmetric4): Symmetric4 {
  const vectors: Symmetric4 = [0, 1, 2, 3].map((i) => [0, 1, 2, 3].map((j) => (i === j ? 1 : 0)));
  const size = Math.max(...k.flat().map(Math.abs));
  // Convergence is quadratic: five sweeps are typical, and 32 is never reached.
  for (let sweep = 0; sweep < 32; sweep++) {
    let off = 0;
    for (let p = 0; p < 3; p++)
      for (let q = p + 1; q < 4; q++) {
        off = Math.max(off, Math.abs(k[p][q]));
        if (k[p][q] !== 0) rotatePlane(k, vectors, p, q);
      }
    if (off <= size * 1e-17) break;
  }
  return vectors;
}

function rotatePlane(k: Symmetric4, vectors: Symmetric4, p: number, q: number): void {
  const theta = (k[q][q] - k[p][p]) / (2 * k[p][q]);
  const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(theta, 1));
  const c = 1 / Math.hypot(t, 1);
  const s = t * c;
  for (const rows of [k, vectors]) {
    for (const row of rows) {
      const [x, y] = [row[p], row[q]];
      row[p] = c * x - s * y;
      row[q] = s * x + c * y;
    }
  }
  for (let i = 0; i < 4; i++) {
    const [x, y] = [k[p][i], k[q][i]];
    k[p][i] = c * x - s * y;
    k[q][i] = s * x + c * y;
  }
  k[p][q] = 0;
  k[q][p] = 0;
}
