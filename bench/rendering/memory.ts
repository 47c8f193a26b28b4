import type { Bench } from '../support/bench.ts';
import { inChild } from '../support/inChild.ts';
import { SAMPLES } from '../support/scenes.ts';

interface MeasuredMemory {
  readonly vertices: number;
  readonly bytes: number;
}
const FEW = 50;

export const memory: Bench = {
  name: 'memory',
  title: 'Memory of a deforming mesh',
  about:
    'Growth of resident memory when a deforming scene of 100,000 triangles is uploaded and drawn, in a process of its own; with a software GPU that is the memory of program and GPU ' +
    "together. The scene's own arrays (12 bytes per vertex and sample, 24 with normals) come to that. Per vertex and sample: the slope between two numbers of samples.",
  async run() {
    const [few, many] = [FEW, SAMPLES].map((samples) => inChild<MeasuredMemory>('memory', String(samples)));
    const slope = (many.bytes - few.bytes) / (many.vertices * (SAMPLES - FEW));
    const row = (samples: number, { vertices, bytes }: MeasuredMemory) => [
      vertices.toLocaleString('en'),
      String(samples),
      bytes / 2 ** 20,
    ];
    return [
      {
        columns: ['vertices', 'samples', 'resident [MiB]'],
        rows: [row(FEW, few), row(SAMPLES, many)],
        remark: `**${slope.toFixed(1)} bytes per vertex and sample.**`,
      },
    ];
  },
};
