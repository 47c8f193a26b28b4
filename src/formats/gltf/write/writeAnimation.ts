import type { Accessor, Animation, Buffer, Document, Node as GltfNode } from '@gltf-transform/core';
import { msg } from '../../../messages/message.ts';
import { isStatic, sampleTimes } from '../../../scene/motion/motion.ts';
import type { Motion, SampledMotion, Scene } from '../../../scene/types.ts';
import type { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import { exportPoses, orientationYUp, vectorYUp } from '../../write/exportMotion.ts';

/** Keys of glTF are f32 and not before 0: the scene's times, moved where they are, and those that f32 tells apart. */
export class AnimationWriter {
  private readonly document: Document;
  private readonly buffer: Buffer;
  private readonly scene: Scene;
  /** How much later all is [s]. */
  readonly shift: number;
  private made: Animation | undefined;

  constructor(document: Document, buffer: Buffer, scene: Scene, losses: DiagnosticLog) {
    this.document = document;
    this.buffer = buffer;
    this.scene = scene;
    const { objects, cameras, lights } = scene;
    const motions = [...objects, ...cameras, ...lights].flatMap((x) => ('motion' in x ? [x.motion] : []));
    const startOf = (motion: Motion): number => {
      const times = sampleTimes(motion);
      return times ? times[0] : isStatic(motion) ? 0 : scene.startTime;
    };
    const starts = motions.map(startOf);
    this.shift = -starts.reduce((a, b) => Math.min(a, b), 0);
    if (this.shift > 0)
      losses.add('info', 'convert.times', '', msg`all times are ${this.shift} s later: glTF has none before 0`);
  }

  addPoses(node: GltfNode, motion: SampledMotion): void {
    const { keys, times } = this.keysOf(motion.times);
    const poses = exportPoses(motion);
    const positions = keys.flatMap((i) => vectorYUp(this.scene, poses[i].position));
    const orientations = keys.flatMap((i) => orientationYUp(this.scene, poses[i].orientation));
    if (moves(positions, 3)) this.channel(node, 'translation', times, this.values('VEC3', positions));
    if (moves(orientations, 4)) this.channel(node, 'rotation', times, this.values('VEC4', orientations));
  }

  /** At each time one morph target alone counts, at the first none: between times the points move straight. */
  addWeights(node: GltfNode, motion: { readonly times: Float64Array }): void {
    const { keys, times } = this.keysOf(motion.times);
    const targets = motion.times.length - 1;
    const weights = keys.flatMap((key) => Array.from({ length: targets }, (_, i) => (i + 1 === key ? 1 : 0)));
    this.channel(node, 'weights', times, this.values('SCALAR', weights));
  }

  private keysOf(all: Float64Array): { keys: number[]; times: Accessor } {
    const rounded = Float32Array.from(all, (t) => t + this.shift);
    const keys = [...rounded.keys()].filter((i) => i === 0 || rounded[i] > rounded[i - 1]);
    return {
      keys,
      times: this.values(
        'SCALAR',
        keys.map((i) => rounded[i]),
      ),
    };
  }

  private values(type: 'SCALAR' | 'VEC3' | 'VEC4', numbers: readonly number[]): Accessor {
    return this.document.createAccessor().setType(type).setArray(Float32Array.from(numbers)).setBuffer(this.buffer);
  }

  private channel(
    node: GltfNode,
    path: 'translation' | 'rotation' | 'weights',
    times: Accessor,
    output: Accessor,
  ): void {
    this.made ??= this.document.createAnimation('Motion');
    const sampler = this.document.createAnimationSampler().setInput(times).setOutput(output).setInterpolation('LINEAR');
    const channel = this.document.createAnimationChannel().setTargetNode(node).setTargetPath(path).setSampler(sampler);
    this.made.addSampler(sampler).addChannel(channel);
  }
}

const moves = (values: readonly number[], width: number): boolean => values.some((x, i) => x !== values[i % width]);
