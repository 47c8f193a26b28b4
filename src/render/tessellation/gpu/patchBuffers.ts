import { atomicAdd, int, storage, uint, vec4 } from 'three/tsl';
import { IndirectStorageBufferAttribute, type Node, StorageBufferAttribute } from 'three/webgpu';
import type { Int } from '../../../shaders/types.ts';
import { FACTORS_OFFSET, INSTANCE_OFFSET, PATCH_FLOATS } from '../patches/patch.ts';
import { PATTERNS } from '../patches/pattern.ts';
import { type IndexRange, patternTriangleCount } from './patternGeometry.ts';
import type { ShaderPatch } from './shaderPatch.ts';

const PATTERN_COUNT = PATTERNS.length;
/** Words of an indexed indirect draw: index count, instance count, first index, base vertex, first instance. */
const DRAW_WORDS = 5;
const INSTANCE_COUNT_OFFSET = 1;
/** In a list's entry the patch's index is above the nine bits of its tessellation factors. */
const FACTOR_BITS = 9;
const MIN_CAPACITY = 1024;

type Uint = Node<'uint'>;

/** Where a batch's patches are in the buffer; the list of its k-th pattern begins at PATTERN_COUNT · first + k · count. */
export interface PatchRange<T = number> {
  readonly first: T;
  readonly count: T;
}

const listOffset = (range: PatchRange<Uint>, pattern: Int): Uint =>
  range.first.mul(uint(PATTERN_COUNT)).add(range.count.mul(uint(pattern))) as Uint;

/**
 * The patches of a frame on the GPU, batch after batch, and for each batch (`slot`) and pattern a list of its patches, with an indirect draw whose instances
 * are the list's entries. In place of its tessellation factors a patch stores its batch's slot.
 */
export class PatchBuffers {
  /** For each batch, one draw per pattern. */
  readonly draws: IndirectStorageBufferAttribute;
  private readonly ranges: StorageBufferAttribute;
  private patches = patchBuffer(MIN_CAPACITY);
  private lists = listBuffer(MIN_CAPACITY);
  private readonly patchesNode = storage(this.patches, 'float', 0).toReadOnly();
  private readonly listsNode = storage(this.lists, 'uint', 0).toReadOnly();
  private readonly listsOutput = storage(this.lists, 'uint', 0);
  private readonly rangesNode;
  private readonly drawCounters;

  /** `patterns`: where each pattern's triangles are in the index buffer that the draws use. */
  constructor(batches: number, patterns: readonly IndexRange[]) {
    const draws = new Uint32Array(DRAW_WORDS * PATTERN_COUNT * batches);
    for (let i = 0; i < PATTERN_COUNT * batches; i++) {
      const { first, count } = patterns[i % PATTERN_COUNT];
      draws.set([count, 0, first, 0, 0], DRAW_WORDS * i);
    }
    this.draws = new IndirectStorageBufferAttribute(draws, DRAW_WORDS);
    this.ranges = new StorageBufferAttribute(new Uint32Array(2 * batches), 2);
    this.rangesNode = storage(this.ranges, 'uvec2', 0).toReadOnly();
    this.drawCounters = storage(this.draws, 'uint', 0).toAtomic();
  }

  /** Byte offsets of a batch's draws. */
  offsets(slot: number): number[] {
    return Array.from({ length: PATTERN_COUNT }, (_, pattern) => 4 * DRAW_WORDS * (PATTERN_COUNT * slot + pattern));
  }

  /** Begins a frame with this number of patches; empties all lists. */
  begin(patchCount: number): void {
    if (PATCH_FLOATS * patchCount > this.patches.array.length) this.grow(patchCount);
    // Resets the instance counts, which the GPU has incremented in its copy.
    this.draws.needsUpdate = true;
  }

  /** Writes a batch's patches from index `first` on; `firstTriangle` and `firstInstance` are added to their indices. */
  write(
    slot: number,
    { first, count }: PatchRange,
    patches: Float32Array,
    firstTriangle: number,
    firstInstance: number,
  ): void {
    const out = this.patches.array;
    const at = PATCH_FLOATS * first;
    out.set(patches.subarray(0, PATCH_FLOATS * count), at);
    for (let i = at; i < at + PATCH_FLOATS * count; i += PATCH_FLOATS) {
      out[i] += firstTriangle;
      out[i + FACTORS_OFFSET] = slot;
      out[i + INSTANCE_OFFSET] += firstInstance;
    }
    this.patches.addUpdateRange(at, PATCH_FLOATS * count);
    this.patches.needsUpdate = true;
    this.ranges.array.set([first, count], 2 * slot);
    this.ranges.needsUpdate = true;
  }

  /** In a kernel: the floats of a patch. */
  patch(index: Uint): Omit<ShaderPatch, 'factors'> {
    const at = index.mul(uint(PATCH_FLOATS)).toVar();
    const float = (k: number) => this.patchesNode.element(at.add(uint(k)));
    const head = vec4(float(0), float(1), float(2), float(3)).toVar();
    const tail = vec4(float(4), float(5), float(6), float(7)).toVar();
    return { head, tail, instance: float(8).toVar() };
  }

  /** In a kernel: appends a patch to its list. `slot`: what the patch stores in place of its factors. */
  append(index: Uint, slot: Int, factors: Int, pattern: Int): void {
    const range = this.rangesNode.element(slot).toVar();
    const draw = slot.mul(int(PATTERN_COUNT)).add(pattern).mul(int(DRAW_WORDS));
    const before = atomicAdd(this.drawCounters.element(draw.add(int(INSTANCE_COUNT_OFFSET))), uint(1));
    const at = listOffset({ first: range.x, count: range.y }, pattern).add(before);
    this.listsOutput.element(at).assign(index.shiftLeft(uint(FACTOR_BITS)).bitOr(uint(factors)));
  }

  /** In a vertex stage: the patch of an instance. */
  patchOfInstance(range: PatchRange<Uint>, pattern: Int, instance: Uint): ShaderPatch {
    const entry = this.listsNode.element(listOffset(range, pattern).add(instance)).toVar();
    const factors = int(entry.bitAnd(uint((1 << FACTOR_BITS) - 1))).toVar();
    return { ...this.patch(entry.shiftRight(uint(FACTOR_BITS)).toVar()), factors };
  }

  /** The number of triangles of draws that were read back. */
  static countTriangles(draws: Uint32Array): number {
    let sum = 0;
    for (let i = 0; i < draws.length / DRAW_WORDS; i++)
      sum += draws[DRAW_WORDS * i + INSTANCE_COUNT_OFFSET] * patternTriangleCount(i % PATTERN_COUNT);
    return sum;
  }

  dispose(): void {
    for (const buffer of [this.patches, this.lists, this.ranges, this.draws]) buffer.dispose();
  }

  private grow(patchCount: number): void {
    const capacity = 2 ** Math.ceil(Math.log2(patchCount));
    this.patches.dispose();
    this.lists.dispose();
    this.patches = patchBuffer(capacity);
    this.lists = listBuffer(capacity);
    this.patchesNode.value = this.patches;
    this.listsNode.value = this.lists;
    this.listsOutput.value = this.lists;
  }
}

const patchBuffer = (capacity: number) => new StorageBufferAttribute(new Float32Array(PATCH_FLOATS * capacity), 1);
const listBuffer = (capacity: number) => new StorageBufferAttribute(new Uint32Array(PATTERN_COUNT * capacity), 1);
