import { attribute, int } from 'three/tsl';
import {
  type BufferGeometry,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
} from 'three/webgpu';
import { cornerSources, type DrawCall, makeDrawCall } from '../../gbuffer/drawCall.ts';
import type { VertexInput } from '../../geometry/vertexInput.ts';
import { INSTANCE_OFFSET, PATCH_FLOATS } from '../patches/patch.ts';
import { PATTERNS } from '../patches/pattern.ts';
import type { PatchArray, PatchesByPattern } from '../plan/tessellationPlan.ts';
import { patternGeometry, patternTriangleCount } from './patternGeometry.ts';
import { weightsAt } from './shaderPatch.ts';
import type { TriangleTable } from './triangleTable.ts';

const MIN_CAPACITY = 64;

/** The patches of one batch with tessellation factors computed on the CPU: each pattern is drawn as instances, one per patch. */
export class InstancedPatches {
  readonly drawCalls: readonly DrawCall[];
  private readonly buffers: PatternInstances[];

  constructor(indexed: DrawCall, triangleTable: TriangleTable) {
    const vertex = (): VertexInput => {
      const coordinate = attribute<'vec3'>('position', 'vec3');
      const head = attribute<'vec4'>('head', 'vec4');
      const tail = attribute<'vec4'>('tail', 'vec4');
      const weights = weightsAt({ head, tail, factors: int(tail.w).toVar() }, coordinate.x, coordinate.y);
      return triangleTable.interpolate(
        int(head.x),
        weights,
        cornerSources(indexed),
        attribute<'float'>('instance', 'float'),
      );
    };
    const sources = { ...indexed, vertex: { ...indexed.vertex, vertex } };
    this.buffers = PATTERNS.map((_, pattern) => new PatternInstances(pattern));
    // All patterns share one shader, so one set of materials.
    const materials: DrawCall['materials'] = new Map();
    this.drawCalls = this.buffers.map(({ geometry }) => ({ ...makeDrawCall(geometry, sources), materials }));
    this.hide();
  }

  /** `firstTriangle`, `firstInstance`: added to the patches' indices. Returns the number of triangles. */
  show(patchesByPattern: PatchesByPattern, firstTriangle: number, firstInstance: number): number {
    let triangles = 0;
    this.drawCalls.forEach(({ mesh }, pattern) => {
      const patches = patchesByPattern[pattern];
      mesh.visible = patches.count > 0;
      if (patches.count === 0) return;
      mesh.geometry = this.buffers[pattern].fill(patches, firstTriangle, firstInstance);
      triangles += patches.count * patternTriangleCount(pattern);
    });
    return triangles;
  }

  hide(): void {
    for (const { mesh } of this.drawCalls) mesh.visible = false;
  }
}

/** A pattern's geometry with a growing buffer for the patches that it is drawn for. */
class PatternInstances {
  geometry: InstancedBufferGeometry;
  private readonly pattern: BufferGeometry;
  private buffer: InstancedInterleavedBuffer;

  constructor(pattern: number) {
    this.pattern = patternGeometry([pattern]).geometry;
    this.buffer = patchBuffer(MIN_CAPACITY);
    this.geometry = instancedGeometry(this.pattern, this.buffer);
  }

  fill({ patches, count }: PatchArray, firstTriangle: number, firstInstance: number): InstancedBufferGeometry {
    if (count > this.buffer.count) {
      this.geometry.dispose();
      this.buffer = patchBuffer(2 ** Math.ceil(Math.log2(count)));
      this.geometry = instancedGeometry(this.pattern, this.buffer);
    }
    const { array } = this.buffer;
    array.set(patches);
    for (let i = 0; i < patches.length; i += PATCH_FLOATS) {
      array[i] += firstTriangle;
      array[i + INSTANCE_OFFSET] += firstInstance;
    }
    this.buffer.clearUpdateRanges();
    this.buffer.addUpdateRange(0, patches.length);
    this.buffer.needsUpdate = true;
    this.geometry.instanceCount = count;
    return this.geometry;
  }
}

const patchBuffer = (capacity: number) =>
  new InstancedInterleavedBuffer(new Float32Array(PATCH_FLOATS * capacity), PATCH_FLOATS);

function instancedGeometry(pattern: BufferGeometry, buffer: InstancedInterleavedBuffer): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', pattern.getAttribute('position'));
  geometry.setIndex(pattern.index);
  geometry.setAttribute('head', new InterleavedBufferAttribute(buffer, 4, 0));
  geometry.setAttribute('tail', new InterleavedBufferAttribute(buffer, 4, 4));
  geometry.setAttribute('instance', new InterleavedBufferAttribute(buffer, 1, INSTANCE_OFFSET));
  return geometry;
}
