import { StepFailure } from '../dynamics/methods/method.ts';
import { type System, SystemError } from '../dynamics/system.ts';
import { msg } from '../messages/message.ts';
import { packBodies, packObstacles, packStage, packWorld, STAGE_BYTES, WORDS } from './bufferLayout.ts';
import type { ForceRows } from './forceRows.ts';
import { SPLITTING_WGSL, WORKGROUP_SIZE } from './shader.ts';
import type { SplittingStage } from './splittingStages.ts';

/** Result of some passes. */
export interface PassResult {
  /** `VelocityChange` of each row. */
  readonly changes: Float32Array;
  /** Row of a point that passed through a solid. */
  readonly piercedAt: number | undefined;
  /** Whether a point travelled beyond the validity of the neighbour list. */
  readonly strayed: boolean;
}

const NO_POINT = 0xffffffff;
const CLEARED_MARKS = Uint32Array.of(NO_POINT, 0);
/** Size of a buffer for an empty list of links or obstacles. */
const MIN_BUFFER_BYTES = 64;

/** The shader's passes over the points of a system, with their buffers. */
export class IntegratorPasses {
  private readonly device: GPUDevice;
  private readonly system: System;
  private readonly links: ForceRows;
  private readonly kernels: Kernels;
  private readonly buffers: ReturnType<typeof makeBuffers>;
  private near: GPUBuffer;
  /** From one buffer of changes to the other, and back. */
  private bindGroups: readonly [GPUBindGroup, GPUBindGroup];

  /** Throws a SystemError if the GPU has too little memory. */
  static async create(
    device: GPUDevice,
    system: System,
    links: ForceRows,
    stages: readonly SplittingStage[],
  ): Promise<IntegratorPasses> {
    return new IntegratorPasses(device, system, links, stages, await compileKernels(device));
  }

  private constructor(
    device: GPUDevice,
    system: System,
    links: ForceRows,
    stages: readonly SplittingStage[],
    kernels: Kernels,
  ) {
    this.device = device;
    this.system = system;
    this.links = links;
    this.kernels = kernels;
    this.buffers = makeBuffers(device, system, links, stages);
    this.near = bufferWith(device, GPUBufferUsage.STORAGE, new Uint32Array(1));
    this.bindGroups = this.makeBindGroups();
    this.setMaxTravel(Number.POSITIVE_INFINITY);
  }

  /** Uploads the neighbour list (`neighborRows`). */
  setNeighbors(rows: Uint32Array<ArrayBuffer>): void {
    this.near.destroy();
    this.near = bufferWith(this.device, GPUBufferUsage.STORAGE, rows);
    this.bindGroups = this.makeBindGroups();
  }

  /** Sets the maximum travel of points from their origins [m]. */
  setMaxTravel(maxTravel: number): void {
    this.device.queue.writeBuffer(this.buffers.world, 0, packWorld(this.system, this.links, maxTravel));
  }

  /** Runs passes from origins and changes; `sequence`: stage index of each. */
  async run(
    origins: Float32Array<ArrayBuffer>,
    changes: Float32Array<ArrayBuffer>,
    sequence: readonly number[],
  ): Promise<PassResult> {
    const { device, buffers } = this;
    device.queue.writeBuffer(buffers.origins, 0, origins);
    device.queue.writeBuffer(buffers.changes[0], 0, changes);
    device.queue.writeBuffer(buffers.marks, 0, CLEARED_MARKS);
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    sequence.forEach((stage, k) => void this.dispatch(pass, stage, this.bindGroups[k % 2]));
    pass.end();
    encoder.copyBufferToBuffer(buffers.changes[sequence.length % 2], 0, buffers.readback, 0, changes.byteLength);
    encoder.copyBufferToBuffer(buffers.marks, 0, buffers.readback, changes.byteLength, CLEARED_MARKS.byteLength);
    device.queue.submit([encoder.finish()]);
    await buffers.readback.mapAsync(GPUMapMode.READ).catch(deviceLost);
    const read = buffers.readback.getMappedRange().slice(0);
    buffers.readback.unmap();
    const [pierced, strayed] = new Uint32Array(read, changes.byteLength);
    return {
      changes: new Float32Array(read, 0, changes.length),
      piercedAt: pierced === NO_POINT ? undefined : pierced,
      strayed: strayed !== 0,
    };
  }

  /** Frees GPU memory. */
  release(): void {
    for (const each of [...Object.values(this.buffers).flat(), this.near]) each.destroy();
  }

  private dispatch(pass: GPUComputePassEncoder, stage: number, maxTravel: GPUBindGroup): void {
    const { pointOfRow, longRowCount } = this.links;
    pass.setBindGroup(0, maxTravel, [stage * STAGE_BYTES]);
    if (pointOfRow.length > longRowCount) {
      pass.setPipeline(this.kernels.short);
      pass.dispatchWorkgroups(Math.ceil((pointOfRow.length - longRowCount) / WORKGROUP_SIZE));
    }
    if (longRowCount > 0) {
      pass.setPipeline(this.kernels.long);
      pass.dispatchWorkgroups(longRowCount);
    }
  }

  private makeBindGroups(): readonly [GPUBindGroup, GPUBindGroup] {
    const { world, stages, bodies, origins, links, obstacles, changes, marks } = this.buffers;
    const stage = { buffer: stages, size: STAGE_BYTES };
    const bind = (here: GPUBuffer, next: GPUBuffer): GPUBindGroup => {
      const stored = [bodies, origins, links, obstacles, this.near, here, next, marks].map((buffer) => ({ buffer }));
      return this.device.createBindGroup({
        layout: this.kernels.layout,
        entries: [{ buffer: world }, stage, ...stored].map((resource, binding) => ({ binding, resource })),
      });
    };
    return [bind(...changes), bind(changes[1], changes[0])];
  }
}

function deviceLost(error: unknown): never {
  const why = error instanceof Error ? error.message : String(error);
  throw new StepFailure('lost', msg`the GPU was lost (${why}); go on, or compute it on the processor`);
}

interface Kernels {
  readonly layout: GPUBindGroupLayout;
  readonly short: GPUComputePipeline;
  readonly long: GPUComputePipeline;
}

async function compileKernels(device: GPUDevice): Promise<Kernels> {
  const read = { type: 'read-only-storage' } as const;
  const written = { type: 'storage' } as const;
  const kinds = [{}, { hasDynamicOffset: true }, read, read, read, read, read, read, written, written];
  const layout = device.createBindGroupLayout({
    entries: kinds.map((buffer, binding) => ({ binding, visibility: GPUShaderStage.COMPUTE, buffer })),
  });
  const module = device.createShaderModule({ label: 'passes of a splitting', code: SPLITTING_WGSL });
  const whole = device.createPipelineLayout({ bindGroupLayouts: [layout] });
  const kernel = (entryPoint: string): Promise<GPUComputePipeline> =>
    device.createComputePipelineAsync({ layout: whole, compute: { module, entryPoint } });
  return { layout, short: await kernel('shortRows'), long: await kernel('longRows') };
}

function makeBuffers(device: GPUDevice, system: System, links: ForceRows, stages: readonly SplittingStage[]) {
  const { COPY_SRC, COPY_DST, MAP_READ, STORAGE, UNIFORM } = GPUBufferUsage;
  const count = links.pointOfRow.length;
  const empty = (words: number, usage: number): GPUBuffer => makeBuffer(device, 4 * words, usage);
  const table = new Uint8Array(stages.length * STAGE_BYTES);
  stages.forEach((stage, k) => void table.set(new Uint8Array(packStage(stage).buffer), k * STAGE_BYTES));
  const change = (): GPUBuffer => empty(WORDS.change * count, STORAGE | COPY_DST | COPY_SRC);
  return {
    world: empty(WORDS.world, UNIFORM | COPY_DST),
    stages: bufferWith(device, UNIFORM, table),
    bodies: bufferWith(device, STORAGE, packBodies(system, links)),
    origins: empty(WORDS.origin * count, STORAGE | COPY_DST),
    links: bufferWith(device, STORAGE, links.words),
    obstacles: bufferWith(device, STORAGE, packObstacles(links)),
    changes: [change(), change()] as const,
    marks: empty(CLEARED_MARKS.length, STORAGE | COPY_DST | COPY_SRC),
    readback: empty(WORDS.change * count + CLEARED_MARKS.length, MAP_READ | COPY_DST),
  };
}

/** A buffer with contents; empty buffers are not allowed. */
function bufferWith(device: GPUDevice, usage: number, contents: ArrayBuffer | ArrayBufferView<ArrayBuffer>): GPUBuffer {
  const buffer = makeBuffer(device, Math.max(MIN_BUFFER_BYTES, contents.byteLength), usage | GPUBufferUsage.COPY_DST);
  device.queue.writeBuffer(buffer, 0, contents);
  return buffer;
}

function makeBuffer(device: GPUDevice, size: number, usage: number): GPUBuffer {
  const most = Math.min(device.limits.maxStorageBufferBindingSize, device.limits.maxBufferSize);
  if (size > most) {
    const [asked, there] = [size, most].map((bytes) => `${Math.ceil(bytes / 2 ** 20)} MiB`);
    throw new SystemError(msg`it takes a buffer of ${asked}, and the GPU gives ${there} at most`);
  }
  return device.createBuffer({ size, usage });
}
