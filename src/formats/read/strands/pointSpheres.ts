import { normalize, type Vec3 } from '../../../math/vec3.ts';

/** A sphere of radius 1 as triangles: 3 numbers per point, and per triangle its points. */
export interface SphereTemplate {
  readonly points: Float32Array;
  readonly triangles: Uint32Array;
}

const OCTAHEDRON: SphereTemplate = {
  points: Float32Array.of(1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1),
  triangles: Uint32Array.of(0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5),
};

/** Each triangle in four, with the new points on the sphere. */
function divided({ points, triangles }: SphereTemplate): SphereTemplate {
  const all = [...points];
  const middles = new Map<string, number>();
  const middle = (a: number, b: number): number => {
    const key = a < b ? `${a} ${b}` : `${b} ${a}`;
    const known = middles.get(key);
    if (known !== undefined) return known;
    const sum = [0, 1, 2].map((k) => all[3 * a + k] + all[3 * b + k]) as unknown as Vec3;
    const made = all.length / 3;
    all.push(...normalize(sum));
    middles.set(key, made);
    return made;
  };
  const out: number[] = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [triangles[i], triangles[i + 1], triangles[i + 2]];
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    out.push(a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca);
  }
  return { points: Float32Array.from(all), triangles: Uint32Array.from(out) };
}

/** Maximum number of triangles of spheres that are made together. */
const MAX_TRIANGLES = 2 ** 20;
/** Maximum number of such spheres: then each is an octahedron. */
export const MAX_SPHERES = MAX_TRIANGLES / 8;
/** 8, 32, 128, 512 triangles. */
const MAX_DIVISIONS = 3;

/** The finest sphere of which `count` are not too many. */
export function sphereFor(count: number): SphereTemplate {
  let made = OCTAHEDRON;
  for (let k = 0; k < MAX_DIVISIONS && count * 4 * (made.triangles.length / 3) <= MAX_TRIANGLES; k++)
    made = divided(made);
  return made;
}
