import { cofactors, determinant, invert, type Mat3 } from '../../../math/mat3.ts';
import { linearPart } from '../../../math/mat4.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import { facetAt, type QuadricFacet } from '../../../scene/mesh/quadric.ts';
import type { Quadric, QuadricShape } from '../../../scene/types.ts';

/** A surface F(x, y, z) = a (x² + y²) + b z² + c z + d = 0 that bounds a solid; F < 0 inside. */
export interface BoundingSurface {
  readonly a: number;
  readonly b: number;
  readonly c: number;
  readonly d: number;
  /** As in `facetAt`: side 0, bottom 1, top 2. */
  readonly part: number;
}

const below = (z: number): BoundingSurface => ({ a: 0, b: 0, c: 1, d: -z, part: 2 });
const above = (z: number): BoundingSurface => ({ a: 0, b: 0, c: -1, d: z, part: 1 });
const ball = (radius: number, z: number): BoundingSurface => ({
  a: 1,
  b: 1,
  c: -2 * z,
  d: z * z - radius * radius,
  part: 0,
});
const tube = (radius: number): BoundingSurface => ({ a: 1, b: 0, c: 0, d: -radius * radius, part: 0 });

function surfacesOf(shape: QuadricShape): readonly BoundingSurface[] {
  const { radius } = shape;
  switch (shape.kind) {
    case 'sphere':
      return [ball(radius, 0)];
    case 'cylinder':
      return [tube(radius), above(-shape.height / 2), below(shape.height / 2)];
    case 'cone': {
      const [k, apex] = [radius / shape.height, shape.height / 2];
      const side = { a: 1, b: -k * k, c: 2 * k * k * apex, d: -k * k * apex * apex, part: 0 };
      return [side, above(-apex), { ...below(apex), part: 0 }];
    }
    case 'capsule':
      return [tube(radius), ball(radius, shape.height / 2), ball(radius, -shape.height / 2)];
  }
}

/** Half the height along the axis [own units]. */
const halfHeight = (shape: QuadricShape): number =>
  shape.kind === 'sphere' ? shape.radius : shape.height / 2 + (shape.kind === 'capsule' ? shape.radius : 0);

/** A round solid in its own axes, and the map from the mesh's. */
export class RoundSolid {
  /** It is inside all of them; a capsule is inside any of them, between the planes where they meet. */
  readonly surfaces: readonly BoundingSurface[];
  /** Of the ball around its centre that contains it. */
  readonly radius: number;
  /** Half the sides of the box around its centre that contains it. */
  readonly extent: Vec3;
  /** To the mesh's axes: x → `place` + `linear` x [m], and the inverse of `linear`. */
  readonly linear: Mat3;
  readonly place: Vec3;
  readonly inverse: Mat3;
  private readonly quadric: Quadric;
  private readonly normals: Mat3;

  constructor(quadric: Quadric) {
    const { shape, toMesh } = quadric;
    this.quadric = quadric;
    this.surfaces = surfacesOf(shape);
    this.extent = [shape.radius, shape.radius, halfHeight(shape)];
    this.radius =
      shape.kind === 'cylinder' || shape.kind === 'cone'
        ? Math.hypot(shape.radius, shape.height / 2)
        : halfHeight(shape);
    this.linear = linearPart(toMesh);
    this.place = [toMesh[3], toMesh[7], toMesh[11]];
    const inverse = invert(this.linear);
    if (!inverse) throw new Error('the solid is flat');
    this.inverse = inverse;
    const sign = determinant(this.linear) < 0 ? -1 : 1;
    this.normals = cofactors(this.linear).map((x) => sign * x);
  }

  contains(x: number, y: number, z: number): boolean {
    const { shape } = this.quadric;
    if (shape.kind === 'capsule') {
      const beyond = Math.max(0, Math.abs(z) - shape.height / 2);
      return x * x + y * y + beyond * beyond <= shape.radius * shape.radius;
    }
    for (const { a, b, c, d } of this.surfaces) if (a * (x * x + y * y) + (b * z + c) * z + d > 0) return false;
    return true;
  }

  /** The outward normal at a point of a part, of any length, in its own axes. */
  normalAt([x, y, z]: Vec3, part: number): Vec3 {
    const { shape } = this.quadric;
    if (part > 0) return [0, 0, part === 1 ? -1 : 1];
    switch (shape.kind) {
      case 'sphere':
        return [x, y, z];
      case 'cylinder':
        return [x, y, 0];
      case 'cone':
        return [x, y, (Math.hypot(x, y) * shape.radius) / shape.height];
      case 'capsule':
        return [x, y, Math.sign(z) * Math.max(0, Math.abs(z) - shape.height / 2)];
    }
  }

  /** The same in the mesh's axes. */
  meshNormalAt(point: Vec3, part: number): Vec3 {
    const [x, y, z] = this.normalAt(point, part);
    const n = this.normals;
    return [n[0] * x + n[1] * y + n[2] * z, n[3] * x + n[4] * y + n[5] * z, n[6] * x + n[7] * y + n[8] * z];
  }

  /** The place on the mesh of a point of the surface. */
  facetAt(point: Vec3, part: number): QuadricFacet {
    return facetAt(this.quadric, point, part);
  }
}
