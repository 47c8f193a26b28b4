import { atomicAdd, int, storage, uint, vec4 } from 'three/tsl';
import { IndirectStorageBufferAttribute, type Node, StorageBufferAttribute } from 'three/webgpu';
import type { Int } from '../../shaders/types.ts';
import type { ShaderLeaf } from './gpuLeaf.ts';
import { type IndexRun, patternTriangles } from './gpuPatterns.ts';
import { LEAF_FLOATS, LEVELS_AT, WEARER_AT } from './leaf.ts';
import { PATTERNS } from './pattern.ts';

const LISTS = PATTERNS.length;
/** Numbers of an indexed indirect draw: indices, instances, first index, base vertex, first instance. */
const DRAW = 5;
const INSTANCES = 1;
/** In an entry of a list the leaf's number is above the nine bits of its levels. */
const LEVEL_BITS = 9;
const LEAST_ROOM = 1024;

type Uint = Node<'uint'>;

/** Where the leaves of a batch are in a picture; the list of its k-th pattern begins at LISTS · first + k · count. */
export interface LeafRun<T = number> {
  readonly first: T;
  readonly count: T;
}

const place = (run: LeafRun<Uint>, pattern: Int): Uint =>
  run.first.mul(uint(LISTS)).add(run.count.mul(uint(pattern))) as Uint;

/**
 * The leaves of a picture on the GPU, of all batches one after another, and for each batch (`slot`) and pattern a list of its leaves, with an indirect draw whose instances are the list's entries. In place of its levels a leaf has its batch's slot.
 */
export class LeafBuffers {
  /** Of batch after batch, a draw per pattern. */
  readonly draws: IndirectStorageBufferAttribute;
  private readonly runs: StorageBufferAttribute;
  private leaves = leafBuffer(LEAST_ROOM);
  private list = listBuffer(LEAST_ROOM);
  private readonly leavesRead = storage(this.leaves, 'float', 0).toReadOnly();
  private readonly listRead = storage(this.list, 'uint', 0).toReadOnly();
  private readonly listWritten = storage(this.list, 'uint', 0);
  private readonly runsRead;
  private readonly drawsCounted;

  /** `patterns`: where each pattern's triangles are in the index buffer that is drawn with. */
  constructor(batches: number, patterns: readonly IndexRun[]) {
    const draws = new Uint32Array(DRAW * LISTS * batches);
    for (let i = 0; i < LISTS * batches; i++) {
      const { first, count } = patterns[i % LISTS];
      draws.set([count, 0, first, 0, 0], DRAW * i);
    }
    this.draws = new IndirectStorageBufferAttribute(draws, DRAW);
    this.runs = new StorageBufferAttribute(new Uint32Array(2 * batches), 2);
    this.runsRead = storage(this.runs, 'uvec2', 0).toReadOnly();
    this.drawsCounted = storage(this.draws, 'uint', 0).toAtomic();
  }

  /** Byte offsets of a batch's draws. */
  offsets(slot: number): number[] {
    return Array.from({ length: LISTS }, (_, pattern) => 4 * DRAW * (LISTS * slot + pattern));
  }

  /** Begins a picture with so many leaves; all lists are empty. */
  begin(leaves: number): void {
    if (LEAF_FLOATS * leaves > this.leaves.array.length) this.grow(leaves);
    // The GPU counted its own copy.
    this.draws.needsUpdate = true;
  }

  /** Writes a batch's leaves from the `first`-th on; what its triangles and instances begin with is added to theirs. */
  write(
    slot: number,
    { first, count }: LeafRun,
    leaves: Float32Array,
    firstTriangle: number,
    firstInstance: number,
  ): void {
    const out = this.leaves.array;
    const at = LEAF_FLOATS * first;
    out.set(leaves.subarray(0, LEAF_FLOATS * count), at);
    for (let i = at; i < at + LEAF_FLOATS * count; i += LEAF_FLOATS) {
      out[i] += firstTriangle;
      out[i + LEVELS_AT] = slot;
      out[i + WEARER_AT] += firstInstance;
    }
    this.leaves.addUpdateRange(at, LEAF_FLOATS * count);
    this.leaves.needsUpdate = true;
    this.runs.array.set([first, count], 2 * slot);
    this.runs.needsUpdate = true;
  }

  /** In a kernel: the leaf's floats. */
  leaf(index: Uint): Omit<ShaderLeaf, 'levels'> {
    const at = index.mul(uint(LEAF_FLOATS)).toVar();
    const float = (k: number) => this.leavesRead.element(at.add(uint(k)));
    const head = vec4(float(0), float(1), float(2), float(3)).toVar();
    const tail = vec4(float(4), float(5), float(6), float(7)).toVar();
    return { head, tail, instance: float(8).toVar() };
  }

  /** In a kernel: adds a leaf to its list. `slot`: where its levels would be. */
  enlist(index: Uint, slot: Int, levels: Int, pattern: Int): void {
    const run = this.runsRead.element(slot).toVar();
    const draw = slot.mul(int(LISTS)).add(pattern).mul(int(DRAW));
    const before = atomicAdd(this.drawsCounted.element(draw.add(int(INSTANCES))), uint(1));
    const at = place({ first: run.x, count: run.y }, pattern).add(before);
    this.listWritten.element(at).assign(index.shiftLeft(uint(LEVEL_BITS)).bitOr(uint(levels)));
  }

  /** In a vertex stage: the leaf of an instance. */
  listed(run: LeafRun<Uint>, pattern: Int, instance: Uint): ShaderLeaf {
    const entry = this.listRead.element(place(run, pattern).add(instance)).toVar();
    const levels = int(entry.bitAnd(uint((1 << LEVEL_BITS) - 1))).toVar();
    return { ...this.leaf(entry.shiftRight(uint(LEVEL_BITS)).toVar()), levels };
  }

  /** Of the draws, as they were read back. */
  static triangles(draws: Uint32Array): number {
    let sum = 0;
    for (let i = 0; i < draws.length / DRAW; i++) sum += draws[DRAW * i + INSTANCES] * patternTriangles(i % LISTS);
    return sum;
  }

  dispose(): void {
    for (const buffer of [this.leaves, this.list, this.runs, this.draws]) buffer.dispose();
  }

  private grow(leaves: number): void {
    const room = 2 ** Math.ceil(Math.log2(leaves));
    this.leaves.dispose();
    this.list.dispose();
    this.leaves = leafBuffer(room);
    this.list = listBuffer(room);
    this.leavesRead.value = this.leaves;
    this.listRead.value = this.list;
    this.listWritten.value = this.list;
  }
}

const leafBuffer = (room: number) => new StorageBufferAttribute(new Float32Array(LEAF_FLOATS * room), 1);
const listBuffer = (room: number) => new StorageBufferAttribute(new Uint32Array(LISTS * room), 1);
