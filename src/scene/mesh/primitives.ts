import type { Mat4 } from '../../math/mat4.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { Mesh } from '../types.ts';
import { makeMesh } from './makeMesh.ts';
import { ROUND_SEGMENTS } from './quadric.ts';
import type { QuadricShape } from './quadricTypes.ts';

/** The axis of symmetry, as `axis` in USD. */
export type Axis = 'X' | 'Y' | 'Z';

/** Radius and height [m] of a circle about an axis; of normals their radial and axial part. */
export type RadiusHeight = readonly [number, number];

/**
 * A band of a surface of revolution between two circles. With the axis up and r to the right, its outside is to the right of the direction from `from` to `to`.
 */
export interface SurfaceBand {
  /** Radius and height [m] of the two circles; a radius of 0 is a pole. */
  readonly from: RadiusHeight;
  /** The same of the second circle. */
  readonly to: RadiusHeight;
  /** Radial and axial part of the normals at the two circles. */
  readonly fromNormal: RadiusHeight;
  /** The same of the second circle. */
  readonly toNormal: RadiusHeight;
  /** Texture v at the two circles. */
  readonly v: RadiusHeight;
}

/** Points and corners of a surface of revolution under construction; circles shared by two bands share their points. */
class RevolutionBuilder {
  readonly points: number[] = [];
  readonly faceCounts: number[] = [];
  readonly faceIndices: number[] = [];
  readonly normals: number[] = [];
  readonly uvs: number[] = [];
  private readonly circles = new Map<string, number>();
  private readonly segments: number;
  private readonly onAxis: (x: number, y: number, z: number) => Vec3;

  constructor(segments: number, axis: Axis) {
    this.segments = segments;
    this.onAxis = (x, y, z) => (axis === 'Z' ? [x, y, z] : axis === 'Y' ? [y, z, x] : [z, x, y]);
  }

  band({ from, to, fromNormal, toNormal, v }: SurfaceBand): void {
    for (let s = 0; s < this.segments; s++) {
      // The one corner at a pole has the normal and u of the triangle's centre.
      const low = from[0] > 0 ? [s, s + 1] : [s + 0.5];
      const high = to[0] > 0 ? [s + 1, s] : [s + 0.5];
      for (const at of low) this.corner(from, fromNormal, at, v[0]);
      for (const at of high) this.corner(to, toNormal, at, v[1]);
      this.faceCounts.push(low.length + high.length);
    }
  }

  private corner(circle: RadiusHeight, normal: RadiusHeight, at: number, v: number): void {
    const angle = (2 * Math.PI * at) / this.segments;
    this.faceIndices.push(this.circle(circle) + (circle[0] > 0 ? at % this.segments : 0));
    this.normals.push(...this.onAxis(normal[0] * Math.cos(angle), normal[0] * Math.sin(angle), normal[1]));
    this.uvs.push(at / this.segments, v);
  }

  private circle([r, h]: RadiusHeight): number {
    const existing = this.circles.get(`${r} ${h}`);
    if (existing !== undefined) return existing;
    const first = this.points.length / 3;
    this.circles.set(`${r} ${h}`, first);
    for (let s = 0; s < (r > 0 ? this.segments : 1); s++) {
      const angle = (2 * Math.PI * s) / this.segments;
      this.points.push(...this.onAxis(r * Math.cos(angle), r * Math.sin(angle), h));
    }
    return first;
  }
}

/**
 * Revolves bands about the axis; u runs once around it.
 * @example
 * // The wall of a tube of radius 1 m and height 2 m.
 * const wall = { from: [1, -1], to: [1, 1], fromNormal: [1, 0], toNormal: [1, 0], v: [0, 1] } as const;
 * boundingBox(revolve([wall], 4, 'Y').positions); // { min: [-1.00, -1, -1.00], max: [1.00, 1, 1.00] } m
 */
export function revolve(bands: readonly SurfaceBand[], segments: number, axis: Axis): Mesh {
  const lathe = new RevolutionBuilder(segments, axis);
  for (const band of bands) lathe.band(band);
  const { points, faceCounts, faceIndices, normals, uvs } = lathe;
  return makeMesh({
    points,
    faceCounts,
    faceIndices,
    normals: { per: 'corner', values: normals },
    uvs: { per: 'corner', values: uvs },
  }).mesh;
}

/** Bands along a curve t ∈ [0, 1] → circle and normal, e.g. an arc; v rises with t. */
function curve(
  steps: number,
  at: (t: number) => { circle: RadiusHeight; normal: RadiusHeight },
  v: RadiusHeight = [0, 1],
): SurfaceBand[] {
  return Array.from({ length: steps }, (_, i): SurfaceBand => {
    const [a, b] = [at(i / steps), at((i + 1) / steps)];
    const vAt = (t: number) => v[0] + (v[1] - v[0]) * t;
    const vs: RadiusHeight = [vAt(i / steps), vAt((i + 1) / steps)];
    return { from: a.circle, to: b.circle, fromNormal: a.normal, toNormal: b.normal, v: vs };
  });
}

/** An arc around (0, h0) from latitude `from` to `to` [rad]; exactly on the axis at the poles. */
function arc(radius: number, h0: number, from: number, to: number, steps: number, v: RadiusHeight): SurfaceBand[] {
  return curve(
    steps,
    (t) => {
      const latitude = from + (to - from) * t;
      const [c, s] =
        Math.abs(Math.abs(latitude) - Math.PI / 2) < 1e-12
          ? [0, Math.sign(latitude)]
          : [Math.cos(latitude), Math.sin(latitude)];
      return { circle: [radius * c, h0 + radius * s], normal: [c, s] };
    },
    v,
  );
}

const flatBand = (from: RadiusHeight, to: RadiusHeight, axial: number, v: RadiusHeight): SurfaceBand => ({
  from,
  to,
  fromNormal: [0, axial],
  toNormal: [0, axial],
  v,
});

/** From axes with the axis of symmetry along z to the mesh's, as `RevolutionBuilder` places points. */
const FROM_Z: { readonly [K in Axis]: Mat4 } = {
  X: [0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1],
  Y: [0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1],
  Z: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
};

/** The mesh with the solid that it stands for, unless it is too coarse to be meant as one. */
const round = (mesh: Mesh, shape: QuadricShape, axis: Axis, segments: number, rings = 1): Mesh =>
  segments >= ROUND_SEGMENTS ? { ...mesh, quadric: { shape, toMesh: FROM_Z[axis], segments, rings } } : mesh;

/** How finely round shapes are divided, and where they point. With fewer than 20 segments they are the prisms and pyramids that their polygons are. */
export interface RoundOptions {
  /** Segments around the axis. */
  readonly segments?: number;
  /** The axis of symmetry; default Z. */
  readonly axis?: Axis;
}

/**
 * A sphere of `radius` [m]; v runs from pole to pole in equal steps of latitude.
 * @example
 * boundingBox(sphere(1, { segments: 32 }).positions)!.max[2]; // 1 m
 */
export function sphere(radius: number, options: RoundOptions & { readonly rings?: number } = {}): Mesh {
  const { segments = 64, axis = 'Z' } = options;
  const rings = Math.round(options.rings ?? segments / 2);
  const mesh = revolve(arc(radius, 0, -Math.PI / 2, Math.PI / 2, rings, [0, 1]), segments, axis);
  return round(mesh, { kind: 'sphere', radius }, axis, segments, rings);
}

/**
 * A closed cylinder, centred on the origin [m].
 * @example
 * boundingBox(cylinder(1, 4, { axis: 'Y' }).positions)!.max[1]; // 2 m
 */
export function cylinder(radius: number, height: number, { segments = 64, axis = 'Z' }: RoundOptions = {}): Mesh {
  const h = height / 2;
  const side: SurfaceBand = { from: [radius, -h], to: [radius, h], fromNormal: [1, 0], toNormal: [1, 0], v: [0, 1] };
  const bands = [flatBand([0, -h], [radius, -h], -1, [0, 1]), side, flatBand([radius, h], [0, h], 1, [1, 0])];
  return round(revolve(bands, segments, axis), { kind: 'cylinder', radius, height }, axis, segments);
}

/**
 * A closed cone, its apex at +height/2 [m].
 * @example
 * boundingBox(cone(1, 4).positions)!.max[2]; // 2 m
 */
export function cone(radius: number, height: number, { segments = 64, axis = 'Z' }: RoundOptions = {}): Mesh {
  const h = height / 2;
  const slant = Math.hypot(radius, height);
  const n: RadiusHeight = [height / slant, radius / slant];
  const side: SurfaceBand = { from: [radius, -h], to: [0, h], fromNormal: n, toNormal: n, v: [0, 1] };
  const mesh = revolve([flatBand([0, -h], [radius, -h], -1, [0, 1]), side], segments, axis);
  return round(mesh, { kind: 'cone', radius, height }, axis, segments);
}

/**
 * A cylinder of `height` [m] (without its caps) closed by hemispheres.
 * @example
 * boundingBox(capsule(1, 4).positions)!.max[2]; // 3 m
 */
export function capsule(
  radius: number,
  height: number,
  options: RoundOptions & { readonly rings?: number } = {},
): Mesh {
  const { segments = 64, rings = segments / 4, axis = 'Z' } = options;
  const h = height / 2;
  const steps = Math.round(rings);
  const cap = (Math.PI / 2) * radius;
  const low = cap / (2 * cap + height);
  const side: SurfaceBand = {
    from: [radius, -h],
    to: [radius, h],
    fromNormal: [1, 0],
    toNormal: [1, 0],
    v: [low, 1 - low],
  };
  const bands = [
    ...arc(radius, -h, -Math.PI / 2, 0, steps, [0, low]),
    ...(height > 0 ? [side] : []),
    ...arc(radius, h, 0, Math.PI / 2, steps, [1 - low, 1]),
  ];
  return round(revolve(bands, segments, axis), { kind: 'capsule', radius, height }, axis, segments, steps);
}

/**
 * A torus: a tube of radius `tube` around a circle of radius `ring` [m] about the axis.
 * @example
 * boundingBox(torus(2, 0.5).positions)!.max[2]; // 0.5 m
 */
export function torus(ring: number, tube: number, options: RoundOptions & { readonly rings?: number } = {}): Mesh {
  const { segments = 96, rings = 32, axis = 'Z' } = options;
  const at = (t: number): { circle: RadiusHeight; normal: RadiusHeight } => {
    // The last circle equals the first to the bit, so that the tube is closed.
    const angle = 2 * Math.PI * (t % 1) - Math.PI;
    const normal: RadiusHeight = [Math.cos(angle), Math.sin(angle)];
    return { circle: [ring + tube * normal[0], tube * normal[1]], normal };
  };
  return revolve(curve(rings, at), segments, axis);
}

/**
 * A box centred on the origin; each face has uv from 0 to 1.
 * @example
 * box([1, 2, 3]).positions.length / 3; // 24: four corners of six faces
 */
export function box(size: Vec3): Mesh {
  const points: number[] = [];
  for (let i = 0; i < 8; i++) points.push(...[0, 1, 2].map((k) => ((i >> k) & 1 ? size[k] : -size[k]) / 2));
  const faceIndices = [1, 3, 7, 5, 2, 0, 4, 6, 3, 2, 6, 7, 0, 1, 5, 4, 4, 5, 7, 6, 2, 3, 1, 0];
  const uvs = { per: 'corner' as const, values: Array.from({ length: 6 }, () => [0, 0, 1, 0, 1, 1, 0, 1]).flat() };
  return makeMesh({ points, faceCounts: [4, 4, 4, 4, 4, 4], faceIndices, uvs }).mesh;
}

/**
 * A rectangle that faces along `axis`, divided into nx × ny cells; uv from 0 to 1. As in USD, x is the width and y the length.
 * @example
 * grid(2, 1, 4, 2).indices.length / 3; // 16 triangles
 */
export function grid(width: number, length: number, nx: number, ny: number, axis: Axis = 'Z'): Mesh {
  // As USD's Plane: the width is along X (for axis X: along Z), the length along Y (for axis Y: along Z).
  const place = (x: number, y: number): Vec3 => (axis === 'Z' ? [x, y, 0] : axis === 'Y' ? [x, 0, -y] : [0, y, -x]);
  const points: number[] = [];
  const uvs: number[] = [];
  for (let j = 0; j <= ny; j++)
    for (let i = 0; i <= nx; i++) {
      points.push(...place((i / nx - 0.5) * width, (j / ny - 0.5) * length));
      uvs.push(i / nx, j / ny);
    }
  const faceIndices: number[] = [];
  for (let j = 0; j < ny; j++)
    for (let i = 0; i < nx; i++) {
      const a = j * (nx + 1) + i;
      faceIndices.push(a, a + 1, a + nx + 2, a + nx + 1);
    }
  const faceCounts = new Array<number>(nx * ny).fill(4);
  const { mesh } = makeMesh({ points, faceCounts, faceIndices, uvs: { per: 'point', values: uvs } });
  return { ...mesh, doubleSided: true };
}

/**
 * A rectangle of one cell.
 * @example
 * boundingBox(plane(2, 1, 'Y').positions); // { min: [-1, 0, -0.5], max: [1, 0, 0.5] } m
 */
export const plane = (width: number, length: number, axis: Axis = 'Z'): Mesh => grid(width, length, 1, 1, axis);
