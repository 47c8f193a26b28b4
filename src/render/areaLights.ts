import { int, Loop } from 'three/tsl';
import { rotate } from '../math/quat.ts';
import { scale, type Vec3 } from '../math/vec3.ts';
import type { AreaLight } from '../scene/types.ts';
import type * as gpu from '../shaders/types.ts';
import { FloatTable } from './floatTable.ts';
import { lampSeen } from './lampSeen.ts';
import { shapingValues } from './shaping.ts';
import type { Sight } from './sight.ts';

/** A lamp with a size on the GPU, relative to the observer's event [m]. */
export interface AreaTexels {
  readonly kind: AreaLight['kind'];
  readonly place: gpu.Vec3;
  /** Half axes; of a tube X is one, and Y of length 1. */
  readonly X: gpu.Vec3;
  readonly Y: gpu.Vec3;
  readonly radius: gpu.Float;
  /** Radiance. */
  readonly color: gpu.Vec3;
  readonly inner: gpu.Float;
  readonly outer: gpu.Float;
  readonly focus: gpu.Float;
}

const KINDS = ['rect', 'disk', 'cylinder'] as const;
const TEXELS = 4;
/** A line is drawn as a tube of this part of its length. */
const LINE = 5e-4;

/** Lamps with a size in a table, those of a kind together: each kind has code of its own. */
export class AreaLights {
  private readonly lights: readonly AreaLight[];
  private readonly table = new FloatTable(256);

  constructor(lights: readonly AreaLight[]) {
    this.lights = KINDS.flatMap((kind) => lights.filter((light) => light.kind === kind));
    this.table.reserve(TEXELS * this.lights.length);
  }

  each(visit: (light: AreaTexels) => void): void {
    for (const kind of KINDS) {
      const start = this.lights.findIndex((light) => light.kind === kind);
      const end = start + this.lights.filter((light) => light.kind === kind).length;
      if (start < 0) continue;
      if (end - start === 1) visit(this.light(kind, int(start)));
      else
        Loop({ start: int(start), end: int(end), type: 'int', condition: '<' }, ({ i }) => {
          visit(this.light(kind, int(i)));
        });
    }
  }

  private light(kind: AreaLight['kind'], index: gpu.Int): AreaTexels {
    const first = index.mul(int(TEXELS)).toVar();
    const [place, X, Y, color] = [0, 1, 2, 3].map((k) => this.table.texel(first.add(int(k))).toVar());
    const shaping = { inner: X.w, outer: Y.w, focus: color.w };
    return { kind, place: place.xyz, radius: place.w, X: X.xyz, Y: Y.xyz, color: color.xyz, ...shaping };
  }

  update(sight: Sight): void {
    this.lights.forEach((light, i) => {
      const { position, orientation, color } = lampSeen(light, sight);
      const [inner, outer, focus] = shapingValues(light);
      const { x, y, radius, gain } = extents(light);
      const axis = (v: Vec3): Vec3 => rotate(orientation, v);
      const texels = [...position, radius, ...axis([x, 0, 0]), inner, ...axis([0, y, 0]), outer];
      this.table.values.set([...texels, ...scale(color, gain), focus], 4 * TEXELS * i);
    });
    this.table.upload();
  }

  dispose(): void {
    this.table.dispose();
  }
}

/** Half sizes along X and Y and the radius [m], and what the colour is multiplied with to be a radiance. */
function extents(light: AreaLight): { x: number; y: number; radius: number; gain: number } {
  if (light.kind === 'rect') return { x: light.width / 2, y: light.height / 2, radius: 0, gain: 1 };
  if (light.kind === 'disk') return { x: light.radius, y: light.radius, radius: light.radius, gain: 1 };
  const radius = light.radius || LINE * light.length;
  return { x: light.length / 2, y: 1, radius, gain: light.radius > 0 ? 1 : 1 / (2 * radius) };
}
