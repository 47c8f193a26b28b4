import { atomicAdd, int, storage, uint, vec4 } from 'three/tsl';
import { IndirectStorageBufferAttribute, type Node, StorageBufferAttribute } from 'three/webgpu';
import type { Int } from '../../../shaders/types.ts';
import { FACTORS_OFFSET, INSTANCE_OFFSET, PATCH_FLOATS } from '../patches/patch.ts';
import { PATTERNS } from '../patches/pattern.ts';
import { type IndexRange, patternTriangleCount } from './patternGeometry.ts';
import type { ShaderPatch } from './shaderPatch.ts';

const PATTERN_COUNT = PATTERNS.length;
/** Numbers of an indexed indirect draw: indices, instances, first index, base vertex, first instance. */
const DRAW_WORDS = 5;
const INSTANCE_COUNT_OFFSET = 1;
/** In an entry of a list the leaf's number is above the nine bits of its levels. */
const FACTOR_BITS = 9;
const MIN_CAPACITY = 1024;

type Uint = Node<'uint'>;

/** Where the leaves of a batch are in a picture; the list of its k-th pattern begins at LISTS · first + k · count. */
export interface PatchRange<T = number> {
  readonly first: T;
  readonly count: T;
}

const listOffset = (run: PatchRange<Uint>, pattern: Int): Uint =>
  run.first.mul(uint(PATTERN_COUNT)).add(run.count.mul(uint(pattern))) as Uint;

/**
 * The leaves of a picture on the GPU, of all batches one after another, and for each batch (`slot`) and pattern a list of its leaves, with an indirect draw whose instances are the list's entries. In place of its levels a leaf has its batch's slot.
 */
export class PatchBuffers {
  /** Of batch after batch, a draw per pattern. */
  readonly draws: IndirectStorageBufferAttribute;
  private readonly ranges: StorageBufferAttribute;
  private patches = patchBuffer(MIN_CAPACITY);
  private lists = listBuffer(MIN_CAPACITY);
  private readonly patchesNode = storage(this.patches, 'float', 0).toReadOnly();
  private readonly listsNode = storage(this.lists, 'uint', 0).toReadOnly();
  private readonly listsOutput = storage(this.lists, 'uint', 0);
  private readonly rangesNode;
  private readonly drawCounters;

  /** `patterns`: where each pattern's triangles are in the index buffer that is drawn with. */
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

  /** Begins a picture with so many leaves; all lists are empty. */
  begin(leaves: number): void {
    if (PATCH_FLOATS * leaves > this.patches.array.length) this.grow(leaves);
    // The GPU counted its own copy.
    this.draws.needsUpdate = true;
  }

  /** Writes a batch's leaves from the `first`-th on; what its triangles and instances begin with is added to theirs. */
  write(
    slot: number,
    { first, count }: PatchRange,
    leaves: Float32Array,
    firstTriangle: number,
    firstInstance: number,
  ): void {
    const out = this.patches.array;
    const at = PATCH_FLOATS * first;
    out.set(leaves.subarray(0, PATCH_FLOATS * count), at);
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

  /** In a kernel: the leaf's floats. */
  patch(index: Uint): Omit<ShaderPatch, 'factors'> {
    const at = index.mul(uint(PATCH_FLOATS)).toVar();
    const float = (k: number) => this.patchesNode.element(at.add(uint(k)));
    const head = vec4(float(0), float(1), float(2), float(3)).toVar();
    const tail = vec4(float(4), float(5), float(6), float(7)).toVar();
    return { head, tail, instance: float(8).toVar() };
  }

  /** In a kernel: adds a leaf to its list. `slot`: where its levels would be. */
  append(index: Uint, slot: Int, levels: Int, pattern: Int): void {
    const run = this.rangesNode.element(slot).toVar();
    const draw = slot.mul(int(PATTERN_COUNT)).add(pattern).mul(int(DRAW_WORDS));
    const before = atomicAdd(this.drawCounters.element(draw.add(int(INSTANCE_COUNT_OFFSET))), uint(1));
    const at = listOffset({ first: run.x, count: run.y }, pattern).add(before);
    this.listsOutput.element(at).assign(index.shiftLeft(uint(FACTOR_BITS)).bitOr(uint(levels)));
  }

  /** In a vertex stage: the leaf of an instance. */
  patchOfInstance(run: PatchRange<Uint>, pattern: Int, instance: Uint): ShaderPatch {
    const entry = this.listsNode.element(listOffset(run, pattern).add(instance)).toVar();
    const levels = int(entry.bitAnd(uint((1 << FACTOR_BITS) - 1))).toVar();
    return { ...this.patch(entry.shiftRight(uint(FACTOR_BITS)).toVar()), factors: levels };
  }

  /** Of the draws, as they were read back. */
  static countTriangles(draws: Uint32Array): number {
    let sum = 0;
    for (let i = 0; i < draws.length / DRAW_WORDS; i++)
      sum += draws[DRAW_WORDS * i + INSTANCE_COUNT_OFFSET] * patternTriangleCount(i % PATTERN_COUNT);
    return sum;
  }

  dispose(): void {
    for (const buffer of [this.patches, this.lists, this.ranges, this.draws]) buffer.dispose();
  }

  private grow(leaves: number): void {
    const room = 2 ** Math.ceil(Math.log2(leaves));
    this.patches.dispose();
    this.lists.dispose();
    this.patches = patchBuffer(room);
    this.lists = listBuffer(room);
    this.patchesNode.value = this.patches;
    this.listsNode.value = this.lists;
    this.listsOutput.value = this.lists;
  }
}

const patchBuffer = (room: number) => new StorageBufferAttribute(new Float32Array(PATCH_FLOATS * room), 1);
const listBuffer = (room: number) => new StorageBufferAttribute(new Uint32Array(PATTERN_COUNT * room), 1);
