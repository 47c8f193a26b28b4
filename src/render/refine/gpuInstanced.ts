import { attribute, int } from 'three/tsl';
import {
  type BufferGeometry,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
} from 'three/webgpu';
import { cornersOf, type Drawable, makeDrawable } from '../drawable.ts';
import type { VertexInput } from '../vertexInput.ts';
import type { Corners } from './gpuCorners.ts';
import { weightsAt } from './gpuLeaf.ts';
import { patternGeometry, patternTriangles } from './gpuPatterns.ts';
import { LEAF_FLOATS, WEARER_AT } from './leaf.ts';
import { PATTERNS } from './pattern.ts';
import type { Leaves, Levelled } from './plan.ts';

const LEAST_ROOM = 64;

/** The leaves of one batch with levels found on the CPU: each pattern is drawn once for each leaf. */
export class InstancedPieces {
  readonly drawables: readonly Drawable[];
  private readonly rooms: InstanceRoom[];

  constructor(indexed: Drawable, corners: Corners) {
    const vertex = (): VertexInput => {
      const place = attribute<'vec3'>('position', 'vec3');
      const head = attribute<'vec4'>('head', 'vec4');
      const tail = attribute<'vec4'>('tail', 'vec4');
      const weights = weightsAt({ head, tail, levels: int(tail.w).toVar() }, place.x, place.y);
      return corners.point(int(head.x), weights, cornersOf(indexed), attribute<'float'>('instance', 'float'));
    };
    const sources = { ...indexed, vertex: { ...indexed.vertex, vertex } };
    this.rooms = PATTERNS.map((_, pattern) => new InstanceRoom(pattern));
    // One shader for all patterns, so one set of materials.
    const materials: Drawable['materials'] = new Map();
    this.drawables = this.rooms.map(({ geometry }) => ({ ...makeDrawable(geometry, sources), materials }));
    this.hide();
  }

  /** What the batch's triangles and instances begin with is added to the leaves'. Tells how many triangles that makes. */
  show(levels: Levelled, firstTriangle: number, firstInstance: number): number {
    let triangles = 0;
    this.drawables.forEach(({ mesh }, pattern) => {
      const leaves = levels[pattern];
      mesh.visible = leaves.count > 0;
      if (leaves.count === 0) return;
      mesh.geometry = this.rooms[pattern].fill(leaves, firstTriangle, firstInstance);
      triangles += leaves.count * patternTriangles(pattern);
    });
    return triangles;
  }

  hide(): void {
    for (const { mesh } of this.drawables) mesh.visible = false;
  }
}

/** A pattern's geometry with room for the leaves that it is drawn for. */
class InstanceRoom {
  geometry: InstancedBufferGeometry;
  private readonly pattern: BufferGeometry;
  private buffer: InstancedInterleavedBuffer;

  constructor(pattern: number) {
    this.pattern = patternGeometry([pattern]).geometry;
    this.buffer = leafBuffer(LEAST_ROOM);
    this.geometry = instanced(this.pattern, this.buffer);
  }

  fill({ leaves, count }: Leaves, firstTriangle: number, firstInstance: number): InstancedBufferGeometry {
    if (count > this.buffer.count) {
      this.geometry.dispose();
      this.buffer = leafBuffer(2 ** Math.ceil(Math.log2(count)));
      this.geometry = instanced(this.pattern, this.buffer);
    }
    const { array } = this.buffer;
    array.set(leaves);
    for (let i = 0; i < leaves.length; i += LEAF_FLOATS) {
      array[i] += firstTriangle;
      array[i + WEARER_AT] += firstInstance;
    }
    this.buffer.clearUpdateRanges();
    this.buffer.addUpdateRange(0, leaves.length);
    this.buffer.needsUpdate = true;
    this.geometry.instanceCount = count;
    return this.geometry;
  }
}

const leafBuffer = (room: number) => new InstancedInterleavedBuffer(new Float32Array(LEAF_FLOATS * room), LEAF_FLOATS);

function instanced(pattern: BufferGeometry, buffer: InstancedInterleavedBuffer): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', pattern.getAttribute('position'));
  geometry.setIndex(pattern.index);
  geometry.setAttribute('head', new InterleavedBufferAttribute(buffer, 4, 0));
  geometry.setAttribute('tail', new InterleavedBufferAttribute(buffer, 4, 4));
  geometry.setAttribute('instance', new InterleavedBufferAttribute(buffer, 1, WEARER_AT));
  return geometry;
}
