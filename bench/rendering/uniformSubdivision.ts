import { isListed } from '../../src/scene/streaming/samplePoints.ts';
import type { Mesh, Motion, Scene, SceneObject } from '../../src/scene/types.ts';

/**
 * The scene with every edge bisected until none is longer than `longest` [m], as a loader could do; undefined if that exceeds
 * `most` triangles. Only an edge's own length decides, so there are no cracks.
 */
export function subdivideUniformly(scene: Scene, longest: number, most: number): Scene | undefined {
  const objects: SceneObject[] = [];
  let triangles = 0;
  for (const object of scene.objects) {
    const cutter = new UniformSubdivision(object.mesh, longest, 3 * (most - triangles));
    if (!cutter.done) return undefined;
    triangles += cutter.indices.length / 3;
    objects.push({ ...object, mesh: cutter.mesh(), motion: cutter.motion(object.motion) });
  }
  return { ...scene, objects };
}

/** The longest edge of all meshes [m]. */
export function longestEdge({ objects }: Scene): number {
  let square = 0;
  for (const { mesh } of objects)
    for (let i = 0; i < mesh.indices.length; i++) {
      const [a, b] = [mesh.indices[i], mesh.indices[i % 3 === 2 ? i - 2 : i + 1]];
      square = Math.max(square, squareApart(mesh.positions, a, b));
    }
  return Math.sqrt(square);
}

/** Bisects each triangle at the midpoint of its longest edge, recursively; midpoints are shared between triangles. */
class UniformSubdivision {
  readonly indices: number[] = [];
  private readonly original: Mesh;
  private readonly positions: number[];
  private readonly square: number;
  private readonly room: number;
  /** The two parents of each new vertex. */
  private readonly parents: number[] = [];
  private readonly middles = new Map<number, number>();
  private readonly groups: Mesh['groups'];

  constructor(mesh: Mesh, longest: number, room: number) {
    this.original = mesh;
    this.positions = [...mesh.positions];
    this.square = longest * longest;
    this.room = room;
    this.groups = mesh.groups.map((group) => {
      const start = this.indices.length;
      for (let i = group.start; i < group.start + group.count; i += 3)
        this.divide(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]);
      return { ...group, start, count: this.indices.length - start };
    });
  }

  /** False if the maximum number of triangles was exceeded. */
  get done(): boolean {
    return this.indices.length <= this.room;
  }

  mesh(): Mesh {
    const { positions, normals, uvs, colors, doubleSided } = this.original;
    return {
      positions: this.extended(positions, 3),
      normals: this.extended(normals, 3),
      uvs: this.extended(uvs, 2),
      ...(colors && { colors: this.extended(colors, 3) }),
      indices: Uint32Array.from(this.indices),
      groups: this.groups,
      doubleSided,
    };
  }

  motion(motion: Motion): Motion {
    if (motion.kind !== 'sampled-points') return motion;
    const { points, normals } = motion;
    if (!isListed(points)) return motion;
    const all = (arrays: readonly Float32Array[]) => arrays.map((array) => this.extended(array, 3));
    return { ...motion, points: all(points), ...(normals && { normals: all(normals) }) };
  }

  private divide(a: number, b: number, c: number): void {
    if (!this.done) return;
    const p = this.positions;
    const [ab, bc, ca] = [squareApart(p, a, b), squareApart(p, b, c), squareApart(p, c, a)];
    if (Math.max(ab, bc, ca) <= this.square) this.indices.push(a, b, c);
    else if (bc > ab && bc >= ca) this.divide(b, c, a);
    else if (ca > ab) this.divide(c, a, b);
    else {
      const middle = this.middle(a, b);
      this.divide(a, middle, c);
      this.divide(middle, b, c);
    }
  }

  private middle(a: number, b: number): number {
    const key = Math.min(a, b) * 2 ** 26 + Math.max(a, b);
    const existing = this.middles.get(key);
    if (existing !== undefined) return existing;
    const p = this.positions;
    const made = p.length / 3;
    for (let k = 0; k < 3; k++) p.push((p[3 * a + k] + p[3 * b + k]) / 2);
    this.parents.push(a, b);
    this.middles.set(key, made);
    return made;
  }

  /** A vertex attribute of `size` numbers, extended to the new vertices by the mean of their parents. */
  private extended(array: Float32Array, size: number): Float32Array {
    const { parents } = this;
    const out = new Float32Array(array.length + (size * parents.length) / 2);
    out.set(array);
    for (let i = 0; i < parents.length; i += 2)
      for (let k = 0; k < size; k++)
        out[array.length + (size * i) / 2 + k] = (out[size * parents[i] + k] + out[size * parents[i + 1] + k]) / 2;
    return out;
  }
}

const squareApart = (p: ArrayLike<number>, a: number, b: number): number =>
  (p[3 * a] - p[3 * b]) ** 2 + (p[3 * a + 1] - p[3 * b + 1]) ** 2 + (p[3 * a + 2] - p[3 * b + 2]) ** 2;
