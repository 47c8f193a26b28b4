import { StepFailure } from '../dynamics/methods/method.ts';
import { type System, SystemError } from '../dynamics/system.ts';
import { bodiesOf, obstaclesOf, STAGE_BYTES, stageOf, WORDS, worldOf } from './layout.ts';
import type { Links } from './links.ts';
import { GROUP, SHADER } from './shader.ts';
import type { Stage } from './stages.ts';

/** What came of some passes. */
export interface Passed {
  /** `Change` of each place. */
  readonly changes: Float32Array;
  /** The place of a point that went through what is solid. */
  readonly pierced: number | undefined;
  /** A point went farther than those that are near it are known for. */
  readonly strayed: boolean;
}

const NOWHERE = 0xffffffff;
const UNMARKED = Uint32Array.of(NOWHERE, 0);
/** Of a link or an obstacle: what a list of none is as long as. */
const LEAST_BYTES = 64;

/** The passes of the shader over the points of a system, and the buffers that they read and write. */
export class Passes {
  private readonly device: GPUDevice;
  private readonly system: System;
  private readonly links: Links;
  private readonly kernels: Kernels;
  private readonly buffers: ReturnType<typeof buffersFor>;
  private near: GPUBuffer;
  /** From one buffer of changes to the other, and back. */
  private ways: readonly [GPUBindGroup, GPUBindGroup];

  /** Throws a SystemError for what the GPU has no room for. */
  static async on(device: GPUDevice, system: System, links: Links, stages: readonly Stage[]): Promise<Passes> {
    return new Passes(device, system, links, stages, await kernelsOn(device));
  }

  private constructor(device: GPUDevice, system: System, links: Links, stages: readonly Stage[], kernels: Kernels) {
    this.device = device;
    this.system = system;
    this.links = links;
    this.kernels = kernels;
    this.buffers = buffersFor(device, system, links, stages);
    this.near = filled(device, GPUBufferUsage.STORAGE, new Uint32Array(1));
    this.ways = this.bound();
    this.reach(Number.POSITIVE_INFINITY);
  }

  /** Who is near whom (`nearRows`). */
  meet(rows: Uint32Array<ArrayBuffer>): void {
    this.near.destroy();
    this.near = filled(this.device, GPUBufferUsage.STORAGE, rows);
    this.ways = this.bound();
  }

  /** How far each point may go from its origin [m]. */
  reach(way: number): void {
    this.device.queue.writeBuffer(this.buffers.world, 0, worldOf(this.system, this.links, way));
  }

  /** Passes from origins and changes on; `sequence`: which stage each is. */
  async run(
    origins: Float32Array<ArrayBuffer>,
    changes: Float32Array<ArrayBuffer>,
    sequence: readonly number[],
  ): Promise<Passed> {
    const { device, buffers } = this;
    device.queue.writeBuffer(buffers.origins, 0, origins);
    device.queue.writeBuffer(buffers.changes[0], 0, changes);
    device.queue.writeBuffer(buffers.marks, 0, UNMARKED);
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    sequence.forEach((stage, k) => void this.dispatch(pass, stage, this.ways[k % 2]));
    pass.end();
    encoder.copyBufferToBuffer(buffers.changes[sequence.length % 2], 0, buffers.readback, 0, changes.byteLength);
    encoder.copyBufferToBuffer(buffers.marks, 0, buffers.readback, changes.byteLength, UNMARKED.byteLength);
    device.queue.submit([encoder.finish()]);
    await buffers.readback.mapAsync(GPUMapMode.READ).catch(lost);
    const read = buffers.readback.getMappedRange().slice(0);
    buffers.readback.unmap();
    const [pierced, strayed] = new Uint32Array(read, changes.byteLength);
    return {
      changes: new Float32Array(read, 0, changes.length),
      pierced: pierced === NOWHERE ? undefined : pierced,
      strayed: strayed !== 0,
    };
  }

  /** Gives the GPU its room back. */
  release(): void {
    for (const each of [...Object.values(this.buffers).flat(), this.near]) each.destroy();
  }

  private dispatch(pass: GPUComputePassEncoder, stage: number, way: GPUBindGroup): void {
    const { pointAt, long } = this.links;
    pass.setBindGroup(0, way, [stage * STAGE_BYTES]);
    if (pointAt.length > long) {
      pass.setPipeline(this.kernels.short);
      pass.dispatchWorkgroups(Math.ceil((pointAt.length - long) / GROUP));
    }
    if (long > 0) {
      pass.setPipeline(this.kernels.long);
      pass.dispatchWorkgroups(long);
    }
  }

  private bound(): readonly [GPUBindGroup, GPUBindGroup] {
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

function lost(error: unknown): never {
  const why = error instanceof Error ? error.message : String(error);
  throw new StepFailure('lost', `the GPU was lost (${why}); go on, or compute it on the processor`);
}

interface Kernels {
  readonly layout: GPUBindGroupLayout;
  readonly short: GPUComputePipeline;
  readonly long: GPUComputePipeline;
}

async function kernelsOn(device: GPUDevice): Promise<Kernels> {
  const read = { type: 'read-only-storage' } as const;
  const written = { type: 'storage' } as const;
  const kinds = [{}, { hasDynamicOffset: true }, read, read, read, read, read, read, written, written];
  const layout = device.createBindGroupLayout({
    entries: kinds.map((buffer, binding) => ({ binding, visibility: GPUShaderStage.COMPUTE, buffer })),
  });
  const module = device.createShaderModule({ label: 'passes of a splitting', code: SHADER });
  const whole = device.createPipelineLayout({ bindGroupLayouts: [layout] });
  const kernel = (entryPoint: string): Promise<GPUComputePipeline> =>
    device.createComputePipelineAsync({ layout: whole, compute: { module, entryPoint } });
  return { layout, short: await kernel('shortRows'), long: await kernel('longRows') };
}

function buffersFor(device: GPUDevice, system: System, links: Links, stages: readonly Stage[]) {
  const { COPY_SRC, COPY_DST, MAP_READ, STORAGE, UNIFORM } = GPUBufferUsage;
  const count = links.pointAt.length;
  const empty = (words: number, usage: number): GPUBuffer => made(device, 4 * words, usage);
  const table = new Uint8Array(stages.length * STAGE_BYTES);
  stages.forEach((stage, k) => void table.set(new Uint8Array(stageOf(stage).buffer), k * STAGE_BYTES));
  const change = (): GPUBuffer => empty(WORDS.change * count, STORAGE | COPY_DST | COPY_SRC);
  return {
    world: empty(WORDS.world, UNIFORM | COPY_DST),
    stages: filled(device, UNIFORM, table),
    bodies: filled(device, STORAGE, bodiesOf(system, links)),
    origins: empty(WORDS.origin * count, STORAGE | COPY_DST),
    links: filled(device, STORAGE, links.words),
    obstacles: filled(device, STORAGE, obstaclesOf(links)),
    changes: [change(), change()] as const,
    marks: empty(UNMARKED.length, STORAGE | COPY_DST | COPY_SRC),
    readback: empty(WORDS.change * count + UNMARKED.length, MAP_READ | COPY_DST),
  };
}

/** A buffer with what it holds; one without anything would not be allowed. */
function filled(device: GPUDevice, usage: number, contents: ArrayBuffer | ArrayBufferView<ArrayBuffer>): GPUBuffer {
  const buffer = made(device, Math.max(LEAST_BYTES, contents.byteLength), usage | GPUBufferUsage.COPY_DST);
  device.queue.writeBuffer(buffer, 0, contents);
  return buffer;
}

function made(device: GPUDevice, size: number, usage: number): GPUBuffer {
  const most = Math.min(device.limits.maxStorageBufferBindingSize, device.limits.maxBufferSize);
  if (size > most) {
    const [asked, there] = [size, most].map((bytes) => `${Math.ceil(bytes / 2 ** 20)} MiB`);
    throw new SystemError(`it takes a buffer of ${asked}, and the GPU gives ${there} at most`);
  }
  return device.createBuffer({ size, usage });
}
