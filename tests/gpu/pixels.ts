import { conjugate, rotate } from '../../src/math/quat.ts';
import { add, cross, dot, length, scale, sub, type Vec3 } from '../../src/math/vec3.ts';
import { apparentPosition } from '../../src/physics/apparent.ts';
import { properVelocity } from '../../src/physics/boost.ts';
import { dopplerFactor } from '../../src/physics/doppler.ts';
import { tessellate } from '../../src/render/tessellate.ts';
import { probeVertices, type VertexProbe } from '../../src/scene/probe.ts';
import type { Scene } from '../../src/scene/types.ts';
import type { RenderSettings, ViewPoint } from '../../src/scene/view.ts';

/** What one vertex of the drawn mesh is, by the f64 library: no code of src/render but the mesh it draws. */
interface Vertex {
  /** Observer → event [m], world frame. */
  readonly dx: Vec3;
  /** t_event − t_o [s]. */
  readonly delay: number;
  readonly velocity: Vec3;
  /** In the camera's axes [m]. */
  readonly camera: Vec3;
}

export interface ReferencePixel {
  readonly object: number;
  readonly dx: Vec3;
  readonly delay: number;
  readonly velocity: Vec3;
  readonly doppler: number;
  /** Apparent distance [m]. */
  readonly depth: number;
}

/** Bands of the picture, from the bottom up, each with the triangles that may cover it: a ray then meets few. */
const BANDS = 64;
interface Triangle {
  readonly mesh: { readonly id: number; readonly birth: number; readonly death: number };
  readonly corners: readonly [Vertex, Vertex, Vertex];
}

/** Ray by ray against the triangles between the f64 positions of their vertices; attributes linear over each triangle. */
export class ReferencePicture {
  private readonly view: ViewPoint;
  private readonly settings: RenderSettings;
  private readonly bands: Triangle[][] = Array.from({ length: BANDS }, () => []);

  constructor(scene: Scene, view: ViewPoint, settings: RenderSettings) {
    this.view = view;
    this.settings = settings;
    const { objects } = tessellate(scene, settings.speedOfLight);
    for (const [i, object] of objects.entries()) {
      const mesh = { id: i + 1, birth: object.lifetime.birth - view.t, death: object.lifetime.death - view.t };
      const vertices = this.vertices(object);
      const { indices } = object.mesh;
      for (let k = 0; k < indices.length; k += 3) {
        const [a, b, c] = [vertices[indices[k]], vertices[indices[k + 1]], vertices[indices[k + 2]]];
        if (a && b && c) this.keep({ mesh, corners: [a, b, c] });
      }
    }
  }

  private keep(triangle: Triangle): void {
    const behind = triangle.corners.some(({ camera }) => camera[2] >= 0);
    const bands = behind ? [0, BANDS - 1] : triangle.corners.map(({ camera }) => this.band(camera[1] / -camera[2]));
    for (let band = Math.min(...bands); band <= Math.max(...bands); band++) this.bands[band].push(triangle);
  }

  /** Of the tangent of an angle above the axis; what is outside the picture counts to its edge. */
  private band(tangent: number): number {
    const share = (tangent / Math.tan(this.view.fovY / 2) + 1) / 2;
    return Math.max(0, Math.min(BANDS - 1, Math.floor(share * BANDS)));
  }

  private vertices(object: Scene['objects'][number]): (Vertex | undefined)[] {
    const { view, lightDelay, aberration, speedOfLight } = this.settings;
    const events = view === 'light-cone' && !lightDelay ? 'galilean' : view;
    const probes = probeVertices(object, this.view, speedOfLight, events);
    return probes.map((p) => p && this.vertex(p, view === 'light-cone' && (!lightDelay || !aberration)));
  }

  private vertex(p: VertexProbe, switched: boolean): Vertex {
    const dx = sub(p.position, this.view.position);
    const seen = switched ? (this.settings.aberration ? apparentPosition(dx, this.view.u) : dx) : p.apparent;
    const camera = rotate(conjugate(this.view.orientation), seen);
    return { dx, delay: p.time - this.view.t, velocity: p.velocity, camera };
  }

  /** Through (x, y) in pixels from the top left, centres at halves. */
  at(x: number, y: number, width: number, height: number): ReferencePixel | undefined {
    const tan = Math.tan(this.view.fovY / 2);
    const ray: Vec3 = [((2 * x) / width - 1) * tan * (width / height), (1 - (2 * y) / height) * tan, -1];
    let nearest = Number.POSITIVE_INFINITY;
    let found: ReferencePixel | undefined;
    for (const { mesh, corners } of this.bands[this.band(ray[1])]) {
      const [a, b, c] = corners;
      const hit = intersect(ray, a.camera, b.camera, c.camera);
      if (!hit || hit.distance >= nearest) continue;
      const weigh = (pick: (v: Vertex) => Vec3): Vec3 =>
        add(add(scale(pick(a), 1 - hit.u - hit.v), scale(pick(b), hit.u)), scale(pick(c), hit.v));
      const delay = a.delay * (1 - hit.u - hit.v) + b.delay * hit.u + c.delay * hit.v;
      if (delay < mesh.birth || delay > mesh.death) continue;
      nearest = hit.distance;
      const surface = this.pixel(
        mesh.id,
        weigh((q) => q.dx),
        delay,
        weigh((q) => q.velocity),
      );
      found = { ...surface, depth: length(weigh((q) => q.camera)) };
    }
    return found;
  }

  private pixel(object: number, dx: Vec3, delay: number, v: Vec3): Omit<ReferencePixel, 'depth'> {
    const doppler = this.settings.view === 'light-cone' ? dopplerFactor(dx, this.view.u, properVelocity(v)) : 1;
    return { object, dx, delay, velocity: v, doppler };
  }
}

/** Möller and Trumbore 1997, front faces only. */
function intersect(ray: Vec3, a: Vec3, b: Vec3, c: Vec3): { distance: number; u: number; v: number } | undefined {
  const e1 = sub(b, a);
  const e2 = sub(c, a);
  const p = cross(ray, e2);
  const det = dot(e1, p);
  if (det <= 0) return undefined;
  const t: Vec3 = [-a[0], -a[1], -a[2]];
  const u = dot(t, p) / det;
  if (u < 0 || u > 1) return undefined;
  const q = cross(t, e1);
  const v = dot(ray, q) / det;
  if (v < 0 || u + v > 1) return undefined;
  const distance = dot(e2, q) / det;
  return distance > 0 ? { distance, u, v } : undefined;
}

/** Angle between two directions [rad]. */
export const angle = (a: Vec3, b: Vec3): number => Math.atan2(length(cross(a, b)), dot(a, b));
